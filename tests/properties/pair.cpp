// SPDX-License-Identifier: Apache-2.0
#include "properties/pair.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <utility>

namespace properties {
namespace {

// Through memory: one compiler was seen to drop the rounding of a double to a float and back when it vectorised.
float to_float(double x) {
  const volatile float stored = static_cast<float>(std::clamp<double>(x, -FLT_MAX, FLT_MAX));
  return stored;
}

template <class Bits>
std::int64_t signed_magnitude(Bits bits) {
  constexpr Bits sign = Bits{1} << (8 * sizeof(Bits) - 1);
  const auto magnitude = static_cast<std::int64_t>(bits & ~sign);
  return (bits & sign) != 0 ? -magnitude : magnitude;
}

}  // namespace

const char* name(Scalar scalar) { return scalar == Scalar::f32 ? "f32" : "f64"; }

int field_count(int kind) { return vesica_field_count(kind); }

const char* kind_name(int kind) { return vesica_kind_name(kind); }

Role role(int kind, int field) {
  if (field >= field_count(kind)) return Role::unused;
  if (field < 2) return field == 0 ? Role::x : Role::y;
  if (kind == VESICA_CIRCLE || field == 6 || (kind == VESICA_CAPSULE && field == 4)) return Role::radius;
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB || kind == VESICA_CAPSULE) return field == 2 ? Role::x : Role::y;
  return field < 4 ? Role::axis : Role::size;
}

bool has_axis(int kind) { return role(kind, 2) == Role::axis; }

bool valid(int kind, const Numbers& n) {
  for (int i = 0; i < field_count(kind); ++i) {
    const double x = n[static_cast<std::size_t>(i)];
    if (!std::isfinite(x) || (is_size(role(kind, i)) && x < 0)) return false;
  }
  if (kind == VESICA_AABB) return n[0] <= n[2] && n[1] <= n[3];
  return !has_axis(kind) || n[2] != 0 || n[3] != 0;
}

bool has_area(int kind, const Numbers& n) {
  if (kind == VESICA_AABB) return n[0] < n[2] && n[1] < n[3];
  return radius(kind, n) > 0 || (has_axis(kind) && n[4] > 0 && n[5] > 0);
}

double radius(int kind, const Numbers& n) {
  const int last = field_count(kind) - 1;
  return role(kind, last) == Role::radius ? n[static_cast<std::size_t>(last)] : 0;
}

bool is_curved(int kind, const Numbers& n) {
  return radius(kind, n) > 0 || (kind == VESICA_ELLIPSE && has_area(kind, n));
}

bool is_moderate(const Pair& pair, double most) {
  const auto moderate = [most](double x) { return x == 0 || (std::fabs(x) >= 1 / most && std::fabs(x) <= most); };
  return std::all_of(pair.a.begin(), pair.a.end(), moderate) && std::all_of(pair.b.begin(), pair.b.end(), moderate);
}

double nearest(Scalar scalar, double x) {
  return scalar == Scalar::f32 ? static_cast<double>(to_float(x)) : std::clamp(x, -DBL_MAX, DBL_MAX);
}

bool representable(Scalar scalar, double x) { return std::isfinite(x) && nearest(scalar, x) == x; }

std::int64_t ordinal(Scalar scalar, double x) {
  return scalar == Scalar::f32 ? signed_magnitude(std::bit_cast<std::uint32_t>(to_float(x)))
                               : signed_magnitude(std::bit_cast<std::uint64_t>(x));
}

double at_ordinal(Scalar scalar, std::int64_t place) {
  const std::int64_t last = ordinal(scalar, scalar == Scalar::f32 ? static_cast<double>(FLT_MAX) : DBL_MAX);
  const std::int64_t magnitude = std::min(place < 0 ? -place : place, last);
  const double x = scalar == Scalar::f32
                       ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(magnitude)))
                       : std::bit_cast<double>(magnitude);
  return place < 0 ? -x : x;
}

Numbers nearest_shape(Scalar scalar, int kind, Numbers n) {
  for (int i = 0; i < field_count(kind); ++i) {
    double& x = n[static_cast<std::size_t>(i)];
    x = nearest(scalar, is_size(role(kind, i)) ? std::fabs(x) : x);
  }
  if (kind == VESICA_AABB) {
    if (n[0] > n[2]) std::swap(n[0], n[2]);
    if (n[1] > n[3]) std::swap(n[1], n[3]);
  }
  if (has_axis(kind) && n[2] == 0 && n[3] == 0) n[2] = at_ordinal(scalar, 1);
  return n;
}

NumbersOf<float> narrow(const Numbers& numbers) {
  NumbersOf<float> result{};
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i] = to_float(numbers[i]);
  return result;
}

std::string describe(const Pair& pair) {
  std::string text;
  for (const auto& [kind, numbers] : {std::pair{pair.kind_a, pair.a}, std::pair{pair.kind_b, pair.b}}) {
    text += text.empty() ? "" : " | ";
    text += kind_name(kind);
    for (int i = 0; i < field_count(kind); ++i) {
      std::array<char, 40> number{};
      std::snprintf(number.data(), number.size(), " %a", numbers[static_cast<std::size_t>(i)]);
      text += number.data();
    }
  }
  return text;
}

}  // namespace properties
