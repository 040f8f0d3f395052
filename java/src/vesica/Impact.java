// SPDX-License-Identifier: Apache-2.0
// Written by capi/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A first contact: when, where and along which normal.
 *
 * <p>(nx, ny) is the unit normal at (x, y) from a to b. After a miss t is infinity and all other numbers are NaN.
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
