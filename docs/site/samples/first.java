import vesica.*;

class First {
    public static void main(String[] arguments) {
        Rect car = Vesica.rect(0, 0, Math.toRadians(36.87), 4, 2); // x, y, angle, width, height
        Ellipse person = new Ellipse(1.5, 1, 1, 0, 1, 0.5); // centre, axis, half axes
        Circle post = new Circle(5, 0, 0.5);

        int hit = Vesica.overlap(car, person) ? 1 : 0;
        double gap = Vesica.nearest(car, post).distance(), iou = Vesica.iou(car, person);
        System.out.printf("overlap %d, distance %.3f, IoU %.3f%n", hit, gap, iou);
    }
}
