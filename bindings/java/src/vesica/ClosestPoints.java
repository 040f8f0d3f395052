// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
 *
 * @param distance distance
 * @param ax ax
 * @param ay ay
 * @param bx bx
 * @param by by
 */
public record ClosestPoints(double distance, double ax, double ay, double bx, double by) {
  static ClosestPoints of(double[] n) {
    return new ClosestPoints(n[0], n[1], n[2], n[3], n[4]);
  }
}
