// SPDX-License-Identifier: Apache-2.0
#include "pair.hpp"

namespace {
const bool added = vesica::bench::add_plain_rows<vesica_overlap_point_segment_f64, vesica_overlap_point_segment_f32>();
}
