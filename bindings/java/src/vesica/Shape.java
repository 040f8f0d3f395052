// SPDX-License-Identifier: Apache-2.0
package vesica;

/**
 * One shape: a record of its numbers.
 *
 * <p>Capsules and rounded rectangles are for check, bounds, shapeArea, overlap, relation, contains, nearest, depth,
 * signedDistance, within, area, iou, ratios, suppression, cast, impactTime, sweepBounds, and boundaryDistance but with
 * an ellipse; the same holds of arrays. An index of them has joins by overlap or distance, select, nearest and casts. Other methods throw a {@link
 * VesicaException} for them.
 */
public sealed interface Shape permits Point, Segment, Circle, Aabb, Rect, Ellipse, Capsule, RoundRect {
  /** Its kind. */
  Kind kind();

  /** Its numbers, in the library's order. */
  double[] numbers();

  /** From a kind and as many numbers as it has. */
  static Shape of(Kind kind, double... numbers) {
    if (numbers.length != Shapes.fields(kind)) {
      throw new IllegalArgumentException(
          kind + " has " + Shapes.fields(kind) + " numbers, not " + numbers.length);
    }
    return switch (kind) {
      case POINT -> Point.of(numbers);
      case SEGMENT -> Segment.of(numbers);
      case CIRCLE -> Circle.of(numbers);
      case AABB -> Aabb.of(numbers);
      case RECT -> Rect.of(numbers);
      case ELLIPSE -> Ellipse.of(numbers);
      case CAPSULE -> Capsule.of(numbers);
      case ROUND_RECT -> RoundRect.of(numbers);
    };
  }
}
