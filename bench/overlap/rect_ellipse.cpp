// SPDX-License-Identifier: Apache-2.0
#include "textbook/rect_ellipse.hpp"

#include "pair.hpp"

namespace vesica::bench {
namespace {

const bool added =
    add_rates<vesica_overlap_rect_ellipse_f64, textbook::rect_ellipse<vesica_rect_f64, vesica_ellipse_f64>,
              vesica_overlap_rect_ellipse_f32, textbook::rect_ellipse<vesica_rect_f32, vesica_ellipse_f32>>(
        ratio_at_most(0.6)) &&
    add_rows<vesica_overlap_rect_ellipse_f64>({{Workload::tangent, nanoseconds_at_most(1600)},
                                               {Workload::last_ulp, nanoseconds_at_most(1600)},
                                               {Workload::exponents, nanoseconds_at_most(190'000)}});

}  // namespace
}  // namespace vesica::bench
