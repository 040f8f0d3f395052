// SPDX-License-Identifier: Apache-2.0
/// The places where the outlines of an ellipse and of a core with a radius meet, in 190 digits. The ellipse's form
/// along each edge and each quarter of an arc is a polynomial, whose zeros lie between those of its derivative.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "inflated/shapes.hpp"

namespace inflated {

struct EllipsePlace {
  mpf_class x, y;
  double turn;  ///< the ellipse's angle from the end of its axis, in its disc
};

/// In order along the outline of `round`, whose core is no point and whose radius is not 0; the ellipse has an area.
std::vector<EllipsePlace> places_with_ellipse(const Shape& round, const Shape& ellipse);

/// The places at the begin of each arc, inside it and at its end. Arc i is about corner i, before edge i.
std::vector<std::array<int, 3>> places_on_arcs(const Shape& round, const Shape& ellipse);

}  // namespace inflated
