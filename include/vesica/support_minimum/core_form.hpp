// SPDX-License-Identifier: Apache-2.0
/// The core of a shape as a box or an ellipse, with the shape's radius (form/inflated.hpp).
#pragma once

#include <vesica/form/inflated.hpp>
#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::support_minimum {

struct CoreForm {
  Form form;
  double radius;
  bool is_segment;
};

template <template <class> class Shape>
CoreForm core_form(const Shape<double>& s) noexcept {
  const auto [core, radius] = form::inflated(s);
  return {support_minimum::form(core), radius, std::is_same_v<decltype(core), const Segment<double>>};
}

}  // namespace vesica::detail::support_minimum
