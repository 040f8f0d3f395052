// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
 * turns about its centre. Positive angles turn counter-clockwise if y points up.
 *
 * @param vx vx
 * @param vy vy
 * @param angle angle
 */
public record Turn(double vx, double vy, double angle) {
  static Turn of(double[] n) {
    return new Turn(n[0], n[1], n[2]);
  }
}
