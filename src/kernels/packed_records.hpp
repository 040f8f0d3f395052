// SPDX-License-Identifier: Apache-2.0
// Loads records that follow each other without gaps, a vector for each of their numbers. Included after the lanes of an
// instruction set.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "unaligned.hpp"

namespace vesica {
namespace {

/// Beyond 16 bytes.
inline constexpr bool has_long_vectors = sizeof(Floats) >= 32;

template <class T, int length>
using NumberVector [[gnu::vector_size(length * sizeof(T))]] = T;

/// Numbers in a vector of the lanes (16 bytes where these are no vector).
template <class T>
inline constexpr int packed_length = std::clamp<int>(sizeof(Floats), 16, 64) / sizeof(T);

/// Numbers of a part of a vector within which numbers can be moved by one operation: AVX-512 moves them anywhere.
template <class T>
inline constexpr int part_length = (sizeof(Floats) == 64 ? 64 : 16) / sizeof(T);

template <class Vector>
using NumberOf = std::remove_cvref_t<decltype(std::declval<Vector&>()[0])>;
template <class Vector>
inline constexpr int part_of = part_length<NumberOf<Vector>>;

/// In each part, number i is number from(i) of the same part of a, or number from(i) - part of b.
template <auto from, class Vector>
VESICA_INLINE Vector shuffled(const Vector& a, const Vector& b) noexcept {
  constexpr int part = part_of<Vector>, length = sizeof(Vector) / sizeof(NumberOf<Vector>);
  return [&]<int... i>(std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(a, b,
                                   (i - i % part + from(i % part) + (from(i % part) < part ? 0 : length - part))...);
  }
  (std::make_integer_sequence<int, length>{});
}

/// Units come in rows of n, three to a record. Returns where a vector from three() has unit `unit` of record r.
constexpr int place_in_three(int unit, int n, int r) noexcept { return n <= 2 ? r : (3 * r + unit) % n; }

/// Which of the three vectors has the unit that belongs in that place, for n > 2. Three is coprime to n: no two of
/// these units have the same place in their vectors.
constexpr int vector_of_three(int unit, int n, int place) noexcept {
  int r = 0;
  while (place_in_three(unit, n, r) != place) ++r;
  return (3 * r + unit) / n;
}

/// A unit is `size` numbers, three units are a record, and three vectors have as many records as one has units. Returns
/// unit `unit` of each record.
template <int unit, int size, class Vector>
VESICA_INLINE Vector three(const Vector& a, const Vector& b, const Vector& c) noexcept {
  constexpr int part = part_of<Vector>, n = part / size;
  if constexpr (n == 1) {
    return unit == 0 ? a : unit == 1 ? b : c;
  } else if constexpr (n == 2) {
    constexpr auto from = [](int i) {
      return i < size ? unit % 2 * size + i : part + (3 + unit) % 2 * size + (i - size);
    };
    return shuffled<from>(unit == 2 ? b : a, unit == 0 ? b : c);
  } else {
    constexpr auto second = [](int i) { return vector_of_three(unit, n, i / size) == 1 ? part + i : i; };
    constexpr auto third = [](int i) { return vector_of_three(unit, n, i / size) == 2 ? part + i : i; };
    return shuffled<third>(shuffled<second>(a, b), c);
  }
}

/// The same where two units are a record; in order of records.
template <int unit, int size, class Vector>
VESICA_INLINE Vector two(const Vector& a, const Vector& b) noexcept {
  constexpr int n = part_of<Vector> / size;
  if constexpr (n == 1) {
    return unit == 0 ? a : b;
  } else {
    constexpr auto from = [](int i) { return (2 * (i / size) + unit) * size + i % size; };
    return shuffled<from>(a, b);
  }
}

/// Two vectors hold a pair of fields of each record; the first has the first half of a part's records. Returns where
/// the pair of record r begins.
template <int fields, int pair, int part>
constexpr int place_of_pair(int r) noexcept {
  constexpr int half = part / 2;
  const int in_half = r % half;
  return 2 * (fields == 6 ? place_in_three(pair, half, in_half) : in_half) + (r < half ? 0 : part);
}
template <int fields, int pair, class Vector>
VESICA_INLINE void split_pair(const Vector& a, const Vector& b, Vector (&out)[fields]) noexcept {
  constexpr auto first = [](int i) { return place_of_pair<fields, pair, part_of<Vector>>(i); };
  constexpr auto second = [](int i) { return place_of_pair<fields, pair, part_of<Vector>>(i) + 1; };
  out[2 * pair] = shuffled<first>(a, b);
  out[2 * pair + 1] = shuffled<second>(a, b);
}

/// The numbers of a part's worth of records in each part, as they lie in memory: one vector of `fields`.
template <int fields, int which, class T>
VESICA_INLINE auto load_window(Unaligned<T> from) noexcept {
  constexpr int part = part_length<T>;
  if constexpr (packed_length<T> == part) {
    NumberVector<T, part> all;
    (from + which * part).copy_to(all);
    return all;
  } else {
    static_assert(packed_length<T> == 2 * part);
    NumberVector<T, part> low, high;
    (from + which * part).copy_to(low);
    (from + (part * fields + which * part)).copy_to(high);
    return [&]<int... i>(std::integer_sequence<int, i...>) { return __builtin_shufflevector(low, high, i...); }
    (std::make_integer_sequence<int, 2 * part>{});
  }
}

/// Fields of three a record, one number each: in order of records.
template <int field, class Vector>
VESICA_INLINE Vector one_of_three(const Vector& a, const Vector& b, const Vector& c) noexcept {
  constexpr auto from = [](int i) { return place_in_three(field, part_of<Vector>, i); };
  const Vector numbers = three<field, 1>(a, b, c);
  return shuffled<from>(numbers, numbers);
}

/// Counts of a record's numbers that load_packed() takes.
constexpr bool loads_packed(int fields) noexcept { return fields == 2 || fields == 3 || fields == 4 || fields == 6; }

/// Loads a vector's worth of records.
template <int fields, class T, class Vector>
VESICA_INLINE void load_packed(Unaligned<T> from, Vector (&out)[fields]) noexcept {
  static_assert(loads_packed(fields));
  const auto a = load_window<fields, 0>(from), b = load_window<fields, 1>(from);
  if constexpr (fields == 2) {
    split_pair<fields, 0>(a, b, out);
  } else if constexpr (fields == 3) {
    const auto c = load_window<fields, 2>(from);
    out[0] = one_of_three<0>(a, b, c);
    out[1] = one_of_three<1>(a, b, c);
    out[2] = one_of_three<2>(a, b, c);
  } else if constexpr (fields == 4) {
    const auto c = load_window<fields, 2>(from), d = load_window<fields, 3>(from);
    split_pair<fields, 0>(two<0, 2>(a, b), two<0, 2>(c, d), out);
    split_pair<fields, 1>(two<1, 2>(a, b), two<1, 2>(c, d), out);
  } else {
    const auto c = load_window<fields, 2>(from), d = load_window<fields, 3>(from);
    const auto e = load_window<fields, 4>(from), f = load_window<fields, 5>(from);
    split_pair<fields, 0>(three<0, 2>(a, b, c), three<0, 2>(d, e, f), out);
    split_pair<fields, 1>(three<1, 2>(a, b, c), three<1, 2>(d, e, f), out);
    split_pair<fields, 2>(three<2, 2>(a, b, c), three<2, 2>(d, e, f), out);
  }
}

}  // namespace
}  // namespace vesica
