// SPDX-License-Identifier: Apache-2.0
/// Within a distance or not, against the oracle: over every workload, at distances about the shapes' own, to the last
/// place of it. Two ellipses against the reference in many digits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "nearest/reference.hpp"
#include "oracle/distance.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "within/face.hpp"

namespace {

using namespace within_test;
using nearest_reference::Real;

constexpr double u = 0x1p-53;

bool are_curved(const Pair& p) {
  return p.kind_a == VESICA_ELLIPSE && properties::has_area(p.kind_a, p.a) && p.kind_b == VESICA_ELLIPSE &&
         properties::has_area(p.kind_b, p.b);
}

class Within : public testing::TestWithParam<properties::Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }

  double moved(double x, int places) const {
    const double y = properties::at_ordinal(scalar(), properties::ordinal(scalar(), x) + places);
    return y > 0 ? y : 0;
  }

  /// The distance as computed, the numbers beside it, and a few others.
  std::vector<double> distances(const Pair& p, properties::Random& random) const {
    vesica_closest_points_f64 found;
    if (vesica_nearest_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &found) != 0) found.distance = 1e300;
    const double d = properties::nearest(scalar(), found.distance);
    std::vector<double> list{0, moved(0, 1), properties::nearest(scalar(), random.between(0, 4)), 5, d / 2};
    for (int k = -3; k <= 3; ++k) list.push_back(moved(d, k));
    for (const double relative : {-1e-13, -1e-15, 1e-15, 1e-13}) {
      list.push_back(properties::nearest(scalar(), d * (1 + relative)));
    }
    list.push_back(properties::nearest(scalar(), 2 * d));
    for (double& x : list) x = properties::representable(scalar(), x) ? x : properties::nearest(scalar(), x);
    return list;
  }

  void check(const Pair& p, double distance) {
    char text[40];
    std::snprintf(text, sizeof text, " within %a", distance);
    SCOPED_TRACE(properties::describe(p) + text);
    const std::int32_t answer = within(scalar(), p, distance);
    EXPECT_EQ(answer, within(scalar(), swapped(p), distance));
    ++cases_;
    if (distance == 0) {
      EXPECT_EQ(answer, vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()));
    } else if (are_curved(p)) {
      check_curved(p, distance, answer);
    } else {
      EXPECT_EQ(answer, oracle::within(p.kind_a, p.a.data(), p.kind_b, p.b.data(), distance));
      yes_ += answer == 1;
    }
  }

  void check_curved(const Pair& p, double distance, std::int32_t answer) {
    if (oracle::overlap(p.kind_a, p.a.data(), p.kind_b, p.b.data())) {
      EXPECT_EQ(answer, VESICA_WITHIN_YES);
      return;
    }
    nearest_reference::set_precision(p);
    const auto a = nearest_reference::shape(p.kind_a, p.a), b = nearest_reference::shape(p.kind_b, p.b);
    vesica_closest_points_f64 c{0, 0, 0, 1, 0};
    vesica_nearest_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &c);
    const auto exact = nearest_reference::distance(a, b, c.bx - c.ax, c.by - c.ay);
    yes_ += answer == VESICA_WITHIN_YES;
    nearly_ += answer == VESICA_WITHIN_NEARLY;
    if (answer == VESICA_WITHIN_YES) {
      EXPECT_LE(exact.lower, Real(distance));
    } else if (answer == VESICA_WITHIN_NO) {
      EXPECT_GE(exact.upper, Real(distance));
    } else {
      ASSERT_EQ(answer, VESICA_WITHIN_NEARLY);
      const Real off = abs(Real(exact.upper - Real(distance)));
      EXPECT_LE(off, Real(9 * u * nearest_reference::scale(a, b) + 2 * Real(0x1p-1074)));
    }
  }

  int cases_ = 0, yes_ = 0, nearly_ = 0;
};

TEST_P(Within, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  const bool both_curved = k.a == VESICA_ELLIPSE && k.b == VESICA_ELLIPSE;
  const bool curved = k.a == VESICA_ELLIPSE || k.b == VESICA_ELLIPSE;
  for (const properties::Workload workload : properties::all_workloads) {
    const bool wild = workload == properties::Workload::mixed_scale || workload == properties::Workload::axis_length ||
                      workload == properties::Workload::thin;
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 21);
    properties::Random random(properties::seed() + 22);
    // The oracle is slowest where an ellipse is the first: beside a core with a radius.
    const int count = both_curved ? (wild ? 4 : 3)
                      : curved    ? (wild || k.a == VESICA_ELLIPSE ? 2 : 10)
                                  : (wild ? 8 : 40);
    for (int i = 0; i < count * properties::repeat(); ++i) {
      const Pair p = stream.next();
      for (const double distance : distances(p, random)) check(p, distance);
      if (HasFailure()) FAIL() << properties::name(workload);
    }
  }
  EXPECT_GT(yes_, cases_ / 20);
  if (both_curved && properties::draws_all()) {
    EXPECT_GT(nearly_, 0);
  }
  std::printf("%d cases, %d yes, %d nearly\n", cases_, yes_, nearly_);
}

INSTANTIATE_TEST_SUITE_P(All, Within, testing::ValuesIn(properties::all_pairs_of_kinds()), properties::test_name);

}  // namespace
