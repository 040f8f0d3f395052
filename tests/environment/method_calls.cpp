// SPDX-License-Identifier: Apache-2.0
#include "environment/method_calls.hpp"

#include <vesica_methods.h>

#include <cstring>

namespace environment {
namespace {

using properties::Scalar;

template <class Shape>
const Shape* shape(const properties::NumbersOf<double>& numbers, const properties::NumbersOf<float>&, double) {
  return reinterpret_cast<const Shape*>(numbers.data());
}
template <class Shape>
const Shape* shape(const properties::NumbersOf<double>&, const properties::NumbersOf<float>& numbers, float) {
  return reinterpret_cast<const Shape*>(numbers.data());
}

template <class... Result>
Bytes bytes_of(const Result&... results) {
  Bytes bytes;
  const auto append = [&](const auto& result) {
    const auto* from = reinterpret_cast<const unsigned char*>(&result);
    bytes.insert(bytes.end(), from, from + sizeof result);
  };
  (append(results), ...);
  return bytes;
}

/// The result and the output of a method: method(a, b), or method(a, b, n), method(a, b, &out), method(a, b, n, &out).
template <class T, auto method, class A, class B>
Bytes ask(const Input& p, std::int32_t (*)(const A*, const B*)) {
  return bytes_of(method(shape<A>(p.a_f64, p.a_f32, T{}), shape<B>(p.b_f64, p.b_f32, T{})));
}
template <class T, auto method, class A, class B>
Bytes ask(const Input& p, std::int32_t (*)(const A*, const B*, std::int32_t)) {
  return bytes_of(method(shape<A>(p.a_f64, p.a_f32, T{}), shape<B>(p.b_f64, p.b_f32, T{}), 10));
}
template <class T, auto method, class A, class B, class Out>
Bytes ask(const Input& p, std::int32_t (*)(const A*, const B*, Out*)) {
  Out out;
  std::memset(&out, 0, sizeof out);
  const std::int32_t answer = method(shape<A>(p.a_f64, p.a_f32, T{}), shape<B>(p.b_f64, p.b_f32, T{}), &out);
  return bytes_of(answer, out);
}
template <class T, auto method, class A, class B, class Out>
Bytes ask(const Input& p, std::int32_t (*)(const A*, const B*, std::int32_t, Out*)) {
  Out out;
  std::memset(&out, 0, sizeof out);
  const std::int32_t answer = method(shape<A>(p.a_f64, p.a_f32, T{}), shape<B>(p.b_f64, p.b_f32, T{}), 10, &out);
  return bytes_of(answer, out);
}
template <class T, auto method>
Bytes ask(const Input& p) {
  return ask<T, method>(p, method);
}

template <class T, auto method, class Rect>
Bytes corners(const Input& p) {
  T out[8] = {};
  const std::int32_t error = method(shape<Rect>(p.a_f64, p.a_f32, T{}), out);
  return bytes_of(error, out);
}

template <class T, auto method, class Ellipse, class Settings, class Result>
Bytes descent(const Input& p) {
  Result out;
  std::memset(&out, 0, sizeof out);
  T errors[4] = {};
  const std::int32_t answer = method(shape<Ellipse>(p.a_f64, p.a_f32, T{}), shape<Ellipse>(p.b_f64, p.b_f32, T{}),
                                     static_cast<const Settings*>(nullptr), &out, errors, 4);
  return bytes_of(answer, out, errors);
}

#define METHOD(a, b, name, s, T) \
  { a, b, Scalar::s, #name, ask<T, vesica_method_##name##_##s> }
#define METHODS(s, T)                                                                               \
  METHOD(VESICA_RECT, VESICA_RECT, rect_rect_bounds, s, T),                                         \
      METHOD(VESICA_RECT, VESICA_RECT, rect_rect_separating_lines, s, T),                           \
      METHOD(VESICA_RECT, VESICA_RECT, turned_rects_separating_lines, s, T),                        \
      METHOD(VESICA_RECT, VESICA_RECT, rect_rect_sample_points, s, T),                              \
      METHOD(VESICA_POINT, VESICA_RECT, point_rect_frame, s, T),                                    \
      METHOD(VESICA_POINT, VESICA_AABB, point_aabb_intervals, s, T),                                \
      METHOD(VESICA_AABB, VESICA_AABB, aabb_aabb_intervals, s, T),                                  \
      METHOD(VESICA_RECT, VESICA_ELLIPSE, rect_ellipse_all_features, s, T),                         \
      METHOD(VESICA_RECT, VESICA_ELLIPSE, rect_ellipse_closest_features, s, T),                     \
      METHOD(VESICA_RECT, VESICA_ELLIPSE, rect_ellipse_minkowski_sum, s, T),                        \
      METHOD(VESICA_RECT, VESICA_ELLIPSE, rect_ellipse_point_parallelogram_distance, s, T),         \
      METHOD(VESICA_CIRCLE, VESICA_ELLIPSE, circle_ellipse_closed_form, s, T),                      \
      METHOD(VESICA_CIRCLE, VESICA_ELLIPSE, circle_ellipse_polygonal_sandwich, s, T),               \
      METHOD(VESICA_CIRCLE, VESICA_ELLIPSE, circle_ellipse_circle_approximation, s, T),             \
      METHOD(VESICA_SEGMENT, VESICA_CIRCLE, segment_circle_division_free, s, T),                    \
      METHOD(VESICA_ELLIPSE, VESICA_ELLIPSE, ellipse_ellipse_parallel_axes, s, T),                  \
      METHOD(VESICA_ELLIPSE, VESICA_ELLIPSE, ellipse_ellipse_any_axes, s, T),                       \
      METHOD(VESICA_ELLIPSE, VESICA_ELLIPSE, radius_vector_ellipses_any_axes, s, T),                \
      {VESICA_RECT, VESICA_RECT, Scalar::s, "rect_corners",                                         \
       corners<T, vesica_method_rect_corners_##s, vesica_rect_##s>},                                \
  {                                                                                                 \
    VESICA_ELLIPSE, VESICA_ELLIPSE, Scalar::s, "ellipse_ellipse_distance_gradient_descent",         \
        descent<T, vesica_method_ellipse_ellipse_distance_gradient_descent_##s, vesica_ellipse_##s, \
                vesica_descent_settings_##s, vesica_descent_result_##s>                             \
  }

}  // namespace

const std::vector<MethodCall>& method_calls() {
  static const std::vector<MethodCall> all = {METHODS(f64, double), METHODS(f32, float)};
  return all;
}

}  // namespace environment
