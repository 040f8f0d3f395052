// SPDX-License-Identifier: Apache-2.0
// Several arrays of shapes (sets) numbered through: shape i of set s is item i + the counts of the sets before. Both
// scalars.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vesica/shapes.hpp>

#include "by_kind.hpp"
#include "polygon/element.hpp"

namespace vesica::index {

inline constexpr int chunk = 256;

/// The most sets: a view of them has room on the stack.
inline constexpr int most_sets = 64;

struct Set {
  std::int32_t kind;
  std::int64_t first, count;  // items
  std::ptrdiff_t stride;      // bytes
  const unsigned char* field[max_fields];
  // For polygons and polylines alone, as in vesica_shapes_<T>. Without initializers: a view has room for many sets, of
  // which few are there.
  const std::int32_t *rings, *polygons;
  std::int64_t each;

  PathArray paths() const noexcept {
    const auto at = [this](int k) { return reinterpret_cast<const std::byte*>(field[k]); };
    return {at(0), at(1), stride, rings, polygons, each};
  }
};

struct Sets {
  bool is_float = false;
  int count = 0;
  std::int64_t items = 0;
  Set set[most_sets];

  /// The set of an item. Without a branch on the item, which would be mispredicted.
  int of(std::int64_t item) const noexcept {
    int s = 0;
    for (int i = 1; i < count; ++i) s += static_cast<int>(item >= set[i].first);
    return s;
  }
};

/// Numbers of up to `chunk` shapes, a column a field, exact as doubles.
struct Fields {
  alignas(64) double column[max_fields][chunk];
};

template <class T>
void load_field(const unsigned char* field, std::ptrdiff_t stride, std::int64_t begin, int n, double* out) noexcept {
  const unsigned char* at = field + begin * stride;
  for (int i = 0; i < n; ++i, at += stride) {
    T x;
    std::memcpy(&x, at, sizeof x);
    out[i] = static_cast<double>(x);
  }
}

/// True if a set's shapes are records, their numbers side by side.
template <class T>
bool lies_in_records(const Set& set) noexcept {
  auto next = reinterpret_cast<std::uintptr_t>(set.field[0]);
  for (int k = 1; k < field_count(set.kind); ++k) {
    next += sizeof(T);
    if (reinterpret_cast<std::uintptr_t>(set.field[k]) != next) return false;
  }
  return true;
}

/// Two numbers of a record at a time.
template <class T>
using Two [[gnu::vector_size(2 * sizeof(T)), gnu::aligned(alignof(T))]] = T;

/// n records, two by two; of an odd number of fields the last two overlap the two before.
template <class T, int Count>
void load_records(const unsigned char* at, std::ptrdiff_t stride, int n, Fields& out) noexcept {
  int i = 0;
  for (; i + 2 <= n; i += 2, at += 2 * stride) {
    constexpr int prefetch_distance = 32;
    // Hardware prefetchers stop at the end of a page.
    __builtin_prefetch(at + prefetch_distance * stride);
    __builtin_prefetch(at + (prefetch_distance + 1) * stride);
    for (int next = 0; next < Count; next += 2) {
      const int k = next + 2 <= Count ? next : Count - 2;
      Two<T> a, b;
      std::memcpy(&a, at + static_cast<std::size_t>(k) * sizeof(T), sizeof a);
      std::memcpy(&b, at + stride + static_cast<std::size_t>(k) * sizeof(T), sizeof b);
      const Two<double> low = {static_cast<double>(a[0]), static_cast<double>(b[0])};
      const Two<double> high = {static_cast<double>(a[1]), static_cast<double>(b[1])};
      std::memcpy(&out.column[k][i], &low, sizeof low);
      std::memcpy(&out.column[k + 1][i], &high, sizeof high);
    }
  }
  if (i == n) return;
  for (int k = 0; k < Count; ++k) {
    T x;
    std::memcpy(&x, at + static_cast<std::size_t>(k) * sizeof(T), sizeof x);
    out.column[k][i] = static_cast<double>(x);
  }
}

template <class T>
void load_fields(const Set& set, std::int64_t begin, int n, Fields& out) noexcept {
  const int fields = field_count(set.kind);
  if (lies_in_records<T>(set)) {
    const unsigned char* at = set.field[0] + begin * set.stride;
    return with_field_count(
        fields, [&]<int count>(std::integral_constant<int, count>) { load_records<T, count>(at, set.stride, n, out); });
  }
  for (int k = 0; k < fields; ++k) load_field<T>(set.field[k], set.stride, begin, n, out.column[k]);
}

/// n shapes of a set from its element `begin` on.
inline void load(const Sets& sets, const Set& set, std::int64_t begin, int n, Fields& out) noexcept {
  if (sets.is_float) {
    load_fields<float>(set, begin, n, out);
  } else {
    load_fields<double>(set, begin, n, out);
  }
}

/// One number of an item.
template <class T>
T number_of(const Set& set, int k, std::int64_t item) noexcept {
  T x;
  std::memcpy(&x, set.field[k] + (item - set.first) * set.stride, sizeof x);
  return x;
}

/// An item's numbers as doubles. Returns its kind.
template <class T>
std::int32_t read_item(const Sets& sets, std::uint32_t item, double (&out)[max_fields]) noexcept {
  const Set& set = sets.set[sets.of(item)];
  for (int k = 0; k < field_count(set.kind); ++k) out[k] = static_cast<double>(number_of<T>(set, k, item));
  return set.kind;
}
inline std::int32_t read_item(const Sets& sets, std::uint32_t item, double (&out)[max_fields]) noexcept {
  return sets.is_float ? read_item<float>(sets, item, out) : read_item<double>(sets, item, out);
}

template <class T>
void gather_field(const Set& set, int k, const std::uint32_t* item, int n, double* out) noexcept {
  for (int i = 0; i < n; ++i) out[i] = static_cast<double>(number_of<T>(set, k, item[i]));
}

/// The named items, all of one set.
inline void gather(const Sets& sets, const Set& set, const std::uint32_t* item, int n, Fields& out) noexcept {
  for (int k = 0; k < field_count(set.kind); ++k) {
    if (sets.is_float) {
      gather_field<float>(set, k, item, n, out.column[k]);
    } else {
      gather_field<double>(set, k, item, n, out.column[k]);
    }
  }
}

}  // namespace vesica::index
