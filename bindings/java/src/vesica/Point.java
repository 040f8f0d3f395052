// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A location.
 *
 * @param x x
 * @param y y
 */
public record Point(double x, double y) implements Shape {
  static Point of(double[] n) {
    return new Point(n[0], n[1]);
  }

  @Override
  public Kind kind() {
    return Kind.POINT;
  }

  @Override
  public double[] numbers() {
    return new double[] {x, y};
  }
}
