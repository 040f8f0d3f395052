// SPDX-License-Identifier: Apache-2.0
#include "ratio.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vesica/check.hpp>

#include "compiled_once.hpp"
#include "polygon/areas.hpp"

namespace vesica::queries {

namespace {

using detail::ratio::Facts;

/// The ratio of two valid shapes.
struct SharedMeasure {
  static constexpr Reversal reversal = Reversal::none;
  template <class T>
  using Result = detail::area::Measure;
  template <class A, class B>
  static std::int32_t answer(const A& a, const B& b, detail::area::Measure& out) noexcept {
    out = detail::ratio::shared_measure(a, b);
    return 0;
  }
};
constinit const PairTable shared_measures = pair_table<SharedMeasure, double>();

/// Returns 0 or error_shape. A shape whose area is a number is valid.
std::int32_t facts_by_kind(const ShapeOfKind& s, Facts& out) noexcept {
  return with_shape<double>(s.kind, s.numbers, [&](const HasCore auto& shape) -> std::int32_t {
    if (std::isnan(s.area) && check(shape) != 0) return error_shape;
    out = detail::ratio::facts(shape, s.area);
    return 0;
  });
}

/// asked: the shared area or IoU; NaN where that is an error, and where the area was not asked.
/// The double to divide a shared area by; NaN if that takes more than the areas as doubles.
template <Ratio which>
double plain_divisor(double shared, double a, double b) noexcept {
  using detail::ratio::is_moderate;
  const bool usual = is_moderate(a) && is_moderate(b) && (shared == 0 || shared >= 0x1p-900);
  if (!usual) return std::numeric_limits<double>::quiet_NaN();
  return which == Ratio::over_first ? a : which == Ratio::over_second || b < a ? b : a;
}

template <Ratio which>
std::int32_t derive(double asked, const ShapeOfKind& a, const ShapeOfKind& b, double& out) noexcept {
  if constexpr (detail::ratio::is_of_area(which)) {
    const double whole = plain_divisor<which>(asked, a.area, b.area);
    // Where both areas are numbers, both shapes are valid.
    if (whole >= (asked == 0 ? 1 : 0)) {
      out = std::fmin(1, asked / whole);
      return 0;
    }
  }
  Facts first, second;
  if (facts_by_kind(a, first) != 0 || facts_by_kind(b, second) != 0) return error_shape;
  if constexpr (detail::ratio::is_of_area(which)) {
    detail::area::Measure shared{asked, 0};
    if (!detail::ratio::tells_share(asked, detail::ratio::divisor(which, first, second))) {
      shared_measures.of[a.kind][b.kind](a.numbers, b.numbers, &shared);
    }
    return detail::ratio::over_area(shared, which, first, second, out);
  } else {
    if (std::isnan(asked)) return error_argument;
    out = detail::ratio::less_than_union(asked, which, first, second);
    return 0;
  }
}

double area_as_of_iou(std::int32_t kind, const double* numbers) noexcept { return iou.shape_area(kind, numbers); }

template <Ratio which>
consteval Query derived(const Query& from) noexcept {
  return {.doubles = {},
          .floats = {},
          .reversal = Reversal::none,
          .paths = polygon::ratio<which>,
          .of_shares = polygon::ratio_of_shares<which>,
          .is_none_of_none = detail::ratio::is_of_area(which),
          .numbers = 1,
          .shape_area = area_as_of_iou,
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
  const ShapeOfKind first{kind_a, a, area_as_of_iou(kind_a, a)}, second{kind_b, b, area_as_of_iou(kind_b, b)};
  double asked = std::numeric_limits<double>::quiet_NaN();
  // It stays NaN if there is no IoU. derive() asks for the shared area, once: as a double it might not suffice.
  if (!detail::ratio::is_of_area(which)) {
    const std::int32_t error = query.asked_instead->doubles.of[kind_a][kind_b](a, b, &asked);
    if (error == error_shape) return error;
  }
  return query.derive(asked, first, second, out);
}

}  // namespace vesica::queries
