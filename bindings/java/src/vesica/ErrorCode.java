// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * Why the library has no answer.
 */
public enum ErrorCode {
  /**
   * a pointer is NULL
   */
  NULL(-1),
  /**
   * a shape is invalid; vesica_check_f64 or _f32 says why
   */
  SHAPE(-2),
  /**
   * a kind is not one of the six
   */
  KIND(-3),
  /**
   * another argument is out of its documented range
   */
  ARGUMENT(-4),
  /**
   * a number is NaN or infinite
   */
  NOT_FINITE(-5),
  /**
   * a radius, half extent or half length is negative
   */
  NEGATIVE_SIZE(-6),
  /**
   * the axis (ux, uy) is (0, 0)
   */
  ZERO_AXIS(-7),
  /**
   * an AABB's min exceeds its max
   */
  INVERTED(-8),
  /**
   * a number of the result would overflow its type
   */
  RANGE(-9),
  /**
   * bytes are not an index of this version, or are damaged
   */
  INDEX(-10);

  /** The library's number. */
  public final int value;

  ErrorCode(int value) {
    this.value = value;
  }

  private static final ErrorCode[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static ErrorCode of(int value) {
    for (ErrorCode each : ALL) if (each.value == value) return each;
    return null;
  }
}
