// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box in vectors of 16.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  __m256i min_x, min_y, max_x, max_y;
  explicit BoxLanes(const GridBox& b) noexcept
      : min_x(_mm256_set1_epi16(static_cast<short>(b.min_x))),
        min_y(_mm256_set1_epi16(static_cast<short>(b.min_y))),
        max_x(_mm256_set1_epi16(static_cast<short>(b.max_x))),
        max_y(_mm256_set1_epi16(static_cast<short>(b.max_y))) {}
};

inline __m256i load_16(const std::uint16_t* p) noexcept {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
}

/// A bit for each of 32 boxes that meets the window. a <= b where a - b, limited to 0 from below, is 0.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  __m256i meets[2];
  for (int i = 0; i < 2; ++i) {
    const __m256i x = _mm256_or_si256(_mm256_subs_epu16(load_16(min_x + 16 * i), w.max_x),
                                      _mm256_subs_epu16(w.min_x, load_16(max_x + 16 * i)));
    const __m256i y = _mm256_or_si256(_mm256_subs_epu16(load_16(min_y + 16 * i), w.max_y),
                                      _mm256_subs_epu16(w.min_y, load_16(max_y + 16 * i)));
    meets[i] = _mm256_cmpeq_epi16(_mm256_or_si256(x, y), _mm256_setzero_si256());
  }
  // Packing works within halves of registers: quarters 0 2 1 3 are put in order.
  const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packs_epi16(meets[0], meets[1]), 0xD8);
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes));
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  std::uint32_t mask = 0;
  const __m256d min_x = _mm256_set1_pd(box[0]), min_y = _mm256_set1_pd(box[1]);
  const __m256d max_x = _mm256_set1_pd(box[2]), max_y = _mm256_set1_pd(box[3]);
  for (int i = 0; i < node_children; i += 4) {
    const __m256d x = _mm256_and_pd(_mm256_cmp_pd(_mm256_load_pd(node.min_x + i), max_x, _CMP_LE_OQ),
                                    _mm256_cmp_pd(_mm256_load_pd(node.max_x + i), min_x, _CMP_GE_OQ));
    const __m256d y = _mm256_and_pd(_mm256_cmp_pd(_mm256_load_pd(node.min_y + i), max_y, _CMP_LE_OQ),
                                    _mm256_cmp_pd(_mm256_load_pd(node.max_y + i), min_y, _CMP_GE_OQ));
    mask |= static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_and_pd(x, y))) << i;
  }
  return mask;
}

}  // namespace
}  // namespace vesica::index

#include "index/lanes/bits.hpp"
