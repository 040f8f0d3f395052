// SPDX-License-Identifier: Apache-2.0
#include "textbook/rect_rect.hpp"

#include "pair.hpp"

namespace vesica::bench {
namespace {

const bool added = add_rates<vesica_overlap_rect_rect_f64, textbook::rect_rect<vesica_rect_f64>,
                             vesica_overlap_rect_rect_f32, textbook::rect_rect<vesica_rect_f32>>(ratio_at_most(1.25)) &&
                   add_rows<vesica_overlap_rect_rect_f64>({{Workload::pixels, nanoseconds_at_most(40)},
                                                           {Workload::hundredths, nanoseconds_at_most(40)},
                                                           {Workload::few_digits, nanoseconds_at_most(40)},
                                                           {Workload::tangent, nanoseconds_at_most(40)},
                                                           {Workload::last_ulp, nanoseconds_at_most(40)},
                                                           {Workload::exponents, nanoseconds_at_most(190'000)}});

}  // namespace
}  // namespace vesica::bench
