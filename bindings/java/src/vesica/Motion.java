// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.util.Optional;

/**
 * How a shape moves: by t times a velocity, t from 0 to an end. A ray is a point that moves. Whether there is contact
 * is exact, and times are rounded down. With float shapes velocity and end are rounded to float first.
 *
 * @param vx the velocity's x
 * @param vy the velocity's y
 * @param end 0 or more; infinity has no end
 */
public record Motion(double vx, double vy, double end) {
  /**
   * What a cast finds.
   *
   * @param cast whether there is contact
   * @param impact when and where; after a miss its time is infinity and the rest NaN
   */
  public record Contact(Cast cast, Impact impact) {}

  /**
   * The shape that is met first.
   *
   * @param item its number
   * @param impact when and where, the normal pointing to the shape that moves
   */
  public record First(long item, Impact impact) {}

  /**
   * What {@link #impactTime} finds.
   *
   * @param cast MISS: proved, there is no contact from 0 to 1. HIT: proved, there is contact after the time. NEAR: they
   *     come as near as the gap, and there may be contact later, or none; of a point and a segment, or two points,
   *     contact is never proved. START: they overlap at t = 0, exactly, and the gap is 0
   * @param impact the time, the point of a that is then nearest to b, and the normal that separates them; after a miss
   *     the time is infinity and the rest NaN
   * @param gap how far apart they are at that time, at most
   */
  public record ImpactTime(Cast cast, Impact impact, double gap) {}

  /**
   * When do two shapes that move and turn touch first, t from 0 to 1? Proved: there is no contact before the time that
   * is told, however thin they are and however fast they turn.
   *
   * @param turnA what a does until t is 1: how far its centre moves, and by how much it turns about that, at most 2^20
   *     radians; at t it has done t times that
   * @param tolerance a length above 0, which the gap is not above, but for rounding and very long searches, as
   *     vesica_motion.h tells
   */
  public static ImpactTime impactTime(Shape a, Turn turnA, Shape b, Turn turnB, double tolerance) {
    double[] out = new double[5], gap = new double[1];
    int kindA = a.kind().value, kindB = b.kind().value;
    double[] byA = {turnA.vx(), turnA.vy(), turnA.angle()}, byB = {turnB.vx(), turnB.vy(), turnB.angle()};
    long code =
        checked(Native.impactTimeF64(kindA, Path.lent(a), byA, kindB, Path.lent(b), byB, tolerance, out, gap));
    return new ImpactTime(Cast.of((int) code), Impact.of(out), gap[0]);
  }

  /** Does b touch a while it moves, when first, and where? The normal is from a to b. */
  public Contact cast(Shape a, Shape b) {
    double[] out = new double[5];
    int kindA = a.kind().value, kindB = b.kind().value;
    long code = checked(Native.castF64(kindA, Path.lent(a), kindB, Path.lent(b), vx, vy, end, out));
    return new Contact(Cast.of((int) code), Impact.of(out));
  }

  /**
   * Which of many shapes at rest does a single moving one touch first? The lowest of several. With float shapes the
   * motion is rounded to float first.
   */
  public Optional<First> castFirst(Shapes one, Shapes many) {
    Vesica.alike(one.wide, many.wide);
    Object out = one.wide ? new double[5] : new float[5];
    long item = checked(Native.castFirst(one.wide, one, many, vx, vy, end, out));
    return first(item, many.count, out);
  }

  /** What a cast at many found: an item and the numbers of an impact, unless the item is their count. */
  static Optional<First> first(long item, long count, Object impact) {
    return item == count ? Optional.empty() : Optional.of(new First(item, Impact.of(Index.doubles(impact))));
  }

  /** A box that holds a shape throughout its motion. */
  public Aabb bounds(Shape shape) {
    double[] out = new double[4];
    checked(Native.sweepBoundsF64(shape.kind().value, Path.lent(shape), vx, vy, end, out));
    return Aabb.of(out);
  }

  /**
   * When, and where, does b[i] touch a[i]? There are as many velocities as shapes in step, or one. Columns may be null,
   * but not all. Of an invalid shape or velocity the numbers are NaN, all others are written, and there is an
   * exception. With float shapes {@code end} is rounded to float first.
   *
   * @return how many touch
   */
  public static long castMany(
      Shapes a, Shapes b, Object vx, Object vy, double end, Object t, Object x, Object y, Object nx, Object ny) {
    long needed = Vesica.inStep(a, b), given = Shapes.length(vx, "vx");
    if (given != Shapes.length(vy, "vy") || (given != needed && given != 1)) {
      throw new IllegalArgumentException("1 or " + needed + " velocities are needed, not " + given);
    }
    Vesica.alike(a.wide, Shapes.isWide(vx));
    Vesica.alike(a.wide, Shapes.isWide(vy));
    Object[] out = Vesica.columns(a, b, needed, t, x, y, nx, ny);
    for (Object column : out) {
      apart(column, needed, vx, given, a.wide);
      apart(column, needed, vy, given, a.wide);
    }
    long stride = given == 1 ? 0 : a.wide ? Double.BYTES : Float.BYTES;
    return checked(Native.castMany(a.wide, a, b, vx, vy, stride, end, out[0], out[1], out[2], out[3], out[4]));
  }

  private static void apart(Object column, long needed, Object velocities, long given, boolean wide) {
    if (column == null || !Shapes.shareMemory(column, needed, velocities, given, wide)) return;
    throw new IllegalArgumentException("a column overlaps the velocities: results need memory of their own");
  }
}
