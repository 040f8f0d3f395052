// SPDX-License-Identifier: Apache-2.0
// Linked into the tests compiled with fused operations, but not compiled with them itself: skips them, visibly, on a
// machine that has none.
#include <gtest/gtest.h>

namespace {

class FusedOperations : public testing::Environment {
 public:
  void SetUp() override {
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no fused multiply-add";
  }
};

[[maybe_unused]] const auto* const registered = testing::AddGlobalTestEnvironment(new FusedOperations);

}  // namespace
