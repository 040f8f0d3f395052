// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
 *
 * @param depth depth
 * @param x x
 * @param y y
 */
public record Penetration(double depth, double x, double y) {
  static Penetration of(double[] n) {
    return new Penetration(n[0], n[1], n[2]);
  }
}
