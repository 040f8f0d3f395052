// SPDX-License-Identifier: Apache-2.0
/// Segments, by exact signs: which of a shape's parts their two ends are on, and along which side they lie.
#pragma once

#include <vesica/crossings/box_box.hpp>
#include <vesica/crossings/inflated.hpp>
#include <vesica/de9im/matrix.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::detail::de9im {

using crossings::Corners;
using crossings::Edge;
using crossings::Polygon;
using crossings::Sides;

/// On which parts of another shape the ends of a segment are.
struct Ends {
  bool inside = false, outline = false, outside = false;

  /// sign: 1 inside, 0 on the outline, -1 outside.
  void add(int sign) noexcept { (sign > 0 ? inside : sign == 0 ? outline : outside) = true; }
};

/// For a polygon with area, from the sides of its edges.
inline Ends ends_in_polygon(const Sides& of_b) noexcept {
  Ends ends;
  for (int end = 0; end < 2; ++end) {
    int least = 1;
    for (int edge = 0; edge < 4; ++edge) least = of_b.sign[edge][end] < least ? of_b.sign[edge][end] : least;
    ends.add(least);
  }
  return ends;
}

/// True if a segment has a stretch in common with a side.
inline bool lies_along_side(const Polygon& a, const Sides& of_a, const Polygon& b) noexcept {
  for (int j = 0; j < b.corners.edges; ++j) {
    const bool on_line = of_a.sign[0][j] == 0 && of_a.sign[0][b.corners.next(j)] == 0;
    if (on_line && crossings::share_stretch(Edge(a.corners, 0), Edge(b.corners, j))) return true;
  }
  return false;
}

/// A point and a segment: 1 on the segment between the ends, 0 an end, -1 elsewhere.
inline int place_on_segment(const Corners& segment, int side, const crossings::Position& x,
                            const crossings::Position& y) noexcept {
  if (side != 0) return -1;
  if (crossings::is_corner(segment, 0, x, y) || crossings::is_corner(segment, 1, x, y)) return 0;
  const crossings::Shadow shadow(Edge(segment, 0));
  const crossings::Position& at = shadow.of(x, y);
  return shadow.after_start(at) && shadow.before_end(at) ? 1 : -1;
}

inline Ends ends_on_segment(const Corners& ends, const Corners& segment, const Sides& of_segment) noexcept {
  Ends found;
  for (int i = 0; i < 2; ++i) found.add(place_on_segment(segment, of_segment.sign[0][i], ends.x[i], ends.y[i]));
  return found;
}

/// Two segments that share a point.
VESICA_COLD inline NineIntersections of_segments(const exact::Box& box_a, const exact::Box& box_b,
                                                 Relation r) noexcept {
  const Polygon a(box_a), b(box_b);
  const Sides of_a(a, b), of_b(b, a);
  const Ends in_b = ends_on_segment(a.corners, b.corners, of_b), in_a = ends_on_segment(b.corners, a.corners, of_a);
  const bool along = of_a.sign[0][0] == 0 && of_a.sign[0][1] == 0;
  const char insides = r == Relation::touch ? 'F' : dimension(along ? 1 : 0);
  return {{insides, point_if(in_a.inside), line_if(in_b.outside), point_if(in_b.inside), point_if(in_b.outline),
           point_if(in_b.outside), line_if(in_a.outside), point_if(in_a.outside), '2', 0}};
}

/// A segment and an area that share a point: their insides meet, or a stretch of the outline is shared. If
/// the insides meet, the open segment meets the outline where it leaves the area. If not, it has a stretch of it, or a
/// single point, which may be its end.
inline NineIntersections of_segment_and_area(const Ends& ends, bool insides, bool stretch) noexcept {
  const char outline = insides ? point_if(ends.outside) : stretch ? '1' : point_if(!ends.outline);
  return {{line_if(insides), outline, line_if(ends.outside), point_if(ends.inside), point_if(ends.outline),
           point_if(ends.outside), '2', '1', '2', 0}};
}

/// A segment within a rectangle meets its inside unless it lies along a side.
VESICA_COLD inline NineIntersections of_segment_and_box(const exact::Box& box_a, const exact::Box& box_b,
                                                        Relation r) noexcept {
  const Polygon a(box_a), b(box_b);
  const Sides of_a(a, b), of_b(b, a);
  const bool stretch = r != Relation::cross && lies_along_side(a, of_a, b);
  const bool insides = r != Relation::touch && !stretch;
  return of_segment_and_area(ends_in_polygon(of_b), insides, stretch);
}

/// The place of a point in an ellipse with area, as Ends::add() takes it. Degree 10.
inline int place_in(const exact::Ellipse& e, const crossings::Position& x, const crossings::Position& y) noexcept {
  const auto dx = x - e.cx, dy = y - e.cy;
  const auto along = e.b * exact::dot(e.ux, e.uy, dx, dy), across = e.a * exact::cross(e.ux, e.uy, dx, dy);
  return exact::side_of_rim(along, across, e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy));
}

VESICA_COLD inline NineIntersections of_segment_and_ellipse(const exact::Box& box_a, const exact::Ellipse& b,
                                                            Relation r) noexcept {
  const Corners a(box_a);
  Ends ends;
  for (int i = 0; i < 2; ++i) ends.add(place_in(b, a.x[i], a.y[i]));
  return of_segment_and_area(ends, r != Relation::touch, false);
}

/// The place of a point in a shape with a radius above 0. Degree 6.
inline int place_in(const crossings::RoundOutline& o, const crossings::Position& x,
                    const crossings::Position& y) noexcept {
  const exact::Box& core = o.corners.box;
  const auto dx = x - core.cx, dy = y - core.cy;
  const auto& unit = o.unit.square;
  auto along = exact::abs(exact::dot(core.ux, core.uy, dx, dy)) - core.hx * unit;
  auto across = exact::abs(exact::cross(core.ux, core.uy, dx, dy)) - core.hy * unit;
  if (along.sign < 0) along = {};
  if (across.sign < 0) across = {};
  return exact::compare(exact::square(o.radius) * unit, exact::square(along) + exact::square(across));
}

/// A segment in such a shape meets its inside unless it lies along an edge.
VESICA_COLD inline NineIntersections of_segment_and_outline(const exact::Box& box_a, const crossings::RoundOutline& b,
                                                            Relation r) noexcept {
  const crossings::RoundOutline a(box_a, {});
  Ends ends;
  for (int i = 0; i < 2; ++i) ends.add(place_in(b, a.corners.x[i], a.corners.y[i]));
  const bool stretch = r != Relation::cross && crossings::share_stretch(a, b);
  return of_segment_and_area(ends, r != Relation::touch && !stretch, stretch);
}

}  // namespace vesica::detail::de9im
