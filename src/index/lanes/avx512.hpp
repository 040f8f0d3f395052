// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box in one vector; masks are compressed to lists without a branch.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "index/kernels.hpp"
#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  __m512i min_x, min_y, max_x, max_y;
  explicit BoxLanes(const GridBox& b) noexcept
      : min_x(_mm512_set1_epi16(static_cast<short>(b.min_x))),
        min_y(_mm512_set1_epi16(static_cast<short>(b.min_y))),
        max_x(_mm512_set1_epi16(static_cast<short>(b.max_x))),
        max_y(_mm512_set1_epi16(static_cast<short>(b.max_y))) {}
};

/// A bit for each of 32 boxes that meets the window.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  __mmask32 m = _mm512_cmple_epu16_mask(_mm512_loadu_si512(min_x), w.max_x);
  m = _mm512_mask_cmple_epu16_mask(m, _mm512_loadu_si512(min_y), w.max_y);
  m = _mm512_mask_cmpge_epu16_mask(m, _mm512_loadu_si512(max_x), w.min_x);
  return _mm512_mask_cmpge_epu16_mask(m, _mm512_loadu_si512(max_y), w.min_y);
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  __mmask8 m = _mm512_cmp_pd_mask(_mm512_load_pd(node.min_x), _mm512_set1_pd(box[2]), _CMP_LE_OQ);
  m = _mm512_mask_cmp_pd_mask(m, _mm512_load_pd(node.min_y), _mm512_set1_pd(box[3]), _CMP_LE_OQ);
  m = _mm512_mask_cmp_pd_mask(m, _mm512_load_pd(node.max_x), _mm512_set1_pd(box[0]), _CMP_GE_OQ);
  return _mm512_mask_cmp_pd_mask(m, _mm512_load_pd(node.max_y), _mm512_set1_pd(box[1]), _CMP_GE_OQ);
}

/// Numbers of a table of 8, 16, 32 or 64 by a vector of places.
template <int Count>
inline __m512d look_up(const double* table, __m512i place) noexcept {
  if constexpr (Count == 8) {
    return _mm512_permutexvar_pd(place, _mm512_loadu_pd(table));
  } else if constexpr (Count == 16) {
    return _mm512_permutex2var_pd(_mm512_loadu_pd(table), place, _mm512_loadu_pd(table + 8));
  } else {
    const __mmask8 upper = _mm512_test_epi64_mask(place, _mm512_set1_epi64(Count / 2));
    return _mm512_mask_blend_pd(upper, look_up<Count / 2>(table, place), look_up<Count / 2>(table + Count / 2, place));
  }
}

/// From places in one level of a plan, whose nodes are Count at most, to those in the next.
template <int Count>
inline __m512i descend_level(const double* level, __m512i place, __m512d x, __m512d y) noexcept {
  const __m512d cut = look_up<Count>(level, place);
  const __mmask8 vertical = _mm512_test_epi64_mask(_mm512_castpd_si512(cut), _mm512_set1_epi64(1));
  const __mmask8 upper = _mm512_cmp_pd_mask(_mm512_mask_blend_pd(vertical, x, y), cut, _CMP_GE_OQ);
  const __m512i twice = _mm512_add_epi64(place, place);
  return _mm512_mask_add_epi64(twice, upper, twice, _mm512_set1_epi64(1));
}

/// The nodes of a plan that items have come to after some levels; returns how many. The first levels' nodes are found
/// in registers. Reads and writes whole vectors of 8 items.
inline int descend_first_levels(const Plan& plan, const double* x, const double* y, int n,
                                std::uint32_t* node) noexcept {
  constexpr int levels = 7;
  if (plan.levels < levels) {
    for (int i = 0; i < n; ++i) node[i] = 0;
    return 0;
  }
  const double* const cuts = plan.node;
  for (int i = 0; i < n; i += 8) {
    const __m512d at_x = _mm512_loadu_pd(x + i), at_y = _mm512_loadu_pd(y + i);
    __m512i place = _mm512_setzero_si512();
    place = descend_level<8>(cuts, place, at_x, at_y);
    place = descend_level<8>(cuts + 1, place, at_x, at_y);
    place = descend_level<8>(cuts + 3, place, at_x, at_y);
    place = descend_level<8>(cuts + 7, place, at_x, at_y);
    place = descend_level<16>(cuts + 15, place, at_x, at_y);
    place = descend_level<32>(cuts + 31, place, at_x, at_y);
    place = descend_level<64>(cuts + 63, place, at_x, at_y);
    const __m512i nodes = _mm512_add_epi64(place, _mm512_set1_epi64((1 << levels) - 1));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(node + i), _mm512_cvtepi64_epi32(nodes));
  }
  return levels;
}

/// Lanes of two vectors of 16 numbers for which there is a bit, side by side. May write 32 numbers.
inline std::int32_t write_both(std::uint32_t mask, __m512i low, __m512i high, void* out) noexcept {
  const __mmask16 first = static_cast<__mmask16>(mask), second = static_cast<__mmask16>(mask >> 16);
  const int n = __builtin_popcount(first);
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(first, low));
  _mm512_storeu_si512(static_cast<std::uint32_t*>(out) + n, _mm512_maskz_compress_epi32(second, high));
  return n + __builtin_popcount(second);
}

/// Writes base + i for each bit i; may write up to 32 numbers. Returns how many bits there are.
inline std::int32_t write_lanes(std::uint32_t mask, std::uint32_t base, std::uint32_t* out) noexcept {
  const __m512i low = _mm512_add_epi32(_mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15),
                                       _mm512_set1_epi32(static_cast<int>(base)));
  // Most leaves have only the first 16.
  if (mask >> 16 != 0) return write_both(mask, low, _mm512_add_epi32(low, _mm512_set1_epi32(16)), out);
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), low));
  return __builtin_popcount(mask);
}

/// Writes item[i] for each bit i.
inline std::int32_t write_items(std::uint32_t mask, const std::uint32_t* item, std::uint32_t* out) noexcept {
  return write_both(mask, _mm512_loadu_si512(item), _mm512_loadu_si512(item + 16), out);
}

/// Writes item[i] for each bit i, and beside it `first`.
inline std::int32_t write_pairs(std::uint32_t mask, std::uint32_t first, const std::uint32_t* item,
                                std::uint32_t* out_first, std::uint32_t* out_second) noexcept {
  const __m512i firsts = _mm512_set1_epi32(static_cast<int>(first));
  _mm512_storeu_si512(out_first, firsts);
  const std::int32_t n = write_items(mask, item, out_second);
  if (n > 16) _mm512_storeu_si512(out_first + 16, firsts);
  return n;
}

/// Writes column[i] for each bit i.
inline void write_columns(std::uint32_t mask, const std::uint16_t* column, std::int32_t* out) noexcept {
  const __m512i both = _mm512_loadu_si512(column);
  write_both(mask, _mm512_cvtepu16_epi32(_mm512_castsi512_si256(both)),
             _mm512_cvtepu16_epi32(_mm512_extracti64x4_epi64(both, 1)), out);
}

}  // namespace
}  // namespace vesica::index
