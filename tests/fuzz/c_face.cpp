// SPDX-License-Identifier: Apache-2.0
// Bytes to one call of vesica.h: any function, any legal pointers, buffers that end at a guard page.
#include "capi/face.hpp"
#include "fuzz/bytes.hpp"

namespace fuzz {
namespace {

using Call = void (*)(Bytes& bytes, Memory& memory);

/// A pair function that returns its answer, which is at most `most`.
template <class T, auto Function, std::int32_t most>
void code(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const std::int32_t answer = Function(a.kind(), a.numbers(), b.kind(), b.numbers());
  demand(answer >= VESICA_E_KIND && answer <= most);
}

/// A pair function with an output.
template <class T, class Out, auto Function>
void output(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const Output<Out> out(memory.out, bytes.below(128) == 127);
  const std::int32_t answer = Function(a.kind(), a.numbers(), b.kind(), b.numbers(), out.get());
  demand(answer >= VESICA_E_RANGE && answer <= 8);
  demand(answer >= 0 || out.untouched());
}

/// The function of a ratio, known or not.
template <class T, auto Function>
void ratio(Bytes& bytes, Memory& memory) {
  const std::int32_t which = static_cast<std::int32_t>(bytes.below(9)) - 1;
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const Output<T> out(memory.out, bytes.below(128) == 127);
  const std::int32_t answer = Function(which, a.kind(), a.numbers(), b.kind(), b.numbers(), out.get());
  demand(answer >= VESICA_E_RANGE && answer <= 0);
  demand(answer == 0 ? *out.get() >= -2 && *out.get() <= 1 : out.untouched());
}

/// A function of one shape with an output.
template <class T, class Out, auto Function>
void of_one(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a);
  const Output<Out> out(memory.out, bytes.below(128) == 127);
  const std::int32_t answer = Function(a.kind(), a.numbers(), out.get());
  demand(answer >= VESICA_E_RANGE && answer <= 0);
  demand(answer >= 0 || out.untouched());
}

template <class T, auto Function>
void check(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a);
  demand(Function(a.kind(), a.numbers()) <= 0);
}

/// A shape's struct against a guard page, or NULL.
template <class Struct, class T>
const Struct* typed_shape(Bytes& bytes, GuardedMemory& memory) {
  if (bytes.below(128) == 127) return nullptr;
  auto* numbers = reinterpret_cast<T*>(memory.place(sizeof(Struct), Edge::after));
  for (std::size_t i = 0; i < sizeof(Struct) / sizeof(T); ++i) numbers[i] = bytes.number<T>();
  return reinterpret_cast<const Struct*>(numbers);
}

template <class T, class A, class B, auto Function>
void typed(Bytes& bytes, Memory& memory) {
  const A* a = typed_shape<A, T>(bytes, memory.a);
  const B* b = typed_shape<B, T>(bytes, memory.b);
  const std::int32_t answer = Function(a, b);
  demand(answer == 0 || answer == 1 || answer == VESICA_E_NULL || answer == VESICA_E_SHAPE);
}

void describe(Bytes& bytes, Memory&) {
  const auto value = bytes.take<std::int32_t>();
  demand(vesica_strerror(value) != nullptr && vesica_isa_name() != nullptr);
  const bool has_vertices = value == VESICA_POLYGON || value == VESICA_POLYLINE;
  demand((vesica_kind_name(value) == nullptr) == (vesica_field_count(value) < 0 && !has_vertices));
}

constexpr Call calls[] = {
    call_batch,
    call_batch,
    call_boxes,
    call_constructor,
    call_index,
    call_index,
    call_motion,
    call_motion,
    call_topology,
    call_topology,
    call_polygons,
    call_polygons,
    describe,
    code<double, vesica_overlap_f64, 1>,
    code<float, vesica_overlap_f32, 1>,
    code<double, vesica_interiors_overlap_f64, 1>,
    code<float, vesica_interiors_overlap_f32, 1>,
    code<double, vesica_relation_f64, 7>,
    code<float, vesica_relation_f32, 7>,
    code<double, vesica_contains_f64, 1>,
    code<float, vesica_contains_f32, 1>,
    output<double, vesica_closest_points_f64, vesica_nearest_f64>,
    output<float, vesica_closest_points_f32, vesica_nearest_f32>,
    output<double, vesica_closest_points_f64, vesica_boundary_distance_f64>,
    output<float, vesica_closest_points_f32, vesica_boundary_distance_f32>,
    output<double, vesica_penetration_f64, vesica_depth_f64>,
    output<float, vesica_penetration_f32, vesica_depth_f32>,
    output<double, double, vesica_area_f64>,
    output<float, float, vesica_area_f32>,
    output<double, double, vesica_iou_f64>,
    output<float, float, vesica_iou_f32>,
    ratio<double, vesica_ratio_f64>,
    ratio<float, vesica_ratio_f32>,
    output<double, capi_tests::Crossings<double>, capi_tests::crossings<double>>,
    output<float, capi_tests::Crossings<float>, capi_tests::crossings<float>>,
    of_one<double, double, vesica_shape_area_f64>,
    of_one<float, float, vesica_shape_area_f32>,
    of_one<double, vesica_aabb_f64, vesica_bounds_f64>,
    of_one<float, vesica_aabb_f32, vesica_bounds_f32>,
    check<double, vesica_check_f64>,
    check<float, vesica_check_f32>,
    typed<double, vesica_point_f64, vesica_point_f64, vesica_overlap_point_point_f64>,
    typed<double, vesica_point_f64, vesica_segment_f64, vesica_overlap_point_segment_f64>,
    typed<double, vesica_point_f64, vesica_circle_f64, vesica_overlap_point_circle_f64>,
    typed<double, vesica_point_f64, vesica_aabb_f64, vesica_overlap_point_aabb_f64>,
    typed<double, vesica_point_f64, vesica_rect_f64, vesica_overlap_point_rect_f64>,
    typed<double, vesica_point_f64, vesica_ellipse_f64, vesica_overlap_point_ellipse_f64>,
    typed<double, vesica_segment_f64, vesica_segment_f64, vesica_overlap_segment_segment_f64>,
    typed<double, vesica_segment_f64, vesica_circle_f64, vesica_overlap_segment_circle_f64>,
    typed<double, vesica_segment_f64, vesica_aabb_f64, vesica_overlap_segment_aabb_f64>,
    typed<double, vesica_segment_f64, vesica_rect_f64, vesica_overlap_segment_rect_f64>,
    typed<double, vesica_segment_f64, vesica_ellipse_f64, vesica_overlap_segment_ellipse_f64>,
    typed<double, vesica_circle_f64, vesica_circle_f64, vesica_overlap_circle_circle_f64>,
    typed<double, vesica_circle_f64, vesica_aabb_f64, vesica_overlap_circle_aabb_f64>,
    typed<double, vesica_circle_f64, vesica_rect_f64, vesica_overlap_circle_rect_f64>,
    typed<double, vesica_circle_f64, vesica_ellipse_f64, vesica_overlap_circle_ellipse_f64>,
    typed<double, vesica_aabb_f64, vesica_aabb_f64, vesica_overlap_aabb_aabb_f64>,
    typed<double, vesica_aabb_f64, vesica_rect_f64, vesica_overlap_aabb_rect_f64>,
    typed<double, vesica_aabb_f64, vesica_ellipse_f64, vesica_overlap_aabb_ellipse_f64>,
    typed<double, vesica_rect_f64, vesica_rect_f64, vesica_overlap_rect_rect_f64>,
    typed<double, vesica_rect_f64, vesica_ellipse_f64, vesica_overlap_rect_ellipse_f64>,
    typed<double, vesica_ellipse_f64, vesica_ellipse_f64, vesica_overlap_ellipse_ellipse_f64>,
    typed<float, vesica_point_f32, vesica_point_f32, vesica_overlap_point_point_f32>,
    typed<float, vesica_point_f32, vesica_segment_f32, vesica_overlap_point_segment_f32>,
    typed<float, vesica_point_f32, vesica_circle_f32, vesica_overlap_point_circle_f32>,
    typed<float, vesica_point_f32, vesica_aabb_f32, vesica_overlap_point_aabb_f32>,
    typed<float, vesica_point_f32, vesica_rect_f32, vesica_overlap_point_rect_f32>,
    typed<float, vesica_point_f32, vesica_ellipse_f32, vesica_overlap_point_ellipse_f32>,
    typed<float, vesica_segment_f32, vesica_segment_f32, vesica_overlap_segment_segment_f32>,
    typed<float, vesica_segment_f32, vesica_circle_f32, vesica_overlap_segment_circle_f32>,
    typed<float, vesica_segment_f32, vesica_aabb_f32, vesica_overlap_segment_aabb_f32>,
    typed<float, vesica_segment_f32, vesica_rect_f32, vesica_overlap_segment_rect_f32>,
    typed<float, vesica_segment_f32, vesica_ellipse_f32, vesica_overlap_segment_ellipse_f32>,
    typed<float, vesica_circle_f32, vesica_circle_f32, vesica_overlap_circle_circle_f32>,
    typed<float, vesica_circle_f32, vesica_aabb_f32, vesica_overlap_circle_aabb_f32>,
    typed<float, vesica_circle_f32, vesica_rect_f32, vesica_overlap_circle_rect_f32>,
    typed<float, vesica_circle_f32, vesica_ellipse_f32, vesica_overlap_circle_ellipse_f32>,
    typed<float, vesica_aabb_f32, vesica_aabb_f32, vesica_overlap_aabb_aabb_f32>,
    typed<float, vesica_aabb_f32, vesica_rect_f32, vesica_overlap_aabb_rect_f32>,
    typed<float, vesica_aabb_f32, vesica_ellipse_f32, vesica_overlap_aabb_ellipse_f32>,
    typed<float, vesica_rect_f32, vesica_rect_f32, vesica_overlap_rect_rect_f32>,
    typed<float, vesica_rect_f32, vesica_ellipse_f32, vesica_overlap_rect_ellipse_f32>,
    typed<float, vesica_ellipse_f32, vesica_ellipse_f32, vesica_overlap_ellipse_ellipse_f32>,
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Memory memory;
  fuzz::Bytes bytes(data, size);
  fuzz::calls[bytes.below(sizeof fuzz::calls / sizeof *fuzz::calls)](bytes, memory);
  return 0;
}
