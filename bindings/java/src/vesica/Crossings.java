// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.util.List;

/**
 * Where two outlines meet.
 *
 * @param places in order along the first shape's outline
 * @param shared whether they have a stretch in common
 */
public record Crossings(List<Point> places, boolean shared) {
  /** No two shapes but polygons and polylines have more places, or more vertices of a shared region. */
  static final int MOST = 12;

  /** What writes as many points as there is room for, and says how many there are. */
  interface Writer {
    long write(double[] out, long room);
  }

  /** All points that are written. It is asked again if they are more than MOST. */
  static List<Point> points(Writer writer) {
    double[] out = new double[2 * MOST];
    long count = writer.write(out, MOST);
    if (count > MOST) {
      out = new double[Math.multiplyExact(2, Math.toIntExact(count))];
      count = writer.write(out, count);
    }
    return points(out, count);
  }

  /** The first points of x0 y0 x1 y1 ... */
  static List<Point> points(double[] numbers, long count) {
    Point[] points = new Point[(int) count];
    for (int i = 0; i < count; i++) points[i] = new Point(numbers[2 * i], numbers[2 * i + 1]);
    return List.of(points);
  }
}
