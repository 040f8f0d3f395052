// SPDX-License-Identifier: Apache-2.0
// Non-maximum suppression.
#include "index_arguments.hpp"
#include "join/suppress.hpp"
#include "queries.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

/// Up to so many ratios are asked for one by one: to begin a batch costs as much.
constexpr int64_t few = 8;

template <class T>
T ratio_at(int32_t kind, const void* const* one, const void* const* others, int64_t i) noexcept {
  T a[index::most_fields], b[index::most_fields], ratio = 0;
  for (int k = 0; k < index::fields_of[kind]; ++k) {
    a[k] = static_cast<const T*>(one[k])[0];
    b[k] = static_cast<const T*>(others[k])[i];
  }
  vesica::ask<T>(vesica::queries::iou, kind, a, kind, b, &ratio);
  return ratio;
}

template <class T>
void exceeds(int32_t kind, const void* const* one, const void* const* others, int64_t n, double threshold,
             uint8_t* out) noexcept {
  T ratio[index::chunk];
  if (n <= few) {
    for (int64_t i = 0; i < n; ++i) ratio[i] = ratio_at<T>(kind, one, others, i);
  } else {
    vesica::batch::query_matrix<T, T>(vesica::queries::iou, vesica::kernels(), columns_of<T>(kind, one, 1),
                                      columns_of<T>(kind, others, n), ratio, n);
  }
  for (int64_t i = 0; i < n; ++i) out[i] = ratio[i] > static_cast<T>(threshold);
}

template <class T>
int32_t nms(const CShapesOf<T>* shapes, const T* scores, T threshold, void* scratch, int64_t scratch_size,
            int64_t* keep, int64_t* kept) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(nms<T>, shapes, scores, threshold, scratch, scratch_size, keep, kept);
  if (shapes == nullptr || kept == nullptr) return VESICA_E_NULL;
  const bool anything = shapes->count != 0;
  if (anything && (scores == nullptr || scratch == nullptr || keep == nullptr)) return VESICA_E_NULL;
  const int32_t error = check_array(*shapes);
  if (error != 0) return error;
  if (shapes->kind < VESICA_CIRCLE || shapes->kind > VESICA_ELLIPSE) return VESICA_E_KIND;
  if (anything && has_null(*shapes)) return VESICA_E_NULL;
  const int64_t needed = vesica_nms_scratch(shapes->count);
  if (!(threshold >= 0 && threshold <= 1) || needed < 0) return VESICA_E_ARGUMENT;
  if (!anything) {
    *kept = 0;
    return 0;
  }
  if (scratch_size < needed) return VESICA_E_ARGUMENT;
  index::Sets sets;
  view_sets<T>(shapes, 1, sets);
  bool left_out = false;
  *kept = index::suppress<T>({index_kernels(), sets, exceeds<T>, static_cast<double>(threshold), scratch}, scores, keep,
                             left_out);
  return left_out ? VESICA_E_SHAPE : 0;
}

}  // namespace

int64_t vesica_nms_scratch(int64_t count) {
  if (count < 0 || count > index::most_items) return VESICA_E_ARGUMENT;
  return index::suppression_bytes(count);
}

int32_t vesica_nms_f64(const vesica_shapes_f64* shapes, const double* scores, double threshold, void* scratch,
                       int64_t scratch_size, int64_t* keep, int64_t* kept) {
  return nms<double>(shapes, scores, threshold, scratch, scratch_size, keep, kept);
}
int32_t vesica_nms_f32(const vesica_shapes_f32* shapes, const float* scores, float threshold, void* scratch,
                       int64_t scratch_size, int64_t* keep, int64_t* kept) {
  return nms<float>(shapes, scores, threshold, scratch, scratch_size, keep, kept);
}
