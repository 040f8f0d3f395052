// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/overlap.hpp>

#include "polygon/answers.hpp"
#include "polygon/operand.hpp"

namespace vesica::polygon {

std::int32_t overlap(const Operand& a, const Operand& b, void*) noexcept {
  return with_edges(
      a, b, [](const auto& edges, const auto& other, bool) { return detail::polygon::overlap_or_error(edges, other); });
}

namespace {

template <class T>
std::int32_t convex_overlap_of(const Operand& a, const Operand& b) noexcept {
  return detail::polygon::convex_overlap(*static_cast<const Polygon<T>*>(a.shape),
                                         *static_cast<const Polygon<T>*>(b.shape));
}

}  // namespace

std::int32_t convex_overlap(const Operand& a, const Operand& b) noexcept {
  if (a.kind != polygon_kind || b.kind != polygon_kind) return filter::undecided;
  return a.is_float ? convex_overlap_of<float>(a, b) : convex_overlap_of<double>(a, b);
}

}  // namespace vesica::polygon
