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
  /** No two of these kinds have more places, or more vertices of a shared region. */
  static final int MOST = 8;

  /** The first points of x0 y0 x1 y1 ... */
  static List<Point> points(double[] numbers, long count) {
    Point[] points = new Point[(int) count];
    for (int i = 0; i < count; i++) points[i] = new Point(numbers[2 * i], numbers[2 * i + 1]);
    return List.of(points);
  }
}
