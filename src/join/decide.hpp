// SPDX-License-Identifier: Apache-2.0
// Decides candidates: shapes are gathered from the caller's arrays into columns, and a batch function answers a run of
// pairs of the same kinds at a time. Scalar calls would cost three times as much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "index/shapes.hpp"
#include "join/recent.hpp"

namespace vesica::index {

/// Answers n pairs in columns, the first shape repeated where count_a is 1: out[i] = 1 or 0.
using Decide = void (*)(std::int32_t kind_a, const void* const* a, std::int64_t count_a, std::int32_t kind_b,
                        const void* const* b, std::int64_t n, std::uint8_t* out);

/// Pairs decided at once: their columns stay in the nearest cache.
inline constexpr int decided_at_once = 256;

/// Shapes as columns, of whichever scalar they are.
struct Columns {
  alignas(64) unsigned char column[max_fields][decided_at_once * sizeof(double)];
  const void* field[max_fields];

  /// Shapes of paths, one struct after the other.
  template <class T>
  Polygon<T>* paths() noexcept {
    static_assert(sizeof column >= decided_at_once * sizeof(Polygon<T>));
    return reinterpret_cast<Polygon<T>*>(column[0]);
  }

  /// To be called before the first use: columns may lie in scratch.
  void begin() noexcept {
    for (int k = 0; k < max_fields; ++k) field[k] = column[k];
  }
};

/// One shape as columns.
struct OneShape {
  alignas(double) unsigned char number[max_fields][sizeof(double)];
  const void* field[max_fields];

  /// The first shape of others.
  void set(const Columns& first, std::int32_t kind) noexcept {
    for (int k = 0; k < max_fields; ++k) {
      std::memcpy(number[k], first.column[k], sizeof number[k]);
      field[k] = number[k];
    }
    static_assert(sizeof number >= sizeof(Polygon<double>));
    if (!is_row(kind)) std::memcpy(number[0], first.column[0], sizeof(Polygon<double>));
  }
};

/// Records are prefetched this many places ahead: both of a pair are at random places in memory.
inline constexpr int prefetch_distance = 40;

/// Inlined at once: g++ takes calls of a function that only prefetches for calls without an effect, and drops them.
VESICA_INLINE void prefetch(const Set& set, std::int64_t item) noexcept {
  const auto at = static_cast<std::ptrdiff_t>((item - set.first) * set.stride);
  __builtin_prefetch(set.field[0] + at);
  __builtin_prefetch(set.field[field_count(set.kind) - 1] + at);
}

/// The records of a set, read from the caller's memory.
class FromSet {
 public:
  explicit FromSet(const Set& set) noexcept : base_(set.field[0] - set.first * set.stride), stride_(set.stride) {}
  const unsigned char* at(std::uint32_t item) noexcept { return base_ + static_cast<std::int64_t>(item) * stride_; }
  VESICA_INLINE void prefetch(std::uint32_t item, std::size_t bytes) noexcept {
    // To the second cache: the first takes few at a time.
    __builtin_prefetch(at(item), 0, 2);
    __builtin_prefetch(at(item) + bytes - 1, 0, 2);
  }

 private:
  const unsigned char* base_;
  std::ptrdiff_t stride_;
};

/// The same for a set whose numbers are not adjacent: they are copied into records, except the last two.
template <class T>
class FromColumns {
 public:
  explicit FromColumns(const Set& set) noexcept : set_(set) {}
  const unsigned char* at(std::uint32_t item) noexcept {
    turn_ = !turn_;
    T* const to = number_[static_cast<int>(turn_)];
    for (int k = 0; k < field_count(set_.kind); ++k) std::memcpy(to + k, place(k, item), sizeof(T));
    return reinterpret_cast<const unsigned char*>(to);
  }
  VESICA_INLINE void prefetch(std::uint32_t item, std::size_t) noexcept {
    for (int k = 0; k < field_count(set_.kind); ++k) __builtin_prefetch(place(k, item), 0, 2);
  }

 private:
  const unsigned char* place(int k, std::uint32_t item) const noexcept {
    return set_.field[k] + (static_cast<std::int64_t>(item) - set_.first) * set_.stride;
  }
  const Set& set_;
  bool turn_ = false;
  T number_[2][max_fields];
};

/// Either one, through the cache of recent records (recent.hpp).
template <class From>
struct FromRecent {
  From& set;
  const Recent& recent;
  std::uint32_t mark;  // 0 or Recent::of_second

  const unsigned char* at(std::uint32_t item) noexcept { return recent.at(set, item, mark); }
  void prefetch(std::uint32_t, std::size_t) noexcept {}
};

/// Copies n records to columns; `behind` more items follow these.
template <class T, int Fields, class From>
void gather_records(From from, const std::uint32_t* item, int n, int behind, Columns& out) noexcept {
  int i = 0;
  for (; i + 2 <= n; i += 2) {
    const int ahead = i + prefetch_distance;
    if (ahead + 2 <= n + behind) {
      from.prefetch(item[ahead], Fields * sizeof(T));
      from.prefetch(item[ahead + 1], Fields * sizeof(T));
    }
    const unsigned char *first = from.at(item[i]), *second = from.at(item[i + 1]);
    for (int k = 0; k + 2 <= Fields; k += 2) {
      Two<T> a, b;
      std::memcpy(&a, first + static_cast<std::size_t>(k) * sizeof(T), sizeof a);
      std::memcpy(&b, second + static_cast<std::size_t>(k) * sizeof(T), sizeof b);
      const Two<T> low = {a[0], b[0]}, high = {a[1], b[1]};
      std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T), &low, sizeof low);
      std::memcpy(out.column[k + 1] + static_cast<std::size_t>(i) * sizeof(T), &high, sizeof high);
    }
    if constexpr (Fields % 2 != 0) {
      std::memcpy(out.column[Fields - 1] + static_cast<std::size_t>(i) * sizeof(T), first + (Fields - 1) * sizeof(T),
                  sizeof(T));
      std::memcpy(out.column[Fields - 1] + static_cast<std::size_t>(i + 1) * sizeof(T),
                  second + (Fields - 1) * sizeof(T), sizeof(T));
    }
  }
  for (; i < n; ++i) {
    for (int k = 0; k < Fields; ++k) {
      std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T),
                  from.at(item[i]) + static_cast<std::size_t>(k) * sizeof(T), sizeof(T));
    }
  }
}

template <class T, int Fields, class From>
void gather_fetched(From from, const std::uint32_t* item, int n, Recent& recent, std::uint32_t mark,
                    Columns& out) noexcept {
  recent.fetch<Fields * sizeof(T)>(from, item, n, mark);
  gather_records<T, Fields>(FromRecent<From>{from, recent, mark}, item, n, 0, out);
}

/// Items of one set, through the cache of recent records if `recent` is given.
template <class T, int Fields>
void gather_set(const Set& set, const std::uint32_t* item, int n, int behind, Recent* recent, std::uint32_t mark,
                Columns& out) noexcept {
  const bool in_records = lies_in_records<T>(set);
  if (recent == nullptr && in_records) return gather_records<T, Fields>(FromSet(set), item, n, behind, out);
  if (recent == nullptr) return gather_records<T, Fields>(FromColumns<T>(set), item, n, behind, out);
  if (in_records) return gather_fetched<T, Fields>(FromSet(set), item, n, *recent, mark, out);
  gather_fetched<T, Fields>(FromColumns<T>(set), item, n, *recent, mark, out);
}

/// The set that all items of a kind are of, if it is one.
inline const Set* only_set_of(const Sets& sets, std::int32_t kind) noexcept {
  const Set* found = nullptr;
  for (int i = 0; i < sets.count; ++i) {
    if (sets.set[i].kind != kind) continue;
    if (found != nullptr) return nullptr;
    found = &sets.set[i];
  }
  return found;
}

/// Structs of items that are polygons, or polylines.
template <class T>
void gather_paths(const Sets& sets, const std::uint32_t* item, int n, Columns& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const Set& set = sets.set[sets.of(item[i])];
    out.paths<T>()[i] = path_at<T>(set.paths(), item[i] - set.first);
  }
}

/// Columns of items of one kind; of polygons and polylines structs.
template <class T>
void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n, int behind, Recent* recent,
                    std::uint32_t mark, Columns& out) noexcept {
  if (!is_row(kind)) return gather_paths<T>(sets, item, n, out);
  if (const Set* set = only_set_of(sets, kind)) {
    return with_field_count(field_count(kind), [&]<int count>(std::integral_constant<int, count>) {
      gather_set<T, count>(*set, item, n, behind, recent, mark, out);
    });
  }
  for (int i = 0; i < n; ++i) {
    if (i + prefetch_distance < n + behind) {
      const std::uint32_t ahead = item[i + prefetch_distance];
      prefetch(sets.set[sets.of(ahead)], ahead);
    }
    const Set& set = sets.set[sets.of(item[i])];
    for (int k = 0; k < field_count(kind); ++k) {
      const T number = number_of<T>(set, k, item[i]);
      std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T), &number, sizeof number);
    }
  }
}

/// Not inlined: where few are gathered, compilers warn of the prefetches, which do not happen there. Where `recent`
/// is given it has begun, and `mark` distinguishes the sets that use it.
[[gnu::noinline]] inline void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n,
                                             int behind, Columns& out, Recent* recent = nullptr,
                                             std::uint32_t mark = 0) noexcept {
  return sets.is_float ? gather_columns<float>(sets, kind, item, n, behind, recent, mark, out)
                       : gather_columns<double>(sets, kind, item, n, behind, recent, mark, out);
}

}  // namespace vesica::index
