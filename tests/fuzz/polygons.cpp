// SPDX-License-Identifier: Apache-2.0
// Calls of polygons and polylines, single and in arrays, with any offsets: those that decrease or are negative, and in
// columns of known length those that exceed it. Vertices and offsets end at guard pages.
#include <algorithm>
#include <iterator>
#include <type_traits>

#include "fuzz/arrays.hpp"

namespace fuzz {
namespace polygons {
namespace {

template <class T>
using Polygon = std::conditional_t<std::is_same_v<T, float>, vesica_polygon_f32, vesica_polygon_f64>;

/// Columns x and y of n numbers, and offsets.
template <class T>
struct Columns {
  std::int32_t kind;
  std::int64_t n, rings;
  const T *x, *y;
  const std::int32_t* offsets;
};

/// Offsets are of the columns, or below 0; or, if `wild`, any now and then.
template <class T>
Columns<T> columns(Bytes& bytes, GuardedMemory& memory, GuardedMemory& offset_memory, bool wild) {
  Columns<T> c{};
  c.kind = bytes.below(3) == 0 ? VESICA_POLYLINE : VESICA_POLYGON;
  c.n = 1 + bytes.below(12);
  c.rings = 1 + bytes.below(4);
  const auto n = static_cast<std::size_t>(c.n);
  auto* const numbers = reinterpret_cast<T*>(memory.place(2 * n * sizeof(T), Edge::after));
  for (std::size_t i = 0; i < 2 * n; ++i) numbers[i] = bytes.number<T>();
  auto* const offsets = reinterpret_cast<std::int32_t*>(
      offset_memory.place((static_cast<std::size_t>(c.rings) + 1) * sizeof(std::int32_t), Edge::after));
  for (std::int64_t j = 0; j <= c.rings; ++j) {
    offsets[j] = bytes.below(16) == 15 ? -1 : static_cast<std::int32_t>(bytes.below(static_cast<unsigned>(c.n) + 1));
    if (wild && bytes.below(16) == 15) offsets[j] = bytes.take<std::int32_t>();
  }
  if (bytes.below(4) != 0) std::sort(offsets, offsets + c.rings + 1);
  c.x = numbers;
  c.y = numbers + n;
  c.offsets = offsets;
  return c;
}

template <class T>
void call_pair(Bytes& bytes, Memory& memory) {
  static GuardedMemory offset_memory, other_offsets;
  const auto a = columns<T>(bytes, memory.a, offset_memory, false),
             b = columns<T>(bytes, memory.b, other_offsets, false);
  const Polygon<T> p{a.x, a.y, sizeof(T), a.offsets, a.rings}, q{b.x, b.y, sizeof(T), b.offsets, b.rings};
  const Output<typename Face<T>::Points> points(memory.out);
  using F = Face<T>;
  const std::int32_t met = F::overlap(a.kind, &p, b.kind, &q), relation = F::relation(a.kind, &p, b.kind, &q);
  demand(met == VESICA_E_SHAPE || met == 0 || met == 1);
  demand((met == VESICA_E_SHAPE) == (relation == VESICA_E_SHAPE) && relation <= VESICA_EQUAL);
  demand(met == F::overlap(b.kind, &q, a.kind, &p));
  const std::int32_t code = F::nearest(a.kind, &p, b.kind, &q, points.get());
  demand(code == 0 ? (points.get()->distance == 0) == (met == 1) : points.untouched());
  T area = -7;
  if (F::area(a.kind, &p, b.kind, &q, &area) == 0) demand(area >= 0);
  typename F::Penetration depth;
  demand(F::depth(a.kind, &p, b.kind, &q, &depth) <= 0);
  typename F::Impact impact;
  const std::int32_t hit = F::cast(a.kind, &p, b.kind, &q, T{1}, bytes.number<T>(), T{4}, &impact);
  demand(hit < 0 || (hit == VESICA_CAST_START) == (met == 1));
  demand((F::check(a.kind, &p) == 0) <= (F::overlap(a.kind, &p, a.kind, &p) == 1));
}

template <class T>
void call_arrays(Bytes& bytes, Memory& memory) {
  static GuardedMemory offset_memory, other_offsets;
  const auto a = columns<T>(bytes, memory.a, offset_memory, true), b = columns<T>(bytes, memory.b, other_offsets, true);
  const auto array = [](const Columns<T>& c) {
    typename Face<T>::Shapes shapes{};
    shapes.kind = c.kind;
    shapes.count = c.rings;
    shapes.stride = sizeof(T);
    shapes.field[0] = c.x;
    shapes.field[1] = c.y;
    shapes.rings = c.offsets;
    shapes.each = c.n;
    return shapes;
  };
  const auto first = array(a), second = array(b);
  auto* const out = room<std::uint8_t>(memory.out, a.rings * b.rings);
  const std::int64_t met = Face<T>::overlap_matrix(&first, &second, out, b.rings);
  demand(met == VESICA_E_SHAPE || (met >= 0 && met <= a.rings * b.rings));
  const std::int64_t related = Face<T>::relation_matrix(&first, &second, out, b.rings);
  demand((met == VESICA_E_SHAPE) == (related == VESICA_E_SHAPE));
  Face<T>::area_matrix(&first, &second, room<T>(memory.out, a.rings * b.rings), b.rings);
  Face<T>::nearest_matrix(&first, &second, room<T>(memory.out, a.rings * b.rings), b.rings);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  bytes.below(2) == 0 ? call_pair<T>(bytes, memory) : call_arrays<T>(bytes, memory);
}

}  // namespace
}  // namespace polygons

void call_polygons(Bytes& bytes, Memory& memory) {
  bytes.below(2) == 0 ? polygons::call<double>(bytes, memory) : polygons::call<float>(bytes, memory);
}

}  // namespace fuzz
