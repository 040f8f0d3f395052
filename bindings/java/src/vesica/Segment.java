// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * All points between two end points. If the two are the same, the segment is a point.
 *
 * @param x0 x0
 * @param y0 y0
 * @param x1 x1
 * @param y1 y1
 */
public record Segment(double x0, double y0, double x1, double y1) implements Shape {
  static Segment of(double[] n) {
    return new Segment(n[0], n[1], n[2], n[3]);
  }

  @Override
  public Kind kind() {
    return Kind.SEGMENT;
  }

  @Override
  public double[] numbers() {
    return new double[] {x0, y0, x1, y1};
  }
}
