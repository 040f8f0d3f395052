// SPDX-License-Identifier: Apache-2.0
/// Capsules and rounded rectangles: distances of cores compared with radii; with an ellipse its distance from corners.
#pragma once

#include <vesica/exact/inflated_ellipse.hpp>
#include <vesica/filter/inflated_ellipse.hpp>

namespace vesica::detail::relation {

template <class A, form::Inflated B>
VESICA_INLINE constexpr auto certain_facts(const A& a, const B& b) noexcept {
  return filter::inflated_certain_facts(form::inflated(a), form::inflated(b));
}

template <form::Inflated B>
VESICA_INLINE constexpr auto certain_facts(const Ellipse<double>& a, const B& b) noexcept {
  const auto [core, radius] = form::inflated(b);
  return filter::ellipse_inflated_certain_facts(a, filter::box(core), radius,
                                                filter::offset(filter::place(core), filter::place(a)));
}

}  // namespace vesica::detail::relation
