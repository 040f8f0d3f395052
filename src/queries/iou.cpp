// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <vesica/iou.hpp>
#include <vesica/shape_area.hpp>

#include "compiled_once.hpp"
#include "polygon/areas.hpp"
#include "query.hpp"

namespace vesica::queries {

namespace {

struct IouOfPair {
  static constexpr Reversal reversal = Reversal::none;
  template <class T>
  using Result = T;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return iou_or_error(a, b, out);
  }
};

double area_of_shape(std::int32_t kind, const double* numbers) noexcept {
  double area = std::numeric_limits<double>::quiet_NaN();
  with_shape<double>(kind, numbers, [&](const HasCore auto& shape) { return shape_area_or_error(shape, area); });
  return area;
}

}  // namespace

constinit const Query iou{
    .doubles = pair_table<IouOfPair, double>(),
    .floats = pair_table<IouOfPair, float>(),
    .reversal = IouOfPair::reversal,
    .paths = polygon::ratio<Ratio::over_union>,
    .of_shares = polygon::ratio_of_shares<Ratio::over_union>,
    .is_none_of_none = true,
    .numbers = 1,
    .kernels = &QueryTable::iou,
    .known = Known::radius,
    .shape_area = area_of_shape,
};

}  // namespace vesica::queries
