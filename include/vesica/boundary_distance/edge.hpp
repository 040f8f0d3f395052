// SPDX-License-Identifier: Apache-2.0
/// Places where an edge meets, or comes closest to, the outline of a shape.
#pragma once

#include <vesica/support_minimum/frame.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

/// How far a point in the frame of a shape is from the shape's outline; for an ellipse to first order, and from inside
/// no more than the centre is.
inline double distance_to_outline(const CentredShape& s, const PlaneVector& p) noexcept {
  if (s.curved) {
    const double x = p.x / s.a, y = p.y / s.b;
    const PlaneVector slope{x / s.a, y / s.b};
    const double excess = (x * x + y * y) - 1, off = lane::abs(excess) / (2 * lane::sqrt(dot(slope, slope)));
    return excess < 0 ? lane::min(off, lane::min(s.a, s.b)) : off;
  }
  const double x = lane::abs(p.x) - s.a, y = lane::abs(p.y) - s.b;
  if (x < 0 && y < 0) return lane::min(-x, -y);
  const PlaneVector outside{lane::positive_part(x), lane::positive_part(y)};
  return lane::sqrt(dot(outside, outside));
}

/// The point at t, 0 at the edge's start and 1 at its end, and how far it is from the outline.
struct OnEdge {
  double t, error;
};

/// An edge in the frame of a shape. The candidates are its ends, its crossings with the outline, and the point where it
/// is closest to an ellipse's centre in the ellipse's metric. A crossing that rounding puts beyond an end is left out:
/// then the end itself is close enough.
class Edge {
 public:
  Edge(const CentredShape& shape, const PlaneVector& from, const PlaneVector& to) noexcept
      : shape_(shape), from_(from), to_(to), along_(to + -from) {}

  OnEdge best() noexcept {
    consider(0);
    consider(1);
    if (shape_.curved) {
      meet_ellipse();
    } else {
      meet_line(from_.x, along_.x, shape_.a);
      meet_line(from_.y, along_.y, shape_.b);
    }
    return best_;
  }

 private:
  void consider(double t) noexcept {
    if (!(t >= 0 && t <= 1)) return;
    const PlaneVector p = t < 0.5 ? from_ + t * along_ : to_ + (t - 1) * along_;
    const double error = distance_to_outline(shape_, p);
    if (error < best_.error) best_ = {t, error};
  }

  void meet_line(double from, double along, double size) noexcept {
    consider((size - from) / along);
    consider((-size - from) / along);
  }

  /// The middle of the chord is also where an edge that misses by rounding comes closest.
  void meet_ellipse() noexcept {
    const PlaneVector p{from_.x / shape_.a, from_.y / shape_.b}, d{along_.x / shape_.a, along_.y / shape_.b};
    const double dd = dot(d, d), middle = -dot(p, d) / dd, off = cross(p, d);
    const double half = lane::sqrt(lane::positive_part(dd - off * off)) / dd;
    consider(middle);
    consider(middle - half);
    consider(middle + half);
  }

  const CentredShape& shape_;
  PlaneVector from_, to_, along_;
  OnEdge best_{0, 0x1p1000};
};

}  // namespace vesica::detail::boundary_distance
