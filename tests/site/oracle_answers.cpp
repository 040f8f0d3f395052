// SPDX-License-Identifier: Apache-2.0
/// Overlap by the oracle: lines of two shapes on standard input, each as its kind and seven hexadecimal numbers, those
/// beyond its own 0. One digit a line comes out.
#include <cstdio>

#include "oracle/oracle.hpp"

namespace {

bool read_shape(int& kind, double* numbers) {
  if (std::scanf("%d", &kind) != 1) return false;
  for (int i = 0; i < 7; ++i) {
    if (std::scanf("%la", &numbers[i]) != 1) return false;
  }
  return true;
}

}  // namespace

int main() {
  int kind_a, kind_b;
  double a[7], b[7];
  while (read_shape(kind_a, a)) {
    if (!read_shape(kind_b, b)) return 1;
    std::printf("%d\n", oracle::overlap(kind_a, a, kind_b, b) ? 1 : 0);
  }
  return std::feof(stdin) ? 0 : 1;
}
