// SPDX-License-Identifier: Apache-2.0
/// Times of first contact at unlike exponents: there is contact before the next double, and none before the time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/cast.hpp>

#include "cast/motions.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

namespace core = vesica::detail::cast;
using core::Body;
using core::ExactPair;
using vesica::Kind;

Body body(int kind, const cast_test::Numbers& numbers) {
  Body b{static_cast<Kind>(kind), {}};
  for (std::size_t i = 0; i < 6; ++i) b.number[i] = numbers[i];
  return b;
}

double next(double t) { return std::nextafter(t, std::numeric_limits<double>::infinity()); }

/// Motions that end beside the time, before the witness.
void expect_contact_at_ends(const ExactPair& pair, double t) {
  for (const double end : {std::nextafter(t, 0.0), t, next(t)}) {
    const bool is_late = end > 0 && end <= std::numeric_limits<double>::max() && pair.witness_after(end) > 0;
    if (!is_late || pair.contact_at(end) == core::Contact::beyond) continue;
    double found = 0;
    const std::int32_t reached = core::exact_time_by(pair, end, is_late, t, found);
    EXPECT_EQ(reached != 0, pair.contact_at(end) != core::Contact::none) << std::hexfloat << end;
  }
}

/// The time by bisection from an estimate that says nothing; negative if it is beyond the numbers.
double time_of(const ExactPair& pair) {
  double t = 0;
  return core::exact_time(pair, 0, t) == 1 ? t : -1;
}

/// Checks the time, if there is one, against the predicate and the library's answer.
bool check(const cast_test::Pair& p, const cast_test::Motion& m) {
  const ExactPair pair(body(p.kind_a, p.a), body(p.kind_b, p.b), {m.vx, m.vy, m.end});
  if (pair.contact_at(0) != core::Contact::none) return false;
  const core::LineMeeting line = core::exact_line(pair, m.end);
  if (!line.meets) return false;
  const double t = time_of(pair);
  if (t < 0) return false;
  expect_contact_at_ends(pair, t);
  const cast_test::Answer r = cast_test::cast(cast_test::Scalar::f64, p, m);
  if (r.code == VESICA_CAST_HIT) {
    EXPECT_EQ(r.t, t) << std::hexfloat << t;
  }
  if (r.code == VESICA_CAST_MISS) {
    EXPECT_GE(t, m.end) << std::hexfloat << t;
  }
  if (pair.contact_before(next(t)) < 0) return true;
  EXPECT_EQ(pair.contact_before(t), 0) << std::hexfloat << t;
  EXPECT_EQ(pair.contact_before(next(t)), 1) << std::hexfloat << t;
  return true;
}

TEST(CastAtUnlikeExponents, TimesAreThoseOfTheExactPredicate) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  properties::Random random(properties::seed() + 31);
  int known = 0;
  for (const properties::Kinds& k : properties::all_pairs_of_kinds(properties::kinds_with_form)) {
    if (k.scalar != properties::Scalar::f64) continue;
    for (const properties::Workload workload : properties::all_workloads) {
      for (int i = 0; i < 20 * properties::repeat(); ++i) {
        const properties::Pair p = properties::draw(workload, k.a, k.b, k.scalar, random);
        const cast_test::Motion m = cast_test::draw_motion(p, k.scalar, random);
        if (!(std::fabs(m.vx) + std::fabs(m.vy) > 0)) continue;
        SCOPED_TRACE(cast_test::describe(p, m));
        known += check(p, m) ? 1 : 0;
        if (HasFailure()) return;
      }
    }
  }
  if (properties::draws_all()) {
    EXPECT_GT(known, 200);
  }
}

struct Known {
  Body a, b;
  core::Motion motion;
  double time;
};

TEST(CastAtUnlikeExponents, KnownTimes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Known all[] = {
      // Ellipses whose discriminant has a double zero.
      {{Kind::ellipse, {0, 0, 0x1p-2, -0x1.e1a5be0f0a346p+299, 0x1.e9ea8bec3399ep+290, 0x1.33014ea6fa77p-292}},
       {Kind::ellipse,
        {0x1.7778b777626f4p+289, -0x1.0455bcac6b459p+291, 0x1.5b54cdc7f2babp-2, -0x1.e1a5be0f0a345p-1,
         0x1.e9ea8bec3399ep+290, 0x1.33014ea6fa77p-292}},
       {-0x1.7778b777626f4p+288, 0x1p+324, infinity},
       0x1.d66917a1f178ep-3},
      // A corner meets the ellipse.
      {{Kind::rect,
        {-0x1.8f514724ba494p-754, 0x1.3fba14d1a47f2p-412, -0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1,
         0x1.5624fc733e426p-756, 0x1.6162f6f12ca09p-757}},
       {Kind::ellipse,
        {-0x1.1cb4349a908ccp-753, -0x1.54e837c71c3c7p-753, -0x1.d51de7c1d39b1p-1, -0x1.faca800d4d774p-756,
         0x1.5624fc733e426p-756, 0x1.9f55d8cc219aep-2}},
       {0x1.542e4420cda08p-299, 0x1p+386, infinity},
       0x1.e6df74057a3c4p-511},
      {{Kind::segment, {-0x1.02949fd0084aep-795, 0x1.340cc29a1d4d8p+869, -0x1.4a7b8753fc888p-1001, 0x1p+333, 0, 0}},
       {Kind::circle, {-0x1.69f4d31ac1765p+331, -0x1.932f24be5e478p+329, 0x1.47ef8af26e129p+331, 0, 0, 0}},
       {0x1.798997b136899p+330, 0x1.254b964993b16p+332, infinity},
       0x1.62a52f062ae82p+0},
      // Times below the least double, and among the subnormal ones.
      {{Kind::point, {0x1.b0ab206583e42p-989, -0x1p+72, 0, 0, 0, 0}},
       {Kind::aabb, {-0x1p+72, -0x1.858ed78e94f76p+817, -0x1.12b7109b0369bp-264, 0x1.aa38d1905887fp+459, 0, 0}},
       {0x1.7ac2e0262cf25p+811, 0x1.4a75eee874e38p+816, infinity},
       0},
      {{Kind::point, {0, 0, 0, 0, 0, 0}}, {Kind::segment, {7, -1, 7, 2, 0, 0}}, {-0x1p+1001, -1, infinity}, 0x1.cp-999},
      {{Kind::point, {0, 0, 0, 0, 0, 0}},
       {Kind::segment, {0x1.dp-52, -1, 0x1.dp-52, 2, 0, 0}},
       {-0x1p+1020, 0, infinity},
       0x0.0000000000007p-1022},
      // The time along the direction that is tried first is 0.
      {{Kind::circle, {-0x1.4000000000001p-789, 0x1.cp-789, 0x1.8p-790, 0, 0, 0}},
       {Kind::circle, {-0x1.4p-789, 0x1p-790, 0x1p-790, 0, 0, 0}},
       {0, 0x1.4p-790, infinity},
       0x1.47ae147ae147ap-105},
      // Two ellipses, of whose direction double has no digit.
      {{Kind::circle, {-0x1p+527, -0x1.69b78e35e0be8p-481, 0x1p+819, 0, 0, 0}},
       {Kind::ellipse,
        {-0x0.000000001cbbfp-1022, -0x1p+819, 0x1.afcbada07a9b5p-823, 0x1.4051e1527e1b9p+223, 0x1.304d3f8983797p-14,
         0x1p+100}},
       {0x1p+162, 0x1p+0, 0x1.0000000000002p+234},
       0x1.fffffe833e1c4p+233},
      // Lines that graze: the edge of a box, an ellipse at one point.
      {{Kind::aabb, {0, 0, 1, 1, 0, 0}}, {Kind::aabb, {-5, 1, -3, 2, 0, 0}}, {0x1p-900, 0, infinity}, 0x1.8p+901},
      {{Kind::point, {0x1p+301, -0x1p-262, 0, 0, 0, 0}},
       {Kind::circle, {0x1.63086cfb056cp-824, 0, 0x1p-262, 0, 0, 0}},
       {0x1p+621, 0, infinity},
       0x1.fffffffffffffp-321},
  };
  for (const Known& k : all) {
    const ExactPair pair(k.a, k.b, k.motion);
    const double t = time_of(pair);
    EXPECT_EQ(t, k.time);
    EXPECT_EQ(pair.contact_before(t), 0);
    EXPECT_EQ(pair.contact_before(next(t)), 1);
    expect_contact_at_ends(pair, t);
  }
}

}  // namespace
