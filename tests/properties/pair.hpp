// SPDX-License-Identifier: Apache-2.0
/// Pairs of shapes as flat numbers, in either scalar type, and what tests do with single numbers of them.
#pragma once

#include <vesica.h>

#include <array>
#include <cstdint>
#include <string>

namespace properties {

enum class Scalar { f32, f64 };
const char* name(Scalar scalar);

/// A shape's numbers in the order of vesica.h; those its kind does not use are 0.
template <class T>
using NumbersOf = std::array<T, 7>;
/// For Scalar::f32 each is a float's value, so the pair is the same shapes in both scalar types.
using Numbers = NumbersOf<double>;

/// The kinds that workloads and the oracle know: those below this number. Some questions refuse pairs with a capsule or
/// a rounded rectangle (refused.hpp).
inline constexpr int kinds = 8;
/// The kinds below this number have a form; their pairs have typed functions, and every question answers them.
inline constexpr int kinds_with_form = 6;

struct Pair {
  int kind_a, kind_b;
  Numbers a, b;
};

inline Pair swapped(const Pair& p) { return {p.kind_b, p.kind_a, p.b, p.a}; }

/// The meaning of a shape's number.
enum class Role { x, y, axis, size, radius, unused };
Role role(int kind, int field);
/// Must the number be 0 or more? A size beside an axis is in units of the axis, and a radius in units of coordinates.
constexpr bool is_size(Role role) { return role == Role::size || role == Role::radius; }
bool has_axis(int kind);
int field_count(int kind);
const char* kind_name(int kind);

/// Is it a shape at all: sizes >= 0, axis not zero, min <= max, all finite?
bool valid(int kind, const Numbers& numbers);
/// Returns true if a valid shape has an area.
bool has_area(int kind, const Numbers& numbers);
/// A circle or an ellipse.
constexpr bool is_round(int kind) { return kind == VESICA_CIRCLE || kind == VESICA_ELLIPSE; }
/// A capsule or a rounded rectangle.
constexpr bool is_inflated(int kind) { return kind == VESICA_CAPSULE || kind == VESICA_ROUND_RECT; }
/// The radius of a shape that has one, else 0.
double radius(int kind, const Numbers& numbers);
/// Has the outline a curved part?
bool is_curved(int kind, const Numbers& numbers);
/// Is each number of both shapes 0, or from 1 / most to most in magnitude?
bool is_moderate(const Pair& pair, double most);

/// The scalar nearest to x; the largest finite one beyond the range.
double nearest(Scalar scalar, double x);
/// Is x a finite number of this scalar type?
bool representable(Scalar scalar, double x);
/// Place of x among the scalar's numbers: 0 for zero, 1 for the smallest positive one, and so on, odd in x.
std::int64_t ordinal(Scalar scalar, double x);
/// The number at a place; the largest finite one beyond the last.
double at_ordinal(Scalar scalar, std::int64_t place);

/// The shape nearest to these numbers, made valid: sizes lose their sign, an axis that vanishes becomes the smallest.
Numbers nearest_shape(Scalar scalar, int kind, Numbers numbers);

/// The numbers as floats, which they must be.
NumbersOf<float> narrow(const Numbers& numbers);

/// Both shapes with hexadecimal numbers, to be pasted into a test.
std::string describe(const Pair& pair);

}  // namespace properties
