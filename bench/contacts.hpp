// SPDX-License-Identifier: Apache-2.0
/// Pairs that touch in exactly one point or edge from outside, in integers a double holds exactly.
#pragma once

#include <cstdint>
#include <utility>

#include "random.hpp"
#include "shapes.hpp"

namespace vesica::bench {

/// A corner of b on a face of a.
std::pair<Numbers, Numbers> rect_rect_contact(Random& random);

/// By turns a corner of the rectangle on the ellipse, and a face of the rectangle along the ellipse.
std::pair<Numbers, Numbers> rect_ellipse_contact(Random& random);

/// Two ellipses of unrelated axes and proportions with a common normal.
std::pair<Numbers, Numbers> ellipse_ellipse_contact(Random& random);

/// Two shapes other than ellipses that touch, of numbers of few digits. By turns a corner or a face of a rectangle.
std::pair<Numbers, Numbers> short_contact(Random& random, std::int32_t kind_a, std::int32_t kind_b);

}  // namespace vesica::bench
