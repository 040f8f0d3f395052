// SPDX-License-Identifier: Apache-2.0
#include "methods/method.hpp"

namespace vesica::bench::methods {

void add_segment_circle(std::vector<Method>& methods) {
  add<vesica_method_segment_circle_division_free_f64, vesica_overlap_segment_circle_f64>(
      methods, "segment_circle_division_free");
}

}  // namespace vesica::bench::methods
