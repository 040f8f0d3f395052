// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/ratio.hpp>

#include "polygon/areas.hpp"
#include "polygon/operand.hpp"

namespace vesica::polygon {

using detail::polygon::PathShares;

namespace {

template <class T>
bool find_own_area(const Edges<T>& edges, detail::polygon::Box& box, double& area) noexcept {
  if (edges.check(box) != 0) return false;
  detail::polygon::Senses<T> senses(edges);
  const detail::area::Measure own = detail::polygon::measure(edges, box, senses);
  area = own.value;
  return area > 0 && detail::polygon::Scale(box).exponent == 0;
}

}  // namespace

bool own_area(const Operand& polygon, detail::polygon::Box& box, double& area) noexcept {
  return polygon.is_float ? find_own_area(edges<float>(polygon), box, area)
                          : find_own_area(edges<double>(polygon), box, area);
}

std::int32_t area_of_shares(const PathShares& shares, bool is_float, void* out) noexcept {
  return is_float ? detail::area::store(shares.shared, *static_cast<float*>(out))
                  : detail::area::store(shares.shared, *static_cast<double*>(out));
}

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept {
  PathShares found;
  const std::int32_t error = with_edges(a, b, [&](const auto& edges, const auto& other, bool) -> std::int32_t {
    return detail::polygon::shares(edges, other, found);
  });
  return error != 0 ? error : area_of_shares(found, a.is_float, out);
}

std::int32_t ratio_of_shares(Ratio which, const PathShares& s, double& out) noexcept {
  using detail::polygon::facts;
  return detail::polygon::ratio_of_shares(
      which, s, [&] { return facts(s.box_a, s.a); }, [&] { return facts(s.box_b, s.b); }, out);
}

std::int32_t ratio_of_paths(Ratio which, const Operand& a, const Operand& b, double& out) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::ratio_or_error(which, edges, other, reversed, out);
  });
}

}  // namespace vesica::polygon
