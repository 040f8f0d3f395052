// SPDX-License-Identifier: Apache-2.0
/// Capsules and rounded rectangles against everything but ellipses: distances of cores compared with radii.
#pragma once

#include <vesica/exact/inflated.hpp>
#include <vesica/filter/inflated.hpp>

namespace vesica::detail::relation {

template <class A, form::Inflated B>
VESICA_INLINE constexpr auto certain_facts(const A& a, const B& b) noexcept {
  return filter::inflated_certain_facts(form::inflated(a), form::inflated(b));
}

}  // namespace vesica::detail::relation
