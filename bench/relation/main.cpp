// SPDX-License-Identifier: Apache-2.0
#include "relation/report.hpp"

int main() {
  vesica::bench::report_relation(stdout);
  vesica::bench::report_area(stdout);
}
