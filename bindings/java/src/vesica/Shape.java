// SPDX-License-Identifier: Apache-2.0
package vesica;

/**
 * One shape: a record of its numbers, or a polygon or polyline of any number of vertices.
 *
 * <p>Capsules and rounded rectangles are for check, bounds, shapeArea, overlap, relation, contains, nearest, depth,
 * signedDistance, within, area, iou, ratios, suppression, cast, impactTime, sweepBounds, and boundaryDistance but with
 * an ellipse; the same holds of arrays. An index of them has joins by overlap or distance, select, nearest and casts. Other methods throw a {@link
 * VesicaException} for them.
 *
 * <p>Polygons and polylines are for the same but impactTime, and for boundaryDistance with any kind; polylines have no
 * area. depth needs convex ones; so do signedDistance and within where they ask for a depth.
 */
public sealed interface Shape
    permits Point, Segment, Circle, Aabb, Rect, Ellipse, Capsule, RoundRect, Polygon, Polyline {
  /** Its kind. */
  Kind kind();

  /** Its numbers, in the library's order; of polygons and polylines the vertices x y x y ... */
  double[] numbers();

  /** From a kind and as many numbers as it has; of polygons and polylines the vertices of one ring or chain. */
  static Shape of(Kind kind, double... numbers) {
    if (!Path.is(kind) && numbers.length != Shapes.fields(kind)) {
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
      case POLYGON -> new Polygon(numbers);
      case POLYLINE -> new Polyline(numbers);
    };
  }
}
