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

/// A shape's numbers in the order of vesica.h; those its kind does not use are 0. For Scalar::f32 each is a float's
/// value, so the pair is the same shapes in both scalar types.
using Numbers = std::array<double, 6>;

/// The kinds that workloads and the oracle know: those below this number. Every query answers all of them.
inline constexpr int kinds = 6;

struct Pair {
  int kind_a, kind_b;
  Numbers a, b;
};

inline Pair swapped(const Pair& p) { return {p.kind_b, p.kind_a, p.b, p.a}; }

/// The meaning of a shape's number.
enum class Role { x, y, axis, size, unused };
Role role(int kind, int field);
int field_count(int kind);
const char* kind_name(int kind);

/// Is it a shape at all: sizes >= 0, axis not zero, min <= max, all finite?
bool valid(int kind, const Numbers& numbers);
/// Returns true if a valid shape has an area.
bool has_area(int kind, const Numbers& numbers);
/// A circle or an ellipse; and one with an area.
constexpr bool is_round(int kind) { return kind == VESICA_CIRCLE || kind == VESICA_ELLIPSE; }
inline bool is_curved(int kind, const Numbers& numbers) { return is_round(kind) && has_area(kind, numbers); }
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
std::array<float, 6> narrow(const Numbers& numbers);

/// Both shapes with hexadecimal numbers, to be pasted into a test.
std::string describe(const Pair& pair);

}  // namespace properties
