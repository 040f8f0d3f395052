// SPDX-License-Identifier: Apache-2.0
package vesica;

/**
 * Rings of vertices, each joined to a closed curve. What an odd number of them goes around is inside: a ring inside
 * another is a hole, whatever their order and directions.
 */
public final class Polygon extends Path implements Shape {
  /**
   * Copies vertices.
   *
   * @param vertices x y x y ...
   * @param rings where each ring begins among the vertices, with the end; none if all are of one ring
   */
  public Polygon(double[] vertices, int... rings) {
    super(vertices, rings);
  }

  @Override
  public Kind kind() {
    return Kind.POLYGON;
  }
}
