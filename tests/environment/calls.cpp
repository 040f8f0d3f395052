// SPDX-License-Identifier: Apache-2.0
#include "environment/calls.hpp"

#include <vesica.h>

#include <array>
#include <cstring>
#include <limits>

#include "capi/face.hpp"
#include "capi/typed_casts.hpp"
#include "capi/typed_pairs.hpp"

namespace environment {
namespace {

template <class T>
void append(Bytes& bytes, const T* values, std::size_t count) {
  const auto* from = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), from, from + count * sizeof(T));
}
template <class T>
void append(Bytes& bytes, const T& value) {
  append(bytes, &value, 1);
}

const properties::NumbersOf<double>& first(const Input& p, double) { return p.a_f64; }
const properties::NumbersOf<double>& second(const Input& p, double) { return p.b_f64; }
const properties::NumbersOf<float>& first(const Input& p, float) { return p.a_f32; }
const properties::NumbersOf<float>& second(const Input& p, float) { return p.b_f32; }

/// function(kind_a, a, kind_b, b).
template <class T, auto function>
Bytes ask_code(const Input& p) {
  Bytes bytes;
  append(bytes, function(p.kind_a, first(p, T{}).data(), p.kind_b, second(p, T{}).data()));
  return bytes;
}

/// function(kind_a, a, kind_b, b, &out).
template <class T, class Out, auto function>
Bytes ask_pair(const Input& p) {
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(p.kind_a, first(p, T{}).data(), p.kind_b, second(p, T{}).data(), &out));
  append(bytes, out);
  return bytes;
}

/// function(kind, numbers, &out).
template <class T, class Out, auto function>
Bytes ask_one(const Input& p) {
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(p.kind_a, first(p, T{}).data(), &out));
  append(bytes, out);
  return bytes;
}
/// function(kind_a, a, kind_b, b, vx, vy, end, &out), towards the origin: a velocity without arithmetic.
template <class T, class Out, auto function>
Bytes ask_cast(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(p.kind_a, a.data(), p.kind_b, b.data(), -b[0], -b[1], T{3}, &out));
  append(bytes, out);
  return bytes;
}
/// The typed cast of the pair's kinds, likewise.
template <class T, class Out>
Bytes ask_typed_cast(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  Bytes bytes;
  for (const auto& typed : capi::typed_casts(T{})) {
    if (typed.kind_a != p.kind_a || typed.kind_b != p.kind_b) continue;
    Out out;
    std::memset(&out, 0, sizeof out);
    append(bytes, typed.cast(a.data(), b.data(), -b[0], -b[1], T{3}, &out));
    append(bytes, out);
  }
  return bytes;
}
/// function(kind_a, a, &turn_a, kind_b, b, &turn_b, tolerance, &out, &gap). Motions are numbers that are there: a
/// difference would be computed in the other environment.
template <class T, class Turn, class Out, auto function>
Bytes ask_impact_time(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  const Turn turn_a{T{0}, T{0}, T{1} / 3}, turn_b{a[0], b[1], T{-7} / 3};
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  T gap = 0;
  append(bytes, function(p.kind_a, a.data(), &turn_a, p.kind_b, b.data(), &turn_b, T{1} / 512, &out, &gap));
  append(bytes, out);
  append(bytes, gap);
  return bytes;
}
/// function(kind, numbers, vx, vy, end, &out).
template <class T, class Out, auto function>
Bytes ask_sweep(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(p.kind_a, a.data(), b[0], b[1], T{1} / 3, &out));
  append(bytes, out);
  return bytes;
}
template <class T, auto function>
Bytes ask_check(const Input& p) {
  Bytes bytes;
  append(bytes, function(p.kind_a, first(p, T{}).data()));
  return bytes;
}

/// function(n0, ..., &out), the numbers being those of both shapes.
template <class T, class Out, auto function, std::size_t... Index>
Bytes ask_constructor(const Input& p, std::index_sequence<Index...>) {
  const auto a = first(p, T{}), b = second(p, T{});
  const T n[] = {a[0], a[1], a[2], a[3], a[4], a[5], b[0], b[1], b[2], b[3], b[4], b[5]};
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(n[Index]..., &out));
  append(bytes, out);
  return bytes;
}
template <class T, class Out, auto function, std::size_t count>
Bytes ask_constructor(const Input& p) {
  return ask_constructor<T, Out, function>(p, std::make_index_sequence<count>{});
}
/// The sizes are a rectangle's; its axis gives the radius, which is often less than half of them.
template <class T, class Out, auto function>
Bytes ask_round_rect(const Input& p) {
  return ask_constructor<T, Out, function>(p, std::index_sequence<0, 1, 2, 4, 5, 3>{});
}
template <class T, class Out, auto function>
Bytes ask_corners(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  const T corners[8] = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(corners, &out));
  append(bytes, out);
  return bytes;
}
template <class T, class Rect, auto function>
Bytes ask_misfit(const Input& p) {
  const auto a = first(p, T{}), b = second(p, T{});
  const T corners[8] = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
  const Rect rect{b[0], b[1], b[2], b[3], a[4], a[5]};
  Bytes bytes;
  T misfit = 0;
  append(bytes, function(corners, &rect, &misfit));
  append(bytes, misfit);
  return bytes;
}

/// Both sides of a list of pairs as arrays. Odd places are not aligned for any number.
template <class T, class Shapes>
struct Operands {
  std::vector<properties::NumbersOf<T>> records_a, records_b;
  Shapes a{}, b{};

  explicit Operands(const Inputs& inputs) {
    for (const Input& p : inputs.pairs) {
      records_a.push_back(first(p, T{}));
      records_b.push_back(second(p, T{}));
    }
    a = array(inputs.pairs[0].kind_a, records_a, inputs.place, memory_a);
    b = array(inputs.pairs[0].kind_b, records_b, inputs.place, memory_b);
  }

 private:
  Bytes memory_a, memory_b;

  static Shapes array(int kind, const std::vector<properties::NumbersOf<T>>& from, Place place, Bytes& memory) {
    const std::size_t odd = place == Place::records ? 0 : 1, count = from.size();
    const std::size_t stride = place == Place::odd_columns ? sizeof(T) : sizeof from[0] + odd;
    const std::size_t field = place == Place::odd_columns ? count * sizeof(T) + odd : sizeof(T);
    memory.resize(odd + from[0].size() * (sizeof(T) + odd) * (count + 1));
    Shapes s{kind, 0, static_cast<std::int64_t>(count), static_cast<std::ptrdiff_t>(stride), {}, nullptr, nullptr, 0};
    for (std::size_t k = 0; k < from[0].size(); ++k) {
      unsigned char* const column = memory.data() + odd + k * field;
      for (std::size_t i = 0; i < count; ++i) std::memcpy(column + i * stride, &from[i][k], sizeof(T));
      s.field[k] = reinterpret_cast<const T*>(column);
    }
    return s;
  }
};

/// function(a, b, column...).
template <class T, class Shapes, class Out, auto function, std::size_t... Column>
Bytes ask_many(const Inputs& inputs, std::index_sequence<Column...>) {
  const Operands<T, Shapes> operands(inputs);
  std::vector<Out> columns[sizeof...(Column)];
  for (auto& column : columns) column.resize(inputs.pairs.size());
  Bytes bytes;
  append(bytes, function(&operands.a, &operands.b, columns[Column].data()...));
  for (const auto& column : columns) append(bytes, column.data(), column.size());
  return bytes;
}
template <class T, class Shapes, class Out, auto function, std::size_t count>
Bytes ask_many(const Inputs& inputs) {
  return ask_many<T, Shapes, Out, function>(inputs, std::make_index_sequence<count>{});
}

/// function(a, b, vx, vy, stride, end, column...), and the first of all to be hit.
template <class T, class Shapes, class Impact, auto many, auto first_of_all>
Bytes ask_casts(const Inputs& inputs) {
  Operands<T, Shapes> operands(inputs);
  std::vector<T> vx, vy, columns[5];
  for (std::size_t i = 0; i < operands.records_a.size(); ++i) {
    vx.push_back(-operands.records_b[i][0]);
    vy.push_back(-operands.records_b[i][1]);
  }
  for (auto& column : columns) column.resize(inputs.pairs.size());
  Bytes bytes;
  append(bytes, many(&operands.a, &operands.b, vx.data(), vy.data(), sizeof(T), T{2}, columns[0].data(),
                     columns[1].data(), columns[2].data(), columns[3].data(), columns[4].data()));
  for (const auto& column : columns) append(bytes, column.data(), column.size());
  operands.b.count = 1;
  Impact out;
  std::memset(&out, 0, sizeof out);
  append(bytes, first_of_all(&operands.b, &operands.a, vx[0], vy[0], T{2}, &out));
  append(bytes, out);
  return bytes;
}

/// function(a, b, out, row_stride).
template <class T, class Shapes, class Out, auto function>
Bytes ask_matrix(const Inputs& inputs) {
  const Operands<T, Shapes> operands(inputs);
  std::vector<Out> out(inputs.pairs.size() * inputs.pairs.size());
  Bytes bytes;
  append(bytes, function(&operands.a, &operands.b, out.data(), operands.b.count));
  append(bytes, out.data(), out.size());
  return bytes;
}

template <class T, class Shapes, auto function>
Bytes ask_select(const Inputs& inputs) {
  Operands<T, Shapes> operands(inputs);
  operands.a.count = 1;
  std::vector<std::int64_t> out(inputs.pairs.size());
  Bytes bytes;
  append(bytes, function(&operands.a, &operands.b, out.data(), operands.b.count));
  append(bytes, out.data(), out.size());
  return bytes;
}

/// function(shapes, scores, threshold, scratch, scratch_size, keep, kept), the scores being the first shapes' numbers.
template <class T, class Shapes, auto function>
Bytes ask_nms(const Inputs& inputs) {
  const Operands<T, Shapes> operands(inputs);
  std::vector<T> scores;
  for (const auto& shape : operands.records_a) scores.push_back(shape[0]);
  Bytes scratch(static_cast<std::size_t>(vesica_nms_scratch(operands.b.count)));
  std::vector<std::int64_t> keep(inputs.pairs.size());
  std::int64_t kept = 0;
  Bytes bytes;
  append(bytes, function(&operands.b, scores.data(), T{1} / 4, scratch.data(),
                         static_cast<std::int64_t>(scratch.size()), keep.data(), &kept));
  append(bytes, keep.data(), keep.size());
  append(bytes, kept);
  return bytes;
}

/// Memory as an index needs it.
struct Aligned {
  struct alignas(64) Unit {
    unsigned char bytes[64];
  };
  std::vector<Unit> units;
  std::int64_t size;

  explicit Aligned(std::int64_t n) : units(static_cast<std::size_t>(n / 64 + 1)), size(n) {}
};

/// An index of both sides' shapes, built, checked and read.
template <class T, class Shapes, class Impact, auto build, auto select, auto nearest, auto cast, auto cast_first>
Bytes ask_index(const Inputs& inputs) {
  const Operands<T, Shapes> operands(inputs);
  const Shapes sets[] = {operands.a, operands.b};
  Shapes one = operands.a;
  one.count = 1;
  const std::int64_t items = 2 * operands.a.count;
  Aligned index(vesica_index_size(items)), scratch(vesica_index_scratch(items));
  Bytes bytes;
  append(bytes, build(sets, 2, index.units.data(), index.size, scratch.units.data(), scratch.size));
  const std::int64_t size = vesica_index_bytes(index.units.data());
  append(bytes, vesica_index_check(index.units.data(), size));
  append(bytes, index.units.data(), static_cast<std::size_t>(size) / sizeof index.units[0]);
  std::vector<std::int64_t> out(static_cast<std::size_t>(items));
  std::vector<T> distance(out.size());
  std::int64_t state[4] = {};
  append(bytes, select(index.units.data(), sets, 2, &one, out.data(), items, state));
  append(bytes, out.data(), out.size());
  append(bytes, nearest(index.units.data(), sets, 2, &one, items, std::numeric_limits<T>::infinity(), out.data(),
                        distance.data()));
  append(bytes, out.data(), out.size());
  append(bytes, distance.data(), distance.size());
  const T vx = operands.records_b[0][0], vy = T{1} / 8;
  std::int64_t cast_state[4] = {};
  append(bytes, cast(index.units.data(), sets, 2, &one, vx, vy, T{3}, out.data(), items, cast_state));
  append(bytes, out.data(), out.size());
  Impact impact;
  std::memset(&impact, 0, sizeof impact);
  append(bytes, cast_first(index.units.data(), sets, 2, &one, vx, vy, T{3}, &impact));
  append(bytes, impact);
  return bytes;
}

/// Pairs of two indexes, by each query and within distances, and the nearest items of the second one to each of the
/// first.
template <class T, class Shapes, auto build, auto join, auto within, auto nearest>
Bytes ask_join(const Inputs& inputs) {
  const Operands<T, Shapes> operands(inputs);
  const Shapes &a = operands.a, &b = operands.b;
  Aligned index_a(vesica_index_size(a.count)), index_b(vesica_index_size(b.count));
  Aligned scratch(vesica_index_scratch(a.count)), join_scratch(vesica_join_scratch());
  build(&a, 1, index_a.units.data(), index_a.size, scratch.units.data(), scratch.size);
  build(&b, 1, index_b.units.data(), index_b.size, scratch.units.data(), scratch.size);
  std::vector<std::int64_t> out_a(inputs.pairs.size() * inputs.pairs.size()), out_b(out_a.size());
  std::vector<T> distance(out_a.size());
  Bytes bytes;
  for (std::int32_t query = VESICA_JOIN_OVERLAP; query <= VESICA_JOIN_INTERIORS; ++query) {
    std::int64_t state[4] = {};
    append(bytes, join(query, index_a.units.data(), &a, 1, index_b.units.data(), &b, 1, 0, 1, join_scratch.units.data(),
                       join_scratch.size, out_a.data(), out_b.data(), static_cast<std::int64_t>(out_a.size()), state));
    append(bytes, out_a.data(), out_a.size());
    append(bytes, out_b.data(), out_b.size());
  }
  constexpr T infinity = std::numeric_limits<T>::infinity();
  for (const T most : {T{0.5}, infinity}) {
    std::int64_t state[4] = {};
    append(bytes, within(index_a.units.data(), &a, 1, index_b.units.data(), &b, 1, most, 0, 1, out_a.data(),
                         out_b.data(), static_cast<std::int64_t>(out_a.size()), state));
    append(bytes, out_a.data(), out_a.size());
    append(bytes, out_b.data(), out_b.size());
  }
  append(bytes, nearest(&a, 1, index_b.units.data(), &b, 1, 3, infinity, 0, 1, out_a.data(), distance.data()));
  append(bytes, out_a.data(), out_a.size());
  append(bytes, distance.data(), distance.size());
  return bytes;
}

using capi_tests::Face;

/// The typed function of the pair's kinds, in either order.
template <class T>
Bytes ask_typed(const Input& p) {
  Bytes bytes;
  for (const auto& pair : capi::Api<T>::typed_pairs) {
    if (pair.kind_a == p.kind_a && pair.kind_b == p.kind_b) {
      append(bytes, pair.overlap(first(p, T{}).data(), second(p, T{}).data()));
    } else if (pair.kind_a == p.kind_b && pair.kind_b == p.kind_a) {
      append(bytes, pair.overlap(second(p, T{}).data(), first(p, T{}).data()));
    }
  }
  return bytes;
}

constexpr std::int32_t ratios = VESICA_RATIO_COMPLETE + 1;

template <class T>
Bytes ask_ratios(const Input& p) {
  Bytes bytes;
  for (std::int32_t which = 0; which < ratios; ++which) {
    T out{};
    append(bytes, Face<T>::ratio(which, p.kind_a, first(p, T{}).data(), p.kind_b, second(p, T{}).data(), &out));
    append(bytes, out);
  }
  return bytes;
}
template <class T>
Bytes ask_ratio_arrays(const Inputs& inputs) {
  const Operands<T, typename Face<T>::Shapes> operands(inputs);
  const std::size_t n = inputs.pairs.size();
  std::vector<T> out(n), square(n * n);
  Bytes bytes;
  for (std::int32_t which = 0; which < ratios; ++which) {
    append(bytes, Face<T>::ratio_many(which, &operands.a, &operands.b, out.data()));
    append(bytes, out.data(), out.size());
  }
  append(bytes,
         Face<T>::ratio_matrix(VESICA_RATIO_GENERALIZED, &operands.a, &operands.b, square.data(), operands.b.count));
  append(bytes, square.data(), square.size());
  return bytes;
}

/// The first shapes' numbers are scores, by every ratio that suppression takes.
template <class T>
Bytes ask_suppress(const Inputs& inputs) {
  const Operands<T, typename Face<T>::Shapes> operands(inputs);
  std::vector<T> scores;
  std::vector<std::int32_t> labels;
  for (const auto& shape : operands.records_a) {
    scores.push_back(shape[0]);
    labels.push_back(static_cast<std::int32_t>(scores.size() % 3));
  }
  Bytes scratch(static_cast<std::size_t>(vesica_nms_scratch(operands.b.count)));
  std::vector<std::int64_t> keep(inputs.pairs.size());
  Bytes bytes;
  for (std::int32_t which = 0; which < ratios; ++which) {
    std::int64_t kept = 0;
    append(bytes, Face<T>::suppress(&operands.b, scores.data(), labels.data(), which, T{1} / 4, scores.back(),
                                    operands.b.count, scratch.data(), static_cast<std::int64_t>(scratch.size()),
                                    keep.data(), &kept));
    append(bytes, keep.data(), static_cast<std::size_t>(kept));
  }
  return bytes;
}

/// Rectangles and ellipses from the second shapes' numbers; boxes, corners and bounds of the first shapes.
template <class T>
Bytes ask_boxes(const Inputs& inputs) {
  using F = Face<T>;
  const Operands<T, typename F::Shapes> operands(inputs);
  const std::size_t n = inputs.pairs.size();
  std::vector<typename F::Rect> rects(n);
  std::vector<typename F::Ellipse> ellipses(n);
  std::vector<typename F::Aabb> bounds(n);
  std::vector<T> boxes(5 * n), corners(8 * n);
  Bytes bytes;
  for (const std::int32_t angle : {VESICA_ANGLE_RADIANS, VESICA_ANGLE_DEGREES, VESICA_ANGLE_QUARTERS,
                                   VESICA_ANGLE_DEGREES + VESICA_ANGLE_REVERSED}) {
    const T* numbers = operands.records_b[0].data();
    const std::ptrdiff_t stride = sizeof operands.records_b[0];
    append(bytes, F::rects_from_boxes(numbers, operands.b.count, stride, angle, rects.data()));
    append(bytes, rects.data(), n);
    append(bytes, F::ellipses_from_boxes(numbers, operands.b.count, stride, angle, ellipses.data()));
    append(bytes, ellipses.data(), n);
    append(bytes, F::boxes_from_shapes(&operands.a, angle, boxes.data()));
    append(bytes, boxes.data(), boxes.size());
  }
  append(bytes, F::corners_of_shapes(&operands.a, corners.data()));
  append(bytes, corners.data(), corners.size());
  constexpr std::ptrdiff_t corner_stride = 8 * sizeof(T);
  append(bytes, F::rects_from_corners(corners.data(), operands.a.count, corner_stride, rects.data()));
  append(bytes, rects.data(), n);
  append(bytes, F::rect_corners_misfit_many(corners.data(), corner_stride, &operands.a, boxes.data()));
  append(bytes, boxes.data(), n);
  append(bytes, F::bounds_many(&operands.a, bounds.data()));
  append(bytes, bounds.data(), n);
  append(bytes, F::shape_area_many(&operands.a, boxes.data()));
  append(bytes, boxes.data(), n);
  return bytes;
}

/// An index built in steps and parts, and what can be read from it.
template <class T>
Bytes ask_steps(const Inputs& inputs) {
  const Operands<T, typename Face<T>::Shapes> operands(inputs);
  const std::int64_t items = operands.a.count;
  Aligned index(vesica_index_size(items)), scratch(vesica_index_scratch(items));
  Bytes bytes;
  for (std::int32_t step = 0; step < 5; ++step) {
    const std::int64_t parts = step == 0 || step == 4 ? 1 : 2;
    for (std::int64_t part = 0; part < parts; ++part) {
      append(bytes, Face<T>::index_step(step, part, parts, &operands.a, 1, index.units.data(), index.size,
                                        scratch.units.data(), scratch.size));
    }
  }
  const std::int64_t size = vesica_index_bytes(index.units.data());
  append(bytes, index.units.data(), static_cast<std::size_t>(size) / sizeof index.units[0]);
  append(bytes, vesica_index_count(index.units.data()));
  vesica_aabb_f64 bounds{};
  append(bytes, vesica_index_bounds(index.units.data(), &bounds));
  append(bytes, bounds);
  std::vector<std::int64_t> order(static_cast<std::size_t>(items));
  append(bytes, vesica_index_order(index.units.data(), order.data(), items));
  append(bytes, order.data(), order.size());
  return bytes;
}

}  // namespace

/// Within a distance of 1/2.
template <class T>
std::int32_t within(std::int32_t kind_a, const T* a, std::int32_t kind_b, const T* b) {
  return capi_tests::Face<T>::within(kind_a, a, kind_b, b, T{1} / 2);
}
template <class T>
std::int64_t within_many(const typename capi_tests::Face<T>::Shapes* a, const typename capi_tests::Face<T>::Shapes* b,
                         std::uint8_t* out) {
  return capi_tests::Face<T>::within_many(a, b, T{1} / 2, out);
}
template <class T>
std::int64_t within_matrix(const typename capi_tests::Face<T>::Shapes* a, const typename capi_tests::Face<T>::Shapes* b,
                           std::uint8_t* out, std::ptrdiff_t row_stride) {
  return capi_tests::Face<T>::within_matrix(a, b, T{1} / 2, out, row_stride);
}

/// function(kind_a, a, kind_b, b, text).
template <class T, auto function>
Bytes ask_text(const Input& p) {
  char text[10] = "";
  Bytes bytes;
  append(bytes, function(p.kind_a, first(p, T{}).data(), p.kind_b, second(p, T{}).data(), text));
  append(bytes, text);
  return bytes;
}
/// function(kind_a, a, kind_b, b, numbers).
template <class T, auto function, std::size_t count>
Bytes ask_numbers(const Input& p) {
  T numbers[count] = {};
  Bytes bytes;
  append(bytes, function(p.kind_a, first(p, T{}).data(), p.kind_b, second(p, T{}).data(), numbers));
  append(bytes, numbers, count);
  return bytes;
}
/// function(shapes, scores, labels, ratio, decay, parameter, least, most, scratch, keep, decayed): by a Gaussian.
template <class T, class Shapes, auto function>
Bytes ask_soft(const Inputs& inputs) {
  const Operands<T, Shapes> operands(inputs);
  const std::int64_t n = operands.b.count;
  // Without arithmetic, which may trap here.
  constexpr std::array<T, 7> some{T(0.3), T(0.9), T(0.5), T(0.7), T(0.9), T(0.1), T(0.6)};
  std::vector<T> scores;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) scores.push_back(some[i % some.size()]);
  std::vector<double> scratch(static_cast<std::size_t>(vesica_suppress_soft_scratch(n)) / sizeof(double) + 1);
  std::vector<std::int64_t> keep(scores.size());
  std::vector<T> decayed(scores.size());
  std::int64_t kept = 0;
  Bytes bytes;
  append(bytes, function(&operands.b, scores.data(), nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, T{1} / 2,
                         T{0}, n, scratch.data(), static_cast<std::int64_t>(scratch.size() * sizeof(double)),
                         keep.data(), decayed.data(), &kept));
  append(bytes, keep.data(), keep.size());
  append(bytes, decayed.data(), decayed.size());
  return bytes;
}

// The two scalar types' functions differ in their suffix alone.
#define SCALAR_CALLS(s, T)                                                                                           \
  {                                                                                                                  \
    {"check", ask_check<T, vesica_check_##s>}, {"overlap", ask_code<T, vesica_overlap_##s>},                         \
        {"interiors_overlap", ask_code<T, vesica_interiors_overlap_##s>},                                            \
        {"relation", ask_code<T, vesica_relation_##s>}, {"contains", ask_code<T, vesica_contains_##s>},              \
        {"nearest", ask_pair<T, vesica_closest_points_##s, vesica_nearest_##s>},                                     \
        {"boundary_distance", ask_pair<T, vesica_closest_points_##s, vesica_boundary_distance_##s>},                 \
        {"depth", ask_pair<T, vesica_penetration_##s, vesica_depth_##s>},                                            \
        {"crossings", ask_pair<T, capi_tests::Crossings<T>, capi_tests::crossings<T>>},                              \
        {"area", ask_pair<T, T, vesica_area_##s>}, {"iou", ask_pair<T, T, vesica_iou_##s>},                          \
        {"signed_distance", ask_pair<T, T, vesica_signed_distance_##s>}, {"within", ask_code<T, within<T>>},         \
        {"de9im", ask_text<T, vesica_de9im_##s>}, {"intersection", ask_numbers<T, capi_tests::intersection<T>, 16>}, \
        {"typed overlap", ask_typed<T>}, {"ratios", ask_ratios<T>},                                                  \
        {"shape_area", ask_one<T, T, vesica_shape_area_##s>},                                                        \
        {"cast", ask_cast<T, vesica_impact_##s, vesica_cast_##s>},                                                   \
        {"typed cast", ask_typed_cast<T, vesica_impact_##s>},                                                        \
        {"manifold", ask_pair<T, vesica_contacts_##s, vesica_manifold_##s>},                                         \
        {"impact_time", ask_impact_time<T, vesica_turn_##s, vesica_impact_##s, vesica_impact_time_##s>},             \
        {"sweep_bounds", ask_sweep<T, vesica_aabb_##s, vesica_sweep_bounds_##s>},                                    \
        {"bounds", ask_one<T, vesica_aabb_##s, vesica_bounds_##s>},                                                  \
        {"aabb_from_corners", ask_constructor<T, vesica_aabb_##s, vesica_aabb_from_corners_##s, 4>},                 \
        {"rect_from_angle", ask_constructor<T, vesica_rect_##s, vesica_rect_from_angle_##s, 5>},                     \
        {"rect_from_corners", ask_corners<T, vesica_rect_##s, vesica_rect_from_corners_##s>},                        \
        {"rect_corners_misfit", ask_misfit<T, vesica_rect_##s, vesica_rect_corners_misfit_##s>},                     \
        {"round_rect_from_angle", ask_round_rect<T, vesica_round_rect_##s, vesica_round_rect_from_angle_##s>},       \
        {"capsule_from_angle", ask_constructor<T, vesica_capsule_##s, vesica_capsule_from_angle_##s, 5>},            \
        {"capsule_from_width", ask_constructor<T, vesica_capsule_##s, vesica_capsule_from_width_##s, 5>},            \
        {"ellipse_from_angle", ask_constructor<T, vesica_ellipse_##s, vesica_ellipse_from_angle_##s, 5>},            \
        {"ellipse_from_radius_vector",                                                                               \
         ask_constructor<T, vesica_ellipse_##s, vesica_ellipse_from_radius_vector_##s, 5>},                          \
        {"ellipse_from_covariance", ask_constructor<T, vesica_ellipse_##s, vesica_ellipse_from_covariance_##s, 6>},  \
        {"ellipse_from_matrix", ask_constructor<T, vesica_ellipse_##s, vesica_ellipse_from_matrix_##s, 5>},          \
  }
#define BATCH_CALLS(s, T)                                                                                             \
  {                                                                                                                   \
    {"overlap_many", ask_many<T, vesica_shapes_##s, std::uint8_t, vesica_overlap_many_##s, 1>},                       \
        {"interiors_overlap_many",                                                                                    \
         ask_many<T, vesica_shapes_##s, std::uint8_t, vesica_interiors_overlap_many_##s, 1>},                         \
        {"relation_many", ask_many<T, vesica_shapes_##s, std::uint8_t, vesica_relation_many_##s, 1>},                 \
        {"contains_many", ask_many<T, vesica_shapes_##s, std::uint8_t, vesica_contains_many_##s, 1>},                 \
        {"nearest_many", ask_many<T, vesica_shapes_##s, T, vesica_nearest_many_##s, 5>},                              \
        {"boundary_distance_many", ask_many<T, vesica_shapes_##s, T, vesica_boundary_distance_many_##s, 5>},          \
        {"depth_many", ask_many<T, vesica_shapes_##s, T, vesica_depth_many_##s, 3>},                                  \
        {"area_many", ask_many<T, vesica_shapes_##s, T, vesica_area_many_##s, 1>},                                    \
        {"iou_many", ask_many<T, vesica_shapes_##s, T, vesica_iou_many_##s, 1>},                                      \
        {"overlap_matrix", ask_matrix<T, vesica_shapes_##s, std::uint8_t, vesica_overlap_matrix_##s>},                \
        {"interiors_overlap_matrix",                                                                                  \
         ask_matrix<T, vesica_shapes_##s, std::uint8_t, vesica_interiors_overlap_matrix_##s>},                        \
        {"relation_matrix", ask_matrix<T, vesica_shapes_##s, std::uint8_t, vesica_relation_matrix_##s>},              \
        {"contains_matrix", ask_matrix<T, vesica_shapes_##s, std::uint8_t, vesica_contains_matrix_##s>},              \
        {"area_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_area_matrix_##s>},                                 \
        {"iou_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_iou_matrix_##s>},                                   \
        {"nearest_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_nearest_matrix_##s>},                           \
        {"within_matrix", ask_matrix<T, vesica_shapes_##s, std::uint8_t, within_matrix<T>>},                          \
        {"within_many", ask_many<T, vesica_shapes_##s, std::uint8_t, within_many<T>, 1>},                             \
        {"signed_distance_many", ask_many<T, vesica_shapes_##s, T, vesica_signed_distance_many_##s, 1>},              \
        {"signed_distance_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_signed_distance_matrix_##s>},           \
        {"suppress_soft", ask_soft<T, vesica_shapes_##s, vesica_suppress_soft_##s>},                                  \
        {"boundary_distance_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_boundary_distance_matrix_##s>},       \
        {"depth_matrix", ask_matrix<T, vesica_shapes_##s, T, vesica_depth_matrix_##s>},                               \
        {"ratio arrays", ask_ratio_arrays<T>}, {"suppress", ask_suppress<T>}, {"boxes", ask_boxes<T>},                \
        {"index steps", ask_steps<T>},                                                                                \
        {"overlap_select", ask_select<T, vesica_shapes_##s, vesica_overlap_select_##s>},                              \
        {"interiors_overlap_select", ask_select<T, vesica_shapes_##s, vesica_interiors_overlap_select_##s>},          \
        {"nms", ask_nms<T, vesica_shapes_##s, vesica_nms_##s>},                                                       \
        {"casts", ask_casts<T, vesica_shapes_##s, vesica_impact_##s, vesica_cast_many_##s, vesica_cast_first_##s>},   \
        {"index", ask_index<T, vesica_shapes_##s, vesica_impact_##s, vesica_index_build_##s, vesica_index_select_##s, \
                            vesica_index_nearest_##s, vesica_index_cast_##s, vesica_index_cast_first_##s>},           \
        {"join", ask_join<T, vesica_shapes_##s, vesica_index_build_##s, vesica_join_##s, vesica_join_within_##s,      \
                          vesica_join_nearest_##s>},                                                                  \
  }

Input::Input(const properties::Pair& pair) : kind_a(pair.kind_a), kind_b(pair.kind_b), a_f64(pair.a), b_f64(pair.b) {
  for (std::size_t i = 0; i < a_f64.size(); ++i) {
    a_f32[i] = static_cast<float>(a_f64[i]);
    b_f32[i] = static_cast<float>(b_f64[i]);
  }
}

const std::vector<Call>& scalar_calls(properties::Scalar scalar) {
  static const std::vector<Call> f64 = SCALAR_CALLS(f64, double), f32 = SCALAR_CALLS(f32, float);
  return scalar == properties::Scalar::f64 ? f64 : f32;
}

const std::vector<BatchCall>& batch_calls(properties::Scalar scalar) {
  static const std::vector<BatchCall> f64 = BATCH_CALLS(f64, double), f32 = BATCH_CALLS(f32, float);
  return scalar == properties::Scalar::f64 ? f64 : f32;
}

}  // namespace environment
