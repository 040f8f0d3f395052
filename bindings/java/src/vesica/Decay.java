// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * How soft suppression lowers scores.
 */
public enum Decay {
  /**
   * score * (1 - r) if r exceeds the parameter, a threshold from 0 to 1
   */
  LINEAR(0),
  /**
   * score * exp(-r^2 / parameter) if r &gt; 0; the parameter is at least 2^-100
   */
  GAUSSIAN(1);

  /** The library's number. */
  public final int value;

  Decay(int value) {
    this.value = value;
  }

  private static final Decay[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Decay of(int value) {
    for (Decay each : ALL) if (each.value == value) return each;
    return null;
  }
}
