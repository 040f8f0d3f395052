// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
 *
 * <p>After a miss t is infinity and all other numbers are NaN.
 *
 * @param t t
 * @param x x
 * @param y y
 * @param nx nx
 * @param ny ny
 */
public record Impact(double t, double x, double y, double nx, double ny) {
  static Impact of(double[] n) {
    return new Impact(n[0], n[1], n[2], n[3], n[4]);
  }
}
