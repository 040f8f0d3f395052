using System;
using Vesica;

static class First {
    static void Main() {
        Rect car = Make.Rect(0, 0, 36.87 * Math.PI / 180, 4, 2); // x, y, angle, width, height
        var person = new Ellipse(1.5, 1, 1, 0, 1, 0.5); // centre, axis, half axes
        var post = new Circle(5, 0, 0.5);

        int hit = Query.Overlap(car, person) ? 1 : 0;
        double gap = Query.Nearest(car, post).Distance, iou = Query.Iou(car, person);
        Console.WriteLine(FormattableString.Invariant($"overlap {hit}, distance {gap:F3}, IoU {iou:F3}"));
    }
}
