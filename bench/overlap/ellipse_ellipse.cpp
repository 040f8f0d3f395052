// SPDX-License-Identifier: Apache-2.0
#include "textbook/ellipse_ellipse.hpp"

#include "pair.hpp"

namespace vesica::bench {
namespace {

const bool added =
    add_rates<vesica_overlap_ellipse_ellipse_f64, textbook::ellipse_ellipse<vesica_ellipse_f64>,
              vesica_overlap_ellipse_ellipse_f32, textbook::ellipse_ellipse<vesica_ellipse_f32>>(ratio_at_most(1.4)) &&
    add_rows<vesica_overlap_ellipse_ellipse_f64>({{Workload::tangent, nanoseconds_at_most(4400)},
                                                  {Workload::last_ulp, nanoseconds_at_most(4400)},
                                                  {Workload::exponents, nanoseconds_at_most(190'000)}});

}  // namespace
}  // namespace vesica::bench
