// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box in vectors of 8.
#pragma once

#include <emmintrin.h>

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  __m128i min_x, min_y, max_x, max_y;
  explicit BoxLanes(const GridBox& b) noexcept
      : min_x(_mm_set1_epi16(static_cast<short>(b.min_x))),
        min_y(_mm_set1_epi16(static_cast<short>(b.min_y))),
        max_x(_mm_set1_epi16(static_cast<short>(b.max_x))),
        max_y(_mm_set1_epi16(static_cast<short>(b.max_y))) {}
};

inline __m128i load_8(const std::uint16_t* p) noexcept { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)); }

/// A bit for each of 32 boxes that meets the window. a <= b where a - b, limited to 0 from below, is 0.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  std::uint32_t mask = 0;
  const __m128i zero = _mm_setzero_si128();
  for (int half = 0; half < 2; ++half) {
    __m128i meets[2];
    for (int part = 0; part < 2; ++part) {
      const int i = 16 * half + 8 * part;
      const __m128i x =
          _mm_or_si128(_mm_subs_epu16(load_8(min_x + i), w.max_x), _mm_subs_epu16(w.min_x, load_8(max_x + i)));
      const __m128i y =
          _mm_or_si128(_mm_subs_epu16(load_8(min_y + i), w.max_y), _mm_subs_epu16(w.min_y, load_8(max_y + i)));
      meets[part] = _mm_cmpeq_epi16(_mm_or_si128(x, y), zero);
    }
    mask |= static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(meets[0], meets[1]))) << (16 * half);
  }
  return mask;
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  std::uint32_t mask = 0;
  const __m128d min_x = _mm_set1_pd(box[0]), min_y = _mm_set1_pd(box[1]);
  const __m128d max_x = _mm_set1_pd(box[2]), max_y = _mm_set1_pd(box[3]);
  for (int i = 0; i < node_children; i += 2) {
    const __m128d x =
        _mm_and_pd(_mm_cmple_pd(_mm_load_pd(node.min_x + i), max_x), _mm_cmpge_pd(_mm_load_pd(node.max_x + i), min_x));
    const __m128d y =
        _mm_and_pd(_mm_cmple_pd(_mm_load_pd(node.min_y + i), max_y), _mm_cmpge_pd(_mm_load_pd(node.max_y + i), min_y));
    mask |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_and_pd(x, y))) << i;
  }
  return mask;
}

}  // namespace
}  // namespace vesica::index

#include "index/lanes/bits.hpp"
