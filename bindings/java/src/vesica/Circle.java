// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A disc: centre and radius, r &gt;= 0.
 *
 * @param cx cx
 * @param cy cy
 * @param r r
 */
public record Circle(double cx, double cy, double r) implements Shape {
  static Circle of(double[] n) {
    return new Circle(n[0], n[1], n[2]);
  }

  @Override
  public Kind kind() {
    return Kind.CIRCLE;
  }

  @Override
  public double[] numbers() {
    return new double[] {cx, cy, r};
  }
}
