// SPDX-License-Identifier: Apache-2.0
// Ratios of shared volume of upright prisms: a shape from one height to another.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vesica/polygon/own_area.hpp>

#include "polygon/arrays.hpp"
#include "query_calls.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;

/// A prism's base area and heights, or the error of its shape or span.
struct Prism {
  double area = 0, low = 0, high = 0;
  int32_t error = 0;

  bool is_empty() const noexcept { return area == 0 || low == high; }
};

template <class T, class Span>
Prism prism(int32_t kind, const void* shape, const Span& span) noexcept {
  T area = 0;
  const int32_t error = vesica::with_shape<T>(
      kind, shape, [&](const vesica::CoreOrPath auto& s) { return vesica::shape_area_or_error(s, area); });
  const auto low = static_cast<double>(span.low), high = static_cast<double>(span.high);
  const bool sound = vesica::detail::all_finite(low, high) && low <= high;
  return {static_cast<double>(area), low, high, sound ? error : static_cast<int32_t>(VESICA_E_SHAPE)};
}

/// Differences of heights, all halved if one might overflow.
struct Heights {
  double a, b, shared;

  Heights(const Prism& p, const Prism& q) noexcept {
    double most = 0;
    for (const double z : {p.low, p.high, q.low, q.high}) most = std::fmax(most, std::fabs(z));
    const double scale = most > 0x1p1000 ? 0.5 : 1;
    const auto height = [&](double low, double high) { return scale * high - scale * low; };
    a = height(p.low, p.high);
    b = height(q.low, q.high);
    shared = std::fmax(0, height(std::fmax(p.low, q.low), std::fmin(p.high, q.high)));
  }
};

constexpr bool is_of_volume(int32_t ratio) noexcept {
  return ratio >= VESICA_RATIO_OVER_UNION && ratio <= VESICA_RATIO_OVER_SMALLER;
}

/// From the IoU of the bases, of valid prisms. Returns 0 or VESICA_E_ARGUMENT, where the volume to divide by is 0.
int32_t of_volumes(int32_t ratio, double iou, const Prism& p, const Prism& q, double& out) noexcept {
  const bool needs_first = ratio == VESICA_RATIO_OVER_FIRST || ratio == VESICA_RATIO_OVER_SMALLER;
  const bool needs_second = ratio == VESICA_RATIO_OVER_SECOND || ratio == VESICA_RATIO_OVER_SMALLER;
  const bool no_first = p.is_empty(), no_second = q.is_empty();
  if ((needs_first && no_first) || (needs_second && no_second) || (no_first && no_second)) return VESICA_E_ARGUMENT;
  out = 0;
  if (no_first || no_second || iou == 0) return 0;
  const Heights h(p, q);
  if (h.shared == 0) return 0;
  // Shares of either volume; no product of an area and a height may overflow.
  const double area = iou / (1 + iou);
  const double first = std::fmin(1, (1 + q.area / p.area) * area * (h.shared / h.a));
  const double second = std::fmin(1, (1 + p.area / q.area) * area * (h.shared / h.b));
  const double less = std::fmin(first, second), more = std::fmax(first, second);
  if (ratio == VESICA_RATIO_OVER_FIRST) out = first;
  if (ratio == VESICA_RATIO_OVER_SECOND) out = second;
  if (ratio == VESICA_RATIO_OVER_SMALLER) out = more;
  if (ratio == VESICA_RATIO_OVER_UNION && less > 0) out = less / (less / more + (1 - less));
  return 0;
}

/// Turns an IoU of bases, which is NaN if there is none, into the result in place.
template <class T>
int32_t finish_volume_ratio(int32_t ratio, const Prism& p, const Prism& q, T& number) noexcept {
  double result = 0;
  int32_t error = p.error == VESICA_E_SHAPE || q.error == VESICA_E_SHAPE ? static_cast<int32_t>(VESICA_E_SHAPE)
                  : p.error != 0                                         ? p.error
                                                                         : q.error;
  if (error == 0) error = of_volumes(ratio, static_cast<double>(number), p, q, result);
  number = error == 0 ? static_cast<T>(result) : std::numeric_limits<T>::quiet_NaN();
  return error;
}

template <class T, class Span>
int32_t volume_ratio_of_two(int32_t ratio, int32_t kind_a, const void* a, const Span* span_a, int32_t kind_b,
                            const void* b, const Span* span_b, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((volume_ratio_of_two<T, Span>), ratio, kind_a, a, span_a, kind_b, b, span_b, out);
  if (a == nullptr || span_a == nullptr || b == nullptr || span_b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!vesica::has_core_or_path(kind_a) || !vesica::has_core_or_path(kind_b)) return VESICA_E_KIND;
  if (!is_of_volume(ratio)) return VESICA_E_ARGUMENT;
  T number = std::numeric_limits<T>::quiet_NaN();
  vesica::ask<T>(vesica::queries::iou, kind_a, a, kind_b, b, &number);
  const int32_t error = finish_volume_ratio(ratio, prism<T>(kind_a, a, *span_a), prism<T>(kind_b, b, *span_b), number);
  if (error == 0) *out = number;
  return error;
}

/// An array's bases and spans.
template <class T, class Span>
struct Prisms {
  vesica::batch::Shapes<T> shapes;
  const Span* spans;

  Prism operator[](int64_t i) const noexcept {
    const vesica::batch::Element<T> element(shapes, i);
    return prism<T>(shapes.kind, element.operand().shape, spans[i]);
  }
};

/// Results of arrays: how many are above 0, and the error of the call.
struct Volumes {
  int32_t ratio;
  int64_t positive = 0;
  int32_t error = 0;

  template <class T>
  void answer(const Prism& p, const Prism& q, T& number) noexcept {
    const int32_t code = finish_volume_ratio(ratio, p, q, number);
    positive += number > 0;
    error = more_severe(error, code);
  }
  int64_t result() const noexcept { return error != 0 ? error : positive; }
};

template <class T, class Span>
int32_t check_prisms(int32_t ratio, const CShapesOf<T>* a, const Span* spans_a, const CShapesOf<T>* b,
                     const Span* spans_b, const T* out) noexcept {
  const bool some = anything(a, b);
  const bool has_spans = spans_a != nullptr && spans_b != nullptr;
  const int32_t error = check_call(a, b, has_spans ? out : nullptr, some, vesica::has_core_or_path);
  return error != 0 ? error : is_of_volume(ratio) ? 0 : static_cast<int32_t>(VESICA_E_ARGUMENT);
}

template <class T, class Span>
int64_t volume_ratios_in_step(int32_t ratio, const CShapesOf<T>* a, const Span* spans_a, const CShapesOf<T>* b,
                              const Span* spans_b, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((volume_ratios_in_step<T, Span>), ratio, a, spans_a, b, spans_b, out);
  const int32_t error = check_prisms(ratio, a, spans_a, b, spans_b, out);
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n <= 0) return n;
  T* const columns[] = {out};
  vesica::capi::many<T>(vesica::queries::iou, a, b, columns);
  const Prisms<T, Span> first{view<T>(*a), spans_a}, second{view<T>(*b), spans_b};
  Volumes volumes{ratio};
  for (int64_t i = 0; i < n; ++i) {
    volumes.answer(first[a->count == 1 ? 0 : i], second[b->count == 1 ? 0 : i], out[i]);
  }
  return volumes.result();
}

template <class T, class Span>
int64_t volume_ratios_of_all(int32_t ratio, const CShapesOf<T>* a, const Span* spans_a, const CShapesOf<T>* b,
                             const Span* spans_b, T* out, ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((volume_ratios_of_all<T, Span>), ratio, a, spans_a, b, spans_b, out, row_stride);
  const int32_t error = check_prisms(ratio, a, spans_a, b, spans_b, out);
  if (error != 0) return error;
  if (!rows_apart(a->count, b->count, row_stride, sizeof(T))) return VESICA_E_ARGUMENT;
  if (!anything(a, b)) return 0;
  vesica::capi::matrix<T>(vesica::queries::iou, a, b, out, row_stride);
  const Prisms<T, Span> first{view<T>(*a), spans_a}, second{view<T>(*b), spans_b};
  Volumes volumes{ratio};
  constexpr int64_t tile = 256;
  Prism q[tile];
  for (int64_t begin = 0; begin < b->count; begin += tile) {
    const int64_t n = std::min(tile, b->count - begin);
    for (int64_t j = 0; j < n; ++j) q[j] = second[begin + j];
    for (int64_t i = 0; i < a->count; ++i) {
      const Prism p = first[i];
      for (int64_t j = 0; j < n; ++j) volumes.answer(p, q[j], out[i * row_stride + begin + j]);
    }
  }
  return volumes.result();
}

}  // namespace

#define VESICA_VOLUME(scalar, T)                                                                                    \
  int32_t vesica_volume_ratio_##scalar(int32_t ratio, int32_t kind_a, const void* a,                                \
                                       const vesica_span_##scalar* span_a, int32_t kind_b, const void* b,           \
                                       const vesica_span_##scalar* span_b, T* out) {                                \
    return volume_ratio_of_two(ratio, kind_a, a, span_a, kind_b, b, span_b, out);                                   \
  }                                                                                                                 \
  int64_t vesica_volume_ratio_many_##scalar(int32_t ratio, const vesica_shapes_##scalar* a,                         \
                                            const vesica_span_##scalar* spans_a, const vesica_shapes_##scalar* b,   \
                                            const vesica_span_##scalar* spans_b, T* out) {                          \
    return volume_ratios_in_step(ratio, a, spans_a, b, spans_b, out);                                               \
  }                                                                                                                 \
  int64_t vesica_volume_ratio_matrix_##scalar(int32_t ratio, const vesica_shapes_##scalar* a,                       \
                                              const vesica_span_##scalar* spans_a, const vesica_shapes_##scalar* b, \
                                              const vesica_span_##scalar* spans_b, T* out, ptrdiff_t row_stride) {  \
    return volume_ratios_of_all(ratio, a, spans_a, b, spans_b, out, row_stride);                                    \
  }

VESICA_VOLUME(f64, double)
VESICA_VOLUME(f32, float)
