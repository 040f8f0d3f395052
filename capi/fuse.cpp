// SPDX-License-Identifier: Apache-2.0
// Weighted fusion of boxes.
#include "detection/fuse.hpp"

#include "index_arguments.hpp"
#include "query.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;
namespace detection = vesica::detection;
namespace index = vesica::index;

double iou_of_boxes(int32_t kind, const double* a, const double* b) noexcept {
  double iou = 0;
  return vesica::queries::iou.doubles.of[kind][kind](a, b, &iou) == 0 ? iou : 0;
}

/// Optional are weights and labels.
template <class T>
struct FuseInputs {
  const T *scores, *weights;
  const int32_t* labels;
  T threshold;
  int32_t fused_score;

  bool is_sound() const noexcept {
    const bool is_code = fused_score == VESICA_FUSED_MEAN || fused_score == VESICA_FUSED_MAX;
    return threshold >= 0 && threshold <= 1 && is_code;
  }
};

template <class T>
struct FuseOutputs {
  void* fused;
  T* scores;
  int64_t *clusters, *count;
};

template <class T>
int32_t fuse(const CShapesOf<T>* shapes, const FuseInputs<T>& in, void* scratch, int64_t scratch_size,
             const FuseOutputs<T>& out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(fuse<T>, shapes, in, scratch, scratch_size, out);
  if (shapes == nullptr || out.count == nullptr) return VESICA_E_NULL;
  const bool anything = shapes->count != 0;
  const bool has_all = in.scores != nullptr && scratch != nullptr && out.fused != nullptr && out.scores != nullptr &&
                       out.clusters != nullptr;
  if (anything && !has_all) return VESICA_E_NULL;
  const int32_t error = check_array(*shapes, detection::can_be_fused);
  if (error != 0) return error;
  if (anything && has_null(*shapes)) return VESICA_E_NULL;
  const int64_t needed = vesica_fuse_scratch(shapes->count);
  if (!in.is_sound() || needed < 0) return VESICA_E_ARGUMENT;
  if (!anything) {
    *out.count = 0;
    return 0;
  }
  if (scratch_size < needed) return VESICA_E_ARGUMENT;
  index::Sets sets;
  view_sets<T>(shapes, 1, sets);
  bool left_out = false;
  const detection::Fusion fusion{.kernels = index_kernels(),
                                 .sets = sets,
                                 .iou = iou_of_boxes,
                                 .threshold = static_cast<double>(in.threshold),
                                 .highest = in.fused_score == VESICA_FUSED_MAX,
                                 .label = in.labels,
                                 .scratch = scratch};
  *out.count =
      detection::fuse(fusion, in.scores, in.weights, static_cast<T*>(out.fused), out.scores, out.clusters, left_out);
  return left_out ? VESICA_E_SHAPE : 0;
}

}  // namespace

int64_t vesica_fuse_scratch(int64_t count) {
  if (count < 0 || count > index::most_items) return VESICA_E_ARGUMENT;
  return detection::fusion_bytes(count);
}

#define VESICA_FUSE(scalar, T)                                                                          \
  int32_t vesica_fuse_##scalar(const vesica_shapes_##scalar* shapes, const T* scores, const T* weights, \
                               const int32_t* labels, T threshold, int32_t fused_score, void* scratch,  \
                               int64_t scratch_size, void* fused, T* fused_scores, int64_t* clusters,   \
                               int64_t* count) {                                                        \
    return fuse<T>(shapes, {scores, weights, labels, threshold, fused_score}, scratch, scratch_size,    \
                   {fused, fused_scores, clusters, count});                                             \
  }

VESICA_FUSE(f64, double)
VESICA_FUSE(f32, float)
