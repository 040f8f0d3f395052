import vesica

car = vesica.rects([[0, 0, 4, 2, 36.87]], degrees=True)[0]  # x, y, width, height, angle
person = vesica.ellipses([[1.5, 1, 1, 0.5, 0]], degrees=True)[0]  # x, y, half axes, angle
post = vesica.circles([[5, 0, 0.5]])[0]

print(f"overlap {vesica.overlap(car, person):d}, "
      f"distance {vesica.nearest(car, post).distance:.3f}, IoU {vesica.iou(car, person):.3f}")
