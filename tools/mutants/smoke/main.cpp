// SPDX-License-Identifier: Apache-2.0
#include "small.hpp"

int main() {
  const bool right = small::verdict(1) == small::Verdict::apart && small::verdict(0) == small::Verdict::touching &&
                     small::verdict(-1) == small::Verdict::crossing && small::after(2) == 1 && small::after(7) == 5;
  return right ? 0 : 1;
}
