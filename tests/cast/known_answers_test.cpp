// SPDX-License-Identifier: Apache-2.0
/// Contacts that can be worked out by hand, and what is refused.
#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <limits>

#include "cast/face.hpp"

namespace {

using namespace cast_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void expect_hit(const Pair& p, const Motion& m, double t, double x, double y, double nx, double ny) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const Answer r = cast(scalar, p, m);
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_EQ(r.t, t);
    EXPECT_EQ(r.x, x);
    EXPECT_EQ(r.y, y);
    EXPECT_EQ(r.nx, scalar == Scalar::f64 ? nx : static_cast<double>(static_cast<float>(nx)));
    EXPECT_EQ(r.ny, scalar == Scalar::f64 ? ny : static_cast<double>(static_cast<float>(ny)));
  }
}

void expect_miss(const Pair& p, const Motion& m) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const Answer r = cast(scalar, p, m);
    EXPECT_EQ(r.code, VESICA_CAST_MISS);
    EXPECT_EQ(r.t, infinity);
    EXPECT_TRUE(std::isnan(r.x) && std::isnan(r.y) && std::isnan(r.nx) && std::isnan(r.ny));
  }
}

const Pair ray_at_disc{VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {-5, 0}};
const Pair boxes{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {-5, 0.5, -4, 3}};

TEST(Known, Rays) {
  expect_hit(ray_at_disc, {1, 0, infinity}, 4, -1, 0, -1, 0);
  expect_hit(ray_at_disc, {2, 0, 2}, 2, -1, 0, -1, 0);
  expect_miss(ray_at_disc, {1, 0, 3.875});
  expect_miss(ray_at_disc, {-1, 0, infinity});
  expect_miss(ray_at_disc, {0, 0, infinity});
  expect_miss(ray_at_disc, {1, 1, infinity});
}

// The least number that is left of a way is 0 when it is divided by the speed: the time was 1 / 4, after the contact.
TEST(Known, ARayThatIsTheLeastNumberNearer) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const double beside : {least, 0x1p-1023, 0x1p-100}) {
    for (const double sign : {-1.0, 1.0}) {
      const Pair p{VESICA_AABB, VESICA_POINT, {1, 1, 4, 5}, {3, sign * beside}};
      EXPECT_EQ(cast(Scalar::f64, p, {-2, 4, infinity}).t, sign > 0 ? 0.25 - 0x1p-55 : 0.25);
    }
  }
}

TEST(Known, ARayThatGrazesADisc) {
  const Pair p{VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {-5, 1}};
  expect_hit(p, {1, 0, infinity}, 5, 0, 1, 0, 1);
  expect_miss(p, {1, 0x1p-20, infinity});
  expect_miss({VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {-5, 1 + 0x1p-23}}, {1, 0, infinity});
}

// A point has no faces: its slope is that of the curve exactly where its axis, which is arbitrary, lies.
TEST(Known, ThePointThatATipMeets) {
  for (int exponent = -4; exponent <= 60; ++exponent) {
    const double s = std::ldexp(1, exponent);
    const Pair p{VESICA_POINT, VESICA_ELLIPSE, {0, 0}, {4 * s, -3 * s, -1, 1, 3 * s, 0x1p-26 * s}};
    for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
      const Answer r = cast(scalar, p, {-2 * s, 0, infinity});
      EXPECT_EQ(r.code, VESICA_CAST_HIT);
      EXPECT_EQ(r.t, 0.5) << exponent;
      EXPECT_NEAR(r.nx, std::sqrt(0.5), 1e-7);
      EXPECT_NEAR(r.ny, -std::sqrt(0.5), 1e-7);
    }
  }
}

// Half lengths of 2^-577 along an axis of 2^177: no product of the two lengths may be taken alone. Contact comes
// between t and the next double, by rational arithmetic.
TEST(Known, AnEllipseOfTinyNumbersOnALongAxis) {
  const Pair p{VESICA_ELLIPSE,
               VESICA_POINT,
               {0x1.73cf305154d98p-400, -0x1.4a7c77b3cc658p-398, 0x1.88cbb4804e814p+177, -0x1.6b3c19d47559p+175,
                0x1.227aaba16237p-577, 0x1.5a32fb613cd49p-593},
               {0x1.8e42f1ba83bcp-399, 0x1.efee8d669a4a8p-399}};
  const double vx = -0x1.99667f5b09452p+20, vy = -0x1.c3da71a22df5fp+26, t = 0x1.5484748e71e73p-424;
  for (const double end : {0x1p-425, std::nextafter(t, 0), t}) {
    EXPECT_EQ(cast(Scalar::f64, p, {vx, vy, end}).code, VESICA_CAST_MISS);
  }
  for (const double end : {std::nextafter(t, 1), infinity}) {
    const Answer r = cast(Scalar::f64, p, {vx, vy, end});
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_EQ(r.t, t);
  }
}

TEST(Known, Faces) {
  expect_hit(boxes, {1, 0, infinity}, 4, 0, 0.75, -1, 0);  // the middle of what faces share
  expect_hit(boxes, {1, 0, 4}, 4, 0, 0.75, -1, 0);
  const Pair disc_on_box{VESICA_RECT, VESICA_CIRCLE, {0, 0, 0, 2, 1, 3}, {1, 10, 2}};
  expect_hit(disc_on_box, {0, -1, infinity}, 6, 1, 2, 0, 1);
}

// The square of an edge's length underflows beside the other's: the point was NaN, and the answer that it is out of
// range.
TEST(Known, AnEdgeOfAlmostNoLength) {
  constexpr double w = 0x1p-600;
  for (const Pair& p : {Pair{VESICA_AABB, VESICA_AABB, {0, 0, w, 1}, {-1, -3, 1, -2}},
                        Pair{VESICA_SEGMENT, VESICA_AABB, {0, 0, w, 0}, {-1, -3, 1, -2}},
                        Pair{VESICA_RECT, VESICA_AABB, {0.5 * w, 0.5, 1, 0, 0.5 * w, 0.5}, {-1, -3, 1, -2}}}) {
    const Answer r = cast(Scalar::f64, p, {0, 1, infinity});
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_TRUE(r.t == 2 && r.x == 0.5 * w && r.y == 0 && r.nx == 0 && r.ny == -1);
    const Answer s = cast(Scalar::f64, swapped(p), {0, -1, infinity});
    EXPECT_TRUE(s.code == VESICA_CAST_HIT && s.t == 2 && std::fabs(s.x) <= 1 && s.y == -2 && s.ny == 1);
  }
}

TEST(Known, ASlideAlongAFaceTouches) {
  const Pair p{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {-5, 1, -4, 2}};
  expect_hit(p, {1, 0, infinity}, 4, 0, 1, 0, 1);
  const Pair disc{VESICA_AABB, VESICA_CIRCLE, {0, 0, 1, 1}, {-5, 2, 1}};
  expect_hit(disc, {1, 0, infinity}, 5, 0, 1, 0, 1);
}

// A short segment slides down another from its end, away from it by 2^-50 of its way, and touches it a little later. Of
// the long one's normal errors hide nearly all of the time; the axes of the short one tell times before that, and were
// taken for the last: the point was the end, the normal not of the contact.
TEST(Known, ASlideThatTouchesBesideTheEnd) {
  constexpr double t = 0x1p-43;
  const Numbers slope{0, 0, -2, 1, 0, 1}, upright{1, 0x1.ffffffffffffcp+0, 1, 0, 0, 0x1.ffffffffffp-51};
  const Pair a_pair{VESICA_RECT, VESICA_ELLIPSE, slope, upright};
  for (const double end : {1.0, infinity}) {
    const Answer r = cast(Scalar::f64, a_pair, {-1, -0x1.ffffffffffffp+0, end});
    EXPECT_TRUE(r.code == VESICA_CAST_HIT && r.t == t && r.x == 1 - t && r.y == 2 - 2 * t);
    EXPECT_TRUE(r.nx == 0x1.c9f25c5bfedd9p-1 && r.ny == -0x1.c9f25c5bfedd9p-2);
    const Answer s = cast(Scalar::f64, swapped(a_pair), {1, 0x1.ffffffffffffp+0, end});
    EXPECT_TRUE(s.code == VESICA_CAST_HIT && s.t == t && s.nx == -r.nx && s.ny == -r.ny);
    EXPECT_TRUE(s.x == 1 && std::fabs(s.y - 2) <= 0x1p-48);
  }
}

// A needle so thin that it is a segment slides along another, and meets it at the middle of its side. The vertex's
// normal tells no time, for errors hide all of it; the needle's own, along the way, told one before contact and was
// taken: the point was the other one's tip.
TEST(Known, ANeedleThatSlidesAlongAnother) {
  const Pair pairs[] = {
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0, 1, 0x1p-46, 0x1.bcfec77241f44p+0, 0x1.8a693639f59f4p-29},
       {-0x1.b074628cd23fp-6, 0x1.8a6932d90fb57p-29, 1, 0x1p-46, 0x1.0228dd5cea682p-3, 0x1.6dbb0296ef3fp-68}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0, 0x1.433a1b33a09e6p-4, 0, 0x1.12ecd963c967cp+4, 0x1.9ce4001e125d9p-40},
       {0x1.5535f527e5b28p-2, 0x1.04a8b1d6a4dd7p-43, 0x1.433a1b33a09e6p-4, 0, 0x1.fd7160327b33cp-16,
        0x1.fd7160327b33cp-81}}};
  const Motion motions[] = {{8, 0x1p-43, 4}, {-0.25, -0.0, 4}};
  for (int i = 0; i < 2; ++i) {
    const Answer r = cast(Scalar::f64, pairs[i], motions[i]);
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_LT(std::fabs(r.x), 0x1p-48);
    EXPECT_LT(std::fabs(r.nx), 0x1p-45);
    EXPECT_EQ(r.ny, 1);
  }
}

// A needle flies at a disc. Newton's method for the direction went in a circle, and what it had after 80
// steps was taken: the point was on the disc, but a quarter of the needle's length off.
TEST(Known, ANeedleThatPassesADisc) {
  const Pair p{VESICA_CIRCLE,
               VESICA_ELLIPSE,
               {0, 0, 0x1.33cp+0},
               {1, 0x1.337bp+0, 0x1.fep-1, -0x1.5bp-4, 0x1.c1p-5, 0x1.48p-12}};
  const double t = 0x1.de0841106caf3p-1, x = 0x1.8e146e20764d3p-4, y = 0x1.32be1dd10352cp+0;
  const Answer r = cast(Scalar::f64, p, {-1, 0, infinity});
  EXPECT_TRUE(r.code == VESICA_CAST_HIT && r.t == t);
  EXPECT_LT(std::hypot(r.x - x, r.y - y), 0x1p-40);
  EXPECT_LT(std::hypot(r.nx - x / 0x1.33cp+0, r.ny - y / 0x1.33cp+0), 0x1p-40);
}

TEST(Known, PointsOnOneLine) {
  const Pair p{VESICA_POINT, VESICA_POINT, {6, 8}, {0, 0}};
  expect_hit(p, {3, 4, infinity}, 2, 6, 8, -0.6, -0.8);
  expect_miss(p, {3, 4.000001, infinity});
  const Pair segments{VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, 1, 0}, {-4, 0, -2, 0}};
  expect_hit(segments, {1, 0, infinity}, 2, 0, 0, -1, 0);
}

TEST(Known, ABoxThatComesFromOneSideAndSlowlyFromAnother) {
  // In the unit of the longer sides the slow component of the velocity is 0. It tells the time.
  const Pair p{VESICA_POINT,
               VESICA_AABB,
               {0, 0},
               {-0x1.97d4320e6db0cp+649, -0x1.e19b35356a018p-649, -0x1.2ce4ddc307628p+646, -0x1.ee56d32c14b2p-652}};
  const double vx = 0x1.97d4320e6db0cp+648, vy = 0x1.e19b35356a018p-650;
  const Answer r = cast(Scalar::f64, p, {vx, vy, 6});
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_EQ(r.t, 0x1.06c4aa095c3c2p-2);
  EXPECT_EQ(cast(Scalar::f64, p, {vx, vy, 0.25}).code, VESICA_CAST_MISS);
}

/// The greatest number is a time as any other; later contact has none.
TEST(Known, AtTheGreatestTime) {
  constexpr double most = std::numeric_limits<double>::max();
  const struct {
    std::int32_t kind;
    double numbers[6];
  } still[] = {{VESICA_POINT, {most, 0}},
               {VESICA_SEGMENT, {most, -1, most, 1}},
               {VESICA_CIRCLE, {most, 0, 0}},
               {VESICA_AABB, {most, -1, most, 1}},
               {VESICA_RECT, {most, 0, 0, 1, 2, 0}},
               {VESICA_ELLIPSE, {most, 0, 0, 1, 2, 0}}},
    moving[] = {
        {VESICA_POINT, {0, 0}},        {VESICA_SEGMENT, {-5, 0, 0, 0}},    {VESICA_CIRCLE, {-1, 0, 1}},
        {VESICA_AABB, {-2, -1, 0, 1}}, {VESICA_RECT, {-2, 0, 0, 1, 1, 2}}, {VESICA_ELLIPSE, {-2, 0, 1, 0, 2, 1}}};
  for (const auto& a : still) {
    for (const auto& b : moving) {
      const auto ask = [&](double shift, double vx, double end, vesica_impact_f64& out) {
        auto shifted = b;
        shifted.numbers[0] += shift;
        if (b.kind == VESICA_SEGMENT || b.kind == VESICA_AABB) shifted.numbers[2] += shift;
        const std::int32_t code = vesica_cast_f64(a.kind, a.numbers, b.kind, shifted.numbers, vx, 0, end, &out);
        vesica_impact_f64 exchanged;
        EXPECT_EQ(vesica_cast_f64(b.kind, shifted.numbers, a.kind, a.numbers, -vx, 0, end, &exchanged), code);
        return code;
      };
      vesica_impact_f64 out;
      for (const double end : {most, infinity}) {
        EXPECT_EQ(ask(0, 1, end, out), VESICA_CAST_HIT) << a.kind << ' ' << b.kind;
        EXPECT_EQ(out.t, most) << a.kind << ' ' << b.kind;
        EXPECT_EQ(out.x, most);
      }
      EXPECT_EQ(ask(0, 1, std::nextafter(most, 0), out), VESICA_CAST_MISS);
      EXPECT_EQ(ask(0, 0.5, infinity, out), VESICA_E_RANGE);
      EXPECT_EQ(ask(-0.25, 1, infinity, out), VESICA_E_RANGE) << a.kind << ' ' << b.kind;
      EXPECT_EQ(ask(-0.25, 1, most, out), VESICA_CAST_MISS);
      EXPECT_EQ(ask(0.25, 1, infinity, out), VESICA_CAST_HIT);
      EXPECT_EQ(out.t, std::nextafter(most, 0)) << a.kind << ' ' << b.kind;
    }
  }
}

TEST(Known, AtTheStart) {
  const Pair touching{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {1, 0, 3, 1}};
  for (const double vx : {-1.0, 0.0, 1.0}) {
    const Answer r = cast(Scalar::f64, touching, {vx, 0, 5});
    EXPECT_EQ(r.code, VESICA_CAST_START);
    EXPECT_EQ(r.t, 0);
    EXPECT_EQ(r.x, 1);
    EXPECT_EQ(r.nx, 1);
    EXPECT_EQ(r.ny, 0);
  }
}

TEST(Known, Refused) {
  const auto code = [](const Pair& p, const Motion& m) { return cast(Scalar::f64, p, m).code; };
  EXPECT_EQ(code(boxes, {nan, 0, 1}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, {0, infinity, 1}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, {1, 0, -1}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, {1, 0, nan}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({VESICA_AABB, VESICA_POLYLINE + 1, {}, {}}, {1, 0, 1}), VESICA_E_KIND);
  EXPECT_EQ(code({VESICA_CIRCLE, VESICA_POINT, {0, 0, -1}, {5, 0}}, {1, 0, 1}), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_CIRCLE, VESICA_POINT, {0, 0, -1}, {5, 0}}, {0, 0, 1}), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {nan, 0}}, {1, 0, 1}), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_POINT, VESICA_POINT, {1e300, 0}, {0, 0}}, {1e-300, 0, infinity}), VESICA_E_RANGE);
  EXPECT_EQ(code({VESICA_POINT, VESICA_POINT, {1e300, 0}, {0, 0}}, {1e-300, 0, 1}), VESICA_CAST_MISS);
  vesica_impact_f64 out{7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_cast_f64(0, nullptr, 0, boxes.b.data(), 1, 0, 1, &out), VESICA_E_NULL);
  EXPECT_EQ(vesica_cast_f64(0, boxes.a.data(), 0, boxes.b.data(), 1, 0, 1, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_cast_f64(2, boxes.a.data(), VESICA_POLYLINE + 1, boxes.b.data(), nan, 0, 1, &out), VESICA_E_KIND);
  EXPECT_EQ(out.t, 7);
}

// A size below 0 is no smaller sum, whatever the other's is, and whether the sum would be met or not.
TEST(Known, NegativeSizesAreRefusedOnEveryWay) {
  const Pair pairs[] = {{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, -1}, {5, 0, 2}},
                        {VESICA_CIRCLE, VESICA_POINT, {0, 0, -1}, {5, 0}},
                        {VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, -1, 1}, {5, 0, 1, 0, 2, 2}},
                        {VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, 1, -1}, {5, 0, 1, 0, 2, 2}},
                        {VESICA_ELLIPSE, VESICA_POINT, {0, 0, 1, 0, 1, -1}, {5, 0}},
                        {VESICA_RECT, VESICA_POINT, {0, 0, 1, 0, 2, -1}, {5, 0}},
                        {VESICA_RECT, VESICA_POINT, {0, 0, 1, 0, -1, 2}, {5, 0}},
                        {VESICA_AABB, VESICA_POINT, {1, 0, 0, 1}, {5, 0}},
                        {VESICA_RECT, VESICA_RECT, {0, 0, 1, 0, -1, 1}, {5, 0, 1, 0, 2, 2}}};
  for (const Pair& p : pairs) {
    for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
      for (const Motion& m : {Motion{-1, 0, infinity}, Motion{1, 0, infinity}, Motion{0, 1, 2}, Motion{-1, 0, 0.5}}) {
        EXPECT_EQ(cast(scalar, p, m).code, VESICA_E_SHAPE) << properties::describe(p);
        EXPECT_EQ(cast(scalar, swapped(p), m).code, VESICA_E_SHAPE) << properties::describe(p);
      }
    }
  }
}

// Half of the least number is 0: by half widths these boxes were valid, and a ray that misses them got an answer.
TEST(Known, BoxesThatAreInvertedByTheLeastNumberAreRefused) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const Motion& m : {Motion{1, 0, infinity}, Motion{-1, 0, infinity}, Motion{0, 1, 2}, Motion{-1, -1, 0.5}}) {
    for (const double x : {-50.0, 0.0, 50.0}) {
      EXPECT_EQ(cast(Scalar::f64, {VESICA_AABB, VESICA_POINT, {least, -1, 0, 1}, {x, 50}}, m).code, VESICA_E_SHAPE);
      EXPECT_EQ(cast(Scalar::f64, {VESICA_AABB, VESICA_POINT, {-1, 0, 1, -least}, {x, 50}}, m).code, VESICA_E_SHAPE);
    }
  }
}

TEST(Known, SweptBounds) {
  const double disc[] = {1, 2, 3};
  vesica_aabb_f64 box{};
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, 2, -1, 4, &box), 0);
  EXPECT_EQ(box.min_x, -2);
  EXPECT_EQ(box.max_y, 5);
  EXPECT_NEAR(box.max_x, 12, 4e-15);
  EXPECT_GT(box.max_x, 12);
  EXPECT_NEAR(box.min_y, -5, 4e-15);
  EXPECT_LT(box.min_y, -5);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, 0, 0, infinity, &box), 0);
  EXPECT_EQ(box.max_x, 4);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, 1, 0, infinity, &box), VESICA_E_RANGE);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, nan, 0, 1, &box), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, 1, 0, -1, &box), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POLYLINE + 1, disc, 1, 0, 1, &box), VESICA_E_KIND);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_CIRCLE, disc, 1, 0, 1, nullptr), VESICA_E_NULL);
}

TEST(Known, SweptBoundsLeaveErrnoAlone) {
  const double least = 0x1p-1074, origin[] = {0, 0};
  vesica_aabb_f64 box{};
  errno = 0;
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POINT, origin, least, -least, 1, &box), 0);
  EXPECT_TRUE(box.min_x == 0 && box.max_x >= least && box.max_x <= 3 * least) << box.max_x;
  EXPECT_TRUE(box.max_y == 0 && box.min_y <= -least && box.min_y >= -3 * least) << box.min_y;
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POINT, origin, 0x1p1000, 0, 0x1p100, &box), VESICA_E_RANGE);
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POINT, origin, -0x1p1000, 0, 0x1p100, &box), VESICA_E_RANGE);
  EXPECT_EQ(errno, 0);
}

}  // namespace
