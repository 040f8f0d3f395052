// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * All points C + s u + t perp(u) with |s| &lt;= hx and |t| &lt;= hy, where C is (cx, cy); hx, hy &gt;= 0 and u != (0,
 * 0).
 *
 * @param cx cx
 * @param cy cy
 * @param ux ux
 * @param uy uy
 * @param hx hx
 * @param hy hy
 */
public record Rect(double cx, double cy, double ux, double uy, double hx, double hy) implements Shape {
  static Rect of(double[] n) {
    return new Rect(n[0], n[1], n[2], n[3], n[4], n[5]);
  }

  @Override
  public Kind kind() {
    return Kind.RECT;
  }

  @Override
  public double[] numbers() {
    return new double[] {cx, cy, ux, uy, hx, hy};
  }
}
