// SPDX-License-Identifier: Apache-2.0
#include "overlap/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace contact {
namespace {

/// The meaning of a shape's number. Each x is followed by its y, each axis_x by its axis_y.
enum class Role { none, x, y, length, axis_x, axis_y, per_axis };

constexpr Role roles[8][7] = {
    {Role::x, Role::y},                                                                            // point
    {Role::x, Role::y, Role::x, Role::y},                                                          // segment
    {Role::x, Role::y, Role::length},                                                              // circle
    {Role::x, Role::y, Role::x, Role::y},                                                          // aabb
    {Role::x, Role::y, Role::axis_x, Role::axis_y, Role::per_axis, Role::per_axis},                // rect
    {Role::x, Role::y, Role::axis_x, Role::axis_y, Role::per_axis, Role::per_axis},                // ellipse
    {Role::x, Role::y, Role::x, Role::y, Role::length},                                            // capsule
    {Role::x, Role::y, Role::axis_x, Role::axis_y, Role::per_axis, Role::per_axis, Role::length},  // round_rect
};

bool has_axis(std::int32_t kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE || kind == VESICA_ROUND_RECT; }

/// Transforms of a family: lengths times 2^length, each axis times its own power, then moved by 2^length * offset.
struct Placement {
  int length = 0, axis_a = 0, axis_b = 0;
  bool moved = false;
};

// Unequal and with few bits, so that most families stay representable when moved.
constexpr double offset_x = 0x5p17;
constexpr double offset_y = -0x3p15;

/// Exponents from the smallest to the largest, both and 0 included. Steps are odd: even and odd exponents occur.
std::vector<int> exponents(int smallest, int largest, int step) {
  std::vector<int> result{0, largest};
  for (int e = smallest; e < largest; e += step) result.push_back(e);
  return result;
}

template <class T>
std::vector<Placement> placements(bool axis_a, bool axis_b) {
  constexpr bool is_double = std::is_same_v<T, double>;
  const int smallest = is_double ? -1060 : -140;
  const int largest = is_double ? 1000 : 120;
  std::vector<Placement> result;
  for (int e : exponents(smallest, largest, is_double ? 43 : 7)) {
    result.push_back({e, 0, 0, false});
    result.push_back({e, 0, 0, true});
  }
  if (!axis_a && !axis_b) return result;
  for (int e : exponents(smallest, largest, is_double ? 87 : 15)) {
    result.push_back({0, e, e, false});
    result.push_back({e, e, e, false});
    result.push_back({-e, e, e, true});
    if (!axis_a || !axis_b) continue;
    result.push_back({0, e, -e, false});
    result.push_back({e, -e, e, false});
    result.push_back({0, e, 0, true});
  }
  return result;
}

/// value * 2^exponent, false when it is not a double.
bool scale(double value, int exponent, double& result) {
  result = std::ldexp(value, exponent);
  return std::isfinite(result) && std::ldexp(result, -exponent) == value;
}

/// a + b, false when it is not a double: the rounding error of a sum is itself a double (Knuth's two-sum).
bool add(double a, double b, double& sum) {
  sum = a + b;
  const double b_part = sum - a;
  return (a - (sum - b_part)) + (b - b_part) == 0;
}

bool place_number(double value, Role role, const Placement& p, int axis, double& result) {
  if (role == Role::none) return true;
  if (role == Role::axis_x || role == Role::axis_y) return scale(value, axis, result);
  if (role == Role::per_axis) return scale(value, p.length - axis, result);
  if (!scale(value, p.length, result)) return false;
  if (!p.moved || role == Role::length) return true;
  return add(result, std::ldexp(role == Role::x ? offset_x : offset_y, p.length), result);
}

/// The shape at a placement, false when a number of it is not a T.
template <class T>
bool place(const Shape<double>& shape, const Placement& p, int axis, Shape<T>& result) {
  result = {shape.kind, {}};
  for (std::size_t i = 0; i < shape.number.size(); ++i) {
    double value = 0;
    if (!place_number(shape.number[i], roles[shape.kind][i], p, axis, value)) return false;
    if (std::fabs(value) > static_cast<double>(std::numeric_limits<T>::max())) return false;
    result.number[i] = static_cast<T>(value);
    if (static_cast<double>(result.number[i]) != value) return false;
  }
  return true;
}

/// Ways of writing a pair that cannot change its answer.
enum class Spelling { as_stated, mirrored_x, mirrored_y, quarter_turned, rewritten };
constexpr Spelling spellings[] = {Spelling::as_stated, Spelling::mirrored_x, Spelling::mirrored_y,
                                  Spelling::quarter_turned, Spelling::rewritten};
constexpr const char* spelling_names[] = {"as stated", "mirrored in x", "mirrored in y", "quarter turned", "rewritten"};

template <class T>
void move_vector(T& x, T& y, Spelling spelling) {
  if (spelling == Spelling::mirrored_x) x = -x;
  if (spelling == Spelling::mirrored_y) y = -y;
  if (spelling == Spelling::quarter_turned) x = -std::exchange(y, x);
}

/// The same points under other numbers: ends of a segment exchanged, axis turned by a quarter and sizes exchanged.
template <class T>
void rewrite(Shape<T>& s) {
  auto& n = s.number;
  if (s.kind == VESICA_SEGMENT || s.kind == VESICA_CAPSULE) {
    std::swap(n[0], n[2]);
    std::swap(n[1], n[3]);
  }
  if (has_axis(s.kind)) {
    move_vector(n[2], n[3], Spelling::quarter_turned);
    std::swap(n[4], n[5]);
  }
}

template <class T>
Shape<T> spell(Shape<T> s, Spelling spelling) {
  if (spelling == Spelling::rewritten) {
    rewrite(s);
    return s;
  }
  for (std::size_t i = 0; i < s.number.size(); ++i) {
    const Role role = roles[s.kind][i];
    if (role == Role::x || role == Role::axis_x) move_vector(s.number[i], s.number[i + 1], spelling);
  }
  if (s.kind == VESICA_AABB) {
    // The smaller end of an axis is now the larger one.
    if (spelling == Spelling::mirrored_x || spelling == Spelling::quarter_turned) std::swap(s.number[0], s.number[2]);
    if (spelling == Spelling::mirrored_y) std::swap(s.number[1], s.number[3]);
  }
  return s;
}

std::int32_t by_kind(const Shape<double>& a, const Shape<double>& b) {
  return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
}
std::int32_t by_kind(const Shape<float>& a, const Shape<float>& b) {
  return vesica_overlap_f32(a.kind, a.number.data(), b.kind, b.number.data());
}
std::int32_t typed(const Functions& f, const Shape<double>& a, const Shape<double>& b) {
  return f.f64(a.number.data(), b.number.data());
}
std::int32_t typed(const Functions& f, const Shape<float>& a, const Shape<float>& b) {
  return f.f32(a.number.data(), b.number.data());
}

template <class T>
std::string text(const Shape<T>& s) {
  std::string result = vesica_kind_name(s.kind);
  for (int i = 0; i < vesica_field_count(s.kind); ++i) {
    char number[40];
    std::snprintf(number, sizeof number, " %a", static_cast<double>(s.number[static_cast<std::size_t>(i)]));
    result += number;
  }
  return result;
}

/// Asks one case in every spelling through every function; false, with the case reported, at the first wrong answer.
template <class T>
bool ask(const Functions& functions, const Shape<T>& stated_a, const Shape<T>& stated_b, std::int32_t expected) {
  for (Spelling spelling : spellings) {
    const Shape<T> a = spell(stated_a, spelling);
    const Shape<T> b = spell(stated_b, spelling);
    const bool has_types = functions.f64 != nullptr;
    const std::int32_t answers[] = {has_types ? typed(functions, a, b) : expected, by_kind(a, b), by_kind(b, a)};
    if (answers[0] == expected && answers[1] == expected && answers[2] == expected) continue;
    ADD_FAILURE() << "expected " << expected << ", got " << answers[0] << " typed, " << answers[1] << " by kind, "
                  << answers[2] << " by kind in the other order\n  " << text(a) << "\n  " << text(b) << "\n  "
                  << (sizeof(T) == 4 ? "float, " : "double, ") << spelling_names[static_cast<int>(spelling)];
    return false;
  }
  return true;
}

template <class T>
void step(Shape<T>& s, int field, bool upward) {
  T& number = s.number[static_cast<std::size_t>(field)];
  const T infinity = std::numeric_limits<T>::infinity();
  number = std::nextafter(number, upward ? infinity : -infinity);
}

template <class T>
bool ask_nudged(const Functions& functions, Shape<T> a, Shape<T> b, const Nudge& nudge, std::int32_t expected) {
  step(nudge.side == first ? a : b, nudge.field, nudge.up);
  return ask(functions, a, b, expected);
}

/// Asks the family wherever it is representable; returns at how many places that was.
template <class T>
int ask_everywhere(const Functions& functions, const Shape<double>& a, const Shape<double>& b,
                   std::initializer_list<Nudge> nudges, const Answers& answers) {
  int asked = 0;
  for (const Placement& p : placements<T>(has_axis(a.kind), has_axis(b.kind))) {
    Shape<T> placed_a{}, placed_b{};
    if (!place(a, p, p.axis_a, placed_a) || !place(b, p, p.axis_b, placed_b)) continue;
    ++asked;
    if (!ask(functions, placed_a, placed_b, answers.stated)) return asked;
    for (const Nudge& nudge : nudges) {
      const Nudge opposite{nudge.side, nudge.field, !nudge.up};
      if (!ask_nudged(functions, placed_a, placed_b, nudge, answers.nudged)) return asked;
      if (!ask_nudged(functions, placed_a, placed_b, opposite, answers.opposite)) return asked;
    }
  }
  return asked;
}

}  // namespace

void expect(const Functions& functions, const Shape<double>& a, const Shape<double>& b,
            std::initializer_list<Nudge> nudges, const Answers& answers) {
  // Placement 0 is the literal itself and always representable in double; the other scales must not all drop out.
  const int in_double = ask_everywhere<double>(functions, a, b, nudges, answers);
  if (!::testing::Test::HasFailure()) {
    EXPECT_GE(in_double, 2) << "representable at too few scales";
  }
  // Literals of more than 24 bits are no floats at any scale.
  ask_everywhere<float>(functions, a, b, nudges, answers);
}

}  // namespace contact
