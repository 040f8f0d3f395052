// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * A box along the coordinate axes, min_x &lt;= max_x and min_y &lt;= max_y.
 *
 * @param minX min_x
 * @param minY min_y
 * @param maxX max_x
 * @param maxY max_y
 */
public record Aabb(double minX, double minY, double maxX, double maxY) implements Shape {
  static Aabb of(double[] n) {
    return new Aabb(n[0], n[1], n[2], n[3]);
  }

  @Override
  public Kind kind() {
    return Kind.AABB;
  }

  @Override
  public double[] numbers() {
    return new double[] {minX, minY, maxX, maxY};
  }
}
