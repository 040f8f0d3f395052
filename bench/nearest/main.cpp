// SPDX-License-Identifier: Apache-2.0
#include "nearest/outline_report.hpp"

int main() {
  vesica::bench::report_nearest(stdout);
  vesica::bench::report_boundary_distance(stdout);
  vesica::bench::report_depth(stdout);
}
