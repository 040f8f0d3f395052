// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

/**
 * Arrays of boxes as detectors write them, five numbers each: centre x, centre y, width along the angle, height across
 * it, angle. Multiples of 90 degrees turn exactly. An invalid box or shape gives NaN throughout, all others are
 * written, and there is an exception, which has the result.
 */
public final class Boxes {
  private Boxes() {}

  /** Rectangles from boxes, one after the other: a double[], float[] or direct buffer. */
  public static Shapes rects(Object boxes, Angle unit) {
    return rects(boxes, 5, unit, false);
  }

  /** Rectangles from rows of {@code size} numbers, of which five are a box; reversed: angles turn the other way. */
  public static Shapes rects(Object boxes, int size, Angle unit, boolean reversed) {
    return shapes(Kind.RECT, boxes, size, unit, reversed);
  }

  /** Ellipses from the boxes about them, whose sides they touch in the middle. */
  public static Shapes ellipses(Object boxes, int size, Angle unit, boolean reversed) {
    return shapes(Kind.ELLIPSE, boxes, size, unit, reversed);
  }

  private static int number(Angle unit, boolean reversed) {
    return unit.value + (reversed ? Angle.REVERSED.value : 0);
  }

  private static Shapes shapes(Kind kind, Object boxes, int size, Angle unit, boolean reversed) {
    int length = Shapes.length(boxes, "boxes");
    if (size < 5 || length % size != 0) {
      throw new IllegalArgumentException(length + " numbers are no rows of " + size + ", of which 5 are a box's");
    }
    boolean wide = Shapes.isWide(boxes);
    int count = length / size, angle = number(unit, reversed);
    long stride = (long) size * (wide ? Double.BYTES : Float.BYTES);
    Object out = wide ? new double[6 * count] : new float[6 * count];
    long code =
        kind == Kind.RECT
            ? Native.rectsFromBoxes(wide, boxes, count, stride, angle, out)
            : Native.ellipsesFromBoxes(wide, boxes, count, stride, angle, out);
    return VesicaException.finished(code, Shapes.of(kind, out));
  }

  /** The way back: five numbers of each rectangle, or of the box about each ellipse. */
  public static void of(Shapes shapes, Angle unit, boolean reversed, Object out) {
    Vesica.output("out", out, shapes, shapes, 5 * shapes.count);
    checked(Native.boxesFromShapes(shapes.wide, shapes, number(unit, reversed), out));
  }

  /** The corners x0 y0 ... x3 y3 of each rectangle, or of the box about each ellipse. */
  public static void corners(Shapes shapes, Object out) {
    Vesica.output("out", out, shapes, shapes, 8 * shapes.count);
    checked(Native.cornersOfShapes(shapes.wide, shapes, out));
  }

  /** The smallest boxes along the axes of representable numbers that contain shapes: four numbers of each. */
  public static void bounds(Shapes shapes, Object out) {
    Vesica.output("out", out, shapes, shapes, 4 * shapes.count);
    checked(Native.boundsMany(shapes.wide, shapes, out));
  }
}
