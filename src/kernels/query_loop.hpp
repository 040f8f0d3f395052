// SPDX-License-Identifier: Apache-2.0
// The one loop behind every query kernel. Included once by each src/isa/<set>_queries.cpp, after that set's lanes.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>

#include "kernels/outline_cores.hpp"
#include "kernels/query_cores.hpp"
#include "lanes/two_vectors.hpp"

namespace vesica {
namespace {

template <template <class> class Shape, class V, std::size_t... Field>
VESICA_INLINE Shape<V> load_shape(const double* const* field, std::int32_t i, std::index_sequence<Field...>) noexcept {
  return {V::load(field[Field] + i)...};
}
template <template <class> class Shape, class V>
VESICA_INLINE Shape<V> load_shape(const double* const* field, std::int32_t i) noexcept {
  return load_shape<Shape, V>(field, i, std::make_index_sequence<ShapeTraits<Shape<double>>::fields>{});
}

// Whether a shape is valid, by the rules of check(): finite numbers, no negative size, an axis that is not zero.
// Relations need none of these: a filter decides nothing about an invalid shape. Areas need none either: the reach of an
// invalid rectangle is NaN.
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

/// The loop: loads a vector of pairs, asks Core, stores the results.
template <class Core, template <class> class A, template <class> class B, class V>
bool answer_vectors(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept {
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
                              V::load(columns.second.area + at_b), V::load(columns.first.reach + at_a),
                              V::load(columns.second.reach + at_b)};
    V out[Core::results];
    MaskOf<V> settled = Core::evaluate(a, b, known, out);
    if constexpr (!sees_validity) settled = both(settled, both(valid(a), valid(b)));
    all_settled = both(all_settled, settled);
    out[0] = select(settled, out[0], no_number);
    for (int k = 0; k < Core::results; ++k) out[k].store(results[k] + i);
  }
  return all(all_settled);
}

/// The ApartKernel: one comparison a pair.
inline void find_apart(const QueryColumns& columns, std::int32_t n, std::uint8_t* out) noexcept {
  const std::int32_t step_a = columns.first.repeated ? 0 : 1, step_b = columns.second.repeated ? 0 : 1;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const auto a = [&](const double* column) { return Doubles::load(column + i * step_a); };
    const auto b = [&](const double* column) { return Doubles::load(column + i * step_b); };
    const Doubles dx = b(columns.second.number[0]) - a(columns.first.number[0]);
    const Doubles dy = b(columns.second.number[1]) - a(columns.first.number[1]);
    store_bytes(circles_apart(dx, dy, a(columns.first.reach) + b(columns.second.reach)), out + i);
  }
}

template <class Core, template <class> class A, template <class> class B, class V = Doubles>
constexpr void fill(QueryKernels& kernels) noexcept {
  kernels[static_cast<int>(ShapeTraits<A<double>>::kind)][static_cast<int>(ShapeTraits<B<double>>::kind)] =
      answer_vectors<Core, A, B, V>;
}

template <class Core>
constexpr void fill_lane_pairs(QueryKernels& kernels) noexcept {
  fill<Core, Rect, Rect>(kernels);
  fill<Core, Rect, Ellipse>(kernels);
  fill<Core, Circle, Ellipse>(kernels);
  fill<Core, Ellipse, Ellipse>(kernels);
}

/// Everything this instruction set offers, laid down at compile time.
consteval QueryTable make_query_table() noexcept {
  QueryTable table{};
  fill_lane_pairs<RelationCore>(table.relation);
  fill<RelationCore, Circle, Circle>(table.relation);
  fill<RelationCore, Circle, Rect>(table.relation);
  fill<RelationCore, Aabb, Aabb>(table.relation);
  fill<RelationCore, Point, Rect>(table.relation);
  fill<RelationCore, Point, Ellipse>(table.relation);
  fill<NearestCore, Rect, Rect>(table.nearest);
  fill<NearestCore, Rect, Ellipse, TwoVectors<Doubles>>(table.nearest);
  fill<NearestCore, Circle, Ellipse, TwoVectors<Doubles>>(table.nearest);
  fill<NearestCore, Ellipse, Ellipse, TwoVectors<Doubles>>(table.nearest);
  fill_lane_pairs<BoundaryDistanceCore>(table.boundary_distance);
  fill_lane_pairs<DepthCore>(table.depth);
  fill<AreaCore, Rect, Rect>(table.area);
  fill<IouCore, Rect, Rect>(table.iou);
  table.apart = find_apart;
  return table;
}

}  // namespace
}  // namespace vesica
