// SPDX-License-Identifier: Apache-2.0
/// Pairs of circles, ellipses and segments whose answer is known, off contact by more than any method rounds.
#pragma once

#include <cmath>
#include <span>

#include "methods/typed_method.hpp"

namespace method_pairs {

struct KnownAnswer {
  const char* what;
  properties::Numbers a, b;
  std::int32_t answer;
};

/// Off contact by this much, in floats too.
inline constexpr double off = 0x1p-8;

// On the ellipse of half lengths 45 and 25 the point (27, 20) has the unit normal (5, 12) / 13: a circle about (32, 32)
// touches it with a radius of 13, one about (22, 8), inside, also.
inline constexpr KnownAnswer circle_ellipse_cases[] = {
    {"at a vertex of the longer axis", {7, 0, 2 + off}, {0, 0, 1, 0, 5, 2}, 1},
    {"off a vertex of the longer axis", {7, 0, 2 - off}, {0, 0, 1, 0, 5, 2}, 0},
    {"at a vertex of the shorter axis", {0, 5, 3 + off}, {0, 0, 1, 0, 5, 2}, 1},
    {"off a vertex of the shorter axis", {0, 5, 3 - off}, {0, 0, 1, 0, 5, 2}, 0},
    {"at a slanting normal", {32, 32, 13 + off}, {0, 0, 1, 0, 45, 25}, 1},
    {"off a slanting normal", {32, 32, 13 - off}, {0, 0, 1, 0, 45, 25}, 0},
    {"second quadrant", {-32, 32, 13 + off}, {0, 0, 1, 0, 45, 25}, 1},
    {"second quadrant, off", {-32, 32, 13 - off}, {0, 0, 1, 0, 45, 25}, 0},
    {"third quadrant", {-32, -32, 13 + off}, {0, 0, -1, 0, 45, 25}, 1},
    {"third quadrant, off", {-32, -32, 13 - off}, {0, 0, -1, 0, 45, 25}, 0},
    {"fourth quadrant, shorter axis first", {32, -32, 13 + off}, {0, 0, 0, 1, 25, 45}, 1},
    {"fourth quadrant, shorter axis first, off", {32, -32, 13 - off}, {0, 0, 0, 1, 25, 45}, 0},
    // (32, 32) turned by (3, 4), which is 5 long.
    {"turned", {-32, 224, 65 + 16 * off}, {0, 0, 3, 4, 45, 25}, 1},
    {"turned, off", {-32, 224, 65 - 16 * off}, {0, 0, 3, 4, 45, 25}, 0},
    {"moved", {1032, -968, 13 + 16 * off}, {1000, -1000, 1, 0, 45, 25}, 1},
    {"moved, off", {1032, -968, 13 - 16 * off}, {1000, -1000, 1, 0, 45, 25}, 0},
    {"circle inside", {1, 1, 0.25}, {0, 0, 1, 0, 5, 2}, 1},
    {"circle about all of it", {1, 1, 100}, {0, 0, 1, 0, 5, 2}, 1},
    {"equal circles", {1, 1, 2}, {1, 1, 3, 4, 0.4, 0.4}, 1},
    {"two circles", {6, 8, 5 + off}, {0, 0, 1, 0, 5, 5}, 1},
    {"two circles, off", {6, 8, 5 - off}, {0, 0, 1, 0, 5, 5}, 0},
    // Outside the ellipse and within its evolute, which reaches to (0, 24) on this axis: the nearest point is (0, 1).
    {"within the evolute", {0, 3, 2 + off}, {0, 0, 1, 0, 5, 1}, 1},
    {"within the evolute, off", {0, 3, 2 - off}, {0, 0, 1, 0, 5, 1}, 0},
    {"point inside", {4, 0.5, 0}, {0, 0, 1, 0, 5, 2}, 1},
    {"point outside", {4, 1.5, 0}, {0, 0, 1, 0, 5, 2}, 0},
    {"needle, beside", {3, 1, 1 + off}, {0, 0, 1, 0, 5, 0x1p-20}, 1},
    {"needle, beside, off", {3, 1, 1 - off}, {0, 0, 1, 0, 5, 0x1p-20}, 0},
    {"needle, past its end", {8, 4, 5 + off}, {0, 0, 1, 0, 5, 0x1p-20}, 1},
    {"needle, past its end, off", {8, 4, 5 - off}, {0, 0, 1, 0, 5, 0x1p-20}, 0},
    {"segment, beside", {3, 1, 1 + off}, {0, 0, 1, 0, 5, 0}, 1},
    {"segment, beside, off", {3, 1, 1 - off}, {0, 0, 1, 0, 5, 0}, 0},
    {"segment, past its end", {4, 8, 5 + off}, {0, 0, 1, 0, 0, 5}, 1},
    {"segment, past its end, off", {4, 8, 5 - off}, {0, 0, 1, 0, 0, 5}, 0},
    {"point in the circle", {3, 4, 5 + off}, {0, 0, 1, 0, 0, 0}, 1},
    {"point off the circle", {3, 4, 5 - off}, {0, 0, 1, 0, 0, 0}, 0},
    {"two points", {3, 4, 0}, {0, 0, 1, 0, 0, 0}, 0},
};

// The slanting contact of circle_ellipse_cases, all of it stretched along y.
inline constexpr KnownAnswer parallel_ellipse_cases[] = {
    {"side by side", {0, 0, 1, 0, 5, 2}, {8, 0, 1, 0, 3 + off, 7}, 1},
    {"side by side, off", {0, 0, 1, 0, 5, 2}, {8, 0, 1, 0, 3 - off, 7}, 0},
    {"one above the other", {0, 0, 1, 0, 5, 2}, {0, 8, 1, 0, 7, 6 + off}, 1},
    {"one above the other, off", {0, 0, 1, 0, 5, 2}, {0, 8, 1, 0, 7, 6 - off}, 0},
    {"at a slanting normal", {0, 0, 1, 0, 45, 25}, {32, 32, 1, 0, 13 + off, 13 + off}, 1},
    {"at a slanting normal, off", {0, 0, 1, 0, 45, 25}, {32, 32, 1, 0, 13 - off, 13 - off}, 0},
    {"slanting, y halved", {0, 0, 1, 0, 45, 12.5}, {-32, 16, 1, 0, 13 + off, 6.5 + off}, 1},
    {"slanting, y halved, off", {0, 0, 1, 0, 45, 12.5}, {-32, 16, 1, 0, 13 - off, 6.5 - off}, 0},
    {"axes at right angles", {0, 0, 1, 0, 45, 12.5}, {-32, 16, 0, 1, 6.5 + off, 13 + off}, 1},
    {"axes at right angles, off", {0, 0, 1, 0, 45, 12.5}, {-32, 16, 0, 1, 6.5 - off, 13 - off}, 0},
    // (-32, 16) turned by (3, 4); the second axis is longer by 2, and turned about.
    {"turned", {0, 0, 3, 4, 45, 12.5}, {-160, -80, -6, -8, 6.5 + 4 * off, 3.25 + 4 * off}, 1},
    {"turned, off", {0, 0, 3, 4, 45, 12.5}, {-160, -80, -6, -8, 6.5 - 4 * off, 3.25 - 4 * off}, 0},
    {"equal", {1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1}, 1},
    {"one in the other", {1, 2, 3, 4, 2, 1}, {0, 2, 3, 4, 8, 6}, 1},
    {"bounds overlap, ellipses do not", {0, 0, 1, 0, 2, 1}, {3, 1.75, 1, 0, 2, 1}, 0},
    {"second a segment", {0, 0, 1, 0, 5, 2}, {8, 0, 1, 0, 3 + off, 0}, 1},
    {"second a segment, off", {0, 0, 1, 0, 5, 2}, {8, 0, 1, 0, 3 - off, 0}, 0},
    {"second a segment beside", {0, 0, 1, 0, 5, 2}, {6, 0, 1, 0, 0, 7}, 0},
    {"first a segment", {8, 0, 1, 0, 3 + off, 0}, {0, 0, 1, 0, 5, 2}, 1},
    {"first a segment, off", {8, 0, 1, 0, 3 - off, 0}, {0, 0, 1, 0, 5, 2}, 0},
    {"first a point", {8, 0, 1, 0, 0, 0}, {0, 0, 1, 0, 8 + off, 2}, 1},
    {"first a point, off", {8, 0, 1, 0, 0, 0}, {0, 0, 1, 0, 8 - off, 2}, 0},
    {"two segments crossing", {0, 0, 1, 0, 5, 0}, {4, 1, 1, 0, 0, 1}, 1},
    {"two segments", {0, 0, 1, 0, 5, 0}, {4, 1, 1, 0, 0, 0.75}, 0},
    {"two equal points", {3, 4, 1, 0, 0, 0}, {3, 4, 1, 0, 0, 0}, 1},
    {"two points", {3, 4, 1, 0, 0, 0}, {3, 4.5, 1, 0, 0, 0}, 0},
};

inline constexpr KnownAnswer any_ellipse_cases[] = {
    {"a circle, slanting", {0, 0, 3, 4, 45, 25}, {-32, 224, 5, 12, 5 + 4 * off, 5 + 4 * off}, 1},
    {"a circle, slanting, off", {0, 0, 3, 4, 45, 25}, {-32, 224, 5, 12, 5 - 4 * off, 5 - 4 * off}, 0},
    {"crossing", {0, 0, 1, 1, 5, 0.5}, {0, 0, 1, -1, 5, 0.5}, 1},
    {"crossing at an angle", {0, 0, 1, 0, 5, 0.5}, {1, 1, 1, 2, 5, 0.5}, 1},
    {"beside", {0, 0, 1, 0, 5, 0.5}, {1, 4, 3, 1, 1, 0.5}, 0},
    {"skewed past each other", {0, 0, 1, 1, 3, 0.25}, {2, 0, 1, 1, 3, 0.25}, 0},
    {"end to side", {0, 0, 1, 1, 3, 0.25}, {4.5, 4.5, 1, -1, 0.25, 1.5 + off}, 1},
    {"end to side, off", {0, 0, 1, 1, 3, 0.25}, {4.5, 4.5, 1, -1, 0.25, 1.5 - off}, 0},
};

/// Both shapes with all lengths times 2^exponent: centres and sizes, or centres and axes, if both have one.
inline Pair scaled(int kind_a, int kind_b, const KnownAnswer& known, int exponent, bool by_axes) {
  Pair pair{kind_a, kind_b, known.a, known.b};
  const auto scale = [&](int kind, properties::Numbers& numbers) {
    const bool axis = properties::role(kind, 2) == properties::Role::axis;
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const properties::Role role = properties::role(kind, i);
      const bool skipped = axis && role == (by_axes ? properties::Role::size : properties::Role::axis);
      double& number = numbers[static_cast<std::size_t>(i)];
      if (!skipped) number = std::ldexp(number, exponent);
    }
  };
  scale(kind_a, pair.a);
  scale(kind_b, pair.b);
  return pair;
}

/// All cases, at scales over the range of the scalar.
inline void expect_known_answers(std::span<const KnownAnswer> cases, int kind_a, int kind_b, Scalar scalar,
                                 const Method& method) {
  const auto exponents =
      scalar == Scalar::f64 ? std::array{0, -1000, -300, 300, 1000} : std::array{0, -110, -30, 30, 110};
  for (const KnownAnswer& known : cases) {
    for (const int exponent : exponents) {
      for (const bool by_axes : {false, true}) {
        const Pair pair = scaled(kind_a, kind_b, known, exponent, by_axes);
        EXPECT_EQ(truth(scalar, pair), known.answer) << known.what;
        EXPECT_EQ(method(pair), known.answer)
            << known.what << ", " << properties::name(scalar) << ", times 2^" << exponent;
      }
    }
  }
}

}  // namespace method_pairs
