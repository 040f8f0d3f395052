// SPDX-License-Identifier: Apache-2.0
#include "polygon/manifold.hpp"

#include <vesica/polygon/manifold.hpp>

#include "polygon/operand.hpp"

namespace vesica::polygon {

namespace {

/// Rows of numbers: their depth is the one of the query.
std::int32_t manifold_of_rows(const AnyShape& a, const AnyShape& b, Contacts<double>& out) noexcept {
  Penetration<double> p{0, 0, 0};
  const std::int32_t error = queries::depth.doubles.of[a.kind][b.kind](a.number, b.number, &p);
  if (error != 0) return error;
  using detail::polygon::core_form;
  return detail::manifold::checked(detail::manifold::of_cores(core_form(a), core_form(b), p), out);
}

template <class T>
std::int32_t manifold_in_double(const Operand& a, const Operand& b, Contacts<double>& out) noexcept {
  if (is_row(a.kind) && is_row(b.kind)) return manifold_of_rows(any_shape<T>(a), any_shape<T>(b), out);
  return with_edges_of<T>(a, b, [&out](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::manifold_or_error(edges, other, reversed, out);
  });
}

}  // namespace

template <>
std::int32_t manifold(const Operand& a, const Operand& b, Contacts<double>& out) noexcept {
  return manifold_in_double<double>(a, b, out);
}
template <>
std::int32_t manifold(const Operand& a, const Operand& b, Contacts<float>& out) noexcept {
  Contacts<double> wide = detail::manifold::no_contact;
  const std::int32_t code = manifold_in_double<float>(a, b, wide);
  if (code < 0) return code;
  return detail::manifold::rounded_to(wide, out) ? code : static_cast<std::int32_t>(error_range);
}

}  // namespace vesica::polygon
