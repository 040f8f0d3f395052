// SPDX-License-Identifier: Apache-2.0
#include "properties/answers.hpp"

#include <vesica.h>

#include <array>
#include <cstddef>

#include "capi/typed.hpp"

namespace properties {
namespace {

using capi::Typed;
using F64 = std::int32_t (*)(const double*, const double*);
using F32 = std::int32_t (*)(const float*, const float*);

// The pairs in the order of shapes, first by the first shape.
constexpr std::array<F64, 21> typed_f64{
    Typed<vesica_overlap_point_point_f64>::call,     Typed<vesica_overlap_point_segment_f64>::call,
    Typed<vesica_overlap_point_circle_f64>::call,    Typed<vesica_overlap_point_aabb_f64>::call,
    Typed<vesica_overlap_point_rect_f64>::call,      Typed<vesica_overlap_point_ellipse_f64>::call,
    Typed<vesica_overlap_segment_segment_f64>::call, Typed<vesica_overlap_segment_circle_f64>::call,
    Typed<vesica_overlap_segment_aabb_f64>::call,    Typed<vesica_overlap_segment_rect_f64>::call,
    Typed<vesica_overlap_segment_ellipse_f64>::call, Typed<vesica_overlap_circle_circle_f64>::call,
    Typed<vesica_overlap_circle_aabb_f64>::call,     Typed<vesica_overlap_circle_rect_f64>::call,
    Typed<vesica_overlap_circle_ellipse_f64>::call,  Typed<vesica_overlap_aabb_aabb_f64>::call,
    Typed<vesica_overlap_aabb_rect_f64>::call,       Typed<vesica_overlap_aabb_ellipse_f64>::call,
    Typed<vesica_overlap_rect_rect_f64>::call,       Typed<vesica_overlap_rect_ellipse_f64>::call,
    Typed<vesica_overlap_ellipse_ellipse_f64>::call,
};
constexpr std::array<F32, 21> typed_f32{
    Typed<vesica_overlap_point_point_f32>::call,     Typed<vesica_overlap_point_segment_f32>::call,
    Typed<vesica_overlap_point_circle_f32>::call,    Typed<vesica_overlap_point_aabb_f32>::call,
    Typed<vesica_overlap_point_rect_f32>::call,      Typed<vesica_overlap_point_ellipse_f32>::call,
    Typed<vesica_overlap_segment_segment_f32>::call, Typed<vesica_overlap_segment_circle_f32>::call,
    Typed<vesica_overlap_segment_aabb_f32>::call,    Typed<vesica_overlap_segment_rect_f32>::call,
    Typed<vesica_overlap_segment_ellipse_f32>::call, Typed<vesica_overlap_circle_circle_f32>::call,
    Typed<vesica_overlap_circle_aabb_f32>::call,     Typed<vesica_overlap_circle_rect_f32>::call,
    Typed<vesica_overlap_circle_ellipse_f32>::call,  Typed<vesica_overlap_aabb_aabb_f32>::call,
    Typed<vesica_overlap_aabb_rect_f32>::call,       Typed<vesica_overlap_aabb_ellipse_f32>::call,
    Typed<vesica_overlap_rect_rect_f32>::call,       Typed<vesica_overlap_rect_ellipse_f32>::call,
    Typed<vesica_overlap_ellipse_ellipse_f32>::call,
};

/// Place of a pair of kinds, kind_a <= kind_b, in those tables: rows of 6, 5, ... 1.
std::size_t place(int kind_a, int kind_b) {
  return static_cast<std::size_t>(kind_a * 6 - kind_a * (kind_a - 1) / 2 + kind_b - kind_a);
}

}  // namespace

std::int32_t overlap_by_kind(Scalar scalar, const Pair& p) {
  if (scalar == Scalar::f64) return vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return vesica_overlap_f32(p.kind_a, narrow(p.a).data(), p.kind_b, narrow(p.b).data());
}

std::int32_t overlap_typed(Scalar scalar, const Pair& p) {
  const std::size_t i = place(p.kind_a, p.kind_b);
  if (scalar == Scalar::f64) return typed_f64.at(i)(p.a.data(), p.b.data());
  return typed_f32.at(i)(narrow(p.a).data(), narrow(p.b).data());
}

Pair swapped(const Pair& p) { return {p.kind_b, p.kind_a, p.b, p.a}; }

}  // namespace properties
