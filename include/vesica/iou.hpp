// SPDX-License-Identifier: Apache-2.0
/// iou(a, b): intersection over union, the shared area over the area of the union.
///
/// Laws, each tested, without a tolerance: iou(a, b) == iou(b, a); 0 for shapes that share no area; 1 for equal shapes;
/// 0 <= iou <= 1; unchanged when both shapes are scaled by 2^k without leaving the format. Accuracy: area()'s,
/// over the area of the union.
#pragma once

#include <vesica/area.hpp>

namespace vesica {

namespace detail {

/// For valid shapes with the shared area known, at least one of them with an area.
inline double iou_of(const detail::area::Measure& shared, const detail::area::Measure& a,
                     const detail::area::Measure& b) noexcept {
  return shared.value == 0 ? 0 : ratio_of_union(shared, a, b);
}

template <class A, class B>
std::int32_t iou_of_pair(const A& a, const B& b, double& out) noexcept {
  if constexpr (detail::area::has_area<A> && detail::area::has_area<B>) {
    if (filter::Verdict<bool>(detail::overlap::filter(a, b)).disjoint) {
      if (detail::area::is_flat(a) && detail::area::is_flat(b)) return error_argument;
      out = 0;
      return 0;
    }
    const auto quick = detail::area::quick_area(a, b);
    if (quick.settled) [[likely]] {
      out = iou_of({quick.area, 0}, detail::area::shape_measure(a), detail::area::shape_measure(b));
      return 0;
    }
  }
  detail::area::Shares shares;
  const std::int32_t error = detail::area::shares_by_relation(a, b, shares);
  if (error != 0) return error;
  if (shares.a.value == 0 && shares.b.value == 0) return error_argument;
  out = shares.equal ? 1 : iou_of(shares.shared, shares.a, shares.b);
  return 0;
}

}  // namespace detail

/// The checked form: writes the intersection over union. Returns 0, error_shape, or error_argument when neither shape
/// has an area (with one that has, it is 0); on error `out` is untouched. Nothing overflows, whatever the sizes. A
/// float is the double rounded.
template <template <class> class A, template <class> class B, class T>
std::int32_t iou_or_error(const A<T>& a, const B<T>& b, T& out) noexcept {
  if constexpr (!detail::in_order<A<T>, B<T>>) {
    return iou_or_error(b, a, out);
  } else {
    double ratio;
    const std::int32_t error = detail::iou_of_pair(widen(a), widen(b), ratio);
    if (error == 0) out = static_cast<T>(ratio);
    return error;
  }
}

/// Intersection over union. For valid shapes: it is 0 where iou_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
T iou(const A<T>& a, const B<T>& b) noexcept {
  T out = 0;
  iou_or_error(a, b, out);
  return out;
}

}  // namespace vesica
