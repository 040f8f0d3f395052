// SPDX-License-Identifier: Apache-2.0
/// The search for the first contact has the same bits by fused products and by splitting.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <vesica/cast/first_contact.hpp>

#include "cast/motions.hpp"
#include "properties/generators.hpp"

namespace {

using namespace cast_test;
namespace core = vesica::detail::cast;

core::Body body_of(int kind, const Numbers& n) {
  core::Body body{static_cast<vesica::Kind>(kind), {}};
  for (std::size_t k = 0; k < n.size(); ++k) body.number[k] = n[k];
  return body;
}

bool same(double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; }
bool same(const core::Offset& x, const core::Offset& y) { return same(x.x, y.x) && same(x.y, y.y); }
bool same(const core::Twofold<double>& x, const core::Twofold<double>& y) {
  return same(x.high, y.high) && same(x.low, y.low);
}
bool same(const core::Foremost& x, const core::Foremost& y) { return same(x.middle, y.middle) && same(x.half, y.half); }
bool same(const core::TimeBounds& x, const core::TimeBounds& y) {
  return same(x.value, y.value) && same(x.error, y.error) && same(x.gain, y.gain) && same(x.step, y.step) &&
         x.certain == y.certain;
}
bool same(const core::Meeting& x, const core::Meeting& y) {
  return same(x.found.normal.x, y.found.normal.x) && same(x.found.normal.y, y.found.normal.y) &&
         same(x.found.time, y.found.time) && same(x.of_a, y.of_a) && (!x.of_a.is_edge() || same(x.of_b, y.of_b));
}

struct Count {
  int asked = 0, fused = 0;

  /// A line that certainly meets both shapes, as cast() asks.
  void check(const Pair& p, const Motion& m) {
    const core::Body a = body_of(p.kind_a, p.a), b = body_of(p.kind_b, p.b);
    const core::Motion motion{m.vx, m.vy, m.end};
    const core::Verdict verdict = core::filter(core::sketch(a), core::sketch(b), motion).verdict;
    if (verdict != core::Verdict::reached && verdict != core::Verdict::late) return;
    core::Scene scene;
    core::set_scene(a, b, motion, scene);
    ++asked;
    core::Meeting by_splitting{}, by_fusing{};
    if (!core::has_fused_products(scene) || !core::find_meeting<core::FusedProducts>(scene, by_fusing)) return;
    ++fused;
    ASSERT_TRUE(core::find_meeting<core::SplitProducts>(scene, by_splitting));
    EXPECT_TRUE(same(by_splitting, by_fusing)) << describe(p, m);
  }
};

TEST(Products, FusedOrSplitHaveTheSameBits) {
  Count usual, all;
  for (const properties::Workload workload : properties::all_workloads) {
    for (int a = 0; a < properties::kinds_with_form; ++a) {
      for (int b = 0; b < properties::kinds_with_form; ++b) {
        properties::Stream stream(workload, a, b, Scalar::f64, properties::seed() + 51);
        properties::Random random(properties::seed() + 52);
        for (int i = 0; i < 150 * properties::repeat(); ++i) {
          const Pair p = stream.next();
          const Motion m = draw_motion(p, Scalar::f64, random);
          all.check(p, m);
          // Velocities and places about the ends of the range in which products are fused.
          const int e = random.integer(-45, 45), f = random.integer(-45, 45);
          Pair q = p;
          for (double* x : {&q.a[0], &q.a[1], &q.b[0], &q.b[1]}) *x = std::ldexp(*x, random.chance(0.2) ? f : 0);
          if (properties::valid(a, q.a) && properties::valid(b, q.b)) {
            all.check(q, {std::ldexp(m.vx, e), std::ldexp(m.vy, random.chance(0.5) ? e : f), m.end});
          }
          if (workload == properties::Workload::random) usual.check(p, m);
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(all.asked, 10000 * properties::repeat());
  EXPECT_GT(all.fused, all.asked / 4);
  EXPECT_GT(usual.fused, usual.asked * 2 / 3);  // of velocities that differ by more from places there are some 20%
  std::printf("%d searches, %d fused; of usual numbers %d of %d\n", all.asked, all.fused, usual.fused, usual.asked);
}

}  // namespace
