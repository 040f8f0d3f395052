// SPDX-License-Identifier: Apache-2.0
// The loop behind every batch of overlap: load lanes, run the filter, store bytes, list the undecided elements.
// Included after the lanes of an instruction set.
#pragma once

#include <type_traits>
#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/overlap.hpp>

#include "kernels/filters.hpp"
#include "kernels/packed_records.hpp"
#include "kernels/table.hpp"

namespace vesica {
namespace {

template <class T>
using LanesOf = std::conditional_t<sizeof(T) == 4, Floats, Doubles>;

/// A shape of lanes from element i on, or one shape in every lane.
template <template <class> class Shape, class T, std::size_t... Field>
VESICA_INLINE Shape<LanesOf<T>> load_lanes(const Unaligned<T>* field, std::int32_t i,
                                           std::index_sequence<Field...>) noexcept {
  return {LanesOf<T>::load(field[Field] + i)...};
}
template <template <class> class Shape, class T, std::size_t... Field>
VESICA_INLINE Shape<LanesOf<T>> broadcast(const Unaligned<T>* field, std::index_sequence<Field...>) noexcept {
  return {LanesOf<T>(field[Field][0])...};
}

/// One operand of a kernel. It keeps copies of the column pointers: a store through a byte pointer may alias anything,
/// so the compiler would load the originals again in each iteration.
template <template <class> class Shape, class T, bool Repeated>
struct LaneOperand {
  static constexpr int fields = ShapeTraits<Shape<T>>::fields;
  Unaligned<T> field[fields];

  VESICA_INLINE explicit LaneOperand(const Unaligned<T>* from) noexcept {
    for (int k = 0; k < fields; ++k) field[k] = from[k];
  }
  VESICA_INLINE Shape<LanesOf<T>> at(std::int32_t i) const noexcept {
    return load_lanes<Shape>(field, i, std::make_index_sequence<fields>{});
  }
};

template <template <class> class Shape, class T>
struct LaneOperand<Shape, T, true> {
  Shape<LanesOf<T>> shape;

  VESICA_INLINE explicit LaneOperand(const Unaligned<T>* from) noexcept
      : shape(broadcast<Shape>(from, std::make_index_sequence<ShapeTraits<Shape<T>>::fields>{})) {}
  VESICA_INLINE const Shape<LanesOf<T>>& at(std::int32_t) const noexcept { return shape; }
};

/// Records without gaps as an operand: they become lanes in registers. Where lanes are vectors.
template <template <class> class Shape, class T>
struct PackedOperand {
  Unaligned<T> from;

  VESICA_INLINE Shape<LanesOf<T>> at(std::int32_t i) const noexcept {
    constexpr int fields = ShapeTraits<Shape<T>>::fields;
    NumberVector<T, LanesOf<T>::width> number[fields];
    load_packed<fields>(from + i * fields, number);
    return [&]<std::size_t... field>(std::index_sequence<field...>) {
      using Register = decltype(LanesOf<T>::v);
      return Shape<LanesOf<T>>{LanesOf<T>(static_cast<Register>(number[field]))...};
    }
    (std::make_index_sequence<fields>{});
  }
};

/// The verdicts on n elements, a vector at a time, in order.
template <class Filter, class First, class Second>
class Verdicts {
 public:
  VESICA_INLINE Verdicts(const Filter& filter, const First& first, const Second& second, std::int32_t) noexcept
      : filter_(filter), first_(first), second_(second) {}
  VESICA_INLINE auto at(std::int32_t i) noexcept { return filter_.filter(first_.at(i), second_.at(i)); }

 private:
  const Filter& filter_;
  const First& first_;
  const Second& second_;
};

/// Software pipelining, for a filter in two halves. Each half is a long chain of dependent operations, so the first
/// half of the next vector is computed beside the second half of this one. The processor then has two chains to work
/// on.
template <class Filter, class First, class Second>
requires HalfDone<decltype(std::declval<Filter>().filter(std::declval<First>().at(0), std::declval<Second>().at(0)))>
class Verdicts<Filter, First, Second> {
 public:
  VESICA_INLINE Verdicts(const Filter&, const First& first, const Second& second, std::int32_t n) noexcept
      : first_(first), second_(second), n_(n), next_(half(0)) {}
  VESICA_INLINE auto at(std::int32_t i) noexcept {
    const auto current = next_;
    next_ = half(i + width < n_ ? i + width : i);
    return decide(current);
  }

 private:
  VESICA_INLINE auto half(std::int32_t i) const noexcept { return Filter::filter(first_.at(i), second_.at(i)); }

  const First& first_;
  const Second& second_;
  std::int32_t n_;
  decltype(Filter::filter(std::declval<First>().at(0), std::declval<Second>().at(0))) next_;
  static constexpr std::int32_t width = decltype(next_)::Lanes::width;
};

/// Appends the indices of the lanes set in `open`.
VESICA_INLINE std::int32_t* append(std::uint32_t open, std::int32_t i, std::int32_t* list) noexcept {
  for (; open != 0; open &= open - 1) *list++ = i + __builtin_ctz(open);
  return list;
}

/// Answers a whole number of vectors; the caller takes care of the elements left over.
template <class Filter, class First, class Second, class T>
VESICA_INLINE BlockResult answer_whole(const Filter& filter, const First& first, const Second& second,
                                       const Block<T>& block) noexcept {
  constexpr std::int32_t width = LanesOf<T>::width;
  constexpr std::uint32_t lanes = (1u << width) - 1;
  const std::int32_t n = block.count;
  std::uint8_t* const out = block.out;
  std::int32_t* list = block.undecided;
  std::int32_t overlaps = 0;
  if (n == 0) return {0, 0};
  Verdicts<Filter, First, Second> verdicts(filter, first, second, n);
  for (std::int32_t i = 0; i < n; i += width) {
    const auto verdict = verdicts.at(i);
    store_bytes(verdict.overlap, out + i);
    overlaps += count(verdict.overlap);
    const auto known = decided(verdict);
    if (!all(known)) [[unlikely]] {
      list = append(~bits(known) & lanes, i, list);
      if (list - block.undecided > block.give_up) break;
    }
  }
  return {overlaps, static_cast<std::int32_t>(list - block.undecided)};
}

template <class Filter, template <class> class A, template <class> class B, class T, Repeat repeat>
[[gnu::noinline]] VESICA_KERNEL BlockResult answer_vectors(const Block<T>& block) noexcept {
  const LaneOperand<A, T, repeat == Repeat::first> first(block.first);
  const LaneOperand<B, T, repeat == Repeat::second> second(block.second);
  return answer_whole(Filter{}, first, second, block);
}

/// The same for two shapes of one kind, of records without gaps.
template <class Filter, template <class> class Shape, class T, Repeat repeat>
[[gnu::noinline]] VESICA_KERNEL BlockResult answer_packed(const Block<T>& block) noexcept {
  const PackedOperand<Shape, T> second{block.second[0]};
  if constexpr (repeat == Repeat::first) {
    return answer_whole(Filter{}, LaneOperand<Shape, T, true>(block.first), second, block);
  } else {
    return answer_whole(Filter{}, PackedOperand<Shape, T>{block.first[0]}, second, block);
  }
}

}  // namespace
}  // namespace vesica
