// SPDX-License-Identifier: Apache-2.0
#include <vesica/nms.hpp>

#include "arrays.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

/// Shape i of an array, however it lies in memory.
template <class Shape, class Array>
Shape shape_of(const Array& shapes, int64_t i) noexcept {
  using T = typename vesica::ShapeTraits<Shape>::Scalar;
  T numbers[6];
  for (int k = 0; k < vesica::ShapeTraits<Shape>::fields; ++k) {
    const char* const at = reinterpret_cast<const char*>(shapes.field[k]) + static_cast<ptrdiff_t>(i) * shapes.stride;
    std::memcpy(&numbers[k], at, sizeof(T));
  }
  return vesica::load<Shape>(numbers);
}

template <class Shape, class Array, class T>
int32_t nms_of_kind(const Array& shapes, const T* scores, T threshold, void* scratch, int64_t* keep,
                    int64_t* kept) noexcept {
  return vesica::nms(
      shapes.count, [&](int64_t i) { return shape_of<Shape>(shapes, i); }, [&](int64_t i) { return scores[i]; },
      threshold, scratch, keep, *kept);
}

template <class T>
int32_t nms(const vesica::capi::CShapesOf<T>* shapes, const T* scores, T threshold, void* scratch, int64_t scratch_size,
            int64_t* keep, int64_t* kept) noexcept {
  using namespace vesica;
  VESICA_DEFAULT_ENVIRONMENT(nms<T>, shapes, scores, threshold, scratch, scratch_size, keep, kept);
  if (shapes == nullptr || kept == nullptr) return VESICA_E_NULL;
  const bool anything = shapes->count != 0;
  if (anything && (scores == nullptr || scratch == nullptr || keep == nullptr)) return VESICA_E_NULL;
  const int32_t error = capi::check_array(*shapes);
  if (error != 0) return error;
  if (shapes->kind < VESICA_CIRCLE || shapes->kind > VESICA_ELLIPSE) return VESICA_E_KIND;
  if (anything && capi::has_null(*shapes)) return VESICA_E_NULL;
  const int64_t needed = nms_scratch(shapes->count);
  if (!(threshold >= 0 && threshold <= 1) || needed < 0) return VESICA_E_ARGUMENT;
  if (!anything) {
    *kept = 0;
    return 0;
  }
  if (scratch_size < needed) return VESICA_E_ARGUMENT;
  switch (shapes->kind) {
    case VESICA_CIRCLE:
      return nms_of_kind<Circle<T>>(*shapes, scores, threshold, scratch, keep, kept);
    case VESICA_AABB:
      return nms_of_kind<Aabb<T>>(*shapes, scores, threshold, scratch, keep, kept);
    case VESICA_RECT:
      return nms_of_kind<Rect<T>>(*shapes, scores, threshold, scratch, keep, kept);
    default:
      return nms_of_kind<Ellipse<T>>(*shapes, scores, threshold, scratch, keep, kept);
  }
}

}  // namespace

int64_t vesica_nms_scratch(int64_t count) { return vesica::nms_scratch(count); }

int32_t vesica_nms_f64(const vesica_shapes_f64* shapes, const double* scores, double threshold, void* scratch,
                       int64_t scratch_size, int64_t* keep, int64_t* kept) {
  return nms(shapes, scores, threshold, scratch, scratch_size, keep, kept);
}
int32_t vesica_nms_f32(const vesica_shapes_f32* shapes, const float* scores, float threshold, void* scratch,
                       int64_t scratch_size, int64_t* keep, int64_t* kept) {
  return nms(shapes, scores, threshold, scratch, scratch_size, keep, kept);
}
