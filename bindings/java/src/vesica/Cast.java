// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * What a cast finds.
 */
public enum Cast {
  /**
   * no contact from 0 to t_end
   */
  MISS(0),
  /**
   * contact, the first after t = 0
   */
  HIT(1),
  /**
   * the shapes overlap at t = 0, as vesica_overlap_f64 tells
   */
  START(2),
  /**
   * only from vesica_impact_time_f64: none before t, and perhaps none later
   */
  NEAR(3);

  /** The library's number. */
  public final int value;

  Cast(int value) {
    this.value = value;
  }

  private static final Cast[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Cast of(int value) {
    for (Cast each : ALL) if (each.value == value) return each;
    return null;
  }
}
