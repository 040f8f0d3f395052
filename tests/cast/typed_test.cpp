// SPDX-License-Identifier: Apache-2.0
/// Casts of given kinds: the typed functions have the bits of that by kind; and the early outs of these kinds, by
/// either
/// product, has those of the way for all kinds.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vesica/cast.hpp>

#include "capi/face.hpp"
#include "capi/typed_casts.hpp"
#include "cast/motions.hpp"
#include "properties/core_shape.hpp"
#include "properties/generators.hpp"

namespace {

using namespace cast_test;
namespace core = vesica::detail::cast;
using capi_tests::Face;
using properties::shape_of;

template <class T>
properties::NumbersOf<T> in_scalar(const Numbers& n) {
  properties::NumbersOf<T> out{};
  for (std::size_t k = 0; k < n.size(); ++k) out[k] = static_cast<T>(n[k]);
  return out;
}

template <class T>
class TypedCasts : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(TypedCasts, Scalars);

TYPED_TEST(TypedCasts, HaveTheBitsOfTheCastByKind) {
  using T = TypeParam;
  using Impact = typename Face<T>::Impact;
  constexpr Scalar scalar = sizeof(T) == 8 ? Scalar::f64 : Scalar::f32;
  constexpr std::array<T, 5> untouched{7, 7, 7, 7, 7};
  for (const auto& typed : capi::typed_casts(T{})) {
    int count[3] = {};
    for (const properties::Workload workload : properties::all_workloads) {
      properties::Stream stream(workload, typed.kind_a, typed.kind_b, scalar, properties::seed() + 61);
      properties::Random random(properties::seed() + 62);
      for (int i = 0; i < 60 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        const Motion m = draw_motion(p, scalar, random);
        const auto a = in_scalar<T>(p.a), b = in_scalar<T>(p.b);
        const T vx = static_cast<T>(m.vx), vy = static_cast<T>(m.vy), end = static_cast<T>(m.end);
        auto wanted = std::bit_cast<Impact>(untouched), found = wanted;
        const int code = Face<T>::cast(typed.kind_a, a.data(), typed.kind_b, b.data(), vx, vy, end, &wanted);
        ASSERT_EQ(typed.cast(a.data(), b.data(), vx, vy, end, &found), code) << describe(p, m);
        ASSERT_EQ(std::memcmp(&found, &wanted, sizeof found), 0) << describe(p, m);
        if (code >= 0) ++count[code];
      }
    }
    EXPECT_GT(count[VESICA_CAST_MISS], 0);
    EXPECT_GT(count[VESICA_CAST_HIT], 0);
    EXPECT_GT(count[VESICA_CAST_START], 0);
  }
}

TYPED_TEST(TypedCasts, RefuseWhatTheCastByKindRefuses) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
  constexpr std::array<T, 5> untouched{7, 7, 7, 7, 7};
  for (const auto& typed : capi::typed_casts(T{})) {
    const properties::NumbersOf<T> a{0, 0, 1, 1, 1, 1}, b{-5, -6, 1, 1, 1, 1};
    auto out = std::bit_cast<typename Face<T>::Impact>(untouched);
    EXPECT_EQ(typed.cast(nullptr, b.data(), 1, 1, 1, &out), VESICA_E_NULL);
    EXPECT_EQ(typed.cast(a.data(), nullptr, 1, 1, 1, &out), VESICA_E_NULL);
    EXPECT_EQ(typed.cast(a.data(), b.data(), nan, 1, 1, nullptr), VESICA_E_NULL);
    EXPECT_EQ(typed.cast(a.data(), b.data(), nan, 1, 1, &out), VESICA_E_ARGUMENT);
    EXPECT_EQ(typed.cast(a.data(), b.data(), 1, infinity, 1, &out), VESICA_E_ARGUMENT);
    EXPECT_EQ(typed.cast(a.data(), b.data(), 1, 1, -1, &out), VESICA_E_ARGUMENT);
    EXPECT_EQ(typed.cast(a.data(), b.data(), 1, 1, nan, &out), VESICA_E_ARGUMENT);
    for (std::size_t k = 0; k < 6; ++k) {
      for (const T bad : {nan, infinity, T(-2)}) {
        auto wrong = a;
        wrong[k] = bad;
        // Of numbers that the kind does not have, and of places that are below 0, nothing is wrong.
        const std::int32_t code =
            Face<T>::cast(typed.kind_a, wrong.data(), typed.kind_b, b.data(), T(1), T(1), infinity, &out);
        out = std::bit_cast<typename Face<T>::Impact>(untouched);
        EXPECT_EQ(typed.cast(wrong.data(), b.data(), 1, 1, infinity, &out), code);
        EXPECT_TRUE(code >= 0 || std::memcmp(&out, untouched.data(), sizeof out) == 0);
        EXPECT_TRUE(bad < 0 || k >= 2 || code == VESICA_E_SHAPE);
      }
    }
  }
}

struct Tally {
  int asked = 0, quick = 0, hits = 0, fast_hits = 0;
};

template <class Products, class A, class B>
void check_early(const A& a, const B& b, const core::Motion& m, std::int32_t code, const vesica::Impact<double>& wanted,
                 Tally& tally) {
  core::EarlyOut quick = core::early_out(a, b, m);
  vesica::Impact<double> found{};
  if (quick == core::EarlyOut::hit) quick = core::fast_hit<Products>(a, b, m, found);
  ++tally.asked;
  tally.hits += code == vesica::cast_hit;
  if (quick == core::EarlyOut::open) return;
  ++tally.quick;
  ASSERT_EQ(quick == core::EarlyOut::hit ? vesica::cast_hit : vesica::cast_miss, code);
  if (quick == core::EarlyOut::missed) return;
  ++tally.fast_hits;
  ASSERT_EQ(std::memcmp(&found, &wanted, sizeof found), 0)
      << found.t << ' ' << found.x << ' ' << found.y << ' ' << found.nx << ' ' << found.ny << " / " << wanted.t << ' '
      << wanted.x << ' ' << wanted.y << ' ' << wanted.nx << ' ' << wanted.ny;
}

template <template <class> class A, template <class> class B>
struct Early {
  Tally fused, split;

  void ask(const Pair& p, const Motion& motion) {
    SCOPED_TRACE(describe(p, motion));
    const core::Motion m{motion.vx, motion.vy, motion.end};
    if (!core::is_sound(m)) return;
    const auto a = shape_of<A<double>, double>(p.a);
    const auto b = shape_of<B<double>, double>(p.b);
    vesica::Impact<double> wanted{};
    const std::int32_t code = core::cast_bodies(
        core::body(a), core::body(b), m, core::filter(core::sketch(a), core::sketch(b), m),
        [&] { return vesica::overlap_or_error(a, b); }, core::fused_meeting, wanted);
    check_early<core::FusedProducts>(a, b, m, code, wanted, fused);
    check_early<core::SplitProducts>(a, b, m, code, wanted, split);
  }

  /// A component of the axis of a shape.
  static double axis_of(const Pair& p, std::size_t k) {
    if (p.kind_a == VESICA_SEGMENT) return p.a[2 + k] - p.a[k];
    return p.kind_a >= VESICA_RECT ? p.a[2 + k] : k == 0 ? 1 : 0;
  }

  /// On a grid, but for one coordinate beside 0: what that adds to a time is below all its digits, and counts.
  void ask_beside_zero(Pair p, const Motion& m, properties::Random& random) {
    for (std::size_t k = 0; k < 6; ++k) {
      p.a[k] = std::round(4 * p.a[k]);
      p.b[k] = std::round(4 * p.b[k]);
    }
    auto& of_one = random.chance(0.5) ? p.a : p.b;
    const int exponent = random.chance(0.5) ? 1074 : random.integer(54, 1074);
    of_one[static_cast<std::size_t>(random.integer(0, 1))] = std::ldexp(random.sign(), -exponent);
    const auto power = [](double v) { return v == 0 ? 0 : std::copysign(std::exp2(2 + std::ilogb(v)), v); };
    ask(p, {power(m.vx), power(m.vy), infinity});
  }

  /// The pair as it is drawn, of other sizes and at other speeds, along an axis, and with its end about the contact.
  void ask_about(const Pair& p, const Motion& m, properties::Random& random) {
    ask(p, m);
    ask_beside_zero(p, m, random);
    ask(p, {m.vx, 0, m.end});
    ask(p, {0, m.vy, infinity});
    // About along a side.
    const double ux = axis_of(p, 0), uy = axis_of(p, 1), off = std::ldexp(random.sign(), -random.integer(20, 60));
    ask(p, {ux - off * uy, uy + off * ux, infinity});
    ask(p, {uy, -ux, infinity});
    const int e = random.integer(-30, 30), f = random.integer(-30, 30);
    ask(p, {std::ldexp(m.vx, e), std::ldexp(m.vy, random.chance(0.8) ? e : f), m.end});
    Pair q = p;
    for (double* x : {&q.a[0], &q.a[1], &q.b[0], &q.b[1]}) *x = std::ldexp(*x, random.chance(0.2) ? f : 0);
    if (q.kind_a >= VESICA_RECT) q.a[4] = std::ldexp(q.a[4], random.integer(-20, 8));
    ask(q, m);
    const Answer found = cast_test::cast(Scalar::f64, p, {m.vx, m.vy, infinity});
    if (found.code != VESICA_CAST_HIT) return;
    for (const double end : {std::nextafter(found.t, 0.0), found.t, std::nextafter(found.t, infinity)}) {
      ask(p, {m.vx, m.vy, end});
    }
    // The end comes that little before the contact, or after it.
    const double beside = std::ldexp(random.sign(), -random.integer(1, 52));
    ask(p, {m.vx, m.vy, found.t * (1 - beside)});
    ask(p, {m.vx, m.vy, found.t * (1 + beside)});
    for (const Moving& near : about_grazing({p, m}, Scalar::f64, random, 2)) ask(near.pair, near.motion);
  }

  void run() {
    constexpr int kind_a = static_cast<int>(vesica::kind_of<A>), kind_b = static_cast<int>(vesica::kind_of<B>);
    for (const properties::Workload workload : properties::all_workloads) {
      properties::Stream stream(workload, kind_a, kind_b, Scalar::f64, properties::seed() + 63);
      properties::Random random(properties::seed() + 64);
      for (int i = 0; i < 100 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        ask_about(p, draw_motion(p, Scalar::f64, random), random);
        if (testing::Test::HasFailure()) return;
      }
    }
    // A path that is never taken tests nothing.
    EXPECT_GT(fused.quick, fused.asked / 16);
    EXPECT_GT(fused.fast_hits, fused.hits / 32);
    EXPECT_EQ(fused.quick, split.quick);
    std::printf("%s at %s: %d asked, %d early; %d hits, %d early\n", vesica_kind_name(kind_b), vesica_kind_name(kind_a),
                fused.asked, fused.quick, fused.hits, fused.fast_hits);
  }
};

TEST(EarlyOuts, HaveTheBitsOfTheGeneralPath) {
  using namespace vesica;
  Early<Segment, Point>().run();
  Early<Circle, Point>().run();
  Early<Aabb, Point>().run();
  Early<Rect, Point>().run();
  Early<Ellipse, Point>().run();
  Early<Circle, Circle>().run();
  Early<Ellipse, Ellipse>().run();
}

}  // namespace
