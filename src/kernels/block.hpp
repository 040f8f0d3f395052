// SPDX-License-Identifier: Apache-2.0
// The kernels of overlap for every pair. Included once by each source in src/isa, after the lanes of its instruction
// set.
#pragma once

#include "kernels/block_loop.hpp"
#include "kernels/checked.hpp"
#include "kernels/records.hpp"
#include "kernels/rings.hpp"

namespace vesica {
namespace {

template <class Filter, template <class> class A, template <class> class B, class T>
consteval void fill(BlockKernel<T> (&kernel)[repeat_count]) noexcept {
  kernel[static_cast<int>(Repeat::none)] = answer_vectors<Filter, A, B, T, Repeat::none>;
  kernel[static_cast<int>(Repeat::first)] = answer_vectors<Filter, A, B, T, Repeat::first>;
  if constexpr (!std::is_same_v<A<T>, B<T>>) {
    kernel[static_cast<int>(Repeat::second)] = answer_vectors<Filter, A, B, T, Repeat::second>;
  }
}

template <template <class> class A, template <class> class B, class T>
consteval void fill_pair(ScalarKernels<T>& kernels) noexcept {
  auto& pair = kernels[static_cast<int>(ShapeTraits<A<T>>::kind)][static_cast<int>(ShapeTraits<B<T>>::kind)];
  fill<General, A, B, T>(pair.general);
  fill<General, A, B, T>(pair.unit);
}

/// Replaces the kernel for unit axes, which fill_pair() set to the general one.
template <template <class> class A, template <class> class B, class T>
consteval void fill_unit_pair(ScalarKernels<T>& kernels) noexcept {
  auto& pair = kernels[static_cast<int>(ShapeTraits<A<T>>::kind)][static_cast<int>(ShapeTraits<B<T>>::kind)];
  fill<UnitAxes, A, B, T>(pair.unit);
}

template <class T>
consteval void fill_pairs(ScalarKernels<T>& kernels) noexcept {
#define VESICA_FILL(a, A, b, B) fill_pair<A, B>(kernels);
  VESICA_EACH_PAIR(VESICA_FILL)
#undef VESICA_FILL
  fill_unit_pair<Rect, Rect>(kernels);
  fill_unit_pair<Circle, Ellipse>(kernels);
  fill_unit_pair<Ellipse, Ellipse>(kernels);
}

template <class Filter, template <class> class Shape, Repeat repeat, class T>
consteval void enter_packed(PackedKernels<T>& kernels) noexcept {
  kernels[static_cast<int>(ShapeTraits<Shape<T>>::kind)][static_cast<int>(repeat)] =
      answer_packed<Filter, Shape, T, repeat>;
}

/// For the kinds that most often are records, on long vectors: others would take more space than they gain time. Two
/// ellipses gain little with the 16 registers of AVX2.
///
/// Gains over copying records to columns first, double / float, AVX-512 (Zen 5): two rectangles 1.69 / 1.87, one
/// rectangle against many 1.51 / 1.62, two ellipses 1.63 / 1.60.
template <class T>
consteval void fill_packed(PackedKernels<T>& kernels) noexcept {
  if constexpr (has_long_vectors) {
    enter_packed<General, Aabb, Repeat::none>(kernels);
    enter_packed<General, Aabb, Repeat::first>(kernels);
    enter_packed<UnitAxes, Rect, Repeat::none>(kernels);
    enter_packed<UnitAxes, Rect, Repeat::first>(kernels);
    if constexpr (sizeof(Floats) == 64) enter_packed<UnitAxes, Ellipse, Repeat::none>(kernels);
  }
}

template <class T>
consteval void fill_insides(InsidesKernels<T>& kernels) noexcept {
  fill<Insides, Point, Aabb, T>(kernels.of[static_cast<int>(Kind::point)].general);
  fill<Insides, Point, Aabb, T>(kernels.of[static_cast<int>(Kind::point)].unit);
  fill<Insides, Aabb, Aabb, T>(kernels.of[static_cast<int>(Kind::aabb)].general);
  fill<Insides, Aabb, Aabb, T>(kernels.of[static_cast<int>(Kind::aabb)].unit);
  if constexpr (has_long_vectors) {
    enter_packed<Insides, Aabb, Repeat::none>(kernels.packed);
    enter_packed<Insides, Aabb, Repeat::first>(kernels.packed);
  }
}

template <int n, class T>
consteval void fill_rings(RingKernels<T>& kernels) noexcept {
  kernels[n - least_ring][static_cast<int>(Repeat::none)] = answer_rings<T, n, false>;
  kernels[n - least_ring][static_cast<int>(Repeat::first)] = answer_rings<T, n, true>;
}

/// Floats as doubles, exactly.
VESICA_KERNEL void widen_column(Unaligned<float> from, std::int32_t n, double* to) noexcept {
  std::int32_t i = 0;
  for (; i + Doubles::width <= n; i += Doubles::width) Doubles::load(from + i).store(to + i);
  for (; i < n; ++i) to[i] = from[i];
}

/// The tables of this instruction set, as constants.
consteval KernelTable make_table(const char* name, const QueryTable& queries, const index::Kernels& index) noexcept {
  KernelTable table{};
  table.name = name;
  table.queries = &queries;
  table.index = &index;
  table.width_f32 = Floats::width;
  table.width_f64 = Doubles::width;
  table.widen_column = widen_column;
  table.copy_records_f32 = records_to_columns<float>;
  table.copy_records_f64 = records_to_columns<double>;
  fill_pairs<float>(table.f32);
  fill_pairs<double>(table.f64);
  table.checked_f32 = make_checked_kernels<float>();
  table.checked_f64 = make_checked_kernels<double>();
  fill_packed(table.packed_f32);
  fill_packed(table.packed_f64);
  fill_insides(table.insides_f32);
  fill_insides(table.insides_f64);
#if !defined(__wasm__)  // modules are downloaded: they go without
  fill_rings<3>(table.rings_f32);
  fill_rings<4>(table.rings_f32);
  fill_rings<3>(table.rings_f64);
  fill_rings<4>(table.rings_f64);
#endif
  return table;
}

}  // namespace
}  // namespace vesica
