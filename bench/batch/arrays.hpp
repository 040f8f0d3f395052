// SPDX-License-Identifier: Apache-2.0
/// Arrays of shapes in memory: the pools batches are drawn from, and the buffers that are timed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "batch.hpp"
#include "by_kind.hpp"
#include "shapes.hpp"

namespace vesica::bench {

inline constexpr std::size_t cache_line = 64;  // bytes

struct Free {
  void operator()(void* memory) const noexcept { std::free(memory); }
};
template <class T>
using Memory = std::unique_ptr<T[], Free>;

/// `count` numbers on a cache line of their own.
template <class T>
Memory<T> allocate(std::size_t count) {
  if (count > PTRDIFF_MAX / sizeof(T) - cache_line) throw std::bad_array_new_length();
  const std::size_t bytes = (count * sizeof(T) + cache_line - 1) / cache_line * cache_line;
  Memory<T> memory(static_cast<T*>(std::aligned_alloc(cache_line, bytes)));
  if (!memory) throw std::bad_alloc();
  return memory;
}

/// Shapes of one kind, a column a number.
template <class T>
class Columns {
 public:
  Columns(std::int32_t kind, std::size_t capacity) : kind_(kind), capacity_(capacity) {
    // A line between columns: where their length is a power of two, all would otherwise compete for the same sets.
    const std::size_t step = capacity + cache_line / sizeof(T);
    memory_ = allocate<T>(step * static_cast<std::size_t>(fields()));
    for (int k = 0; k < fields(); ++k) field_[k] = memory_.get() + step * static_cast<std::size_t>(k);
  }

  Columns(std::int32_t kind, const std::vector<Numbers>& shapes) : Columns(kind, shapes.size()) {
    for (int k = 0; k < fields(); ++k) {
      for (std::size_t i = 0; i < capacity_; ++i) field_[k][i] = static_cast<T>(shapes[i][static_cast<std::size_t>(k)]);
    }
  }

  int fields() const { return field_count(kind_); }
  std::size_t capacity() const { return capacity_; }
  const T* const* columns() const { return field_; }

  /// Copies n elements of `from` on from the given one.
  void copy(const Columns& from, std::size_t begin, std::size_t n, std::size_t to = 0) {
    for (int k = 0; k < fields(); ++k) std::copy_n(from.field_[k] + begin, n, field_[k] + to);
  }

  void copy_one(const Columns& from, std::size_t index, std::size_t to) {
    for (int k = 0; k < fields(); ++k) field_[k][to] = from.field_[k][index];
  }

  /// The library's operand; the first `count` shapes. One shape is one that repeats.
  batch::Shapes<T> shapes(std::size_t count) const {
    const std::ptrdiff_t stride = count == 1 ? 0 : static_cast<std::ptrdiff_t>(sizeof(T));
    batch::Shapes<T> view{kind_, static_cast<std::int64_t>(count), stride, {}};
    std::copy_n(field_, fields(), view.field);
    return view;
  }

 private:
  std::int32_t kind_;
  std::size_t capacity_;
  Memory<T> memory_;
  T* field_[max_fields] = {};
};

/// Shapes of one kind, one after the other as an array of C structs.
template <class T>
class Records {
 public:
  Records(std::int32_t kind, std::size_t capacity)
      : kind_(kind), fields_(static_cast<std::size_t>(field_count(kind))), memory_(allocate<T>(capacity * fields_)) {}

  void copy(const Columns<T>& from, std::size_t begin, std::size_t n) {
    for (std::size_t k = 0; k < fields_; ++k) {
      for (std::size_t i = 0; i < n; ++i) memory_[i * fields_ + k] = from.columns()[k][begin + i];
    }
  }

  batch::Shapes<T> shapes(std::size_t count) const {
    const std::size_t stride = count == 1 ? 0 : fields_ * sizeof(T);
    batch::Shapes<T> view{kind_, static_cast<std::int64_t>(count), static_cast<std::ptrdiff_t>(stride), {}};
    for (std::size_t k = 0; k < fields_; ++k) view.field[k] = memory_.get() + k;
    return view;
  }

 private:
  std::int32_t kind_;
  std::size_t fields_;
  Memory<T> memory_;
};

}  // namespace vesica::bench
