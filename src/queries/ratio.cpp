// SPDX-License-Identifier: Apache-2.0
#include "ratio.hpp"

#include <cmath>
#include <iterator>
#include <limits>
#include <vesica/check.hpp>

namespace vesica::queries {

namespace {

using detail::ratio::Facts;

/// Returns 0 or error_shape.
std::int32_t facts_by_kind(std::int32_t kind, const double* numbers, Facts& out) noexcept {
  return with_shape(kind, numbers, [&](const HasForm auto& shape) -> std::int32_t {
    if (check(shape) != 0) return error_shape;
    out = detail::ratio::facts(shape);
    return 0;
  });
}

/// asked: the shared area or IoU; NaN where that is an error.
template <Ratio which>
std::int32_t derive(double asked, std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b,
                    double& out) noexcept {
  Facts first, second;
  const std::int32_t error = facts_by_kind(kind_a, a, first) | facts_by_kind(kind_b, b, second);
  if (error != 0) return error_shape;
  if constexpr (detail::ratio::is_of_area(which)) {
    const auto union_ratio = [&] {
      double r = 0;
      iou.doubles.of[kind_a][kind_b](a, b, &r);
      return r;
    };
    return detail::ratio::over_area(asked, which, first, second, union_ratio, out);
  } else {
    if (std::isnan(asked)) return error_argument;
    out = detail::ratio::less_than_union(asked, which, first, second);
    return 0;
  }
}

template <Ratio which>
constexpr Query derived(const Query& from) noexcept {
  return {.doubles = {},
          .floats = {},
          .reversal = Reversal::none,
          .numbers = 1,
          .asked_instead = &from,
          .derive = derive<which>};
}

constinit const Query ratios[] = {
    derived<Ratio::over_first>(area), derived<Ratio::over_second>(area), derived<Ratio::over_smaller>(area),
    derived<Ratio::generalized>(iou), derived<Ratio::distance>(iou),     derived<Ratio::complete>(iou),
};
static_assert(std::size(ratios) == ratio_count - 1);

}  // namespace

const Query& ratio(Ratio which) noexcept {
  return which == Ratio::over_union ? iou : ratios[static_cast<int>(which) - 1];
}

std::int32_t ratio_of_pair(Ratio which, std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b,
                           double& out) noexcept {
  const Query& query = ratio(which);
  if (query.derive == nullptr) return query.doubles.of[kind_a][kind_b](a, b, &out);
  double asked = 0;
  const std::int32_t error = query.asked_instead->doubles.of[kind_a][kind_b](a, b, &asked);
  if (error == error_shape || error == error_kind) return error;
  if (error != 0) asked = std::numeric_limits<double>::quiet_NaN();
  return query.derive(asked, kind_a, a, kind_b, b, out);
}

}  // namespace vesica::queries
