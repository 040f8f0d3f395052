// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 &lt;= 1, where C is (cx, cy); a, b &gt;= 0 and u != (0, 0).
 *
 * @param cx cx
 * @param cy cy
 * @param ux ux
 * @param uy uy
 * @param a a
 * @param b b
 */
public record Ellipse(double cx, double cy, double ux, double uy, double a, double b) implements Shape {
  static Ellipse of(double[] n) {
    return new Ellipse(n[0], n[1], n[2], n[3], n[4], n[5]);
  }

  @Override
  public Kind kind() {
    return Kind.ELLIPSE;
  }

  @Override
  public double[] numbers() {
    return new double[] {cx, cy, ux, uy, a, b};
  }
}
