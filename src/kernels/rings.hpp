// SPDX-License-Identifier: Apache-2.0
// The kernels of overlap for polygons of three or four vertices. Included by block.hpp.
#pragma once

#include <vesica/filter/convex_rings.hpp>

#include "kernels/block_loop.hpp"

namespace vesica {
namespace {

/// Rings in columns: coordinate k of ring i at first[0][k * ring_column + i], x before y of each vertex.
template <class T, int n, bool repeats>
class RingOperand {
 public:
  using V = LanesOf<T>;

  VESICA_INLINE explicit RingOperand(Unaligned<T> from) noexcept : from_(from) {}
  VESICA_INLINE filter::Ring<V, n> at(std::int32_t i) const noexcept {
    return {filter::numbers<n>([&](int k) { return number(2 * k, i); }),
            filter::numbers<n>([&](int k) { return number(2 * k + 1, i); })};
  }

 private:
  VESICA_INLINE V number(int k, std::int32_t i) const noexcept {
    if constexpr (repeats) return V(from_[k * ring_column]);
    return V::load(from_ + (k * ring_column + i));
  }
  Unaligned<T> from_;
};

template <class T, int n, bool repeats>
[[gnu::noinline]] VESICA_KERNEL BlockResult answer_rings(const Block<T>& block) noexcept {
  constexpr std::int32_t width = LanesOf<T>::width;
  constexpr std::uint32_t lanes = (1u << width) - 1;
  const RingOperand<T, n, repeats> first(block.first[0]);
  const RingOperand<T, n, false> second(block.second[0]);
  const std::int32_t count = block.count;
  std::uint8_t* const out = block.out;
  std::int32_t* list = block.undecided;
  const filter::Ring<LanesOf<T>, n> repeated = first.at(0);
  for (std::int32_t i = 0; i < count; i += width) {
    const auto a = repeats ? repeated : first.at(i), b = second.at(i);
    const filter::RingBoxes boxes(a, b);
    const auto apart = both(boxes.usable(a, b), boxes.apart());
    if (repeats && all(apart)) {
      store_bytes(and_not(apart, apart), out + i);
      continue;
    }
    const auto verdict = filter::convex_rings(a, b, boxes);
    store_bytes(verdict.overlap, out + i);
    const auto known = either(either(verdict.overlap, verdict.disjoint), apart);
    if (!all(known)) [[unlikely]]
      list = append(~bits(known) & lanes, i, list);
  }
  return {0, static_cast<std::int32_t>(list - block.undecided)};
}

}  // namespace
}  // namespace vesica
