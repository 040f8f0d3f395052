// SPDX-License-Identifier: Apache-2.0
/// A point of both outlines, for shapes whose outlines are known to meet (the outline of a point or a segment is all of
/// it). The candidate with the least error is taken, and that error is measured: where it is too large, as it may be of
/// needles, the caller takes one of the places that crossings.hpp finds.
#pragma once

#include <vesica/boundary_distance/edge.hpp>
#include <vesica/boundary_distance/ellipse_in_disc.hpp>
#include <vesica/nearest/near_outline.hpp>
#include <vesica/support_minimum/order.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

/// One step of Newton's method along an edge towards an ellipse's outline, as a share of the edge. The crossing was
/// computed from the start of the edge and carries a rounding error relative to its whole length, which this removes.
/// It is 0 where the point is not close to the outline, or the edge is nearly parallel to it.
inline double correction(const CentredShape& ellipse, const PlaneVector& p, const PlaneVector& along) noexcept {
  const double x = p.x / ellipse.a, y = p.y / ellipse.b;
  const double excess = (x * x + y * y) - 1, slope = 2 * (x * (along.x / ellipse.a) + y * (along.y / ellipse.b));
  const double step = -excess / slope;
  return lane::abs(excess) < 0x1p-20 && lane::abs(step) < 0x1p-40 ? step : 0;
}

/// The four edges of the second shape, a box, against the first. Without area some of them coincide.
inline PlaneVector common_point_on_box(const Frame& frame) noexcept {
  constexpr PlaneVector corners[5] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
  const CentredShape first = frame.first_by_axis();
  OnEdge best{0, 0x1p1000};
  int edge = 0;
  for (int i = 0; i < 4; ++i) {
    const PlaneVector &from = corners[i], &to = corners[i + 1];
    const OnEdge found = Edge(first, frame.second_by_axis(from.x, from.y), frame.second_by_axis(to.x, to.y)).best();
    if (found.error < best.error) best = found, edge = i;
  }
  const PlaneVector along = corners[edge + 1] + -corners[edge], w = corners[edge] + best.t * along;
  if (!first.curved || best.t == 0 || best.t == 1) return w;
  const PlaneVector way = frame.second_by_axis(corners[edge + 1].x, corners[edge + 1].y) +
                          -frame.second_by_axis(corners[edge].x, corners[edge].y);
  const double t = best.t + correction(first, frame.second_by_axis(w.x, w.y), way);
  return corners[edge] + lane::max(lane::min(t, 1.0), 0.0) * along;
}

/// A point that is on one outline to rounding, and whether it is on the other one too.
struct CommonPoint {
  PlaneVector at;
  bool certain;
};

/// A common point of two outlines that meet, rounded: found as a point of one, and measured from the other.
inline CommonPoint common_outline_point(const Form& a, const Form& b) noexcept {
  const PlacedPair given = place(a, b);
  // The edges of the second shape are walked, so a box comes second.
  const bool exchange = a.curved == b.curved ? out_of_order(a, b, given) : b.curved;
  const PlacedPair pair = exchange ? exchanged(given) : given;
  const Frame frame(pair);
  const PlaneVector w = pair.second.centred.curved ? EllipseInDisc(frame).common() : common_point_on_box(frame);
  const PlacedShape& s = pair.second;
  const CentredShape first = frame.first_by_axis();
  const PlaneVector seen = frame.second_by_axis(w.x, w.y);
  const double off =
      first.curved ? nearest::off_ellipse(first.a, first.b, seen.x, seen.y) : distance_to_outline(first, seen);
  return {located(exchange ? a : b, out_of_frame(s.u, {s.a * w.x, s.b * w.y}), pair.exponent),
          off <= nearest::least_certain * frame.axis_length()};
}

}  // namespace vesica::detail::boundary_distance
