// SPDX-License-Identifier: Apache-2.0
// Capsules and rounded rectangles, which have no typed functions: calls by kind.
#include "textbook/inflated.hpp"

#include "pair.hpp"

namespace vesica::bench {
namespace {

template <class A, class B>
std::int32_t overlap(const A* a, const B* b) {
  if constexpr (std::is_same_v<typename Described<A>::Scalar, double>) {
    return vesica_overlap_f64(kind_of<A>, a, kind_of<B>, b);
  } else {
    return vesica_overlap_f32(kind_of<A>, a, kind_of<B>, b);
  }
}

const bool added =
    add_rates<overlap<vesica_circle_f64, vesica_capsule_f64>,
              textbook::circle_capsule<vesica_circle_f64, vesica_capsule_f64>,
              overlap<vesica_circle_f32, vesica_capsule_f32>,
              textbook::circle_capsule<vesica_circle_f32, vesica_capsule_f32>>({}) &&
    add_rates<overlap<vesica_capsule_f64, vesica_capsule_f64>, textbook::capsule_capsule<vesica_capsule_f64>,
              overlap<vesica_capsule_f32, vesica_capsule_f32>, textbook::capsule_capsule<vesica_capsule_f32>>({}) &&
    add_rows<overlap<vesica_ellipse_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap<vesica_rect_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap<vesica_ellipse_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap<vesica_round_rect_f64, vesica_round_rect_f64>>({{Workload::mixed}});

}  // namespace
}  // namespace vesica::bench
