// SPDX-License-Identifier: Apache-2.0
// Depths of overlapping shapes against 90 digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "boundary_distance/reference.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "vesica.h"

namespace {

using properties::Pair;
using properties::Workload;

/// The header's error bounds, in roundoffs of the scale; for the direction's length, in roundoffs.
constexpr double promised = 4, promised_length = 3;

struct Worst {
  double depth = 0, length = 0;
  int pairs = 0;
};

void measure(const Pair& pair, Worst& worst) {
  const auto a = outline_reference::shape(pair.kind_a, pair.a), b = outline_reference::shape(pair.kind_b, pair.b);
  const double scale = outline_reference::scale(a, b);
  // Beyond: what is promised up to 1e6 only, and where roundoffs of the scale are subnormal or the scale itself is
  // infinite.
  if (!(outline_reference::aspect(a) <= 1e6 && outline_reference::aspect(b) <= 1e6 && scale > 0x1p-960 &&
        scale <= 0x1p1023)) {
    return;
  }
  vesica_penetration_f64 found;
  const int32_t error = vesica_depth_f64(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data(), &found);
  if (error == VESICA_E_RANGE) return;
  ASSERT_EQ(error, 0);
  if (found.x == 0 && found.y == 0) return;
  const auto least = outline_reference::least(a, b, 1);
  const double off = std::abs(outline_reference::error_in_roundoffs(found.depth, least.value, scale));
  EXPECT_LE(off, promised) << properties::describe(pair) << " " << found.depth << " " << least.value.get_d();
  const double length = std::abs(std::hypot(found.x, found.y) - 1) * 0x1p53;
  EXPECT_LE(length, promised_length) << properties::describe(pair);
  worst = {std::max(worst.depth, off), std::max(worst.length, length), worst.pairs + 1};
}

class Accuracy : public testing::TestWithParam<Workload> {};

TEST_P(Accuracy, EveryPairOfKinds) {
  Worst worst;
  const int pairs = (GetParam() == Workload::near_contact ? 4 : 40) * properties::repeat();
  for (int ka = VESICA_POINT; ka <= VESICA_ELLIPSE; ++ka) {
    for (int kb = ka; kb <= VESICA_ELLIPSE; ++kb) {
      properties::Stream stream(GetParam(), ka, kb, properties::Scalar::f64, properties::seed());
      const bool round = kb == VESICA_ELLIPSE;
      for (int i = 0; i < pairs * (round ? 2 : 1) && !HasFailure(); ++i) measure(stream.next(), worst);
    }
  }
  std::printf("%s: %d depths, off by %.2f, directions by %.2f\n", name(GetParam()), worst.pairs, worst.depth,
              worst.length);
  EXPECT_GT(worst.pairs, 0);
}

INSTANTIATE_TEST_SUITE_P(Depth, Accuracy, testing::ValuesIn(properties::all_workloads),
                         [](const auto& test) { return std::string(properties::name(test.param)); });

}  // namespace
