// SPDX-License-Identifier: Apache-2.0
// Parts of cast at the ends of what they are defined for, which no pair of shapes is known to reach.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>
#include <vesica/vesica.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica;
using namespace vesica::detail::cast;
using exact::from_double;
using Products = SplitProducts;

constexpr double infinity = std::numeric_limits<double>::infinity();

double next(double x) { return std::nextafter(x, infinity); }
double before(double x) { return std::nextafter(x, -infinity); }

Scene scene_of(const auto& a, const auto& b, const Motion& v) {
  Scene scene;
  set_scene(body(a), body(b), v, scene);
  return scene;
}

TEST(CastParts, UsableSizes) {
  const auto usable = [](double u, double a, double b) { return sketch(Ellipse<double>{0, 0, u, 0, a, b}).usable; };
  EXPECT_TRUE(usable(1, 2, 1) && usable(0x1p200, 2, 1) && usable(0x1p-200, 2, 1) && usable(1, 0, 0));
  EXPECT_FALSE(usable(0x1p201, 2, 1) || usable(0x1p-201, 2, 1) || usable(1, -1, 1) || usable(1, 1, -1));
  EXPECT_FALSE(usable(1, 0x1p200, 0x1p200));
}

/// Times beyond 2^+-1000 are floored as others are, as long as a neighbour and a unit of the time are within the range.
TEST(CastParts, KnownFloor) {
  Scene scene{};
  scene.faithful = true;
  const auto floor = [&](double high, double low) {
    return known_floor(scene, TimeBounds{{high, high * low}, lane::max(high * 0x1p-80, 0x1p-1070), 0, 0, true});
  };
  for (const double t : {1.5, 0x1p-999, 0x1.8p-1000, 0x1p1000, 0x1.8p1010, 0x1.8p1018}) {
    EXPECT_EQ(floor(t, 0x1p-60), t);
    EXPECT_EQ(floor(t, -0x1p-60), before(t));
    EXPECT_EQ(floor(t, 0), -1) << "it may be on either side";
  }
  for (const double t : {0x1p-1010, 0x1p1022}) EXPECT_EQ(floor(t, 0x1p-60), -1) << t;
}

/// Fused products have the bits of split ones where each number of a scene is 0 or within bounds, lower parts too.
TEST(CastParts, FusedProductsOfEachNumber) {
  const Scene usual = scene_of(Rect<double>{0, 0, 1, 2, 3, 4}, Ellipse<double>{8, 5, 1, 1, 2, 1}, {-1, 0.5, infinity});
  EXPECT_TRUE(has_fused_products(usual));
  const auto is_fused = [](const Scene& s, double& part, double x) {
    const double kept = part;
    part = x;
    const bool fused = has_fused_products(s);
    part = kept;
    return fused;
  };
  Scene s = usual;
  std::vector<Twofold<double>*> numbers{&s.d.x, &s.d.y};
  for (Side* side : {&s.a, &s.b}) numbers.insert(numbers.end(), {&side->u.x, &side->u.y, &side->hx, &side->hy});
  std::vector<double*> upper{&s.vx, &s.vy};
  for (Twofold<double>* number : numbers) upper.push_back(&number->high);
  for (std::size_t i = 0; i < upper.size(); ++i) {
    for (const double x : {0.0, 0x1p-40, -0x1p-40, 0x1p40}) EXPECT_TRUE(is_fused(s, *upper[i], x)) << i << ' ' << x;
    for (const double x : {0x1p-41, -0x1p-41, 0x1p-1074, -0x1p41}) EXPECT_FALSE(is_fused(s, *upper[i], x)) << i;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const double x : {0.0, 0x1p-60, -0x1p-54}) EXPECT_TRUE(is_fused(s, numbers[i]->low, x)) << i << ' ' << x;
    for (const double x : {0x1p-61, -0x1p-61, 0x1p-1074}) EXPECT_FALSE(is_fused(s, numbers[i]->low, x)) << i;
  }
}

/// Whatever has no speed tells no time: not even one to begin a search with.
TEST(CastParts, DirectionsAcrossTheWay) {
  Scene scene = scene_of(Circle<double>{0, 0, 1}, Circle<double>{4, 0, 1}, {-1, 0, infinity});
  const auto look = [&scene](double nx) { return time_bounds<Products>(scene, {{nx, 0}, {1, 0}}); };
  for (const bool whole : {true, false}) {
    scene.whole = whole;
    for (const double nx : {0.0, 0x1p-90, -1.0}) {
      const TimeBounds none = look(nx);
      EXPECT_FALSE(none.tells()) << nx;
      EXPECT_TRUE(none.value.high == 0 && none.value.low == 0) << nx;
      EXPECT_EQ(none.certain, whole && nx == 0) << "across the way for certain";
    }
  }
  EXPECT_TRUE(look(0x1p-70).tells());
}

/// The same of scalars, by bits, and of lanes.
TEST(CastParts, PlainNumbers) {
  const Vector d{{3, 0}, {4, 0}};
  for (const double x : {0.0, 0x1p-1074, before(0x1p-60), 0x1p-60, 1.0, 0x1p60, next(0x1p60), 0x1p1000, infinity}) {
    for (const double sign : {1.0, -1.0}) {
      const bool plain = x == 0 || (x >= 0x1p-60 && x <= 0x1p60);
      EXPECT_EQ(is_plain(sign * x), plain) << x;
      const bool has_speed = x <= 0x1p60 && plain;
      EXPECT_EQ(is_plain(d, Motion{sign * x, 0, infinity}), has_speed) << x;
      EXPECT_EQ(is_plain(d, Motion{0, sign * x, infinity}), has_speed) << x;
    }
  }
}

/// Of two boxes and a direction that is no edge's normal: a lower bound, which does not tell the time.
TEST(CastParts, TimeBoundsBetweenNormals) {
  const Scene scene = scene_of(Aabb<double>{-1, -1, 1, 1}, Aabb<double>{3, -1, 5, 1}, {-1, 0, infinity});
  const TimeBounds across = time_bounds<Products>(scene, {{4, 0}, {1, 0}}),
                   face = time_bounds<Products>(scene, {{1, 0}, {0, 0}});
  EXPECT_EQ(across.value.high, 1.5);
  EXPECT_FALSE(across.certain);
  EXPECT_EQ(face.value.high, 2);
  EXPECT_TRUE(face.certain);
}

/// Of ellipses so thin that their bend underflows, which a scene has as segments, nothing is certain, and no step is
/// told.
TEST(CastParts, PolishedWithoutABend) {
  Scene scene = scene_of(Circle<double>{0, 0, 1}, Circle<double>{4, 0, 1}, {-1, 0, infinity});
  const Found usual = polished<Products>(scene, 0);
  EXPECT_EQ(usual.time.value.high, 2);
  EXPECT_TRUE(usual.time.certain);
  for (Side* side : {&scene.a, &scene.b}) side->hy = {0x1p-600, 0};
  const Found found = polished<Products>(scene, 0);
  EXPECT_EQ(found.time.value.high, 2);
  EXPECT_FALSE(found.time.certain || std::isfinite(found.time.step));
}

/// A direction that is certain by a hair, and the next one, which is not, as the errors of both are greater than the
/// step: the first is kept.
TEST(CastParts, PolishedUntilNothingIsCertain) {
  const Ellipse<double> needle{0, -0x1.b64ec337f0d07p-65, 0x1.cd0dc50377c1dp-1,
                               0, 0x1.4159398c877aep-36,  0x1.11bde2a671668p-10};
  const Scene scene = scene_of(needle, Point<double>{-0x1.c99490f130af4p-82, 0x1.ed01aa75115b9p-11},
                               {0x1.d4db04bf5c806p-2, 0, infinity});
  const double start = 0x1.7c192698da9a4p+19;
  TimeBounds kept{}, last = time_bounds<Products>(scene, direction<Products>(scene, start));
  double s = start;
  for (int i = 0; i < 3 && last.certain; ++i) {
    kept = last;
    s += last.step;
    last = time_bounds<Products>(scene, direction<Products>(scene, s));
  }
  ASSERT_TRUE(kept.certain && last.tells() && !last.certain);
  const Found found = polished<Products>(scene, start);
  EXPECT_TRUE(found.time.certain);
  EXPECT_EQ(found.time.value.high, kept.value.high);
  EXPECT_EQ(found.time.gain, kept.gain);
}

/// Two needles seen lengthwise: eighty steps do not find where their slopes have the sum that is asked for, which is in
/// the bracket still.
TEST(CastParts, SearchThatEndsAtItsLimit) {
  const auto curve = [](double s, double al, double de) { return Curve{s, al, de, std::sqrt(al)}; };
  const Curve a = curve(-0x1.569a0d40cd9d4p+50, 0x1.528fa8f46c02p+27, 0x1.d0a5082bcc394p-338),
              b = curve(-0x1.1342b7821e70ap-63, 0x1.322c8d256f7efp+49, 0x1.0624289829ccep-300);
  int steps;
  const double s = maximum_of_two(a, b, 0x1.2ca1d39f2533p-19, steps);
  EXPECT_EQ(steps, 80);
  EXPECT_TRUE(s > a.s && s < 1) << s;
  // Seen from the side they meet where they should.
  const double wide = maximum_of_two(curve(-1, 1, 1), curve(1, 1, 1), 1, steps);
  EXPECT_LT(steps, 20);
  EXPECT_NEAR((wide + 1) / std::hypot(wide + 1, 1) + (wide - 1) / std::hypot(wide - 1, 1), 1, 0x1p-40);
}

/// A direction that is not the contact's own normal.
TEST(CastParts, EndsAtTheNormalAlone) {
  const auto ends = [](double x, double y) {
    return ends_at({{x, 0}, {y, 0}}, {x, y}, QuickTime{{1, 0}, 0, 1, 1}, 1, 1, 1);
  };
  EXPECT_TRUE(ends(1, 1));
  EXPECT_FALSE(ends(1, 1 + 0x1p-40));
  EXPECT_FALSE(ends(1, -1));
}

/// An end about the time of contact: after it, at it, and before.
TEST(CastParts, QuickEllipsesAboutTheEnd) {
  const Ellipse<double> a{0, 0, 0.6, 0.8, 2, 1}, b{9, 1, 0.8, 0.6, 1.5, 1};
  Impact<double> found, again;
  ASSERT_EQ(quick_hit<UsualProducts>(a, b, {-1, 0.125, infinity}, found), Quick::hit);
  const auto ask = [&](double end) { return quick_hit<UsualProducts>(a, b, {-1, 0.125, end}, again); };
  EXPECT_EQ(ask(next(found.t)), Quick::hit);
  EXPECT_EQ(ask(found.t), Quick::open);
  EXPECT_EQ(ask(before(found.t)), Quick::missed);
  // The time is rounded down, so that there is none at it.
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.125, next(found.t), again), cast_hit);
  EXPECT_EQ(again.t, found.t);
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.125, found.t, again), cast_miss);
}

/// Head on: what of a normal is 0 has no sign, by the quick ways and the general one.
TEST(CastParts, NormalsHaveNoNegativeZero) {
  const auto expect = [](const auto& a, const auto& b, double vx, double vy) {
    Impact<double> quick, found;
    const auto check = [&](const Impact<double>& i) {
      EXPECT_FALSE(std::signbit(i.nx) && i.nx == 0) << vx << ' ' << vy;
      EXPECT_FALSE(std::signbit(i.ny) && i.ny == 0) << vx << ' ' << vy;
      EXPECT_EQ(i.nx, vx == 0 ? 0 : -vx);
      EXPECT_EQ(i.ny, vy == 0 ? 0 : -vy);
    };
    if (quick_hit<UsualProducts>(a, b, {vx, vy, infinity}, quick) == Quick::hit) check(quick);
    ASSERT_EQ(cast_any(a, b, {vx, vy, infinity}, found), cast_hit);
    check(found);
    ASSERT_EQ(cast_or_error(a, b, vx, vy, infinity, found), cast_hit);
    check(found);
  };
  for (const double v : {1.0, -1.0}) {
    for (const double zero : {0.0, -0.0}) {
      for (const double at : {0.0, -0.0}) {
        const Ellipse<double> e{0, 0, 1, zero, 2, 1}, f{0, 0, zero, 1, 1.5, 1};
        const Circle<double> c{0, 0, 2};
        const double far = -8 * v;
        expect(e, Ellipse<double>{far, at, 1, 0, 2, 1}, v, zero);
        expect(f, Ellipse<double>{at, far, 0, 1, 2, 1}, zero, v);
        expect(e, Point<double>{far, at}, v, zero);
        expect(f, Point<double>{at, far}, zero, v);
        expect(c, Point<double>{far, at}, v, zero);
        expect(c, Circle<double>{at, far, 1}, zero, v);
      }
    }
  }
}

/// Points about the flat side of a thin ellipse, where what is left of the form is far less than its terms: contact at
/// the start is the overlap, whether they come or go.
TEST(CastParts, StartsAtTheFlatSideOfAThinEllipse) {
  properties::Random random(properties::seed());
  int starts = 0, others = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const double side = random.sign(), a = 1 + random.unit(), thin = random.between(1, 20), b = a * std::exp2(-thin);
    const double length = 1 + random.unit(), slope = random.chance(0.3) ? 0 : std::exp2(-random.between(1, 30));
    const double along = b * random.between(-1, 1), off = random.integer(-4, 4) * 0x1p-53;
    const double across = side * b * std::sqrt(1 - along / a * (along / a)) * (1 + off);
    const Ellipse<double> e{0, 0, length, length * slope, a, b};
    const Point<double> p{along * e.ux - across * e.uy, along * e.uy + across * e.ux};
    const std::int32_t overlapping = overlap_or_error(e, p);
    for (const double v : {1.0, -1.0}) {
      Impact<double> out;
      const std::int32_t code = cast_or_error(e, p, 0.125, v, infinity, out);
      ASSERT_EQ(code == cast_start, overlapping == 1) << e.uy << ' ' << p.x << ' ' << p.y << ' ' << a << ' ' << b;
    }
    (overlapping == 1 ? starts : others) += 1;
  }
  EXPECT_GT(starts, 500 * properties::repeat());
  EXPECT_GT(others, 500 * properties::repeat());
}

/// The contact is at a double, and the quotient of rounded numbers beside it.
TEST(CastParts, QuickBoxAtADouble) {
  constexpr double v = 0x1.199999999999ap+0, t = 0x1.e666686b5e666p+0;
  const Aabb<double> box{0x1.0b851fd4a71ecp+1, 0, 8, 1};
  const Point<double> point{0x1.47ae12dd4e148p-53, 0.5};
  ASSERT_NE((box.min_x - point.x) / v, t);
  Impact<double> found;
  EXPECT_EQ(quick_hit<UsualProducts>(box, point, {v, 0, infinity}, found), Quick::open);
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, infinity, found), cast_hit);
  EXPECT_EQ(found.t, t);
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, t, found), cast_hit);
  EXPECT_EQ(cast_or_error(box, point, v, 0.0, before(t), found), cast_miss);
}

/// A box from so far that lengths are no longer below 2^40 of the disc is met by the general way.
TEST(CastParts, QuickMeetingsFromFarOff) {
  for (const int exponent : {2, 20, 35, 36, 37, 38, 39, 40, 50}) {
    const double far = std::ldexp(1, exponent);
    const Scene scene = scene_of(Circle<double>{0, 0, 1}, Aabb<double>{far, -1, far + 2, 1}, {-1, 0, infinity});
    Meeting met;
    ASSERT_EQ(quick_meeting<UsualProducts>(scene, met), exponent <= 38) << exponent;
    if (exponent <= 38) {
      EXPECT_EQ(met.found.time.value.high, far - 1);
    }
  }
}

/// A rectangle of which one half length is out of the quick range.
TEST(CastParts, QuickRectOfOddSizes) {
  const Point<double> point{4, 0.25};
  const Motion v{-1, -0x1p-10, infinity};
  const auto ask = [&](double hx, double hy) {
    Impact<double> quick{}, found;
    const Rect<double> rect{0, 0, 1, 0.125, hx, hy};
    const Quick answer = quick_hit<UsualProducts>(rect, point, v, quick);
    EXPECT_EQ(cast_any(rect, point, v, found), cast_hit);
    EXPECT_NEAR(found.t, (4 + 0.25 * 0.125 - hx * 1.015625) / (1 + 0.125 * 0x1p-10), 0x1p-48) << hx;
    EXPECT_TRUE(answer != Quick::hit || quick.t == found.t);
    return answer;
  };
  EXPECT_EQ(ask(1, 1), Quick::hit);
  EXPECT_EQ(ask(0, 1), Quick::hit);
  EXPECT_EQ(ask(0x1p-70, 1), Quick::open);
  EXPECT_EQ(ask(1, 0x1p41), Quick::open);
}

/// Errors of the form for shapes that have no quick way; and of a start whose common point, or depth, is beyond.
TEST(CastParts, ErrorsOfTheHeader) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), largest = std::numeric_limits<double>::max();
  Impact<double> out{7, 7, 7, 7, 7};
  const Circle<double> disc{0, 0, 1}, other{9, 0, 1};
  EXPECT_EQ(cast_or_error(disc, other, nan, 0.0, 1.0, out), error_argument);
  EXPECT_EQ(cast_or_error(disc, other, 0.0, infinity, 1.0, out), error_argument);
  EXPECT_EQ(cast_or_error(disc, other, 1.0, 0.0, -1.0, out), error_argument);
  const Aabb<double> all{-largest, -largest, largest, largest};
  EXPECT_EQ(cast_or_error(all, all, 0.0, 0.0, 1.0, out), error_range);
  // Two needles that cross beyond the numbers.
  const Rect<double> down{1e308, 1e308, 1, -1, 1.2e308, 0}, up{1e308, -1e308, 1, 1, 1.2e308, 0};
  ASSERT_EQ(overlap_or_error(down, up), 1);
  EXPECT_EQ(cast_or_error(down, up, 0.0, 0.0, 1.0, out), error_range);
  EXPECT_EQ(out.t, 7);
}

/// A slide along a face: the witness comes in the middle, after the end, and contact before.
TEST(CastParts, ASlideThatEndsBeforeItsMiddle) {
  const Aabb<double> a{0, 0, 1, 1}, b{3, 1, 4, 2};
  Impact<double> out;
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 2.5, out), cast_hit);
  EXPECT_EQ(out.t, 2);
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 2.0, out), cast_hit);
  EXPECT_EQ(cast_or_error(a, b, -1.0, 0.0, 1.5, out), cast_miss);
}

}  // namespace
