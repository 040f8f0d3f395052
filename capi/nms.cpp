// SPDX-License-Identifier: Apache-2.0
// Non-maximum suppression.
#include <limits>

#include "index_arguments.hpp"
#include "join/suppress.hpp"
#include "queries.hpp"
#include "queries/ratio.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

/// Up to this many ratios are computed one by one, because starting a batch costs as much.
constexpr int64_t few = 8;

/// The ratio of a shape with shape i of others.
template <class T>
T ratio_at(vesica::Ratio ratio, int32_t kind, const void* const* one, const void* const* others, int64_t i) noexcept {
  double a[vesica::max_fields], b[vesica::max_fields], result = 0;
  for (int k = 0; k < vesica::field_count(kind); ++k) {
    a[k] = static_cast<double>(static_cast<const T*>(one[k])[0]);
    b[k] = static_cast<double>(static_cast<const T*>(others[k])[i]);
  }
  vesica::queries::ratio_of_pair(ratio, kind, a, kind, b, result);
  return static_cast<T>(result);
}

template <class T>
void exceeds(int32_t kind, const void* const* one, const void* const* others, int64_t n,
             const index::Measured& measured, uint8_t* out) noexcept {
  const auto which = static_cast<vesica::Ratio>(measured.ratio);
  T ratio[index::chunk];
  if (n <= few && vesica::is_row(kind)) {
    for (int64_t i = 0; i < n; ++i) ratio[i] = ratio_at<T>(which, kind, one, others, i);
  } else {
    vesica::batch::query_matrix<T, T>(vesica::queries::ratio(which), vesica::kernels(), columns_of<T>(kind, one, 1),
                                      columns_of<T>(kind, others, n), ratio, static_cast<ptrdiff_t>(n));
  }
  for (int64_t i = 0; i < n; ++i) out[i] = ratio[i] > static_cast<T>(measured.threshold);
}

/// The criteria of a suppression besides scores.
template <class T>
struct Choice {
  const int32_t* labels;
  int32_t ratio;
  T threshold, least_score;
  int64_t most;

  bool is_sound() const noexcept {
    return vesica::queries::is_symmetric(ratio) && threshold >= 0 && threshold <= 1 && least_score == least_score &&
           most >= 0;
  }
};

template <class T>
int32_t suppress(const CShapesOf<T>* shapes, const T* scores, const Choice<T>& choice, void* scratch,
                 int64_t scratch_size, int64_t* keep, int64_t* kept) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(suppress<T>, shapes, scores, choice, scratch, scratch_size, keep, kept);
  if (shapes == nullptr || kept == nullptr) return VESICA_E_NULL;
  const bool anything = shapes->count != 0;
  if (anything && (scores == nullptr || scratch == nullptr || keep == nullptr)) return VESICA_E_NULL;
  const int32_t error = check_array(*shapes, may_be_suppressed);
  if (error != 0) return error;
  if (anything && has_null(*shapes)) return VESICA_E_NULL;
  const int64_t needed = vesica_nms_scratch(shapes->count);
  if (!choice.is_sound() || needed < 0) return VESICA_E_ARGUMENT;
  if (!anything) {
    *kept = 0;
    return 0;
  }
  if (scratch_size < needed) return VESICA_E_ARGUMENT;
  index::Sets sets;
  view_sets<T>(shapes, 1, sets, may_be_suppressed);
  bool left_out = false;
  *kept = index::suppress<T>(
      {.kernels = index_kernels(),
       .sets = sets,
       .exceeds = exceeds<T>,
       .measured = {choice.ratio, choice.ratio == VESICA_RATIO_OVER_SMALLER, static_cast<double>(choice.threshold)},
       .scratch = scratch,
       .label = choice.labels,
       .least_score = static_cast<double>(choice.least_score),
       .most = choice.most},
      scores, keep, left_out);
  return left_out ? VESICA_E_SHAPE : 0;
}

/// By IoU alone.
template <class T>
Choice<T> by_union(T threshold) noexcept {
  return {nullptr, VESICA_RATIO_OVER_UNION, threshold, -std::numeric_limits<T>::infinity(), INT64_MAX};
}

}  // namespace

int64_t vesica_nms_scratch(int64_t count) {
  if (count < 0 || count > index::most_items) return VESICA_E_ARGUMENT;
  return index::suppression_bytes(count);
}

#define VESICA_SUPPRESSION(scalar, T)                                                                            \
  int32_t vesica_nms_##scalar(const vesica_shapes_##scalar* shapes, const T* scores, T threshold, void* scratch, \
                              int64_t scratch_size, int64_t* keep, int64_t* kept) {                              \
    return suppress(shapes, scores, by_union(threshold), scratch, scratch_size, keep, kept);                     \
  }                                                                                                              \
  int32_t vesica_suppress_##scalar(const vesica_shapes_##scalar* shapes, const T* scores, const int32_t* labels, \
                                   int32_t ratio, T threshold, T least_score, int64_t most, void* scratch,       \
                                   int64_t scratch_size, int64_t* keep, int64_t* kept) {                         \
    const Choice<T> choice{labels, ratio, threshold, least_score, most};                                         \
    return suppress(shapes, scores, choice, scratch, scratch_size, keep, kept);                                  \
  }

VESICA_SUPPRESSION(f64, double)
VESICA_SUPPRESSION(f32, float)
