// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * What makes item a of one index and item b of another a pair of a join.
 */
public enum JoinQuery {
  /**
   * a and b overlap, as by vesica_overlap_f64
   */
  OVERLAP(0),
  /**
   * their bounds in the indexes do: all pairs that overlap, and some that do not
   */
  BOUNDS(1),
  /**
   * a contains b, as by vesica_contains_f64
   */
  CONTAINS(2),
  /**
   * b contains a
   */
  INSIDE(3);

  /** The library's number. */
  public final int value;

  JoinQuery(int value) {
    this.value = value;
  }

  private static final JoinQuery[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static JoinQuery of(int value) {
    for (JoinQuery each : ALL) if (each.value == value) return each;
    return null;
  }
}
