// SPDX-License-Identifier: Apache-2.0
// A C++ program that uses the header-only core and links nothing. Exit status 0 when the answers are right.
#include <vesica/vesica.hpp>

int main() {
  const vesica::Rect<double> rect{0, 0, 1, 0, 2, 1};
  const vesica::Ellipse<double> touching{3, 1, 1, 0, 1, 0.5}, apart{3.125, 1, 1, 0, 1, 0.5};
  if (!vesica::overlap(rect, touching)) return 2;
  if (vesica::overlap(rect, apart)) return 3;
  return 0;
}
