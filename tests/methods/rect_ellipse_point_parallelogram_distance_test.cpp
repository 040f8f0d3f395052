// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vesica/methods/rect_ellipse_point_parallelogram_distance.hpp>

#include "methods/exact_method.hpp"
#include "methods/rect_ellipse_cases.hpp"

namespace {

using namespace method_pairs;

std::int32_t answer_f64(const vesica_rect_f64* rect, const vesica_ellipse_f64* ellipse) {
  vesica_metric_closest_f64 out;
  return vesica_method_rect_ellipse_point_parallelogram_distance_f64(rect, ellipse, &out);
}
std::int32_t answer_f32(const vesica_rect_f32* rect, const vesica_ellipse_f32* ellipse) {
  vesica_metric_closest_f32 out;
  return vesica_method_rect_ellipse_point_parallelogram_distance_f32(rect, ellipse, &out);
}

struct Closest {
  const char* what;
  vesica_rect_f64 rect;
  vesica_ellipse_f64 ellipse;
  double x, y, c_min;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

// All but the skewed ones are exact in both scalars.
constexpr Closest cases[] = {
    {"disc before a face", {0, 0, 1, 0, 1, 1}, {4, 0, 1, 0, 1, 1}, 1, 0, 8},
    {"disc over a face", {0, 0, 1, 0, 1, 1}, {2, 0.5, 1, 0, 2, 2}, 1, 0.5, -0.75},
    {"flat ellipse above", {0, 0, 1, 0, 1, 1}, {0, 4, 1, 0, 2, 1}, 0, 1, 8},
    {"corner at contact", {0, 0, 1, 0, 1, 1}, {4, 5, 1, 0, 5, 5}, 1, 1, 0},
    {"corner inside", {0, 0, 1, 0, 1, 1}, {4, 5, 1, 0, 10, 10}, 1, 1, -0.75},
    {"end of a face", {0, 0, 1, 0, 1, 1}, {1, 3, 1, 0, 1, 1}, 1, 1, 3},
    {"centre in the rectangle", {1, 2, 3, 4, 2, 2}, {2, 2, 1, 0, 1, 3}, 2, 2, -1},
    {"centre on the outline", {0, 0, 1, 0, 1, 1}, {1, 0.5, 1, 1, 1, 3}, 1, 0.5, -1},
    // On y = 1, 2 below the centre: ((x - 2) / 4)^2 + ((x + 2) / 2)^2 - 1 is least at x = -6/5, where it is -1/5.
    {"metric, not nearest, point", {0, 0, 1, 0, 5, 1}, {0, 3, 1, 1, 2, 1}, -1.2, 1, -0.2},
    // The same cut short at x = -1/2: (5/8)^2 + (3/4)^2 - 1.
    {"metric, cut short", {0, 0, 1, 0, 0.5, 1}, {0, 3, 1, 1, 2, 1}, -0.5, 1, -0.046875},
    {"point", {0, 0, 1, 0, 1, 1}, {4, 5, 1, 0, 0, 0}, 1, 1, infinity},
    {"segment up to a face", {0, 0, 1, 0, 1, 1}, {3, 0, 1, 0, 2, 0}, 1, 0, 0},
    {"segment short of a face", {0, 0, 1, 0, 1, 1}, {3, 0, 0, 1, 0, 1}, 1, 0, 3},
    {"segment beside the rectangle", {0, 0, 1, 0, 1, 1}, {3, 5, 1, 0, 2, 0}, 1, 1, infinity},
    // The line y = x - 1 enters at (1, 0), 2 (1, 1) from the centre.
    {"slanting segment", {0, 0, 1, 0, 1, 1}, {3, 2, 1, 1, 4, 0}, 1, 0, -0.75},
    {"segment along a face", {0, 0, 1, 0, 1, 1}, {0.5, 2, 1, 0, 4, 0}, 0.5, 1, infinity},
    {"rectangle without size", {1, 1, 1, 0, 0, 0}, {4, 5, 1, 0, 5, 5}, 1, 1, 0},
};

TEST(RectEllipsePointParallelogramDistance, KnownPoints) {
  for (const Closest& known : cases) {
    const std::int32_t answer = known.c_min <= 0 ? 1 : 0;
    vesica_metric_closest_f64 out;
    EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&known.rect, &known.ellipse, &out), answer)
        << known.what;
    EXPECT_DOUBLE_EQ(out.x, known.x) << known.what;
    EXPECT_DOUBLE_EQ(out.y, known.y) << known.what;
    EXPECT_DOUBLE_EQ(out.c_min, known.c_min) << known.what;
  }
}

TEST(RectEllipsePointParallelogramDistance, KnownPointsInFloat) {
  const auto f = [](double x) { return static_cast<float>(x); };
  for (const Closest& known : cases) {
    const auto& [cx, cy, ux, uy, hx, hy] = known.rect;
    const auto& [kx, ky, vx, vy, a, b] = known.ellipse;
    const vesica_rect_f32 rect{f(cx), f(cy), f(ux), f(uy), f(hx), f(hy)};
    const vesica_ellipse_f32 ellipse{f(kx), f(ky), f(vx), f(vy), f(a), f(b)};
    vesica_metric_closest_f32 out;
    EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f32(&rect, &ellipse, &out), known.c_min <= 0)
        << known.what;
    EXPECT_FLOAT_EQ(out.x, f(known.x)) << known.what;
    EXPECT_FLOAT_EQ(out.y, f(known.y)) << known.what;
    EXPECT_FLOAT_EQ(out.c_min, f(known.c_min)) << known.what;
  }
}

// Lengths that double cannot square, and axes longer still.
TEST(RectEllipsePointParallelogramDistance, KnownPointsAtEveryScale) {
  for (const int exponent : {-1000, -400, 400, 1000}) {
    for (const Closest& known : cases) {
      const auto s = [&](double x) { return std::ldexp(x, exponent); };
      const auto& [cx, cy, ux, uy, hx, hy] = known.rect;
      const auto& [kx, ky, vx, vy, a, b] = known.ellipse;
      const vesica_rect_f64 rect{s(cx), s(cy), s(ux), s(uy), hx, hy};
      const vesica_ellipse_f64 ellipse{s(kx), s(ky), vx, vy, s(a), s(b)};
      vesica_metric_closest_f64 out;
      EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &ellipse, &out), known.c_min <= 0)
          << known.what;
      EXPECT_DOUBLE_EQ(out.x, s(known.x)) << known.what << ", times 2^" << exponent;
      EXPECT_DOUBLE_EQ(out.y, s(known.y)) << known.what << ", times 2^" << exponent;
      EXPECT_DOUBLE_EQ(out.c_min, known.c_min) << known.what << ", times 2^" << exponent;
    }
  }
}

/// The ellipse's level at a point, in a longer format.
long double level(const vesica_ellipse_f64& e, long double x, long double y) {
  const long double vv = static_cast<long double>(e.ux) * e.ux + static_cast<long double>(e.uy) * e.uy;
  const long double dx = x - e.cx, dy = y - e.cy;
  const long double s = (e.ux * dx + e.uy * dy) / (vv * e.a), t = (e.ux * dy - e.uy * dx) / (vv * e.b);
  return s * s + t * t - 1;
}

// No point of the outline has a lower level than P, P's level is c_min, and P lies in the rectangle.
TEST(RectEllipsePointParallelogramDistance, LeastLevelOfTheOutline) {
  properties::Stream stream(properties::Workload::random, VESICA_RECT, VESICA_ELLIPSE, Scalar::f64, properties::seed());
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Pair pair = stream.next();
    vesica_rect_f64 rect;
    vesica_ellipse_f64 ellipse;
    std::memcpy(&rect, pair.a.data(), sizeof rect);
    std::memcpy(&ellipse, pair.b.data(), sizeof ellipse);
    vesica_metric_closest_f64 out;
    const std::int32_t answer = vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &ellipse, &out);
    ASSERT_EQ(answer, out.c_min <= 0 ? 1 : 0);
    if (out.c_min == -1) continue;
    const auto at = static_cast<double>(level(ellipse, out.x, out.y));
    ASSERT_NEAR(at, out.c_min, 1e-12 * (1 + std::abs(out.c_min))) << properties::describe(pair);
    const vesica_rect_f64 grown{rect.cx, rect.cy, rect.ux, rect.uy, rect.hx + 1e-14, rect.hy + 1e-14};
    const vesica_point_f64 point{out.x, out.y};
    ASSERT_EQ(vesica_overlap_point_rect_f64(&point, &grown), 1) << properties::describe(pair);
    for (int k = 0; k < 64; ++k) {
      const long double along = (k % 16) / 7.5L - 1, side = k < 32 ? 1 : -1;
      const long double s = k % 32 < 16 ? along : side, t = k % 32 < 16 ? side : along;
      const long double x = rect.cx + s * rect.hx * rect.ux - t * rect.hy * rect.uy;
      const long double y = rect.cy + s * rect.hx * rect.uy + t * rect.hy * rect.ux;
      ASSERT_GE(static_cast<double>(level(ellipse, x, y)), out.c_min - 1e-12 * (1 + std::abs(out.c_min)))
          << properties::describe(pair);
    }
  }
}

// The rectangle reaches to twice the largest number; an ellipse that leans over there has its metric-closest point
// there.
TEST(RectEllipsePointParallelogramDistance, PointBeyondTheRange) {
  constexpr double largest = std::numeric_limits<double>::max();
  const vesica_rect_f64 rect{largest, 0, 1, 0, largest, 1};
  const vesica_ellipse_f64 leaning_out{largest, largest, 1, -1, largest / 4, largest / 4000};
  const vesica_ellipse_f64 leaning_in{largest, largest, 1, 1, largest / 4, largest / 4000};
  vesica_metric_closest_f64 out{1, 2, 3};
  EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &leaning_out, &out), VESICA_E_RANGE);
  EXPECT_EQ(out.x, 1);
  EXPECT_EQ(out.y, 2);
  EXPECT_EQ(out.c_min, 3);
  EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &leaning_in, &out), 0);
  EXPECT_NEAR(out.x / largest, 0, 1e-5);
  // For the axis (1, 1), 1 of 4 half lengths by 1: ((1, 1).(1, 1) / 2) / (1 / 4) = 4 half lengths away.
  EXPECT_NEAR(out.c_min, 15, 1e-4);
}

TEST(RectEllipsePointParallelogramDistance, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(scalar, method<answer_f64, answer_f32>(scalar));
  }
}

TEST(RectEllipsePointParallelogramDistance, InvalidInput) {
  InvalidInput<answer_f64>::expect_errors();
  InvalidInput<answer_f32>::expect_errors();
  const vesica_rect_f64 rect{0, 0, 1, 0, 1, 1};
  const vesica_ellipse_f64 ellipse{0, 0, 0, 0, 1, 1};
  vesica_metric_closest_f64 out{1, 2, 3};
  EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &ellipse, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_rect_ellipse_point_parallelogram_distance_f64(&rect, &ellipse, &out), VESICA_E_SHAPE);
  EXPECT_EQ(out.x, 1);
  EXPECT_EQ(out.y, 2);
  EXPECT_EQ(out.c_min, 3);
}

TEST(RectEllipsePointParallelogramDistance, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("point_parallelogram_distance", method<answer_f64, answer_f32>(scalar), VESICA_RECT,
                            VESICA_ELLIPSE, scalar);
  }
}

TEST(RectEllipsePointParallelogramDistance, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("point_parallelogram_distance", method<answer_f64, answer_f32>(scalar), VESICA_RECT,
                               VESICA_ELLIPSE, scalar);
  }
}

TEST(RectEllipsePointParallelogramDistance, Core) {
  using namespace vesica;
  methods::MetricClosest<double> out{};
  static_assert(noexcept(methods::point_parallelogram_distance(Rect<double>{}, Ellipse<double>{}, out)));
  EXPECT_EQ(
      methods::point_parallelogram_distance(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{4, 5, 1, 0, 5, 5}, out), 1);
  EXPECT_EQ(out.c_min, 0);
}

}  // namespace
