// SPDX-License-Identifier: Apache-2.0
/// Distances and points against the reference, over every workload and pair of kinds, and what is said of overlapping
/// pairs. The bounds are those of the functions' comments; what was observed is recorded as properties of the tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "nearest/face.hpp"
#include "nearest/reference.hpp"
#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using nearest_reference::Real;
using nearest_reference::Shape;
using nearest_test::Answer;
using properties::Pair;
using properties::Scalar;

constexpr double u = 0x1p-53;

/// The worst seen, in units of u.
struct Observed {
  double of_scale = 0, of_itself = 0, off_outline = 0, off_common = 0;
};

void record(double& worst, const Real& error, const Real& unit) {
  worst = std::max(worst, Real(error / unit * Real(0x1p53)).get_d());
}

class Accuracy : public testing::TestWithParam<properties::Kinds> {
 protected:
  bool narrow() const { return GetParam().scalar == Scalar::f32; }
  Real last_place() const { return Real(narrow() ? 0x1p-149 : 0x1p-1074); }

  /// The largest error of a point from rounding its coordinates, where a core has a radius twice.
  Real coordinate_rounding(int kind, double x, double y) const {
    const Real once = Real(narrow() ? 0x1p-24 : u) * (abs(Real(x)) + abs(Real(y))) + 2 * last_place();
    return (properties::is_inflated(kind) ? 2 : 1) * once;
  }

  void check_overlapping(const Shape& a, const Shape& b, const Answer& r, Observed& observed) const {
    EXPECT_EQ(r.distance, 0);
    EXPECT_TRUE(r.ax == r.bx && r.ay == r.by);
    const Real scale = nearest_reference::scale(a, b);
    for (const auto* s : {&a, &b}) {
      const Real rounding = coordinate_rounding(GetParam().b, r.ax, r.ay), allowed = 8 * u * scale;
      const Real off = nearest_reference::beyond_outline(*s, r.ax, r.ay, rounding) - rounding;
      EXPECT_LE(off, allowed);
      if (scale > Real(0x1p-900)) record(observed.off_common, off, scale);
    }
  }

  void check_disjoint(const Shape& a, const Shape& b, const Answer& r, Observed& observed) const {
    ASSERT_GT(r.distance, 0);
    const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
    ASSERT_TRUE(exact.proved());
    const Real scale = nearest_reference::scale(a, b), error = abs(Real(r.distance) - exact.upper);
    const Real own_rounding = narrow() ? Real(exact.upper * Real(0x1p-24)) : Real(0);
    EXPECT_LE(error, Real(4 * u * scale + own_rounding + last_place()));
    const bool normal = !narrow() && scale > Real(0x1p-900);
    if (normal) record(observed.of_scale, error, scale);
    const bool thin = nearest_reference::aspect(a) > Real(1e6) || nearest_reference::aspect(b) > Real(1e6);
    if (normal && !thin && exact.upper > Real(1e-10) * scale) {
      record(observed.of_itself, error, exact.upper);
      EXPECT_LE(error, Real(2 * u * exact.upper));
    }
    for (const auto& [s, kind, x, y] : {std::tuple{&a, GetParam().a, r.ax, r.ay}, {&b, GetParam().b, r.bx, r.by}}) {
      const Real rounding = coordinate_rounding(kind, x, y);
      const Real off = abs(nearest_reference::beyond_outline(*s, x, y, Real(rounding + u * scale))) - rounding;
      EXPECT_LE(off, Real(4 * u * scale));
      if (normal) record(observed.off_outline, off, scale);
    }
  }

  void run(properties::Workload workload, int count) {
    const properties::Kinds k = GetParam();
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed());
    Observed observed;
    for (int i = 0; i < count * properties::repeat(); ++i) {
      const Pair p = stream.next();
      SCOPED_TRACE(properties::describe(p));
      const Answer r = nearest_test::nearest(k.scalar, p);
      if (r.code == VESICA_E_RANGE) {
        EXPECT_TRUE(workload == properties::Workload::mixed_scale || workload == properties::Workload::near_contact);
        continue;
      }
      ASSERT_EQ(r.code, 0);
      nearest_reference::set_precision(p);
      const auto a = nearest_reference::shape(k.a, p.a), b = nearest_reference::shape(k.b, p.b);
      if (oracle::overlap(k.a, p.a.data(), k.b, p.b.data())) {
        check_overlapping(a, b, r, observed);
      } else {
        check_disjoint(a, b, r, observed);
      }
      if (HasFailure()) return;
    }
    std::ostringstream text;
    text << "scale " << observed.of_scale << " itself " << observed.of_itself << " outline " << observed.off_outline
         << " common " << observed.off_common;
    RecordProperty(properties::name(workload), text.str());
    if (std::getenv("VESICA_VERBOSE") != nullptr) {
      std::printf("%s %s: %s\n", properties::to_string(k).c_str(), properties::name(workload), text.str().c_str());
    }
  }
};

TEST_P(Accuracy, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  for (const properties::Workload workload : properties::all_workloads) {
    run(workload, 24);
    if (HasFailure()) FAIL() << properties::name(workload);
  }
}

INSTANTIATE_TEST_SUITE_P(Nearest, Accuracy, testing::ValuesIn(properties::all_pairs_of_kinds()), properties::test_name);

}  // namespace
