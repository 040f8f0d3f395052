// SPDX-License-Identifier: Apache-2.0
// Distances of shapes as Gaussian distributions.
#include <algorithm>
#include <limits>
#include <vesica/gaussian.hpp>

#include "arrays.hpp"
#include "environment.hpp"
#include "queries/cast.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;
using vesica::GaussianDistance;
using vesica::detail::gaussian::Gaussian;
namespace gaussian = vesica::detail::gaussian;

static_assert(static_cast<int32_t>(GaussianDistance::bhattacharyya) == VESICA_GAUSSIAN_BHATTACHARYYA);
static_assert(static_cast<int32_t>(GaussianDistance::hellinger) == VESICA_GAUSSIAN_HELLINGER);
static_assert(static_cast<int32_t>(GaussianDistance::kullback_leibler) == VESICA_GAUSSIAN_KULLBACK_LEIBLER);
static_assert(static_cast<int32_t>(GaussianDistance::wasserstein) == VESICA_GAUSSIAN_WASSERSTEIN);

bool has_gaussian(int32_t kind) noexcept { return vesica::has_form(kind) && vesica::has_area(kind); }

/// Returns 0, VESICA_E_KIND or VESICA_E_SHAPE.
int32_t gaussian_of(int32_t kind, const double* numbers, Gaussian& out) noexcept {
  return vesica::with_shape<double>(kind, numbers, [&](const gaussian::HasGaussian auto& shape) -> int32_t {
    if (check(shape) != 0) return VESICA_E_SHAPE;
    out = gaussian::of(shape);
    return 0;
  });
}

template <class T>
int32_t gaussian_of_two(int32_t which, int32_t kind_a, const void* a, int32_t kind_b, const void* b, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(gaussian_of_two<T>, which, kind_a, a, kind_b, b, out);
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!has_gaussian(kind_a) || !has_gaussian(kind_b)) return VESICA_E_KIND;
  if (!vesica::is_gaussian_distance(which)) return VESICA_E_ARGUMENT;
  double numbers[vesica::max_fields], result = 0;
  Gaussian first, second;
  widen<T>(kind_a, a, numbers);
  if (gaussian_of(kind_a, numbers, first) != 0) return VESICA_E_SHAPE;
  widen<T>(kind_b, b, numbers);
  if (gaussian_of(kind_b, numbers, second) != 0) return VESICA_E_SHAPE;
  const int32_t error = gaussian::distance(static_cast<GaussianDistance>(which), first, second, result);
  return error != 0 ? error : gaussian::rounded_to(result, *out);
}

/// A Gaussian, or why there is none.
struct Element {
  Gaussian gaussian;
  int32_t error;
};

template <class T>
void read(const vesica::batch::Shapes<T>& shapes, int64_t i, Element& out) noexcept {
  out.error = gaussian_of(shapes.kind, vesica::batch::body_at(shapes, i).number, out.gaussian);
}

/// Results of arrays: how many are 0, and the error of the call.
struct Answers {
  GaussianDistance which;
  int64_t equal = 0;
  int32_t error = 0;

  template <class T>
  void answer(const Element& a, const Element& b, T& out) noexcept {
    double result = 0;
    int32_t code = a.error != 0 || b.error != 0 ? static_cast<int32_t>(VESICA_E_SHAPE)
                                                : gaussian::distance(which, a.gaussian, b.gaussian, result);
    if (code == 0) code = gaussian::rounded_to(result, out);
    if (code != 0) out = std::numeric_limits<T>::quiet_NaN();
    equal += code == 0 && out == 0;
    error = more_severe(error, code);
  }
  int64_t result() const noexcept { return error != 0 ? error : equal; }
};

template <class T>
int64_t gaussians_in_step(int32_t which, const CShapesOf<T>* a, const CShapesOf<T>* b, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(gaussians_in_step<T>, which, a, b, out);
  const int32_t error = check_call(a, b, out, anything(a, b), has_gaussian);
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0 || !vesica::is_gaussian_distance(which)) return VESICA_E_ARGUMENT;
  const vesica::batch::Shapes<T> first = view<T>(*a), second = view<T>(*b);
  Answers answers{static_cast<GaussianDistance>(which)};
  Element p, q;
  for (int64_t i = 0; i < n; ++i) {
    if (i == 0 || first.stride != 0) read(first, i, p);
    if (i == 0 || second.stride != 0) read(second, i, q);
    answers.answer(p, q, out[i]);
  }
  return answers.result();
}

template <class T>
int64_t gaussians_of_all(int32_t which, const CShapesOf<T>* a, const CShapesOf<T>* b, T* out,
                         ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(gaussians_of_all<T>, which, a, b, out, row_stride);
  const int32_t error = check_call(a, b, out, anything(a, b), has_gaussian);
  if (error != 0) return error;
  const bool apart = rows_apart(a->count, b->count, row_stride, sizeof(T));
  if (!apart || !vesica::is_gaussian_distance(which)) return VESICA_E_ARGUMENT;
  const vesica::batch::Shapes<T> first = view<T>(*a), second = view<T>(*b);
  Answers answers{static_cast<GaussianDistance>(which)};
  constexpr int64_t tile = 64;
  Element p, q[tile];
  for (int64_t begin = 0; begin < second.count; begin += tile) {
    const int64_t n = std::min(tile, second.count - begin);
    for (int64_t j = 0; j < n; ++j) read(second, begin + j, q[j]);
    for (int64_t i = 0; i < first.count; ++i) {
      read(first, i, p);
      for (int64_t j = 0; j < n; ++j) answers.answer(p, q[j], out[i * row_stride + begin + j]);
    }
  }
  return answers.result();
}

}  // namespace

#define VESICA_GAUSSIAN(scalar, T)                                                                                  \
  int32_t vesica_gaussian_distance_##scalar(int32_t which, int32_t kind_a, const void* a, int32_t kind_b,           \
                                            const void* b, T* out) {                                                \
    return gaussian_of_two(which, kind_a, a, kind_b, b, out);                                                       \
  }                                                                                                                 \
  int64_t vesica_gaussian_distance_many_##scalar(int32_t which, const vesica_shapes_##scalar* a,                    \
                                                 const vesica_shapes_##scalar* b, T* out) {                         \
    return gaussians_in_step(which, a, b, out);                                                                     \
  }                                                                                                                 \
  int64_t vesica_gaussian_distance_matrix_##scalar(int32_t which, const vesica_shapes_##scalar* a,                  \
                                                   const vesica_shapes_##scalar* b, T* out, ptrdiff_t row_stride) { \
    return gaussians_of_all(which, a, b, out, row_stride);                                                          \
  }

VESICA_GAUSSIAN(f64, double)
VESICA_GAUSSIAN(f32, float)
