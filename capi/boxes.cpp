// SPDX-License-Identifier: Apache-2.0
// Arrays of boxes, corners and bounds: an element at a time, or a block by a kernel where there is one.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vesica/bounds.hpp>
#include <vesica/boxes.hpp>
#include <vesica/construct.hpp>
#include <vesica/polygon/bounds.hpp>
#include <vesica/polygon/own_area.hpp>

#include "arrays.hpp"
#include "environment.hpp"
#include "kernels/query_table.hpp"
#include "number_columns.hpp"
#include "polygon/arrays.hpp"
#include "vesica_boxes.h"

namespace {

using namespace vesica::capi;
using vesica::AngleUnit;

/// The unit that a constant names. Returns whether it names one.
bool unit_of(int32_t angle, AngleUnit& out) noexcept {
  const int32_t measure = angle & ~VESICA_ANGLE_REVERSED;
  if (measure < VESICA_ANGLE_RADIANS || measure > VESICA_ANGLE_QUARTERS) return false;
  out = {static_cast<AngleUnit::Measure>(measure), measure != angle};
  return true;
}

/// Writes element i, `width` numbers, by make(i, numbers), which returns 0 or an error. Other errors than
/// VESICA_E_RANGE are those of a shape. `result` is the array's.
template <int width, class T, class Make>
[[gnu::noinline]] void put(int64_t i, T* out, const Make& make, int64_t& result) noexcept {
  T numbers[width];
  const int32_t error = make(i, numbers);
  if (error != 0) {
    std::fill_n(numbers, width, std::numeric_limits<T>::quiet_NaN());
    if (result != VESICA_E_SHAPE) result = error == VESICA_E_RANGE ? VESICA_E_RANGE : VESICA_E_SHAPE;
  }
  std::copy_n(numbers, width, out + i * width);
}

template <int width, class T, class Make>
int64_t each(int64_t count, T* out, const Make& make) noexcept {
  int64_t result = 0;
  for (int64_t i = 0; i < count; ++i) put<width>(i, out, make, result);
  return result;
}

/// A block of rectangles, ellipses or circles as columns of six numbers: a circle has the axis (1, 0) and its radius
/// twice.
class BoxColumns {
 public:
  explicit BoxColumns(int32_t kind) noexcept {
    if (kind != VESICA_CIRCLE) return;
    std::fill_n(one_, vesica::query_block, 1.0);
    std::fill_n(zero_, vesica::query_block, 0.0);
  }

  template <class T>
  void set(const vesica::batch::Shapes<T>& shapes, int64_t begin, int32_t n) noexcept {
    columns_.set(shapes, begin, n, vesica::kernels());
    const double* const* const from = columns_.numbers();
    std::copy_n(from, vesica::max_fields, number_);
    if (shapes.kind != VESICA_CIRCLE) return;
    const std::array<const double*, 6> of_circle = {from[0], from[1], one_, zero_, from[2], from[2]};
    std::copy(of_circle.begin(), of_circle.end(), number_);
  }
  const double* const* numbers() const noexcept { return number_; }

 private:
  vesica::batch::NumberColumns columns_;
  const double* number_[vesica::max_fields];
  double one_[vesica::query_block], zero_[vesica::query_block];
};

/// The same for shapes in blocks: find(numbers, n, columns) finds `width` columns for n shapes, and take(columns, i,
/// to) writes element i of them. Where that returns false, or find() found no number, make() is asked.
template <int width, class T, class Find, class Take, class Make>
int64_t each_in_blocks(const vesica::batch::Shapes<T>& shapes, T* out, const Find& find, const Take& take,
                       const Make& make) noexcept {
  constexpr int64_t block = vesica::query_block;
  BoxColumns columns(shapes.kind);
  double results[width][block];
  double* column[width];
  for (int k = 0; k < width; ++k) column[k] = results[k];
  int64_t result = 0;
  for (int64_t begin = 0; begin < shapes.count; begin += block) {
    const auto n = static_cast<int32_t>(std::min(shapes.count - begin, block));
    columns.set(shapes, begin, n);
    find(columns.numbers(), vesica::batch::whole_vectors(n), column);
    for (int32_t i = 0; i < n; ++i) {
      const bool found = results[0][i] == results[0][i] && take(column, i, out + (begin + i) * width);
      if (!found) [[unlikely]]
        put<width>(begin + i, out, make, result);
    }
  }
  return result;
}

/// Kernels for an array of shapes, or null. A few shapes, or one that repeats, are not worth a block.
template <class T>
const vesica::BoxKernels* box_kernels(const vesica::batch::Shapes<T>& shapes) noexcept {
  constexpr int64_t few = 4;
  if constexpr (!vesica::has_box_kernels) return nullptr;
  return shapes.stride == 0 || shapes.count <= few ? nullptr : vesica::kernels().queries->boxes;
}

template <class Shape, class T>
void flatten(const Shape& shape, T* out) noexcept {
  std::memcpy(out, &shape, sizeof shape);
}

/// A constructor from a box, of the rows of an array.
template <class Shape, class T>
int64_t from_boxes(int (*make)(const vesica::TurnedBox<T>&, AngleUnit, Shape&) noexcept, const T* boxes, int64_t count,
                   ptrdiff_t stride, int32_t angle, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((from_boxes<Shape, T>), make, boxes, count, stride, angle, out);
  if (count != 0 && (boxes == nullptr || out == nullptr)) return VESICA_E_NULL;
  AngleUnit unit;
  if (count < 0 || !addressable(count, stride) || !unit_of(angle, unit)) return VESICA_E_ARGUMENT;
  constexpr int fields = vesica::ShapeTraits<Shape>::fields;
  return each<fields>(count, out, [&](int64_t i, T(&numbers)[fields]) {
    const vesica::Unaligned<T> row = vesica::Unaligned<T>(boxes).advanced(i * stride);
    Shape shape;
    const int error = make({row[0], row[1], row[2], row[3], row[4]}, unit, shape);
    if (error == 0) flatten(shape, numbers);
    return error;
  });
}

/// Row i of an array of four corners each.
template <class T>
void read_corners(const T* corners, ptrdiff_t stride, int64_t i, T (&out)[8]) noexcept {
  const vesica::Unaligned<T> row = vesica::Unaligned<T>(corners).advanced(i * stride);
  for (int k = 0; k < 8; ++k) out[k] = row[k];
}

template <class T>
int64_t rects_from_corners(const T* corners, int64_t count, ptrdiff_t stride, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(rects_from_corners<T>, corners, count, stride, out);
  if (count != 0 && (corners == nullptr || out == nullptr)) return VESICA_E_NULL;
  if (count < 0 || !addressable(count, stride)) return VESICA_E_ARGUMENT;
  return each<6>(count, out, [&](int64_t i, T(&numbers)[6]) {
    T row[8];
    read_corners(corners, stride, i, row);
    vesica::Rect<T> rect;
    const int error = vesica::rect_from_corners(row, rect);
    if (error == 0) flatten(rect, numbers);
    return error;
  });
}

template <class T>
int32_t check_shapes(const CShapesOf<T>* shapes, const T* out, Suits suits) noexcept {
  return check_call(shapes, shapes, out, shapes != nullptr && shapes->count != 0, suits);
}

/// Element i of rectangles or ellipses, as a rectangle.
template <class T>
vesica::Rect<T> rect_at(const vesica::batch::Shapes<T>& shapes, int64_t i) noexcept {
  T numbers[6];
  for (int k = 0; k < 6; ++k) numbers[k] = shapes.field[k].advanced(i * shapes.stride)[0];
  return vesica::load<vesica::Rect<T>>(numbers);
}

bool is_rect(int32_t kind) noexcept { return kind == VESICA_RECT; }

template <class T>
int64_t rect_corners_misfit_many(const T* corners, ptrdiff_t stride, const CShapesOf<T>* rects, T* misfit) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(rect_corners_misfit_many<T>, corners, stride, rects, misfit);
  const int32_t error = check_shapes<T>(rects, misfit, is_rect);
  if (error != 0) return error;
  if (rects->count != 0 && corners == nullptr) return VESICA_E_NULL;
  if (!addressable(rects->count, stride)) return VESICA_E_ARGUMENT;
  const auto v = view<T>(*rects);
  return each<1>(v.count, misfit, [&](int64_t i, T(&number)[1]) {
    T row[8];
    read_corners(corners, stride, i, row);
    return vesica::rect_corners_misfit(row, rect_at(v, i), number[0]);
  });
}

bool has_box(int32_t kind) noexcept { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

template <class T>
int64_t boxes_from_shapes(const CShapesOf<T>* shapes, int32_t angle, T* boxes) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(boxes_from_shapes<T>, shapes, angle, boxes);
  const int32_t error = check_shapes<T>(shapes, boxes, has_box);
  if (error != 0) return error;
  AngleUnit unit;
  if (!unit_of(angle, unit)) return VESICA_E_ARGUMENT;
  const auto v = view<T>(*shapes);
  return each<5>(v.count, boxes, [&](int64_t i, T(&numbers)[5]) {
    vesica::TurnedBox<T> box;
    const int code = vesica::box_from_rect(rect_at(v, i), unit, box);
    if (code == 0) flatten(box, numbers);
    return code;
  });
}

/// Corners as numbers of the shape's own type. False where one is beyond the finite ones.
template <class T>
bool take_corners(const double* const* columns, int32_t i, T* to) noexcept {
  bool finite = true;
  for (int k = 0; k < 8; ++k) {
    to[k] = static_cast<T>(columns[k][i]);
    finite &= std::fabs(to[k]) <= std::numeric_limits<T>::max();
  }
  return finite;
}

template <class T>
int64_t corners_of_shapes(const CShapesOf<T>* shapes, T* corners) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(corners_of_shapes<T>, shapes, corners);
  const int32_t error = check_shapes<T>(shapes, corners, has_box);
  if (error != 0) return error;
  const auto v = view<T>(*shapes);
  const auto corners_of = [&](int64_t i, T(&numbers)[8]) { return vesica::corners(rect_at(v, i), numbers); };
  const vesica::BoxKernels* const kernels = box_kernels(v);
  if (kernels == nullptr) return each<8>(v.count, corners, corners_of);
  return each_in_blocks<8>(v, corners, kernels->corners, take_corners<T>, corners_of);
}

/// Bounds as numbers of the shape's own type. False where one is beyond the finite ones.
bool take_bounds(const double* const* columns, int32_t i, double* to) noexcept {
  for (int k = 0; k < 4; ++k) to[k] = columns[k][i];
  return true;
}
bool take_bounds(const double* const* columns, int32_t i, float* to) noexcept {
  vesica::Aabb<float> box;
  if (vesica::narrow_bounds({columns[0][i], columns[1][i], columns[2][i], columns[3][i]}, box) != 0) return false;
  to[0] = box.min_x;
  to[1] = box.min_y;
  to[2] = box.max_x;
  to[3] = box.max_y;
  return true;
}

template <class T>
int64_t bounds_many(const CShapesOf<T>* shapes, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(bounds_many<T>, shapes, out);
  const int32_t error = check_shapes<T>(shapes, out, vesica::has_core_or_path);
  if (error != 0) return error;
  const auto v = view<T>(*shapes);
  const auto bounds_of = [&](int64_t i, T(&numbers)[4]) {
    vesica::Aabb<T> box;
    const int32_t code =
        vesica::with_shape<T>(v.kind, vesica::batch::Element<T>(v, i).operand().shape,
                              [&](const vesica::CoreOrPath auto& shape) { return vesica::bounds(shape, box); });
    if (code == 0) flatten(box, numbers);
    return code;
  };
  const vesica::BoxKernels* const kernels = box_kernels(v);
  // Bounds of other kinds take little arithmetic.
  const bool has_axis_or_radius = has_box(v.kind) || v.kind == VESICA_CIRCLE;
  if (kernels == nullptr || !has_axis_or_radius) return each<4>(v.count, out, bounds_of);
  const bool is_ellipse = v.kind == VESICA_ELLIPSE;
  const auto find = [&](const double* const* numbers, int32_t n, double* const* results) {
    kernels->bounds(numbers, is_ellipse, n, results);
  };
  const auto take = [](const double* const* columns, int32_t i, T* to) { return take_bounds(columns, i, to); };
  return each_in_blocks<4>(v, out, find, take, bounds_of);
}

template <class T>
int64_t shape_area_many(const CShapesOf<T>* shapes, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(shape_area_many<T>, shapes, out);
  const int32_t error = check_shapes<T>(shapes, out, vesica::has_core_or_path);
  if (error != 0) return error;
  const auto v = view<T>(*shapes);
  return each<1>(v.count, out, [&](int64_t i, T(&number)[1]) {
    return vesica::with_shape<T>(
        v.kind, vesica::batch::Element<T>(v, i).operand().shape,
        [&](const vesica::CoreOrPath auto& shape) { return vesica::shape_area_or_error(shape, number[0]); });
  });
}

/// An array of structs as its numbers.
template <class T, class Struct>
T* numbers_of(Struct* structs) noexcept {
  return reinterpret_cast<T*>(structs);
}

}  // namespace

#define VESICA_BOXES(scalar, T)                                                                                    \
  int64_t vesica_rects_from_boxes_##scalar(const T* boxes, int64_t count, ptrdiff_t stride, int32_t angle,         \
                                           vesica_rect_##scalar* out) {                                            \
    return from_boxes<vesica::Rect<T>>(vesica::rect_from_box<T>, boxes, count, stride, angle, numbers_of<T>(out)); \
  }                                                                                                                \
  int64_t vesica_ellipses_from_boxes_##scalar(const T* boxes, int64_t count, ptrdiff_t stride, int32_t angle,      \
                                              vesica_ellipse_##scalar* out) {                                      \
    return from_boxes<vesica::Ellipse<T>>(vesica::ellipse_from_box<T>, boxes, count, stride, angle,                \
                                          numbers_of<T>(out));                                                     \
  }                                                                                                                \
  int64_t vesica_rects_from_corners_##scalar(const T* corners, int64_t count, ptrdiff_t stride,                    \
                                             vesica_rect_##scalar* out) {                                          \
    return rects_from_corners<T>(corners, count, stride, numbers_of<T>(out));                                      \
  }                                                                                                                \
  int64_t vesica_rect_corners_misfit_many_##scalar(const T* corners, ptrdiff_t stride,                             \
                                                   const vesica_shapes_##scalar* rects, T* misfit) {               \
    return rect_corners_misfit_many<T>(corners, stride, rects, misfit);                                            \
  }                                                                                                                \
  int64_t vesica_boxes_from_shapes_##scalar(const vesica_shapes_##scalar* shapes, int32_t angle, T* boxes) {       \
    return boxes_from_shapes<T>(shapes, angle, boxes);                                                             \
  }                                                                                                                \
  int64_t vesica_corners_of_shapes_##scalar(const vesica_shapes_##scalar* shapes, T* corners) {                    \
    return corners_of_shapes<T>(shapes, corners);                                                                  \
  }                                                                                                                \
  int64_t vesica_bounds_many_##scalar(const vesica_shapes_##scalar* shapes, vesica_aabb_##scalar* out) {           \
    return bounds_many<T>(shapes, numbers_of<T>(out));                                                             \
  }                                                                                                                \
  int64_t vesica_shape_area_many_##scalar(const vesica_shapes_##scalar* shapes, T* out) {                          \
    return shape_area_many<T>(shapes, out);                                                                        \
  }

VESICA_BOXES(f64, double)
VESICA_BOXES(f32, float)
