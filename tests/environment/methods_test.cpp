// SPDX-License-Identifier: Apache-2.0
// The named methods, too, give the same bits in every floating-point environment, and leave it as it was.
#include <gtest/gtest.h>

#include "environment/environments.hpp"
#include "environment/method_calls.hpp"
#include "oracle/oracle.hpp"
#include "properties/generators.hpp"

namespace {

using environment::Bytes;
using environment::Input;
using environment::MethodCall;

TEST(Methods, GiveTheSameBitsInEveryEnvironment) {
  using properties::Workload;
  for (const MethodCall& method : environment::method_calls()) {
    for (const Workload workload : {Workload::near_contact, Workload::tiny, Workload::huge, Workload::thin}) {
      properties::Stream stream(workload, method.kind_a, method.kind_b, method.scalar, 5, oracle::overlap);
      for (int i = 0; i < 40; ++i) {
        const properties::Pair pair = stream.next();
        const Input input(pair);
        const Bytes expected = method.ask(input);
        for (const environment::Environment& e : environment::all_environments) {
          Bytes found;
          found.reserve(expected.size());
          EXPECT_TRUE(environment::ask_in(e, [&] { found = method.ask(input); })) << method.name << " in " << e.name;
          ASSERT_EQ(expected, found) << method.name << " in " << e.name << ": " << describe(pair);
        }
      }
    }
  }
}

}  // namespace
