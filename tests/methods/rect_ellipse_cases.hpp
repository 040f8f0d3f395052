// SPDX-License-Identifier: Apache-2.0
/// Pairs of a rectangle and an ellipse whose answer is known, for every method on them. All numbers are small integers
/// or short binary fractions, at which the methods do not round.
#pragma once

#include "methods/typed_method.hpp"

namespace method_pairs {

struct Known {
  const char* what;
  properties::Numbers rect, ellipse;
  std::int32_t answer;
};

inline constexpr Known rect_ellipse_cases[] = {
    {"vertex in the ellipse", {0, 0, 1, 0, 1, 1}, {2, 2, 1, 0, 2, 2}, 1},
    {"an edge alone is met", {0, 0, 1, 0, 8, 1}, {1, 2, 0, 1, 2, 1}, 1},
    {"ellipse in the rectangle", {0, 0, 3, 4, 2, 2}, {1, 1, 1, 0, 2, 1}, 1},
    {"rectangle in the ellipse, centre outside", {4, 0, 1, 0, 1, 1}, {0, 0, 1, 0, 8, 4}, 1},
    {"bounds overlap, shapes do not", {0, 0, 1, 0, 1, 1}, {3, 3, 1, 1, 0.25, 2.5}, 0},
    {"up to a corner", {0, 0, 1, 0, 1, 1}, {3, 3, 1, 1, 2, 0.25}, 1},
    {"past a corner", {0, 0, 1, 0, 1, 1}, {3, 3, 1, -1, 2, 0.25}, 0},
    {"far away", {0, 0, 1, 0, 1, 1}, {100, 0, 1, 0, 2, 1}, 0},
    // u = (2, 1), u.u = 5; along u the ellipse reaches sqrt((2 4)^2 + (5 3)^2) = 17, and u.(9, 4) = 22 = 5 + 17.
    {"rotated face tangent", {0, 0, 2, 1, 1, 3}, {9, 4, 1, 2, 2, 5}, 1},
    {"rotated face short of it", {0, 0, 2, 1, 0.75, 3}, {9, 4, 1, 2, 2, 5}, 0},
    // The corner (3, 4) of half lengths 5 and 5.
    {"vertex on the outline", {0, 0, 1, 0, 1, 1}, {4, 5, 1, 0, 5, 5}, 1},
    {"vertex just off the outline", {0, 0, 1, 0, 1, 1}, {4, 5.125, 1, 0, 5, 5}, 0},
    // The nine regions of the ellipse's centre, each with an ellipse that reaches and one that does not.
    {"region left below", {0, 0, 1, 0, 2, 1}, {-5, -5, 1, 0, 5, 5}, 1},
    {"region left below, short", {0, 0, 1, 0, 2, 1}, {-5, -5, 1, 0, 4.5, 5}, 0},
    {"region left", {0, 0, 1, 0, 2, 1}, {-5, 0.5, 1, 0, 3, 1}, 1},
    {"region left, short", {0, 0, 1, 0, 2, 1}, {-5, 0.5, 1, 0, 2.75, 1}, 0},
    {"region left above", {0, 0, 1, 0, 2, 1}, {-5, 5, 0, 1, 5, 5}, 1},
    {"region left above, short", {0, 0, 1, 0, 2, 1}, {-5, 5, 0, 1, 5, 4.5}, 0},
    {"region below", {0, 0, 1, 0, 2, 1}, {1, -4, 0, 1, 3, 8}, 1},
    {"region below, short", {0, 0, 1, 0, 2, 1}, {1, -4, 0, 1, 2.75, 8}, 0},
    {"region middle", {0, 0, 1, 0, 2, 1}, {2, 1, 1, 3, 0.125, 0.125}, 1},
    {"region above", {0, 0, 1, 0, 2, 1}, {-1, 4, 1, 0, 8, 3}, 1},
    {"region above, short", {0, 0, 1, 0, 2, 1}, {-1, 4, 1, 0, 8, 2.75}, 0},
    {"region right below", {0, 0, 1, 0, 2, 1}, {5, -5, 1, 0, 5, 5}, 1},
    {"region right below, short", {0, 0, 1, 0, 2, 1}, {5, -5, 1, 0, 5, 4.5}, 0},
    {"region right", {0, 0, 1, 0, 2, 1}, {4, -1, 2, 0, 1, 0.5}, 1},
    {"region right, short", {0, 0, 1, 0, 2, 1}, {4, -1, 2, 0, 0.875, 0.5}, 0},
    {"region right above", {0, 0, 1, 0, 2, 1}, {5, 5, -1, 0, 5, 5}, 1},
    {"region right above, short", {0, 0, 1, 0, 2, 1}, {5, 5, -1, 0, 4.5, 4.5}, 0},
    // Past a small rectangle a skewed ellipse: the printed Minkowski test calls these overlapping. The first one's
    // numbers are 17 times those of half extents 1/4, 7/8, centre (-5/4, -3/8), half lengths 3 and 1/8.
    {"skewed ellipse past a small rectangle", {0, 0, 1, 0, 4.25, 14.875}, {-21.25, -6.375, 8, 15, 3, 0.125}, 0},
    {"diagonal ellipse past a small square", {0, 0, 1, 0, 1, 1}, {2, 9, 1, 1, 14, 0.75}, 0},
    // Zero sizes.
    {"rectangle without height", {0, 0, 1, 0, 4, 0}, {0, 2, 1, 0, 1, 2}, 1},
    {"rectangle without height, short", {0, 0, 1, 0, 4, 0}, {0, 2, 1, 0, 1, 1.75}, 0},
    {"point and ellipse", {3, 4, 1, 0, 0, 0}, {0, 0, 1, 0, 5, 5}, 1},
    {"point off the ellipse", {3, 4.125, 1, 0, 0, 0}, {0, 0, 1, 0, 5, 5}, 0},
    {"segment through the rectangle", {0, 0, 1, 0, 1, 1}, {0, 0, 1, 1, 4, 0}, 1},
    {"segment up to the rectangle", {0, 0, 1, 0, 1, 1}, {3, 0, 1, 0, 2, 0}, 1},
    {"segment short of the rectangle", {0, 0, 1, 0, 1, 1}, {3, 0, 1, 0, 1.75, 0}, 0},
    {"segment past a corner", {0, 0, 1, 0, 1, 1}, {2, 1, 1, -1, 0, 8}, 1},
    {"segment off a corner", {0, 0, 1, 0, 1, 1}, {2, 1, 1, -1, 8, 0}, 0},
    {"segment across the line of its axis", {0, 0, 1, 0, 1, 1}, {0, 3, 1, 0, 0, 2}, 1},
    {"point off the rectangle", {0, 0, 3, 4, 1, 1}, {1, 7, 1, 0, 0, 0}, 0},
    {"point on a corner", {0, 0, 3, 4, 1, 1}, {-1, 7, 1, 0, 0, 0}, 1},
    {"point off a corner", {0, 0, 1, 0, 1, 1}, {1, 1.125, 1, 0, 0, 0}, 0},
    {"two equal points", {3, 4, 1, 0, 0, 0}, {3, 4, 0, 1, 0, 0}, 1},
    {"two points", {3, 4, 1, 0, 0, 0}, {3, 4.5, 0, 1, 0, 0}, 0},
};

/// The pair with all lengths times 2^exponent: centres and sizes, or centres and axes.
inline Pair scaled(const Known& known, int exponent, bool by_axes) {
  Pair pair{VESICA_RECT, VESICA_ELLIPSE, known.rect, known.ellipse};
  for (properties::Numbers* s : {&pair.a, &pair.b}) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (i < 2 || (i < 4) == by_axes) (*s)[i] = std::ldexp((*s)[i], exponent);
    }
  }
  return pair;
}

/// All cases, at scales over the range of the scalar.
inline void expect_known_answers(Scalar scalar, const Method& method) {
  const auto exponents =
      scalar == Scalar::f64 ? std::array{0, -1000, -300, 300, 1000} : std::array{0, -120, -30, 30, 110};
  for (const Known& known : rect_ellipse_cases) {
    for (const int exponent : exponents) {
      for (const bool by_axes : {false, true}) {
        EXPECT_EQ(method(scaled(known, exponent, by_axes)), known.answer)
            << known.what << ", " << properties::name(scalar) << ", times 2^" << exponent;
      }
    }
  }
}

}  // namespace method_pairs
