import vesica

car = vesica.shapes(vesica.Kind.RECT, [[0, 0, 0.8, 0.6, 2, 1]])[0]
person = vesica.shapes(vesica.Kind.ELLIPSE, [[1.5, 1, 1, 0, 1, 0.5]])[0]
post = vesica.circles([[5, 0, 0.5]])[0]

print(f"overlap {vesica.overlap(car, person):d}, "
      f"distance {vesica.nearest(car, post).distance:.6f}, IoU {vesica.iou(car, person):.6f}")
