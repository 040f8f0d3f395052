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

}  // namespace vesica::bench
