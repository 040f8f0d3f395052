// SPDX-License-Identifier: Apache-2.0
/// vesica::Index<T>: an index that owns its memory, and loops over the pairs of two. A C++20 face of vesica.h, for
/// programs that link the library.
///
///     const vesica::Index<double> trees({vesica::shapes(circles), vesica::shapes(boxes)});
///     const vesica::Index<double> roads({vesica::shapes(rects)});
///     for (const auto& [tree, road] : vesica::pairs(trees, roads)) ...
///
/// The shapes stay the caller's: an index keeps the descriptors of their arrays, and the arrays must outlive it.
#pragma once

#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vesica {

namespace index_face {

/// The C functions of a scalar type.
template <class T>
struct Functions;
template <>
struct Functions<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
  static constexpr auto build = vesica_index_build_f64;
  static constexpr auto select = vesica_index_select_f64;
  static constexpr auto nearest = vesica_index_nearest_f64;
  static constexpr auto join = vesica_join_f64;
};
template <>
struct Functions<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
  static constexpr auto build = vesica_index_build_f32;
  static constexpr auto select = vesica_index_select_f32;
  static constexpr auto nearest = vesica_index_nearest_f32;
  static constexpr auto join = vesica_join_f32;
};

/// The kind of a struct of the library's, and the type of its numbers.
template <class T, std::int32_t the_kind>
struct Is {
  using Scalar = T;
  static constexpr std::int32_t kind = the_kind;
};
template <class Struct>
struct Shape;
template <>
struct Shape<vesica_point_f64> : Is<double, VESICA_POINT> {};
template <>
struct Shape<vesica_segment_f64> : Is<double, VESICA_SEGMENT> {};
template <>
struct Shape<vesica_circle_f64> : Is<double, VESICA_CIRCLE> {};
template <>
struct Shape<vesica_aabb_f64> : Is<double, VESICA_AABB> {};
template <>
struct Shape<vesica_rect_f64> : Is<double, VESICA_RECT> {};
template <>
struct Shape<vesica_ellipse_f64> : Is<double, VESICA_ELLIPSE> {};
template <>
struct Shape<vesica_point_f32> : Is<float, VESICA_POINT> {};
template <>
struct Shape<vesica_segment_f32> : Is<float, VESICA_SEGMENT> {};
template <>
struct Shape<vesica_circle_f32> : Is<float, VESICA_CIRCLE> {};
template <>
struct Shape<vesica_aabb_f32> : Is<float, VESICA_AABB> {};
template <>
struct Shape<vesica_rect_f32> : Is<float, VESICA_RECT> {};
template <>
struct Shape<vesica_ellipse_f32> : Is<float, VESICA_ELLIPSE> {};

/// Memory aligned as an index and scratch must be.
class Memory {
 public:
  explicit Memory(std::int64_t bytes)
      : bytes_(bytes), data_(::operator new (static_cast<std::size_t>(bytes), std::align_val_t{64})) {}
  void* data() const { return data_.get(); }
  std::int64_t size() const { return bytes_; }

 private:
  struct Delete {
    void operator()(void* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  std::int64_t bytes_;
  std::unique_ptr<void, Delete> data_;
};

/// A result, or what vesica_strerror says of it.
inline std::int64_t checked(std::int64_t result) {
  if (result < 0) throw std::invalid_argument(vesica_strerror(static_cast<std::int32_t>(result)));
  return result;
}

}  // namespace index_face

/// The descriptor of an array of shapes, as vesica_rect_f64.
template <class Array>
auto shapes(const Array& array) {
  const std::span all(array);
  using Struct = typename decltype(all)::value_type;
  using Functions = index_face::Functions<typename index_face::Shape<Struct>::Scalar>;
  typename Functions::Shapes out;
  index_face::checked(
      Functions::from_records(index_face::Shape<Struct>::kind, std::ssize(all), all.data(), sizeof(Struct), &out));
  return out;
}

/// An index of one or more sets of shapes. Invalid shapes are left out; has_invalid() says whether there were any.
template <class T>
class Index {
 public:
  using Shapes = typename index_face::Functions<T>::Shapes;

  explicit Index(std::span<const Shapes> sets) : sets_(sets.begin(), sets.end()), memory_(build(sets)) {}
  explicit Index(std::initializer_list<Shapes> sets) : Index(std::span<const Shapes>(sets.begin(), sets.size())) {}
  /// A copy of the bytes of an index of the same sets, from wherever they come: they are checked.
  Index(std::span<const Shapes> sets, std::span<const std::byte> saved)
      : sets_(sets.begin(), sets.end()), memory_(std::ssize(saved)) {
    if (!saved.empty()) std::memcpy(memory_.data(), saved.data(), saved.size());
    index_face::checked(vesica_index_check(memory_.data(), memory_.size()));
  }

  const void* data() const { return memory_.data(); }
  /// The bytes to save.
  std::span<const std::byte> bytes() const {
    const auto size = static_cast<std::size_t>(vesica_index_bytes(data()));
    return {static_cast<const std::byte*>(data()), size};
  }
  std::int64_t count() const { return vesica_index_count(data()); }
  bool has_invalid() const { return vesica_index_order(data(), nullptr, 0) < count(); }
  const Shapes* sets() const { return sets_.data(); }
  std::int32_t set_count() const { return static_cast<std::int32_t>(sets_.size()); }

  /// Items in spatial order.
  std::vector<std::int64_t> order() const {
    std::vector<std::int64_t> items(static_cast<std::size_t>(vesica_index_order(data(), nullptr, 0)));
    vesica_index_order(data(), items.data(), static_cast<std::int64_t>(items.size()));
    return items;
  }

  /// Items that overlap a single shape.
  std::vector<std::int64_t> overlapping(const Shapes& one) const {
    std::vector<std::int64_t> items;
    std::array<std::int64_t, 256> some;
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) {
      const auto n = index_face::checked(
          index_face::Functions<T>::select(data(), sets(), set_count(), &one, some.data(), std::ssize(some), state));
      items.insert(items.end(), some.begin(), some.begin() + n);
    }
    return items;
  }

  /// The k items nearest to a single shape, at most `within` away, each with its distance.
  std::vector<std::pair<std::int64_t, T>> nearest(const Shapes& one, std::int64_t k, T within) const {
    std::vector<std::int64_t> items(static_cast<std::size_t>(k));
    std::vector<T> distance(static_cast<std::size_t>(k));
    const auto n = index_face::checked(
        index_face::Functions<T>::nearest(data(), sets(), set_count(), &one, k, within, items.data(), distance.data()));
    std::vector<std::pair<std::int64_t, T>> found;
    if (k == 0) return found;  // n is how many there are
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found.emplace_back(items[i], distance[i]);
    return found;
  }

 private:
  index_face::Memory build(std::span<const Shapes> sets) {
    std::int64_t items = 0;
    for (const Shapes& set : sets) items += set.count;
    index_face::Memory memory(index_face::checked(vesica_index_size(items)));
    const index_face::Memory scratch(index_face::checked(vesica_index_scratch(items)));
    const auto result = index_face::Functions<T>::build(sets.data(), static_cast<std::int32_t>(sets.size()),
                                                        memory.data(), memory.size(), scratch.data(), scratch.size());
    if (result != VESICA_E_SHAPE) index_face::checked(result);
    return memory;
  }

  std::vector<Shapes> sets_;
  index_face::Memory memory_;
};

/// The pairs of two indexes, or of one with itself, for a range-based for: fetched a few thousand at a time. It refers
/// to the indexes, which must outlive it and stay where they are.
template <class T>
class Pairs {
 public:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  Pairs(const Index<T>& a, const Index<T>& b, std::int32_t query)
      : a_(a), b_(b), query_(query), scratch_(vesica_join_scratch()) {}

  class Iterator {
   public:
    using value_type = Pair;
    using difference_type = std::ptrdiff_t;
    explicit Iterator(Pairs& pairs) : pairs_(&pairs) { pairs_->fetch(); }
    Pair operator*() const { return {pairs_->first_[pairs_->at_], pairs_->second_[pairs_->at_]}; }
    Iterator& operator++() {
      if (++pairs_->at_ == pairs_->count_) pairs_->fetch();
      return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t) const { return pairs_->at_ == pairs_->count_; }

   private:
    Pairs* pairs_;
  };
  /// Starts the loop again; only one loop at a time.
  Iterator begin() {
    for (std::int64_t& s : state_) s = 0;
    return Iterator(*this);
  }
  std::default_sentinel_t end() const { return {}; }

  /// How many there are.
  std::int64_t count() { return index_face::checked(call(nullptr, nullptr, 0, nullptr)); }

 private:
  std::int64_t call(std::int64_t* first, std::int64_t* second, std::int64_t capacity, std::int64_t* state) {
    return index_face::Functions<T>::join(query_, a_.data(), a_.sets(), a_.set_count(), b_.data(), b_.sets(),
                                          b_.set_count(), 0, 1, scratch_.data(), scratch_.size(), first, second,
                                          capacity, state);
  }
  void fetch() {
    at_ = count_ = 0;
    while (count_ == 0 && state_[0] != -1) {
      count_ = static_cast<std::size_t>(
          index_face::checked(call(first_.data(), second_.data(), std::ssize(first_), state_)));
    }
  }

  const Index<T>& a_;
  const Index<T>& b_;
  std::int32_t query_;
  index_face::Memory scratch_;
  std::array<std::int64_t, 2048> first_, second_;
  std::size_t at_ = 0, count_ = 0;
  std::int64_t state_[4] = {0, 0, 0, 0};
};

template <class T>
Pairs<T> pairs(const Index<T>& a, const Index<T>& b, std::int32_t query = VESICA_JOIN_OVERLAP) {
  return Pairs<T>(a, b, query);
}
/// Pairs a < b of one index.
template <class T>
Pairs<T> pairs(const Index<T>& a) {
  return Pairs<T>(a, a, VESICA_JOIN_OVERLAP);
}

}  // namespace vesica
