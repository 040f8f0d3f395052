// SPDX-License-Identifier: Apache-2.0
#include "small.hpp"

int main() {
  const bool right = small::verdict(1) == small::Verdict::apart && small::verdict(0) == small::Verdict::touching &&
                     small::verdict(-1) == small::Verdict::crossing;
  return right ? 0 : 1;
}
