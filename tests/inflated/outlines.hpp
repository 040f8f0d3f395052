// SPDX-License-Identifier: Apache-2.0
/// The places where outlines meet, in 190 digits: all places of the lines and circles that two outlines are made of,
/// less those that are not at the radius from both cores. It knows no pieces, no ends and no order of them.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "inflated/shapes.hpp"

namespace inflated {

struct Outline {
  mpf_class cx, cy, ux, uy, hx, hy, radius;  ///< the axis has length 1

  explicit Outline(const Shape& s);
};

struct PlaceOfOutlines {
  mpf_class x, y;
  double along;  ///< grows along the first outline
};

struct OutlinePlaces {
  std::vector<PlaceOfOutlines> places;  ///< in order along the first outline
  bool shared;
};

OutlinePlaces outline_places(const Outline& a, const Outline& b);

/// 1 inside, 0 on the outline, -1 outside, of a shape with area.
int side_of_outline(const Outline& o, const mpf_class& x, const mpf_class& y);

/// A segment and a shape with area: the places, and the ends that are not outside, from the first end on.
struct PartOfSegment {
  std::vector<PlaceOfOutlines> places;
  bool meets_inside, shared;
};
PartOfSegment part_of_segment(const Shape& segment, const Outline& o);

}  // namespace inflated
