// SPDX-License-Identifier: Apache-2.0
/// Trials of times: whether there is contact before one, and a value that is 0 at the time of contact.
#pragma once

#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::cast {

/// What a trial tells: whether there is contact of insides before the time, and where known a value that is positive
/// before contact, 0 at it, and negative after: the discriminant of the cubic, or its negative.
struct Trial {
  bool known = false, after = false, has_value = false;
  arithmetic::Scaled value{0, 0};
};

/// A time, and what a trial there told.
struct TriedTime {
  double time;
  Trial trial;
};

/// y / x for values x, y.
inline double ratio(const arithmetic::Scaled& y, const arithmetic::Scaled& x) noexcept {
  return arithmetic::scale(y.value / x.value, y.exponent - x.exponent);
}

}  // namespace vesica::detail::cast
