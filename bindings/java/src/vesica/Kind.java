// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * The six kinds of shapes.
 */
public enum Kind {
  /**
   * x y
   */
  POINT(0),
  /**
   * x0 y0 x1 y1
   */
  SEGMENT(1),
  /**
   * cx cy r
   */
  CIRCLE(2),
  /**
   * min_x min_y max_x max_y
   */
  AABB(3),
  /**
   * cx cy ux uy hx hy
   */
  RECT(4),
  /**
   * cx cy ux uy a b
   */
  ELLIPSE(5);

  /** The library's number. */
  public final int value;

  Kind(int value) {
    this.value = value;
  }

  private static final Kind[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Kind of(int value) {
    for (Kind each : ALL) if (each.value == value) return each;
    return null;
  }
}
