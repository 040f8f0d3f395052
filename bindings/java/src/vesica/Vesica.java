// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.nio.Buffer;
import java.nio.ReadOnlyBufferException;
import java.util.Arrays;
import java.util.List;

/**
 * Exact overlap queries between plain 2D shapes.
 *
 * <pre>{@code
 * Rect car = Vesica.rect(0, 0, 0.5, 4, 2);                       // centre, angle, width, height
 * Vesica.overlap(car, new Circle(1.4, 1.5, 0.5));                // true
 * Vesica.nearest(car, new Circle(8, 1, 0.5)).distance();
 *
 * Shapes cars = Shapes.of(Kind.RECT, numbers);                   // double[], float[] or direct buffers
 * Vesica.overlapMany(cars, Shapes.of(Kind.CIRCLE, people), hits);
 * long[][] pairs = new Index(cars).join();                       // all pairs that overlap, among millions
 * }</pre>
 *
 * Shapes are closed and solid, and touching is overlap. Answers that are yes or no are exact for every valid input. An
 * invalid shape is a {@link VesicaException}; in a batch all other answers are written all the same. All methods may be
 * called by several threads at once.
 */
public final class Vesica {
  private Vesica() {}

  // ---- Two shapes, or one ----

  /** Do two shapes share a point? Touching counts. Exact. */
  public static boolean overlap(Shape a, Shape b) {
    return checked(Native.overlapF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b))) == 1;
  }

  /** Do the insides of two shapes share a point? Touching does not count. Exact. */
  public static boolean interiorsOverlap(Shape a, Shape b) {
    return checked(Native.interiorsOverlapF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b))) == 1;
  }

  /** How does a relate to b? Exact. */
  public static Relation relation(Shape a, Shape b) {
    return Relation.of((int) checked(Native.relationF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b))));
  }

  /** Does a hold all of b? Equal shapes do. Exact. */
  public static boolean contains(Shape a, Shape b) {
    return checked(Native.containsF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b))) == 1;
  }

  /** The places where the outlines meet. Their number is exact. */
  public static Crossings crossings(Shape a, Shape b) {
    int[] shared = new int[1];
    int kindA = a.kind().value, kindB = b.kind().value;
    List<Point> places =
        Crossings.points(
            (out, room) -> checked(Native.crossingsF64(kindA, Path.lent(a), kindB, Path.lent(b), out, room, shared)));
    return new Crossings(places, shared[0] != 0);
  }

  /** How far are the solid shapes apart, and which of their points are closest? */
  public static ClosestPoints nearest(Shape a, Shape b) {
    double[] out = new double[5];
    checked(Native.nearestF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return ClosestPoints.of(out);
  }

  /** How far are the outlines apart, that of a shape inside another too? */
  public static ClosestPoints boundaryDistance(Shape a, Shape b) {
    double[] out = new double[5];
    checked(Native.boundaryDistanceF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return ClosestPoints.of(out);
  }

  /** How far and in which direction must b move until it only touches a? */
  public static Penetration depth(Shape a, Shape b) {
    double[] out = new double[3];
    checked(Native.depthF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return Penetration.of(out);
  }

  /** The area that a and b share. */
  public static double area(Shape a, Shape b) {
    double[] out = new double[1];
    checked(Native.areaF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return out[0];
  }

  /** Intersection over union, from 0 to 1. */
  public static double iou(Shape a, Shape b) {
    double[] out = new double[1];
    checked(Native.iouF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return out[0];
  }

  /** Throws, with the first rule that it breaks, if a shape is invalid. */
  public static void check(Shape shape) {
    checked(Native.checkF64(shape.kind().value, Path.lent(shape)));
  }

  /** The area of one shape. */
  public static double shapeArea(Shape shape) {
    double[] out = new double[1];
    checked(Native.shapeAreaF64(shape.kind().value, Path.lent(shape), out));
    return out[0];
  }

  /** The smallest box of doubles that contains a shape. */
  public static Aabb bounds(Shape shape) {
    double[] out = new double[4];
    checked(Native.boundsF64(shape.kind().value, Path.lent(shape), out));
    return Aabb.of(out);
  }

  // ---- Shapes from other descriptions ----

  /** Box with two opposite corners, in any order. */
  public static Aabb aabb(double x0, double y0, double x1, double y1) {
    double[] out = new double[4];
    checked(Native.aabbFromCornersF64(x0, y0, x1, y1, out));
    return Aabb.of(out);
  }

  /** Rectangle from centre, angle in radians, and whole sizes: width along the angle, height across it. */
  public static Rect rect(double cx, double cy, double angle, double width, double height) {
    double[] out = new double[6];
    checked(Native.rectFromAngleF64(cx, cy, angle, width, height, out));
    return Rect.of(out);
  }

  /** Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline; crossed corners are refused. */
  public static Rect rectFromCorners(double... corners) {
    if (corners.length != 8) throw new IllegalArgumentException("four corners have 8 numbers, not " + corners.length);
    double[] out = new double[6];
    checked(Native.rectFromCornersF64(corners, out));
    return Rect.of(out);
  }

  /** The largest distance from a given corner to the rectangle's corner that corresponds to it. */
  public static double rectCornersMisfit(double[] corners, Rect rect) {
    if (corners.length != 8) throw new IllegalArgumentException("four corners have 8 numbers, not " + corners.length);
    double[] out = new double[1];
    checked(Native.rectCornersMisfitF64(corners, rect.numbers(), out));
    return out[0];
  }

  /**
   * Rounded rectangle from centre, angle in radians, whole sizes with the round corners included, and their radius. A
   * radius of more than half the width or height is refused.
   */
  public static RoundRect roundRect(double cx, double cy, double angle, double width, double height, double radius) {
    double[] out = new double[7];
    checked(Native.roundRectFromAngleF64(cx, cy, angle, width, height, radius, out));
    return RoundRect.of(out);
  }

  /** Capsule from centre, angle in radians, the length between the ends of its segment, and radius. */
  public static Capsule capsule(double cx, double cy, double angle, double length, double radius) {
    double[] out = new double[5];
    checked(Native.capsuleFromAngleF64(cx, cy, angle, length, radius, out));
    return Capsule.of(out);
  }

  /** Capsule from the ends of its segment and its whole width, twice the radius. */
  public static Capsule capsuleFromWidth(double x0, double y0, double x1, double y1, double width) {
    double[] out = new double[5];
    checked(Native.capsuleFromWidthF64(x0, y0, x1, y1, width, out));
    return Capsule.of(out);
  }

  /** Ellipse from centre, angle in radians, and half lengths: a along the angle, b across it. */
  public static Ellipse ellipse(double cx, double cy, double angle, double a, double b) {
    double[] out = new double[6];
    checked(Native.ellipseFromAngleF64(cx, cy, angle, a, b, out));
    return Ellipse.of(out);
  }

  /** One half axis is (wx, wy), the other ratio times its perpendicular. */
  public static Ellipse ellipseFromRadiusVector(double cx, double cy, double wx, double wy, double ratio) {
    double[] out = new double[6];
    checked(Native.ellipseFromRadiusVectorF64(cx, cy, wx, wy, ratio, out));
    return Ellipse.of(out);
  }

  /** Ellipse of the points within k standard deviations of a mean. */
  public static Ellipse ellipseFromCovariance(
      double meanX, double meanY, double cxx, double cxy, double cyy, double k) {
    double[] out = new double[6];
    checked(Native.ellipseFromCovarianceF64(meanX, meanY, cxx, cxy, cyy, k, out));
    return Ellipse.of(out);
  }

  /** Ellipse of the points X with (X - C) . M (X - C) at most 1. */
  public static Ellipse ellipseFromMatrix(double cx, double cy, double mxx, double mxy, double myy) {
    double[] out = new double[6];
    checked(Native.ellipseFromMatrixF64(cx, cy, mxx, mxy, myy, out));
    return Ellipse.of(out);
  }

  // ---- Arrays in step; of one shape and an array, the one is repeated ----
  // Numbers are written to a double[], float[], or direct DoubleBuffer or FloatBuffer, as the shapes have them.

  /** Do a[i] and b[i] share a point? Returns how many do. */
  public static long overlapMany(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, inStep(a, b));
    return checked(Native.overlapMany(a.wide, a, b, out));
  }

  /** Do the insides of a[i] and b[i] share a point? Returns how many do. */
  public static long interiorsOverlapMany(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, inStep(a, b));
    return checked(Native.interiorsOverlapMany(a.wide, a, b, out));
  }

  /** How does a[i] relate to b[i]? The values of {@link Relation}. Returns how many are not disjoint. */
  public static long relationMany(Shapes a, Shapes b, byte[] out) {
    room("out", out.length, inStep(a, b));
    return checked(Native.relationMany(a.wide, a, b, out));
  }

  /** Does a[i] hold all of b[i]? Returns how many do. */
  public static long containsMany(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, inStep(a, b));
    return checked(Native.containsMany(a.wide, a, b, out));
  }

  /** The area that a[i] and b[i] share. Returns how many are above 0. */
  public static long areaMany(Shapes a, Shapes b, Object out) {
    return checked(Native.areaMany(a.wide, a, b, output("out", out, a, b, inStep(a, b))));
  }

  /** Intersection over union of a[i] and b[i]. Returns how many are above 0. */
  public static long iouMany(Shapes a, Shapes b, Object out) {
    return checked(Native.iouMany(a.wide, a, b, output("out", out, a, b, inStep(a, b))));
  }

  /** How far are a[i] and b[i] apart, and where? Columns may be null, but not all. Returns how many overlap. */
  public static long nearestMany(Shapes a, Shapes b, Object distance, Object ax, Object ay, Object bx, Object by) {
    Object[] out = columns(a, b, inStep(a, b), distance, ax, ay, bx, by);
    return checked(Native.nearestMany(a.wide, a, b, out[0], out[1], out[2], out[3], out[4]));
  }

  /** How far are the outlines of a[i] and b[i] apart? Columns as nearestMany. Returns how many meet. */
  public static long boundaryDistanceMany(
      Shapes a, Shapes b, Object distance, Object ax, Object ay, Object bx, Object by) {
    Object[] out = columns(a, b, inStep(a, b), distance, ax, ay, bx, by);
    return checked(Native.boundaryDistanceMany(a.wide, a, b, out[0], out[1], out[2], out[3], out[4]));
  }

  /** How deep do a[i] and b[i] overlap? Columns may be null, but not all. Returns how many depths are above 0. */
  public static long depthMany(Shapes a, Shapes b, Object depth, Object x, Object y) {
    Object[] out = columns(a, b, inStep(a, b), depth, x, y);
    return checked(Native.depthMany(a.wide, a, b, out[0], out[1], out[2]));
  }

  // ---- Every a with every b: element i * b.count() + j is of a[i] and b[j] ----

  /** Does each of a overlap each of b? Returns how many pairs do. */
  public static long overlapMatrix(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, pairs(a, b));
    return checked(Native.overlapMatrix(a.wide, a, b, out, b.count));
  }

  /** Do the insides of each of a and each of b share a point? Returns how many pairs do. */
  public static long interiorsOverlapMatrix(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, pairs(a, b));
    return checked(Native.interiorsOverlapMatrix(a.wide, a, b, out, b.count));
  }

  /** How does each of a relate to each of b? Returns how many pairs are not disjoint. */
  public static long relationMatrix(Shapes a, Shapes b, byte[] out) {
    room("out", out.length, pairs(a, b));
    return checked(Native.relationMatrix(a.wide, a, b, out, b.count));
  }

  /** Does each of a hold all of each of b? Returns how many pairs do. */
  public static long containsMatrix(Shapes a, Shapes b, boolean[] out) {
    room("out", out.length, pairs(a, b));
    return checked(Native.containsMatrix(a.wide, a, b, out, b.count));
  }

  /** The area that each of a shares with each of b. Returns how many are above 0. */
  public static long areaMatrix(Shapes a, Shapes b, Object out) {
    return checked(Native.areaMatrix(a.wide, a, b, output("out", out, a, b, pairs(a, b)), b.count));
  }

  /** Intersection over union of each of a with each of b. Returns how many are above 0. */
  public static long iouMatrix(Shapes a, Shapes b, Object out) {
    return checked(Native.iouMatrix(a.wide, a, b, output("out", out, a, b, pairs(a, b)), b.count));
  }

  /** The distance of each of a from each of b. Returns how many pairs overlap. */
  public static long nearestMatrix(Shapes a, Shapes b, Object out) {
    return checked(Native.nearestMatrix(a.wide, a, b, output("out", out, a, b, pairs(a, b)), b.count));
  }

  /** The distance of the outline of each of a from that of each of b. Returns how many pairs of outlines meet. */
  public static long boundaryDistanceMatrix(Shapes a, Shapes b, Object out) {
    return checked(Native.boundaryDistanceMatrix(a.wide, a, b, output("out", out, a, b, pairs(a, b)), b.count));
  }

  /** How deep each of a and each of b overlap. Returns how many depths are above 0. */
  public static long depthMatrix(Shapes a, Shapes b, Object out) {
    return checked(Native.depthMatrix(a.wide, a, b, output("out", out, a, b, pairs(a, b)), b.count));
  }

  // ---- Choices among many ----

  /**
   * Which of many shapes overlap one? Their indices are written in ascending order, as many as there is room for.
   *
   * @return how many there are; after an exception about an invalid shape the others are written, and -1 ends them
   */
  public static long overlapSelect(Shapes one, Shapes many, long[] out) {
    alike(one.wide, many.wide);
    return checked(Native.overlapSelect(one.wide, one, many, out, out.length));
  }

  /** Which of many shapes have insides that share a point with that of one? Otherwise as {@link #overlapSelect}. */
  public static long interiorsOverlapSelect(Shapes one, Shapes many, long[] out) {
    alike(one.wide, many.wide);
    return checked(Native.interiorsOverlapSelect(one.wide, one, many, out, out.length));
  }

  /**
   * Greedy suppression: the indices of the shapes kept, best score first. Each has an intersection over union of at
   * most {@code threshold} with every better one that was kept. With float shapes the threshold is rounded to float
   * first.
   *
   * @param scores a double[], float[] or direct buffer, as the shapes' numbers
   */
  public static long[] nms(Shapes shapes, Object scores, double threshold) {
    long count = scores(shapes, scores);
    byte[] scratch = new byte[length(checked(Native.nmsScratch(count)))];
    long[] keep = new long[(int) count], kept = new long[1];
    int code = Native.nms(shapes.wide, shapes, scores, threshold, scratch, scratch.length, keep, kept);
    return VesicaException.finished(code, Arrays.copyOf(keep, (int) kept[0]));
  }

  // ---- What arguments must be ----

  /** How many scores there are: one for each shape, of its type. */
  static long scores(Shapes shapes, Object scores) {
    long count = Shapes.length(scores, "scores");
    if (count != shapes.count) {
      throw new IllegalArgumentException(shapes.count + " shapes need as many scores, not " + count);
    }
    output("scores", scores, shapes, count);
    return count;
  }

  static void alike(boolean wideA, boolean wideB) {
    if (wideA == wideB) return;
    throw new IllegalArgumentException("one array of shapes has double numbers and one float: convert one of them");
  }

  static long pairs(Shapes a, Shapes b) {
    alike(a.wide, b.wide);
    return Math.multiplyExact(a.count, b.count);
  }

  static long inStep(Shapes a, Shapes b) {
    alike(a.wide, b.wide);
    if (a.count == b.count || b.count == 1) return a.count;
    if (a.count == 1) return b.count;
    throw new IllegalArgumentException(
        "a has " + a.count + " shapes and b " + b.count + ": as many are needed, or one of either");
  }

  static void room(String name, long given, long needed) {
    if (given >= needed) return;
    throw new IllegalArgumentException(name + " has " + given + " elements, where " + needed + " are needed");
  }

  /** How long an array of so many elements is. */
  static int length(long needed) {
    room("the longest array of Java's", Integer.MAX_VALUE - 8, needed);
    return (int) needed;
  }

  /** An array or buffer of so many numbers of the shapes' type. */
  private static Object output(String name, Object out, Shapes shapes, long needed) {
    long given = Shapes.length(out, name);
    alike(shapes.wide, Shapes.isWide(out));
    room(name, given, needed);
    return out;
  }

  /** The same of results about two arrays, which need memory of their own. */
  static Object output(String name, Object out, Shapes a, Shapes b, long needed) {
    output(name, out, a, needed);
    if (out instanceof Buffer buffer && buffer.isReadOnly()) throw new ReadOnlyBufferException();
    if (a.meets(out, needed) || b.meets(out, needed)) {
      throw new IllegalArgumentException(name + " overlaps an input: results need memory of their own");
    }
    return out;
  }

  /** Columns for so many results each, of which those that are null are not written. */
  static Object[] columns(Shapes a, Shapes b, long needed, Object... columns) {
    for (int i = 0; i < columns.length; i++) {
      if (columns[i] == null) continue;
      output("a column", columns[i], a, b, needed);
      for (int k = 0; k < i; k++) {
        if (columns[k] == null || !Shapes.shareMemory(columns[k], needed, columns[i], needed, a.wide)) continue;
        throw new IllegalArgumentException(
            "columns " + k + " and " + i + " overlap: results need memory of their own");
      }
    }
    return columns;
  }
}
