// SPDX-License-Identifier: Apache-2.0
// The numbers of an array need no alignment, in any function that takes arrays. What is wrong where the answers are
// right by luck is for the undefined behaviour sanitizer to see; Clang 19's looks at the arguments of memcpy too.
#include <gtest/gtest.h>

#include <string_view>

#include "environment/calls.hpp"
#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "properties/shape_maker.hpp"

namespace {

using environment::Bytes;
using environment::Inputs;
using environment::Place;
using properties::Workload;

class AlignmentTest : public testing::TestWithParam<properties::Kinds> {};

void expect_same_anywhere(const environment::BatchCall& call, Inputs& inputs) {
  inputs.place = Place::records;
  const Bytes expected = call.ask(inputs);
  for (const Place place : {Place::odd_records, Place::odd_columns}) {
    inputs.place = place;
    EXPECT_EQ(expected, call.ask(inputs)) << call.name << (place == Place::odd_records ? " records" : " columns");
  }
}

TEST_P(AlignmentTest, OfArraysIsFree) {
  properties::Stream stream(Workload::near_contact, GetParam().a, GetParam().b, GetParam().scalar, 5, oracle::overlap);
  Inputs inputs;
  for (int i = 0; i < 70; ++i) inputs.pairs.emplace_back(stream.next());
  for (const auto& call : environment::batch_calls(GetParam().scalar)) expect_same_anywhere(call, inputs);
}

/// Along a line: their matrix has tiles that are not computed, and stretches of columns that begin behind such tiles.
TEST_P(AlignmentTest, OfArraysInOrderIsFree) {
  properties::Stream stream(Workload::random, GetParam().a, GetParam().b, GetParam().scalar, 6);
  Inputs inputs;
  for (int i = 0; i < 192; ++i) {
    properties::Pair pair = stream.next();
    pair.a = properties::moved(pair.kind_a, pair.a, {16.0 * i, 0});
    pair.b = properties::moved(pair.kind_b, pair.b, {16.0 * i, 0});
    inputs.pairs.emplace_back(pair);
  }
  for (const auto& call : environment::batch_calls(GetParam().scalar)) {
    if (std::string_view(call.name) == "overlap_matrix") expect_same_anywhere(call, inputs);
  }
}

INSTANTIATE_TEST_SUITE_P(All, AlignmentTest, testing::ValuesIn(properties::all_pairs_of_kinds()),
                         properties::test_name);

}  // namespace
