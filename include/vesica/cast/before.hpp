// SPDX-License-Identifier: Apache-2.0
/// Casts in which only contact before a time counts, for the first of many.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vesica/shapes.hpp>

namespace vesica::detail::cast {

/// ask(end) for an end at the limit. The place then may have more digits than exact numbers hold, where at a rounder
/// time it does not: so if that is out of range, later ends are asked, up to the end of the whole motion. Contact may
/// then be found that is later than the limit.
template <class Ask>
std::int32_t cast_before(double limit, double whole, const Ask& ask) noexcept {
  std::int32_t code = ask(limit);
  for (const double later : {0x1p-500, 0x1p-100, 1.0, 0x1p100, 0x1p500, whole}) {
    if (code != error_range) break;
    if (limit < later && later <= whole) code = ask(later);
  }
  return code;
}

}  // namespace vesica::detail::cast
