// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/**
 * What a shared area is compared with.
 */
public enum Ratio {
  /**
   * shared area / area of the union of a and b (IoU)
   */
  OVER_UNION(0),
  /**
   * shared area / area of a (IoF)
   */
  OVER_FIRST(1),
  /**
   * shared area / area of b (IoA)
   */
  OVER_SECOND(2),
  /**
   * shared area / the smaller of the areas (IoS)
   */
  OVER_SMALLER(3),
  /**
   * IoU - (area of the hull that neither covers / area of the hull) (GIoU)
   */
  GENERALIZED(4),
  /**
   * IoU - (distance of the centres / diagonal of the hull)^2 (DIoU)
   */
  DISTANCE(5),
  /**
   * DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU)
   */
  COMPLETE(6);

  /** The library's number. */
  public final int value;

  Ratio(int value) {
    this.value = value;
  }

  private static final Ratio[] ALL = values();

  /** The one with a number of the library's; null if there is none. */
  public static Ratio of(int value) {
    for (Ratio each : ALL) if (each.value == value) return each;
    return null;
  }
}
