// SPDX-License-Identifier: Apache-2.0
// Soft suppression.
#include <vesica/check.hpp>
#include <vesica/polygon/edges.hpp>

#include "index_arguments.hpp"
#include "join/soft.hpp"
#include "polygon/areas.hpp"
#include "queries.hpp"
#include "queries/ratio.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

template <class T>
void ratios(int32_t ratio, int32_t kind, const double* const* one, const double* const* others, int64_t n,
            double* out) noexcept {
  const auto which = static_cast<vesica::Ratio>(ratio);
  if (!vesica::is_row(kind)) {
    constexpr bool is_float = sizeof(T) == sizeof(float);
    for (int64_t i = 0; i < n; ++i) {
      out[i] = __builtin_nan("");
      vesica::polygon::ratio_of_paths(which, {kind, is_float, one[0]},
                                      {kind, is_float, others[0] + i * vesica::max_fields}, out[i]);
    }
    return;
  }
  const void *first[vesica::max_fields], *second[vesica::max_fields];
  for (int k = 0; k < vesica::field_count(kind); ++k) {
    first[k] = one[k];
    second[k] = others[k];
  }
  vesica::batch::query_matrix<double, double>(vesica::queries::ratio(which), vesica::kernels(),
                                              columns_of<double>(kind, first, 1), columns_of<double>(kind, second, n),
                                              out, static_cast<ptrdiff_t>(n));
}

template <class T>
bool is_valid(int32_t kind, const double* numbers) noexcept {
  if (kind == vesica::polygon_kind) return check(vesica::load<vesica::Polygon<T>>(numbers)) == 0;
  return vesica::with_shape<double>(kind, numbers, [](const vesica::HasCore auto& shape) { return check(shape); }) == 0;
}

bool is_decay(int32_t decay, double parameter) noexcept {
  if (decay == VESICA_DECAY_LINEAR) return parameter >= 0 && parameter <= 1;
  return decay == VESICA_DECAY_GAUSSIAN && parameter >= 0x1p-100 && parameter < __builtin_inf();
}

template <class T>
int32_t suppress_soft(const CShapesOf<T>* shapes, const T* scores, const int32_t* labels, int32_t ratio, int32_t decay,
                      T parameter, T least_score, int64_t most, void* scratch, int64_t scratch_size, int64_t* keep,
                      T* decayed, int64_t* kept) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(suppress_soft<T>, shapes, scores, labels, ratio, decay, parameter, least_score, most,
                             scratch, scratch_size, keep, decayed, kept);
  if (shapes == nullptr || kept == nullptr) return VESICA_E_NULL;
  const bool anything = shapes->count != 0;
  const bool has_all = scores != nullptr && scratch != nullptr && keep != nullptr && decayed != nullptr;
  if (anything && !has_all) return VESICA_E_NULL;
  const int32_t error = check_array(*shapes, may_be_suppressed);
  if (error != 0) return error;
  if (anything && has_null(*shapes)) return VESICA_E_NULL;
  const int64_t needed = vesica_suppress_soft_scratch(shapes->count);
  const bool sound = vesica::queries::is_symmetric(ratio) && is_decay(decay, static_cast<double>(parameter));
  if (!sound || !(least_score >= 0) || most < 0 || needed < 0) return VESICA_E_ARGUMENT;
  if (!anything) {
    *kept = 0;
    return 0;
  }
  if (scratch_size < needed || !aligned(scratch, 8)) return VESICA_E_ARGUMENT;
  index::Sets sets;
  view_sets<T>(shapes, 1, sets, may_be_suppressed);
  bool left_out = false;
  *kept = index::suppress_softly<T>({.sets = sets,
                                     .ratios = ratios<T>,
                                     .valid = is_valid<T>,
                                     .ratio = ratio,
                                     .gaussian = decay == VESICA_DECAY_GAUSSIAN,
                                     .parameter = static_cast<double>(parameter),
                                     .least_score = static_cast<double>(least_score),
                                     .most = most,
                                     .label = labels,
                                     .scratch = scratch},
                                    scores, keep, decayed, left_out);
  return left_out ? VESICA_E_SHAPE : 0;
}

}  // namespace

int64_t vesica_suppress_soft_scratch(int64_t count) {
  if (count < 0 || count > index::most_items) return VESICA_E_ARGUMENT;
  return index::soft_bytes(count);
}

#define VESICA_SOFT_SUPPRESSION(scalar, T)                                                                            \
  int32_t vesica_suppress_soft_##scalar(const vesica_shapes_##scalar* shapes, const T* scores, const int32_t* labels, \
                                        int32_t ratio, int32_t decay, T parameter, T least_score, int64_t most,       \
                                        void* scratch, int64_t scratch_size, int64_t* keep, T* decayed,               \
                                        int64_t* kept) {                                                              \
    return suppress_soft(shapes, scores, labels, ratio, decay, parameter, least_score, most, scratch, scratch_size,   \
                         keep, decayed, kept);                                                                        \
  }

VESICA_SOFT_SUPPRESSION(f64, double)
VESICA_SOFT_SUPPRESSION(f32, float)
