// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * How angles are told. They turn from +x towards +y.
 */
public enum Angle {
  /**
   * radians
   */
  RADIANS(0),
  /**
   * degrees
   */
  DEGREES(1),
  /**
   * quarter turns
   */
  QUARTERS(2),
  /**
   * added to a unit: angles turn the other way, from +x towards -y
   */
  REVERSED(4);

  /** The library's number. */
  public final int value;

  Angle(int value) {
    this.value = value;
  }

  private static final Angle[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Angle of(int value) {
    for (Angle each : ALL) if (each.value == value) return each;
    return null;
  }
}
