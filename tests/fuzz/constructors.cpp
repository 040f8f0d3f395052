// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "fuzz/bytes.hpp"

namespace fuzz {
namespace {

/// If a constructor succeeds, its shape is valid.
template <class T, class Shape>
void demand_valid(std::int32_t error, std::int32_t kind, const Output<Shape>& out) {
  demand(error <= 0);
  demand(error == 0 || out.untouched());
  if (error != 0) return;
  demand((sizeof(T) == sizeof(double) ? vesica_check_f64 : vesica_check_f32)(kind, out.get()) == 0);
}

template <class T, class Rect, class Ellipse, auto RectFromAngle, auto RectFromCorners, auto EllipseFromAngle,
          auto EllipseFromVector, auto EllipseFromCovariance, auto EllipseFromMatrix>
void call(Bytes& bytes, Memory& memory) {
  const unsigned which = bytes.below(6);
  T n[8];
  for (T& x : n) x = bytes.number<T>();
  const Output<Rect> rect(memory.out);
  if (which == 0) return demand_valid<T>(RectFromAngle(n[0], n[1], n[2], n[3], n[4], rect.get()), VESICA_RECT, rect);
  if (which == 1) return demand_valid<T>(RectFromCorners(n, rect.get()), VESICA_RECT, rect);
  const Output<Ellipse> out(memory.out);
  std::int32_t error;
  switch (which) {
    case 2:
      error = EllipseFromAngle(n[0], n[1], n[2], n[3], n[4], out.get());
      break;
    case 3:
      error = EllipseFromVector(n[0], n[1], n[2], n[3], n[4], out.get());
      break;
    case 4:
      error = EllipseFromCovariance(n[0], n[1], n[2], n[3], n[4], n[5], out.get());
      break;
    default:
      error = EllipseFromMatrix(n[0], n[1], n[2], n[3], n[4], out.get());
  }
  demand_valid<T>(error, VESICA_ELLIPSE, out);
}

template <class T, class RoundRect, class Capsule, auto RoundRectFromAngle, auto CapsuleFromAngle,
          auto CapsuleFromWidth>
void call_round(Bytes& bytes, Memory& memory) {
  const unsigned which = bytes.below(3);
  T n[6];
  for (T& x : n) x = bytes.number<T>();
  if (which == 0) {
    const Output<RoundRect> out(memory.out);
    return demand_valid<T>(RoundRectFromAngle(n[0], n[1], n[2], n[3], n[4], n[5], out.get()), VESICA_ROUND_RECT, out);
  }
  const Output<Capsule> out(memory.out);
  const auto make = which == 1 ? CapsuleFromAngle : CapsuleFromWidth;
  demand_valid<T>(make(n[0], n[1], n[2], n[3], n[4], out.get()), VESICA_CAPSULE, out);
}

template <class T, class Rect, auto Misfit>
void call_misfit(Bytes& bytes, Memory& memory) {
  const Output<T> out(memory.out);
  T corners[8];
  for (T& x : corners) x = bytes.number<T>();
  Rect rect;
  T* const number[] = {&rect.cx, &rect.cy, &rect.ux, &rect.uy, &rect.hx, &rect.hy};
  for (T* x : number) *x = bytes.number<T>();
  const std::int32_t error = Misfit(corners, &rect, out.get());
  demand(error == 0 ? *out.get() >= 0 && *out.get() <= std::numeric_limits<T>::max() : out.untouched());
}

template <class T, class Aabb, auto FromCorners>
void call_aabb(Bytes& bytes, Memory& memory) {
  const Output<Aabb> out(memory.out);
  T n[4];
  for (T& x : n) x = bytes.number<T>();
  const std::int32_t error = FromCorners(n[0], n[1], n[2], n[3], out.get());
  demand(error == 0 ? out.get()->min_x <= out.get()->max_x && out.get()->min_y <= out.get()->max_y : out.untouched());
}

}  // namespace

void call_constructor(Bytes& bytes, Memory& memory) {
  switch (bytes.below(8)) {
    case 0:
      return call<double, vesica_rect_f64, vesica_ellipse_f64, vesica_rect_from_angle_f64, vesica_rect_from_corners_f64,
                  vesica_ellipse_from_angle_f64, vesica_ellipse_from_radius_vector_f64,
                  vesica_ellipse_from_covariance_f64, vesica_ellipse_from_matrix_f64>(bytes, memory);
    case 1:
      return call<float, vesica_rect_f32, vesica_ellipse_f32, vesica_rect_from_angle_f32, vesica_rect_from_corners_f32,
                  vesica_ellipse_from_angle_f32, vesica_ellipse_from_radius_vector_f32,
                  vesica_ellipse_from_covariance_f32, vesica_ellipse_from_matrix_f32>(bytes, memory);
    case 2:
      return call_aabb<double, vesica_aabb_f64, vesica_aabb_from_corners_f64>(bytes, memory);
    case 3:
      return call_misfit<double, vesica_rect_f64, vesica_rect_corners_misfit_f64>(bytes, memory);
    case 4:
      return call_misfit<float, vesica_rect_f32, vesica_rect_corners_misfit_f32>(bytes, memory);
    case 5:
      return call_round<double, vesica_round_rect_f64, vesica_capsule_f64, vesica_round_rect_from_angle_f64,
                        vesica_capsule_from_angle_f64, vesica_capsule_from_width_f64>(bytes, memory);
    case 6:
      return call_round<float, vesica_round_rect_f32, vesica_capsule_f32, vesica_round_rect_from_angle_f32,
                        vesica_capsule_from_angle_f32, vesica_capsule_from_width_f32>(bytes, memory);
    default:
      return call_aabb<float, vesica_aabb_f32, vesica_aabb_from_corners_f32>(bytes, memory);
  }
}

}  // namespace fuzz
