// SPDX-License-Identifier: Apache-2.0
// All pairs of two indexes whose ratio is large enough, with the ratio.
#include <algorithm>

#include "index_arguments.hpp"
#include "join/join.hpp"
#include "join/ratio_bound.hpp"
#include "queries.hpp"
#include "queries/ratio.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;
using vesica::queries::is_symmetric;
namespace index = vesica::index;

/// The join's number of a ratio, beside those of VESICA_JOIN_...
constexpr uint32_t first_ratio = 16;

constexpr auto aabb = static_cast<int32_t>(vesica::Kind::aabb), rect = static_cast<int32_t>(vesica::Kind::rect);

bool is_box(int32_t kind) noexcept { return kind == aabb || kind == rect; }

/// A box of gathered columns.
template <class T>
index::Extent extent_at(int32_t kind, const index::Columns& shapes, int64_t i) noexcept {
  double numbers[vesica::max_fields];
  for (int k = 0; k < vesica::field_count(kind); ++k) {
    numbers[k] = static_cast<double>(reinterpret_cast<const T*>(shapes.column[k])[i]);
  }
  if (kind == aabb) return index::extent_of(vesica::load<vesica::Aabb<double>>(numbers));
  return index::extent_of(vesica::load<vesica::Rect<double>>(numbers));
}

template <class T>
void move(int32_t kind, index::Columns& shapes, int64_t from, int64_t to) noexcept {
  for (int k = 0; k < vesica::field_count(kind); ++k) {
    T* const column = reinterpret_cast<T*>(shapes.column[k]);
    column[to] = column[from];
  }
}

/// Moves the pairs of boxes whose ratio may be large enough to the front, and writes which they are. Returns how many.
template <class T>
int64_t keep_some(const index::RatioTest& asked, int32_t kind_a, index::Columns& a, int32_t kind_b, index::Columns& b,
                  int64_t n, uint16_t* kept) noexcept {
  const index::RatioBound bound({asked.ratio, asked.ratio == VESICA_RATIO_OVER_SMALLER, asked.threshold});
  int64_t count = 0;
  for (int64_t i = 0; i < n; ++i) {
    if (!bound.may_exceed(extent_at<T>(kind_a, a, i), extent_at<T>(kind_b, b, i))) continue;
    move<T>(kind_a, a, i, count);
    move<T>(kind_b, b, i, count);
    kept[count++] = static_cast<uint16_t>(i);
  }
  return count;
}

/// A ratio above 0 is that of shapes that share area: bounds and areas rule out most boxes that share too little.
/// Otherwise overlap is asked too.
template <class T>
void decide_ratio(const index::RatioTest& asked, int32_t kind_a, index::Columns& a, int32_t kind_b, index::Columns& b,
                  int64_t n, uint8_t* out, double* value) noexcept {
  const bool implies_overlap = asked.threshold > 0;
  if (!implies_overlap) decide_overlap<T>(kind_a, a.field, n, kind_b, b.field, n, out);
  uint16_t kept[index::decided_at_once];
  const bool rules_out = implies_overlap && is_box(kind_a) && is_box(kind_b) && is_symmetric(asked.ratio);
  int64_t count = n;
  if (rules_out) {
    std::fill_n(out, n, uint8_t{0});
    count = keep_some<T>(asked, kind_a, a, kind_b, b, n, kept);
    if (count == 0) return;
  }
  T ratio[index::decided_at_once];
  T* const columns[] = {ratio};
  const vesica::Query& query = vesica::queries::ratio(static_cast<vesica::Ratio>(asked.ratio));
  vesica::batch::query_many<T, T>(query, vesica::kernels(), columns_of<T>(kind_a, a.field, count),
                                  columns_of<T>(kind_b, b.field, count), count, columns);
  for (int64_t k = 0; k < count; ++k) {
    const int64_t i = rules_out ? kept[k] : k;
    value[i] = static_cast<double>(ratio[k]);
    const bool enough = value[i] >= asked.threshold;  // not if NaN
    out[i] = static_cast<uint8_t>(enough && (implies_overlap || out[i] != 0));
  }
}

template <class T>
int64_t join_ratio(int32_t ratio, T threshold, const void* index_a, const CShapesOf<T>* sets_a, int32_t set_count_a,
                   const void* index_b, const CShapesOf<T>* sets_b, int32_t set_count_b, int64_t part, int64_t parts,
                   void* scratch, int64_t scratch_size, int64_t* out_a, int64_t* out_b, T* values, int64_t capacity,
                   int64_t* state) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(join_ratio<T>, ratio, threshold, index_a, sets_a, set_count_a, index_b, sets_b,
                             set_count_b, part, parts, scratch, scratch_size, out_a, out_b, values, capacity, state);
  if (index_a == nullptr || index_b == nullptr || scratch == nullptr) return VESICA_E_NULL;
  const bool has_room = out_a != nullptr && out_b != nullptr && values != nullptr && state != nullptr;
  if (capacity > 0 && !has_room) return VESICA_E_NULL;
  index::Sets a, b;
  const int32_t error =
      first_error(check_indexed<T>(index_a, sets_a, set_count_a, a), check_indexed<T>(index_b, sets_b, set_count_b, b));
  if (error != 0) return error;
  if (!vesica::is_ratio(ratio) || threshold != threshold) return VESICA_E_ARGUMENT;
  if (parts < 1 || part < 0 || part >= parts || capacity < 0) return VESICA_E_ARGUMENT;
  if (!aligned(scratch) || scratch_size < index::join_scratch_bytes()) return VESICA_E_ARGUMENT;
  const index::Join join{.kernels = index_kernels(),
                         .a = {index_a, &a},
                         .b = {index_b, &b},
                         .decide = nullptr,
                         .reversed = false,
                         .query = first_ratio + static_cast<uint32_t>(ratio),
                         .part = part,
                         .parts = parts,
                         .scratch = scratch,
                         .ratio = {decide_ratio<T>, ratio, static_cast<double>(threshold)}};
  if (capacity == 0) return index::count_pairs(join);
  if (!index::state_is_sound(join, state)) return VESICA_E_ARGUMENT;
  return index::write_pairs(join, out_a, out_b, values, capacity, state);
}

}  // namespace

#define VESICA_JOIN_RATIO(scalar, T)                                                                                 \
  int64_t vesica_join_ratio_##scalar(int32_t ratio, T threshold, const void* index_a,                                \
                                     const vesica_shapes_##scalar* sets_a, int32_t set_count_a, const void* index_b, \
                                     const vesica_shapes_##scalar* sets_b, int32_t set_count_b, int64_t part,        \
                                     int64_t parts, void* scratch, int64_t scratch_size, int64_t* out_a,             \
                                     int64_t* out_b, T* values, int64_t capacity, int64_t* state) {                  \
    return join_ratio(ratio, threshold, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts,     \
                      scratch, scratch_size, out_a, out_b, values, capacity, state);                                 \
  }

VESICA_JOIN_RATIO(f64, double)
VESICA_JOIN_RATIO(f32, float)
