// SPDX-License-Identifier: Apache-2.0
/// Changes to a shape that are exact on its stored numbers, so that laws hold without tolerance. A change that cannot
/// be made exactly, or does not apply to the kind, yields nothing.
#pragma once

#include <optional>
#include <vector>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace properties {

struct Shape {
  int kind;
  Numbers numbers;
};

inline Shape first(const Pair& p) { return {p.kind_a, p.a}; }
inline Shape second(const Pair& p) { return {p.kind_b, p.b}; }
inline Pair pair_of(const Shape& a, const Shape& b) { return {a.kind, b.kind, a.numbers, b.numbers}; }

/// A power of two to scale by: half of the time one near 1, else any that may be exact.
int random_exponent(Scalar scalar, Random& random);

// The same set of points moved.
Shape mirrored(const Shape& shape);  // (x, y) -> (-x, y)
Shape turned(const Shape& shape);    // (x, y) -> (-y, x)
std::optional<Shape> scaled_exactly(const Shape& shape, Scalar scalar, int exponent,
                                    bool scale_axis);  // times 2^exponent

// The same set of points written with other numbers.
std::optional<Shape> with_negated_axis(const Shape& shape);
std::optional<Shape> with_turned_axis(const Shape& shape);  // axis a quarter turn on, sizes exchanged
std::optional<Shape> with_scaled_axis(const Shape& shape, Scalar scalar,
                                      int exponent);  // axis 2^exponent, sizes 2^-exponent
std::optional<Shape> with_ends_exchanged(const Shape& shape);

/// The same set of points as every other kind that can hold it exactly.
std::vector<Shape> as_other_kinds(const Shape& shape, Scalar scalar);

/// A superset: one size grown, by one place or by half.
std::optional<Shape> grown(const Shape& shape, Scalar scalar, Random& random);

/// Points of the shape that are representable: centre, end points, corners, vertices.
std::vector<Shape> own_points(const Shape& shape, Scalar scalar);

}  // namespace properties
