// SPDX-License-Identifier: Apache-2.0
// Arrays of shapes of several kinds laid end to end, of either scalar: shape i of set s is item i + the counts before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace vesica::index {

inline constexpr int most_fields = 6, kinds = 6, chunk = 256;
inline constexpr int fields_of[kinds] = {2, 4, 3, 4, 6, 6};
enum : std::int32_t { kind_point, kind_segment, kind_circle, kind_aabb, kind_rect, kind_ellipse };

/// At most so many sets, so that a view of them has room on the stack.
inline constexpr int most_sets = 64;

struct Set {
  std::int32_t kind;
  std::int64_t first, count;  // items
  std::ptrdiff_t stride;      // bytes
  const unsigned char* field[most_fields];
};

struct Sets {
  bool is_float = false;
  int count = 0;
  std::int64_t items = 0;
  Set set[most_sets];

  /// The set of an item.
  int of(std::int64_t item) const noexcept {
    int s = 0;
    while (s + 1 < count && item >= set[s + 1].first) ++s;
    return s;
  }
};

/// Numbers of up to `chunk` shapes, a column a field, exact as doubles.
struct Fields {
  alignas(64) double column[most_fields][chunk];
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

/// n shapes of a set from its element `begin` on.
inline void load(const Sets& sets, const Set& set, std::int64_t begin, int n, Fields& out) noexcept {
  for (int k = 0; k < fields_of[set.kind]; ++k) {
    if (sets.is_float) {
      load_field<float>(set.field[k], set.stride, begin, n, out.column[k]);
    } else {
      load_field<double>(set.field[k], set.stride, begin, n, out.column[k]);
    }
  }
}

template <class T>
void gather_field(const Set& set, int k, const std::uint32_t* item, int n, double* out) noexcept {
  for (int i = 0; i < n; ++i) {
    T x;
    std::memcpy(&x, set.field[k] + (static_cast<std::int64_t>(item[i]) - set.first) * set.stride, sizeof x);
    out[i] = static_cast<double>(x);
  }
}

/// The named items, all of one set.
inline void gather(const Sets& sets, const Set& set, const std::uint32_t* item, int n, Fields& out) noexcept {
  for (int k = 0; k < fields_of[set.kind]; ++k) {
    if (sets.is_float) {
      gather_field<float>(set, k, item, n, out.column[k]);
    } else {
      gather_field<double>(set, k, item, n, out.column[k]);
    }
  }
}

}  // namespace vesica::index
