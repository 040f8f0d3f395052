// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * How a shape a relates to a shape b: the eight relations of RCC-8.
 */
public enum Relation {
  /**
   * a and b have no common point
   */
  DISJOINT(0),
  /**
   * they have common points, but their insides have none
   */
  TOUCH(1),
  /**
   * their insides meet, and neither shape contains the other
   */
  CROSS(2),
  /**
   * b contains a, and a has no point of b's outline
   */
  INSIDE(3),
  /**
   * b contains a, and a has points of b's outline
   */
  INSIDE_TOUCH(4),
  /**
   * a contains b, and b has no point of a's outline
   */
  CONTAINS(5),
  /**
   * a contains b, and b has points of a's outline
   */
  CONTAINS_TOUCH(6),
  /**
   * a and b are the same set of points
   */
  EQUAL(7);

  /** The library's number. */
  public final int value;

  Relation(int value) {
    this.value = value;
  }

  private static final Relation[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Relation of(int value) {
    for (Relation each : ALL) if (each.value == value) return each;
    return null;
  }
}
