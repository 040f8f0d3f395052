// SPDX-License-Identifier: Apache-2.0
/// Random pairs of shapes for filters: in and about a filter's guard, and where rounding hurts most. Numbers of both
/// shapes stand in one flat array, first shape first, so that searches can change any of them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vesica/shapes.hpp>

#include "properties/random.hpp"

namespace inputs {

inline constexpr int most_numbers = 12;

template <class V>
using Numbers = std::array<V, most_numbers>;

template <class Shape>
Shape shape_at(const typename vesica::ShapeTraits<Shape>::Scalar* n) {
  if constexpr (vesica::ShapeTraits<Shape>::fields == 2) return {n[0], n[1]};
  if constexpr (vesica::ShapeTraits<Shape>::fields == 3) return {n[0], n[1], n[2]};
  if constexpr (vesica::ShapeTraits<Shape>::fields == 4) return {n[0], n[1], n[2], n[3]};
  if constexpr (vesica::ShapeTraits<Shape>::fields == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

/// The role of each number of a kind: p a coordinate, a an axis component, s a size. In the order of kinds.
inline constexpr std::string_view roles[vesica::kind_count] = {"pp",     "pppp",   "pps",   "pppp",
                                                               "ppaass", "ppaass", "pppps", "ppaasss"};

/// Exponents of two of the numbers, both ends included: a guard's, and a few beyond it.
struct Exponents {
  int axis_low, axis_high, size_low, size_high;
};
/// The exponents of a guard stated for float: 8 times as wide for double, as guards are.
template <class V>
constexpr Exponents widened(const Exponents& e) {
  constexpr int range = vesica::ScalarTraits<V>::range;
  return {range * e.axis_low, range * e.axis_high, range * e.size_low, range * e.size_high};
}

template <class V>
class Inputs {
 public:
  Inputs(vesica::Kind a, vesica::Kind b, const Exponents& exponents, properties::Random& random);

  /// A pair of valid shapes. Some lie outside of the guard.
  Numbers<V> draw();
  /// One number or a few changed, by places, by powers of two or anew; still valid.
  Numbers<V> changed(Numbers<V> n);
  /// The pair with the second shape moved until decide() first changes, to the last place; and then some.
  /// Returns n when it never changes.
  template <class Decide>
  Numbers<V> near_contact(Numbers<V> n, Decide decide);

  int first_count() const { return first_count_; }
  int count() const { return first_count_ + second_count_; }
  properties::Random& random() { return random_; }

 private:
  V number(int low, int high);
  void draw_each(Numbers<V>& n);
  void make_needles(Numbers<V>& n);
  void turn_offset(Numbers<V>& n);
  void turn_axis(Numbers<V>& n);
  void move_away(Numbers<V>& n);
  void change_one(Numbers<V>& n);
  void make_valid(Numbers<V>& n) const;
  Numbers<V> moved(Numbers<V> n, V x, V y) const;
  char role(int field) const { return field < first_count_ ? roles_a_[field] : roles_b_[field - first_count_]; }

  vesica::Kind a_, b_;
  std::string_view roles_a_, roles_b_;
  int first_count_, second_count_;
  Exponents exponents_;
  properties::Random& random_;
};

extern template class Inputs<float>;
extern template class Inputs<double>;

/// x moved by some places of its format; finite.
float places_from(float x, int places);
double places_from(double x, int places);

/// Both shapes with hexadecimal numbers.
template <class V>
std::string describe(const Numbers<V>& n, int first_count, int count);

extern template std::string describe(const Numbers<float>& n, int first_count, int count);
extern template std::string describe(const Numbers<double>& n, int first_count, int count);

template <class V>
template <class Decide>
Numbers<V> Inputs<V>::near_contact(Numbers<V> n, Decide decide) {
  const bool here = decide(n);
  const int from = first_count_;
  const V x = n[0] - n[from], y = n[1] - n[from + 1];  // towards the first shape
  V low = 0, high = here ? V(-1) : V(1);
  for (int i = 0; decide(moved(n, high * x, high * y)) == here; ++i) {
    if (i == 8) return n;
    high = high * 2;
  }
  for (int i = 0; i < 60; ++i) {
    const V middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (decide(moved(n, middle * x, middle * y)) == here ? low : high) = middle;
  }
  n = moved(n, low * x, low * y);
  for (int changes = random_.below(4); changes > 0; --changes) {
    const int field = random_.below(count());
    n[field] = places_from(n[field], random_.integer(-3, 3));
  }
  make_valid(n);
  return n;
}

}  // namespace inputs
