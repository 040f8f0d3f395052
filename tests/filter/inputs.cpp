// SPDX-License-Identifier: Apache-2.0
#include "filter/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace inputs {
namespace {

template <class V>
V moved_by_places(V x, int places) {
  const V end = places < 0 ? std::numeric_limits<V>::lowest() : std::numeric_limits<V>::max();
  for (int i = places < 0 ? -places : places; i > 0; --i) x = std::nextafter(x, end);
  return x;
}

template <class V>
struct Direction {
  V x, y;
};

/// The axis of the shape at n: coordinate axes for kinds without one.
template <class V>
Direction<V> axis(vesica::Kind kind, const V* n) {
  switch (kind) {
    case vesica::Kind::segment:
      return {n[2] - n[0], n[3] - n[1]};
    case vesica::Kind::rect:
    case vesica::Kind::ellipse:
      return {n[2], n[3]};
    default:
      return {1, 0};
  }
}

template <class V>
void set_axis(vesica::Kind kind, V* n, Direction<V> u) {
  if (kind == vesica::Kind::segment) {
    n[2] = n[0] + u.x;
    n[3] = n[1] + u.y;
  } else if (kind == vesica::Kind::rect || kind == vesica::Kind::ellipse) {
    n[2] = u.x;
    n[3] = u.y;
  }
}

}  // namespace

float places_from(float x, int places) { return moved_by_places(x, places); }
double places_from(double x, int places) { return moved_by_places(x, places); }

template <class V>
Inputs<V>::Inputs(vesica::Kind a, vesica::Kind b, const Exponents& exponents, properties::Random& random)
    : a_(a),
      b_(b),
      roles_a_(roles[static_cast<int>(a)]),
      roles_b_(roles[static_cast<int>(b)]),
      first_count_(static_cast<int>(roles_a_.size())),
      second_count_(static_cast<int>(roles_b_.size())),
      exponents_(exponents),
      random_(random) {}

/// Its significand random, short, or all ones: the last two meet ties and the greatest relative roundings.
template <class V>
V Inputs<V>::number(int low, int high) {
  using Limits = std::numeric_limits<V>;
  double significand = random_.between(1, 2);
  const int style = random_.below(8);
  if (style == 0) significand = 1 + random_.below(64) / 64.0;
  if (style == 1) significand = 1 + static_cast<double>(Limits::epsilon()) * random_.below(16);
  if (style == 2) significand = 2 - static_cast<double>(Limits::epsilon()) * random_.integer(1, 16);
  const int exponent =
      std::clamp(random_.integer(low, high), Limits::min_exponent - Limits::digits, Limits::max_exponent - 2);
  return static_cast<V>(std::ldexp(significand * random_.sign(), exponent));
}

template <class V>
void Inputs<V>::draw_each(Numbers<V>& n) {
  Exponents e = exponents_;
  int position_low = e.size_low, position_high = e.size_high;
  const int style = random_.below(5);
  if (style <= 1) {
    // Sizes and offsets about alike, axes about 1, at any scale the guard knows; now and then thin.
    const int scale = random_.integer(e.size_low, e.size_high), thin = random_.chance(0.3) ? random_.integer(1, 40) : 0;
    e = {std::max(-1, e.axis_low), std::min(0, e.axis_high), std::max(scale - 1 - thin, e.size_low), scale + 1};
    position_low = scale - 1;
    position_high = scale + 2;
  } else if (style == 2) {
    // The guard's edges.
    const bool low_axis = random_.chance(0.5), low_size = random_.chance(0.5);
    (low_axis ? e.axis_high : e.axis_low) = low_axis ? e.axis_low + 3 : e.axis_high - 3;
    (low_size ? e.size_high : e.size_low) = low_size ? e.size_low + 3 : e.size_high - 3;
  }
  for (int i = 0; i < count(); ++i) {
    if (role(i) == 'p') n[i] = number(position_low, position_high);
    if (role(i) == 'a') n[i] = number(e.axis_low, e.axis_high);
    if (role(i) == 's') n[i] = std::abs(number(e.size_low, e.size_high));
    const double zero = role(i) == 's' ? 0.02 : 0.05;
    if (random_.chance(zero)) n[i] = 0;
  }
  if (style == 3) make_needles(n);
}

/// One of two sizes is the least that the guard lets pass; the offset lies along an axis, where the other size counts,
/// and perhaps axes lie along each other.
template <class V>
void Inputs<V>::make_needles(Numbers<V>& n) {
  for (int i = 0; i + 1 < count(); ++i) {
    if (role(i) != 's' || role(i + 1) != 's') continue;
    n[i + random_.below(2)] = std::abs(number(exponents_.size_low, exponents_.size_low + 2));
    ++i;
  }
  if (random_.chance(0.5)) turn_axis(n);
  turn_offset(n);
}

template <class V>
Numbers<V> Inputs<V>::moved(Numbers<V> n, V x, V y) const {
  for (int i = 0; i + 1 < second_count_ && role(first_count_ + i) == 'p'; i += 2) {
    n[first_count_ + i] += x;
    n[first_count_ + i + 1] += y;
  }
  return n;
}

/// The offset of the shapes' first points along or across an axis, so that a product of the two cancels: where
/// possible to zero after rounding, but not before.
template <class V>
void Inputs<V>::turn_offset(Numbers<V>& n) {
  const V* second = n.data() + first_count_;
  const Direction<V> u = random_.chance(0.5) ? axis(a_, n.data()) : axis(b_, second);
  const double length = std::hypot(static_cast<double>(u.x), static_cast<double>(u.y));
  const bool across = random_.chance(0.5);
  V x = 0, y = 0;
  for (int i = 0; i < 20; ++i) {
    const V factor = static_cast<V>(static_cast<double>(number(exponents_.size_low, exponents_.size_high)) / length);
    x = factor * (across ? -u.y : u.x);
    y = factor * (across ? u.x : u.y);
    const V product = across ? u.x * x : u.x * y, other = across ? u.y * y : -u.y * x;
    if (product + other == 0 && std::fma(u.y, across ? y : -x, product) != 0) break;
  }
  // The first shape at the origin: then the offset is not rounded again.
  if (random_.chance(0.5)) {
    const V ox = n[0], oy = n[1];
    for (int i = 0; i + 1 < first_count_ && role(i) == 'p'; i += 2) {
      n[i] -= ox;
      n[i + 1] -= oy;
    }
  }
  n = moved(n, (n[0] + x) - second[0], (n[1] + y) - second[1]);
}

/// The second axis along or across the first, up to a factor and a few places.
template <class V>
void Inputs<V>::turn_axis(Numbers<V>& n) {
  Direction<V> u = axis(a_, n.data());
  if (random_.chance(0.5)) u = {-u.y, u.x};
  const V factor = random_.chance(0.3) ? V(1) : number(-3, 2);
  const int places = random_.chance(0.5) ? 2 : 0;
  const V x = places_from(factor * u.x, random_.integer(-places, places));
  const V y = places_from(factor * u.y, random_.integer(-places, places));
  set_axis(b_, n.data() + first_count_, {x, y});
}

/// Both shapes far from the origin: differences of coordinates cancel.
template <class V>
void Inputs<V>::move_away(Numbers<V>& n) {
  const int digits = random_.integer(1, std::numeric_limits<V>::digits);
  const V x = std::ldexp(n[0], digits), y = std::ldexp(n[1], digits);
  for (int i = 0; i < count(); ++i) {
    if (role(i) != 'p') continue;
    const bool is_x = (i < first_count_ ? i : i - first_count_) % 2 == 0;
    n[i] += is_x ? x : y;
  }
}

template <class V>
void Inputs<V>::make_valid(Numbers<V>& n) const {
  for (int i = 0; i < count(); ++i) {
    if (!std::isfinite(n[i])) n[i] = 1;
    if (role(i) == 's') n[i] = std::abs(n[i]);
    if (role(i) == 'a' && role(i + 1) == 'a' && n[i] == 0 && n[i + 1] == 0) n[i] = 1;
  }
  const auto order = [](V* box) {
    if (box[0] > box[2]) std::swap(box[0], box[2]);
    if (box[1] > box[3]) std::swap(box[1], box[3]);
  };
  if (a_ == vesica::Kind::aabb) order(n.data());
  if (b_ == vesica::Kind::aabb) order(n.data() + first_count_);
}

template <class V>
Numbers<V> Inputs<V>::draw() {
  Numbers<V> n{};
  draw_each(n);
  if (random_.chance(0.3)) turn_axis(n);
  if (random_.chance(0.4)) turn_offset(n);
  if (random_.chance(0.2)) move_away(n);
  make_valid(n);
  return n;
}

template <class V>
void Inputs<V>::change_one(Numbers<V>& n) {
  const int field = random_.below(count());
  V& x = n[field];
  switch (random_.below(6)) {
    case 0:
    case 1:
      x = places_from(x, random_.integer(-4, 4));
      break;
    case 2:
      x = std::ldexp(x, random_.integer(-2, 2));
      break;
    case 3:
      x = std::ldexp(x, random_.integer(-12, 12));
      break;
    case 4:
      // Another significand of the same magnitude.
      if (x != 0) x = std::copysign(number(std::ilogb(x), std::ilogb(x)), x);
      break;
    default:
      x = random_.chance(0.5) ? -x : x * static_cast<V>(random_.between(0.99, 1.01));
  }
}

template <class V>
Numbers<V> Inputs<V>::changed(Numbers<V> n) {
  const int what = random_.below(16);
  if (what == 0) {
    turn_offset(n);
  } else if (what == 1) {
    turn_axis(n);
  } else {
    for (int changes = random_.integer(1, 3); changes > 0; --changes) change_one(n);
  }
  make_valid(n);
  return n;
}

template class Inputs<float>;
template class Inputs<double>;

template <class V>
std::string describe(const Numbers<V>& n, int first_count, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    char number[40];
    std::snprintf(number, sizeof number, "%s%a",
                  i == 0             ? ""
                  : i == first_count ? " | "
                                     : ", ",
                  static_cast<double>(n[i]));
    text += number;
  }
  return text;
}

template std::string describe(const Numbers<float>& n, int first_count, int count);
template std::string describe(const Numbers<double>& n, int first_count, int count);

}  // namespace inputs
