// SPDX-License-Identifier: Apache-2.0
package vesica;

/** Chains of vertices, which are not closed and have no inside. */
public final class Polyline extends Path implements Shape {
  /**
   * Copies vertices.
   *
   * @param vertices x y x y ...
   * @param rings where each chain begins among the vertices, with the end; none if all are of one chain
   */
  public Polyline(double[] vertices, int... rings) {
    super(vertices, rings);
  }

  @Override
  public Kind kind() {
    return Kind.POLYLINE;
  }
}
