// SPDX-License-Identifier: Apache-2.0
// Capsules and rounded rectangles, which have no typed functions: calls by kind.
#include "textbook/inflated.hpp"

#include "pair.hpp"

namespace vesica::bench {
namespace {

const bool added =
    add_rates<overlap_by_kind<vesica_circle_f64, vesica_capsule_f64>,
              textbook::circle_capsule<vesica_circle_f64, vesica_capsule_f64>,
              overlap_by_kind<vesica_circle_f32, vesica_capsule_f32>,
              textbook::circle_capsule<vesica_circle_f32, vesica_capsule_f32>>({}) &&
    add_rates<overlap_by_kind<vesica_capsule_f64, vesica_capsule_f64>, textbook::capsule_capsule<vesica_capsule_f64>,
              overlap_by_kind<vesica_capsule_f32, vesica_capsule_f32>, textbook::capsule_capsule<vesica_capsule_f32>>(
        {}) &&
    add_rows<overlap_by_kind<vesica_point_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_segment_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_aabb_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_rect_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_ellipse_f64, vesica_capsule_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_point_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_segment_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_circle_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_aabb_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_rect_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_ellipse_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_capsule_f64, vesica_round_rect_f64>>({{Workload::mixed}}) &&
    add_rows<overlap_by_kind<vesica_round_rect_f64, vesica_round_rect_f64>>({{Workload::mixed}});

}  // namespace
}  // namespace vesica::bench
