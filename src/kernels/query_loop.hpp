// SPDX-License-Identifier: Apache-2.0
// The one loop behind every query kernel. Included once by each src/isa/<set>_queries.cpp, after that set's lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "kernels/outline_cores.hpp"
#include "kernels/query_cores.hpp"
#include "kernels/ring_areas.hpp"
#include "lanes/two_vectors.hpp"
#if defined(__AVX__)
#include "kernels/cast_table.hpp"
#endif

namespace vesica {
namespace {

/// A column of one number.
template <int number>
constexpr auto column_of = [] {
  std::array<double, query_block> column;
  column.fill(number);
  return column;
}();

template <template <class> class Shape, class V, std::size_t... Field>
VESICA_INLINE Shape<V> load_shape(const double* const* field, std::int32_t i, std::index_sequence<Field...>) noexcept {
  return {V::load(field[Field] + i)...};
}
template <template <class> class Shape, class V>
VESICA_INLINE Shape<V> load_shape(const double* const* field, std::int32_t i) noexcept {
  return load_shape<Shape, V>(field, i, std::make_index_sequence<ShapeTraits<Shape<double>>::fields>{});
}

// True if a shape is valid, by the rules of check(): finite numbers, no negative size, an axis that is not zero.
// Relations need none of these: a filter decides nothing about an invalid shape. Areas need none either: the radius of
// an invalid rectangle is NaN.
template <class V>
VESICA_INLINE MaskOf<V> valid(const Circle<V>& s) noexcept {
  const V zero(0.0);
  return both(detail::all_finite(s.cx, s.cy, s.r), s.r >= zero);
}
template <class V>
VESICA_INLINE MaskOf<V> valid(const Rect<V>& s) noexcept {
  const V zero(0.0);
  const MaskOf<V> axis = abs(s.ux) + abs(s.uy) > zero;
  return both(both(detail::all_finite(s.cx, s.cy, s.ux, s.uy, s.hx, s.hy), axis), both(s.hx >= zero, s.hy >= zero));
}
template <class V>
VESICA_INLINE MaskOf<V> valid(const Ellipse<V>& s) noexcept {
  return valid(Rect<V>{s.cx, s.cy, s.ux, s.uy, s.a, s.b});
}

}  // namespace
}  // namespace vesica

#if defined(__AVX__)
#include "kernels/box_kernels.hpp"
#endif

namespace vesica {
namespace {

/// True if the core continues from results that an earlier kernel wrote.
template <class Core>
inline constexpr bool goes_on = std::is_same_v<Core, NestedCore>;

/// The loop: loads a vector of pairs, runs Core, stores the results.
template <class Core, template <class> class A, template <class> class B, class V>
VESICA_KERNEL bool answer_vectors(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept {
  constexpr bool sees_validity =
      std::is_same_v<Core, RelationCore> || std::is_same_v<Core, AreaCore> || std::is_same_v<Core, IouCore>;
  const V no_number(std::numeric_limits<double>::quiet_NaN());
  const std::int32_t step_a = columns.first.repeated ? 0 : 1, step_b = columns.second.repeated ? 0 : 1;
  MaskOf<V> all_settled = V(0.0) == V(0.0);
  for (std::int32_t i = 0; i < n; i += V::width) {
    const std::int32_t at_a = i * step_a, at_b = i * step_b;
    const auto a = load_shape<A, V>(columns.first.number, at_a);
    const auto b = load_shape<B, V>(columns.second.number, at_b);
    const KnownLanes<V> known{V::load(columns.known + i), V::load(columns.first.area + at_a),
                              V::load(columns.second.area + at_b), V::load(columns.first.radius + at_a),
                              V::load(columns.second.radius + at_b)};
    V out[Core::results];
    if constexpr (goes_on<Core>) {
      for (int k = 0; k < Core::results; ++k) out[k] = V::load(results[k] + i);
    }
    MaskOf<V> settled = Core::evaluate(a, b, known, out);
    if constexpr (!sees_validity) settled = both(settled, both(valid(a), valid(b)));
    all_settled = both(all_settled, settled);
    out[0] = select(settled, out[0], no_number);
    for (int k = 0; k < Core::results; ++k) out[k].store(results[k] + i);
  }
  return all(all_settled);
}

/// Runs two kernels; the second one continues from the first one's results.
template <QueryKernel first, QueryKernel second>
bool answer_in_turn(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept {
  first(columns, n, results);
  return second(columns, n, results);
}

/// The first shapes are circles; the kernel gets them as ellipses.
template <QueryKernel kernel>
bool answer_circles(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept {
  QueryColumns as_ellipses = columns;
  const double* const* const circle = columns.first.number;
  const double* const ellipse[] = {circle[0],           circle[1], column_of<1>.data(),
                                   column_of<0>.data(), circle[2], circle[2]};
  std::copy(std::begin(ellipse), std::end(ellipse), as_ellipses.first.number);
  return kernel(as_ellipses, n, results);
}

/// The ApartKernel: one comparison a pair.
VESICA_KERNEL inline void find_apart(const QueryColumns& columns, std::int32_t n, std::uint8_t* out) noexcept {
  const std::int32_t step_a = columns.first.repeated ? 0 : 1, step_b = columns.second.repeated ? 0 : 1;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const auto a = [&](const double* column) { return Doubles::load(column + i * step_a); };
    const auto b = [&](const double* column) { return Doubles::load(column + i * step_b); };
    const Doubles dx = b(columns.second.number[0]) - a(columns.first.number[0]);
    const Doubles dy = b(columns.second.number[1]) - a(columns.first.number[1]);
    store_bytes(circles_apart(dx, dy, a(columns.first.radius) + b(columns.second.radius)), out + i);
  }
}

template <template <class> class A, template <class> class B>
consteval void enter(QueryKernels& kernels, QueryKernel kernel) noexcept {
  kernels[static_cast<int>(kind_of<A>)][static_cast<int>(kind_of<B>)] = kernel;
}
template <class Core, template <class> class A, template <class> class B>
consteval void fill(QueryKernels& kernels) noexcept {
  enter<A, B>(kernels, answer_vectors<Core, A, B, Doubles>);
}

/// Two vectors at a time for cores whose time is the latency of divisions and roots in a row. SSE2 has too few
/// registers.
#if defined(__SSE2__) && !defined(__AVX__)
using LongVector = Doubles;
#else
using LongVector = TwoVectors<Doubles>;
#endif

/// Distances of shapes and, by a kernel that goes on from those, of outlines.
template <template <class> class A, template <class> class B, class V, QueryKernel nested>
consteval void fill_distances(QueryTable& table) noexcept {
  constexpr QueryKernel nearest = answer_vectors<NearestCore, A, B, V>;
  enter<A, B>(table.nearest, nearest);
  enter<A, B>(table.boundary_distance, answer_in_turn<nearest, nested>);
}

/// The kernels whose results are codes. A build may leave out the others, to be smaller.
consteval QueryTable make_relation_table() noexcept {
  QueryTable table{};
  fill<RelationCore, Rect, Rect>(table.relation);
  fill<RelationCore, Rect, Ellipse>(table.relation);
  fill<RelationCore, Circle, Ellipse>(table.relation);
  fill<RelationCore, Ellipse, Ellipse>(table.relation);
  fill<RelationCore, Circle, Circle>(table.relation);
  fill<RelationCore, Circle, Rect>(table.relation);
  fill<RelationCore, Aabb, Aabb>(table.relation);
  fill<RelationCore, Point, Rect>(table.relation);
  fill<RelationCore, Point, Ellipse>(table.relation);
  table.apart = find_apart;
  return table;
}

#if defined(__AVX__)
constinit const CastTable cast_table = make_cast_table();
constexpr const CastTable* casts = &cast_table;
constexpr const BoxKernels* boxes = &box_kernels;
#else
constexpr const CastTable* casts = nullptr;
constexpr const BoxKernels* boxes = nullptr;
#endif

/// The tables of this instruction set, as constants.
consteval QueryTable make_query_table() noexcept {
  QueryTable table = make_relation_table();
  constexpr QueryKernel nested_ellipses = answer_vectors<NestedCore, Ellipse, Ellipse, Doubles>;
  fill_distances<Rect, Rect, Doubles, answer_vectors<NestedCore, Rect, Rect, Doubles>>(table);
  fill_distances<Rect, Ellipse, LongVector, answer_vectors<NestedCore, Rect, Ellipse, Doubles>>(table);
  fill_distances<Circle, Ellipse, LongVector, answer_circles<nested_ellipses>>(table);
  fill_distances<Ellipse, Ellipse, Doubles, nested_ellipses>(table);
  fill<DepthCore, Rect, Rect>(table.depth);
  fill<DepthCore, Rect, Ellipse>(table.depth);
  enter<Circle, Ellipse>(table.depth, answer_circles<answer_vectors<DepthCore, Ellipse, Ellipse, Doubles>>);
  fill<DepthCore, Ellipse, Ellipse>(table.depth);
  fill<AreaCore, Aabb, Aabb>(table.area);
  fill<AreaCore, Rect, Rect>(table.area);
  fill<IouCore, Aabb, Aabb>(table.iou);
  fill<IouCore, Rect, Rect>(table.iou);
  table.ring_facts = find_ring_facts;
  table.ring_areas[0] = ring_areas<false>;
  table.ring_areas[1] = ring_areas<true>;
  table.cast = casts;
  table.boxes = boxes;
  return table;
}

}  // namespace
}  // namespace vesica
