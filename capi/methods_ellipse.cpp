// SPDX-License-Identifier: Apache-2.0
#include <vesica/methods/circle_ellipse_circle_approximation.hpp>
#include <vesica/methods/circle_ellipse_closed_form.hpp>
#include <vesica/methods/circle_ellipse_polygonal_sandwich.hpp>
#include <vesica/methods/ellipse_ellipse_any_axes.hpp>
#include <vesica/methods/ellipse_ellipse_parallel_axes.hpp>
#include <vesica/methods/segment_circle_division_free.hpp>

#include "methods.hpp"

static_assert(vesica::methods::most_sandwich_iterations == VESICA_MOST_SANDWICH_ITERATIONS);
static_assert(sizeof(vesica::methods::RadiusVectorEllipse<double>) == sizeof(vesica_radius_vector_ellipse_f64));
static_assert(sizeof(vesica::methods::RadiusVectorEllipse<float>) == sizeof(vesica_radius_vector_ellipse_f32));

namespace {

void store(const vesica::methods::Approximation<double>& from, vesica_approximation_f64* out) noexcept {
  *out = {from.outline_error, from.iterations, 0};
}
void store(const vesica::methods::Approximation<float>& from, vesica_approximation_f32* out) noexcept {
  *out = {from.outline_error, from.iterations};
}

/// `method(a, b, n, approximation)` of two of the core's shapes.
template <class A, class B, class T, class Out, class Method>
int32_t approximate(const void* a, const void* b, int32_t n, Out* out, Method method) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((approximate<A, B, T, Out, Method>), a, b, n, out, method);
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  vesica::methods::Approximation<T> approximation;
  const int32_t answer = method(vesica::shape_at<A>(a), vesica::shape_at<B>(b), n, approximation);
  if (answer >= 0) store(approximation, out);
  return answer;
}

}  // namespace

#define VESICA_APPROXIMATION(name, method, CA, A, CB, B, scalar, T)                                                  \
  int32_t vesica_method_##name##_##scalar(const CA* a, const CB* b, int32_t n, vesica_approximation_##scalar* out) { \
    return approximate<A, B, T>(a, b, n, out, [](const A& x, const B& y, int32_t most, auto& reached) noexcept {     \
      return vesica::methods::method(x, y, most, reached);                                                           \
    });                                                                                                              \
  }

#define VESICA_METHODS(scalar, T)                                                                                  \
  VESICA_METHOD(circle_ellipse_closed_form_##scalar, closed_form, vesica_circle_##scalar, vesica::Circle<T>,       \
                vesica_ellipse_##scalar, vesica::Ellipse<T>)                                                       \
  VESICA_METHOD(segment_circle_division_free_##scalar, division_free, vesica_segment_##scalar, vesica::Segment<T>, \
                vesica_circle_##scalar, vesica::Circle<T>)                                                         \
  VESICA_APPROXIMATION(circle_ellipse_polygonal_sandwich, polygonal_sandwich, vesica_circle_##scalar,              \
                       vesica::Circle<T>, vesica_ellipse_##scalar, vesica::Ellipse<T>, scalar, T)                  \
  VESICA_APPROXIMATION(circle_ellipse_circle_approximation, circle_approximation, vesica_circle_##scalar,          \
                       vesica::Circle<T>, vesica_ellipse_##scalar, vesica::Ellipse<T>, scalar, T)                  \
  VESICA_APPROXIMATION(ellipse_ellipse_parallel_axes, parallel_axes, vesica_ellipse_##scalar, vesica::Ellipse<T>,  \
                       vesica_ellipse_##scalar, vesica::Ellipse<T>, scalar, T)                                     \
  VESICA_APPROXIMATION(ellipse_ellipse_any_axes, any_axes, vesica_ellipse_##scalar, vesica::Ellipse<T>,            \
                       vesica_ellipse_##scalar, vesica::Ellipse<T>, scalar, T)                                     \
  VESICA_APPROXIMATION(radius_vector_ellipses_any_axes, any_axes, vesica_radius_vector_ellipse_##scalar,           \
                       vesica::methods::RadiusVectorEllipse<T>, vesica_radius_vector_ellipse_##scalar,             \
                       vesica::methods::RadiusVectorEllipse<T>, scalar, T)

VESICA_METHODS(f64, double)
VESICA_METHODS(f32, float)
#undef VESICA_METHODS
#undef VESICA_APPROXIMATION
