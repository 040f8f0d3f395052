// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * Whether two shapes are at most so far apart.
 */
public enum Within {
  /**
   * they are farther apart
   */
  NO(0),
  /**
   * they are at most that far apart
   */
  YES(1),
  /**
   * only with an ellipse: their distance is too close to the one asked for to tell
   */
  NEARLY(2);

  /** The library's number. */
  public final int value;

  Within(int value) {
    this.value = value;
  }

  private static final Within[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Within of(int value) {
    for (Within each : ALL) if (each.value == value) return each;
    return null;
  }
}
