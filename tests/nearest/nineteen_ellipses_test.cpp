// SPDX-License-Identifier: Apache-2.0
/// The nineteen sample pairs of "Minimum Distance Between Ellipses" (2021) as solids: those that lie apart, against the
/// reference; of the others a common point.
#include "methods/nineteen_ellipses.hpp"

#include <gtest/gtest.h>

#include "nearest/face.hpp"
#include "nearest/reference.hpp"

namespace {

using nearest_reference::Real;
using nearest_test::Answer;
using nearest_test::Numbers;
using nearest_test::Pair;

Numbers numbers(const nineteen_ellipses::Sample& s) {
  vesica_ellipse_f64 e{};
  vesica_ellipse_from_angle_f64(s.cx, s.cy, s.degrees * std::numbers::pi / 180, s.width / 2, s.height / 2, &e);
  return {e.cx, e.cy, e.ux, e.uy, e.a, e.b};
}

TEST(NearestNineteenEllipses, DistancesAndCommonPoints) {
  const Numbers first = numbers(nineteen_ellipses::first);
  int apart = 0;
  for (std::size_t i = 0; i < nineteen_ellipses::others.size(); ++i) {
    SCOPED_TRACE(i);
    const Pair p{VESICA_ELLIPSE, VESICA_ELLIPSE, first, numbers(nineteen_ellipses::others[i])};
    const Answer r = nearest_test::nearest(properties::Scalar::f64, p);
    ASSERT_EQ(r.code, 0);
    nearest_reference::set_precision(p);
    const auto a = nearest_reference::shape(p.kind_a, p.a), b = nearest_reference::shape(p.kind_b, p.b);
    if (r.distance > 0) {
      ++apart;
      const auto exact = nearest_reference::distance(a, b, r.bx - r.ax, r.by - r.ay);
      ASSERT_TRUE(exact.proved());
      EXPECT_LE(Real(abs(Real(r.distance) - exact.upper)), Real(0x1p-52 * exact.upper));
    } else {
      for (const auto* s : {&a, &b}) EXPECT_LE(nearest_reference::beyond_outline(*s, r.ax, r.ay, Real(0)), Real(1e-14));
    }
  }
  EXPECT_EQ(apart, 10);  // numbers 8 to 17
}

/// To six places; each of the pairs 8 to 17 and its neighbour are the same ellipses, one of them half a turn round.
TEST(NearestNineteenEllipses, Literals) {
  const Numbers first = numbers(nineteen_ellipses::first);
  const double expected[] = {3.707557, 3.454288, 1.640106, 2.498175, 2.891646};
  for (std::size_t i = 0; i < 10; ++i) {
    const Pair p{VESICA_ELLIPSE, VESICA_ELLIPSE, first, numbers(nineteen_ellipses::others[8 + i])};
    EXPECT_NEAR(nearest_test::nearest(properties::Scalar::f64, p).distance, expected[i / 2], 5e-7) << i;
  }
}

}  // namespace
