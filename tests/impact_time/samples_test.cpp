// SPDX-License-Identifier: Apache-2.0
/// No contact before t: at sampled times the shapes, shrunk by 2^-40 so as to lie within the true ones, must not
/// overlap, which is asked exactly. And what is said of the place at t.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "impact_time/face.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace samples_test {
namespace {

using namespace impact_time_test;

/// Times looked at before each t: VESICA_SAMPLES, or 24.
int samples_of_each() {
  const char* number = std::getenv("VESICA_SAMPLES");
  return number == nullptr ? 24 : std::atoi(number);
}

class Samples : public testing::TestWithParam<properties::Kinds> {
 protected:
  /// Times before t, some as near to it as 2^-50 of it.
  void check_before(const Turning& s, double t, properties::Random& random) {
    static const int count = samples_of_each();
    for (int i = 0; i < count; ++i) {
      const double at = i % 2 == 0 ? t * random.unit() : t * (1 - std::pow(10, -random.between(0.5, 15)));
      ++samples_;
      ASSERT_FALSE(cores_overlap(s, at)) << at << " before " << t;
    }
  }
  void check_place(const Turning& s, const Answer& r) {
    const Placed a = placed_at(s.pair.kind_a, s.pair.a, s.a, r.t, 0),
                 b = placed_at(s.pair.kind_b, s.pair.b, s.b, r.t, 0);
    const bool is_float = GetParam().scalar == Scalar::f32;
    const double rounding = is_float ? 1e-6 : 1e-12;
    vesica_closest_points_f64 c{};
    ASSERT_EQ(vesica_nearest_f64(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &c), 0);
    EXPECT_LE(c.distance, r.gap + rounding * 1e-2);
    EXPECT_GE(c.distance, 0);
    near_enough_ += r.gap <= s.tolerance;
    EXPECT_LE(r.gap, s.tolerance + (is_float ? 1e-4 : 1e-12));
    const double point[2] = {r.x, r.y};
    vesica_closest_points_f64 to_a{};
    ASSERT_EQ(vesica_nearest_f64(a.kind, a.numbers.data(), VESICA_POINT, point, &to_a), 0);
    EXPECT_LE(to_a.distance, rounding);
    EXPECT_NEAR(std::hypot(r.nx, r.ny), 1, rounding);
  }
  /// A hit is seen at some later time, unless the contact is short or slight.
  bool seen_after(const Turning& s, double t) {
    const double rest = 1 - t;
    for (int i = 0; i <= 300; ++i) {
      const double way = i < 150 ? std::pow(10, -15 + i * 0.1) : (i - 150) / 150.0;
      if (cores_overlap(s, std::min(1.0, t + rest * way))) return true;
    }
    return false;
  }

  long samples_ = 0, near_enough_ = 0, ends_ = 0;
};

TEST_P(Samples, NoneOverlapBefore) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  properties::Random random(properties::seed() + 31);
  long answers[4] = {}, unseen = 0;
  for (const Style style : {Style::plain, Style::needles, Style::close, Style::still}) {
    for (const double spin : {0.0, 1.0, 6.3, 40.0, 100.0}) {
      for (int i = 0; i < 12 * properties::repeat(); ++i) {
        Turning s = draw(k.a, k.b, style, spin, random);
        if (k.scalar == Scalar::f32) {
          s.tolerance = std::max(s.tolerance, 1e-4);
          s.pair.a = properties::nearest_shape(Scalar::f32, k.a, s.pair.a);
          s.pair.b = properties::nearest_shape(Scalar::f32, k.b, s.pair.b);
          for (Turn* turn : {&s.a, &s.b}) {
            for (double* x : {&turn->vx, &turn->vy, &turn->angle}) *x = static_cast<double>(static_cast<float>(*x));
          }
          s.tolerance = static_cast<double>(static_cast<float>(s.tolerance));
        }
        SCOPED_TRACE(describe(s));
        const Answer r = impact_time(k.scalar, s);
        ASSERT_GE(r.code, 0) << r.code;
        ASSERT_LE(r.code, 3);
        ++answers[r.code];
        EXPECT_EQ(r.code == VESICA_CAST_START, vesica_overlap_f64(k.a, s.pair.a.data(), k.b, s.pair.b.data()) == 1);
        if (r.code == VESICA_CAST_MISS) {
          check_before(s, 1, random);
        } else if (r.code != VESICA_CAST_START) {
          check_before(s, r.t, random);
          check_place(s, r);
          ++ends_;
        }
        if (r.code == VESICA_CAST_HIT) unseen += !seen_after(s, r.t);
        if (HasFailure()) FAIL();
      }
    }
  }
  std::printf("%ld samples; %ld misses, %ld hits (%ld not seen), %ld starts, %ld near\n", samples_, answers[0],
              answers[1], unseen, answers[2], answers[3]);
  // Points meet points in no area, and boxes without one hardly ever do.
  EXPECT_GT(answers[0], 20);
  EXPECT_GE(near_enough_, ends_ * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(ImpactTime, Samples, testing::ValuesIn(properties::all_pairs_of_kinds()),
                         properties::test_name);

}  // namespace
}  // namespace samples_test
