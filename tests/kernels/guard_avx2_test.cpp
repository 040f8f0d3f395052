// SPDX-License-Identifier: Apache-2.0
#include "lanes/avx2.hpp"
// The lanes come first.
#include "kernels/guard_cases.hpp"

namespace {

TEST(GuardOfAvx2, HoldsWithinItsRangesOnly) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor lacks AVX2";
  guard_cases::expect_all<vesica::Floats>();
  guard_cases::expect_all<vesica::Doubles>();
}

}  // namespace
