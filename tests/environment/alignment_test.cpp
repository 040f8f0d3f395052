// SPDX-License-Identifier: Apache-2.0
// The numbers of an array need no alignment, in any function that takes arrays. What is wrong where the answers are
// right by luck is for the undefined behaviour sanitizer to see; that of Clang 19 looks at the arguments of memcpy too.
#include <gtest/gtest.h>

#include "environment/calls.hpp"
#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using environment::Bytes;
using environment::Inputs;
using environment::Place;
using properties::Workload;

class AlignmentTest : public testing::TestWithParam<properties::Kinds> {};

TEST_P(AlignmentTest, OfArraysIsFree) {
  properties::Stream stream(Workload::near_contact, GetParam().a, GetParam().b, GetParam().scalar, 5, oracle::overlap);
  Inputs inputs;
  for (int i = 0; i < 70; ++i) inputs.pairs.emplace_back(stream.next());
  for (const auto& call : environment::batch_calls(GetParam().scalar)) {
    inputs.place = Place::records;
    const Bytes expected = call.ask(inputs);
    for (const Place place : {Place::odd_records, Place::odd_columns}) {
      inputs.place = place;
      EXPECT_EQ(expected, call.ask(inputs)) << call.name << (place == Place::odd_records ? " records" : " columns");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, AlignmentTest, testing::ValuesIn(properties::all_pairs_of_kinds()),
                         properties::test_name);

}  // namespace
