// SPDX-License-Identifier: Apache-2.0
#include "batch/near_tie_hash/contact.hpp"

#include <vesica.h>

#include <bit>
#include <cmath>
#include <cstddef>

namespace near_tie {

std::int32_t overlap(const Pair<float>& p) { return vesica_overlap_f32(p.kind_a, p.a.data(), p.kind_b, p.b.data()); }
std::int32_t overlap(const Pair<double>& p) { return vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()); }

namespace {

constexpr std::uint64_t seed = 20240229;
constexpr int groups = 64;
constexpr int reach = 64;

/// Integers from a seed, by SplitMix64 (Steele, Lea and Flood 2014).
class Integers {
 public:
  explicit Integers(std::uint64_t first_state) : state_(first_state) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// In low ... high.
  int between(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low + 1);
    return low + static_cast<int>(bits() % count);
  }

 private:
  std::uint64_t state_;
};

// Each number is drawn in a statement of its own: the order in which a compiler evaluates arguments is its own choice.

/// The kind of numbers that a pair is made of.
enum class Style { integers, fractions, axis_lengths };

template <class T>
class Maker {
 public:
  Maker(Integers& integers, Style style) : integers_(integers), style_(style) {}

  /// A shape whose first two numbers are (x, y), which it contains.
  Numbers<T> shape_at(int kind, T x, T y) {
    Numbers<T> n{x, y, 0, 0, 0, 0};
    switch (kind) {
      case VESICA_POINT:
        break;
      case VESICA_CIRCLE:
        n[2] = size();
        break;
      case VESICA_SEGMENT:
      case VESICA_AABB:
        n[2] = x + signed_size(kind == VESICA_SEGMENT);
        n[3] = y + signed_size(kind == VESICA_SEGMENT);
        break;
      default:
        set_axis(n);
        n[4] = size();
        n[5] = size();
    }
    return n;
  }

  T coordinate() { return style_ == Style::integers ? T(integers_.between(-9, 9)) : fraction() * T(8) - T(4); }

  /// A number that is likely to part two shapes, or to join them.
  T replacement(T old, bool is_size) {
    const int times = integers_.between(1, 16);
    if (is_size) return old * T(times) / T(4);
    const T step = coordinate();
    return old + step * T(times) / T(4);
  }

 private:
  /// In [0, 1), a multiple of 2^-24, so that it is a float.
  T fraction() { return T(static_cast<std::uint32_t>(integers_.bits() >> 40)) * T(0x1p-24); }

  T size() {
    if (integers_.between(0, 15) == 0) return 0;
    if (style_ == Style::integers) return T(integers_.between(1, 5));
    const T x = fraction();
    return x * T(2) + T(0.125);
  }

  T signed_size(bool either_sign) {
    const T x = size();
    return either_sign && integers_.between(0, 1) == 1 ? -x : x;
  }

  void set_axis(Numbers<T>& n) {
    if (style_ == Style::integers) {
      set_integer_axis(n);
      return;
    }
    // A direction by its half angle's tangent, of unit length up to rounding.
    const T x = fraction(), y = fraction();
    const T dx = x - T(0.5), dy = y - T(0.46875);
    const T length = std::sqrt(dx * dx + dy * dy) + T(0x1p-30);
    T times = 1;
    if (style_ == Style::axis_lengths) times = T(integers_.between(1, 40)) / T(7);
    n[2] = dx / length * times + T(0x1p-40);
    n[3] = dy / length * times;
  }

  void set_integer_axis(Numbers<T>& n) {
    n[2] = T(integers_.between(1, 5));
    n[3] = T(integers_.between(-5, 5));
  }

  Integers& integers_;
  Style style_;
};

int field_count(int kind) {
  constexpr std::array<int, 6> counts{2, 4, 3, 4, 6, 6};
  return counts[static_cast<std::size_t>(kind)];
}
bool is_size(int kind, int field) { return kind == VESICA_CIRCLE ? field == 2 : field >= 4; }
bool is_axis(int kind, int field) { return kind >= VESICA_RECT && (field == 2 || field == 3); }

/// All lengths times a power of two, which is exact while the numbers stay normal.
template <class T>
void scale(int kind, Numbers<T>& n, T power) {
  for (int k = 0; k < field_count(kind); ++k) {
    if (!is_axis(kind, k)) n[static_cast<std::size_t>(k)] *= power;
  }
}

template <class T>
T power_of_two(int exponent) {
  T power = 1;
  for (; exponent > 0; --exponent) power *= 2;
  for (; exponent < 0; ++exponent) power /= 2;
  return power;
}

/// One in four pairs is scaled far away from 1.
template <class T>
T some_power(Integers& integers) {
  constexpr int far = sizeof(T) == sizeof(float) ? 60 : 450;
  if (integers.between(0, 3) != 0) return 1;
  return power_of_two<T>(integers.between(-far, far));
}

template <class T>
T& number(Pair<T>& pair, bool in_b, int field) {
  return (in_b ? pair.b : pair.a)[static_cast<std::size_t>(field)];
}

/// Two shapes that share the point both begin with.
template <class T>
Pair<T> joined(int kind_a, int kind_b, Maker<T>& maker) {
  const T x = maker.coordinate();
  const T y = maker.coordinate();
  Pair<T> pair{kind_a, kind_b, {}, {}};
  pair.a = maker.shape_at(kind_a, x, y);
  pair.b = maker.shape_at(kind_b, x, y);
  return pair;
}

/// Two shapes whose first points are apart, but often not by much.
template <class T>
Pair<T> scattered(int kind_a, int kind_b, Maker<T>& maker) {
  Pair<T> pair = joined(kind_a, kind_b, maker);
  const T x = maker.coordinate();
  const T y = maker.coordinate();
  pair.b = maker.shape_at(kind_b, pair.a[0] + x / T(2), pair.a[1] + y / T(2));
  return pair;
}

template <class T>
auto to_bits(T x) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return std::bit_cast<std::int32_t>(x);
  } else {
    return std::bit_cast<std::int64_t>(x);
  }
}

/// Place of x among all numbers of its type: 0 for both zeros, then one by one in either direction.
template <class T>
std::int64_t place_of(T x) {
  const T magnitude = std::fabs(x);
  const std::int64_t place = to_bits(magnitude);
  return x < 0 ? -place : place;
}
template <class T>
T at_place(std::int64_t place) {
  using Bits = decltype(to_bits(T{}));
  const T magnitude = std::bit_cast<T>(static_cast<Bits>(place < 0 ? -place : place));
  return place < 0 ? -magnitude : magnitude;
}

/// The places between which the answer changes, next to each other; the pair's number is left at one of them.
template <class T>
std::int64_t bisect(Pair<T>& pair, T& x, T other) {
  const std::int32_t answer = overlap(pair);
  std::int64_t same = place_of(x), different = place_of(other);
  while (same + 1 < different || different + 1 < same) {
    // The mean, without sum or difference: both may overflow.
    const std::int64_t middle = same / 2 + different / 2 + (same % 2 + different % 2) / 2;
    x = at_place<T>(middle);
    (overlap(pair) == answer ? same : different) = middle;
  }
  return same;
}

/// One number of a pair, and another for it.
template <class T>
struct Change {
  bool in_b;
  int field;
  T number;
};

template <class T>
Change<T> draw_change(Pair<T>& pair, Maker<T>& maker, Integers& integers) {
  const bool in_b = integers.between(0, 1) == 1;
  const int kind = in_b ? pair.kind_b : pair.kind_a;
  const int field = integers.between(0, field_count(kind) - 1);
  const T other = maker.replacement(number(pair, in_b, field), is_size(kind, field) || is_axis(kind, field));
  const T power = some_power<T>(integers);
  scale(pair.kind_a, pair.a, power);
  scale(pair.kind_b, pair.b, power);
  return {in_b, field, is_axis(kind, field) ? other : other * power};
}

/// False when the change does not change the answer. Neighbours that are no shapes are left out.
template <class T>
bool append_if_found(Pair<T> pair, const Change<T>& change, std::vector<Pair<T>>& pairs) {
  T& x = number(pair, change.in_b, change.field);
  const T before = x;
  const std::int32_t answer = overlap(pair);
  x = change.number;
  const std::int32_t changed = overlap(pair);
  x = before;
  if (answer < 0 || changed < 0 || changed == answer) return false;
  const std::int64_t contact = bisect(pair, x, change.number);
  for (std::int64_t place = contact - reach; place <= contact + reach; ++place) {
    x = at_place<T>(place);
    if (overlap(pair) >= 0) pairs.push_back(pair);
  }
  return true;
}

template <class T>
void append_contact(int kind_a, int kind_b, Integers& integers, std::vector<Pair<T>>& pairs) {
  for (;;) {
    const auto style = static_cast<Style>(integers.between(0, 2));
    Maker<T> maker(integers, style);
    const bool join = integers.between(0, 2) == 0;
    Pair<T> pair = join ? joined(kind_a, kind_b, maker) : scattered(kind_a, kind_b, maker);
    const Change<T> change = draw_change(pair, maker, integers);
    if (append_if_found(pair, change, pairs)) return;
  }
}

}  // namespace

template <class T>
std::vector<Pair<T>> contacts(int kind_a, int kind_b) {
  Integers integers(seed + static_cast<std::uint64_t>((kind_a * 6 + kind_b) * 2) + sizeof(T) / 8);
  std::vector<Pair<T>> pairs;
  for (int i = 0; i < groups; ++i) append_contact(kind_a, kind_b, integers, pairs);
  return pairs;
}

template std::vector<Pair<float>> contacts(int, int);
template std::vector<Pair<double>> contacts(int, int);

}  // namespace near_tie
