// SPDX-License-Identifier: Apache-2.0
// Ratios of shared volume: boxes against rational numbers, other bases against the ratio of areas, arrays, errors.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_detection.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "properties/random.hpp"

namespace volume_ratios {

using properties::Random;

constexpr double u = 0x1p-53, nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array ratios = {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_FIRST, VESICA_RATIO_OVER_SECOND,
                               VESICA_RATIO_OVER_SMALLER};

struct Box {
  vesica_aabb_f64 base;
  vesica_span_f64 span;
};

inline double ratio_of(std::int32_t ratio, const Box& a, const Box& b) {
  double out = -7;
  EXPECT_EQ(vesica_volume_ratio_f64(ratio, VESICA_AABB, &a.base, &a.span, VESICA_AABB, &b.base, &b.span, &out), 0);
  return out;
}

/// ---- The definition

inline mpq_class shared_length(double a0, double a1, double b0, double b1) {
  const mpq_class length = mpq_class(std::min(a1, b1)) - mpq_class(std::max(a0, b0));
  return length > 0 ? length : mpq_class(0);
}
inline mpq_class volume(const Box& b) {
  return (mpq_class(b.base.max_x) - b.base.min_x) * (mpq_class(b.base.max_y) - b.base.min_y) *
         (mpq_class(b.span.high) - b.span.low);
}
inline mpq_class expected(std::int32_t ratio, const Box& a, const Box& b) {
  const mpq_class shared = shared_length(a.base.min_x, a.base.max_x, b.base.min_x, b.base.max_x) *
                           shared_length(a.base.min_y, a.base.max_y, b.base.min_y, b.base.max_y) *
                           shared_length(a.span.low, a.span.high, b.span.low, b.span.high);
  const mpq_class p = volume(a), q = volume(b);
  if (ratio == VESICA_RATIO_OVER_UNION) return shared / (p + q - shared);
  if (ratio == VESICA_RATIO_OVER_FIRST) return shared / p;
  if (ratio == VESICA_RATIO_OVER_SECOND) return shared / q;
  return shared / (p < q ? p : q);
}

/// The same from the library's IoU of the bases, as a number that is exact.
inline mpq_class from_iou(std::int32_t ratio, const Box& a, const Box& b) {
  double iou = -1;
  EXPECT_EQ(vesica_iou_f64(VESICA_AABB, &a.base, VESICA_AABB, &b.base, &iou), 0);
  const mpq_class p = volume(a), q = volume(b);
  const mpq_class area = p / (mpq_class(a.span.high) - a.span.low) + q / (mpq_class(b.span.high) - b.span.low);
  const mpq_class shared =
      area * iou / (1 + mpq_class(iou)) * shared_length(a.span.low, a.span.high, b.span.low, b.span.high);
  if (ratio == VESICA_RATIO_OVER_UNION) return shared / (p + q - shared);
  if (ratio == VESICA_RATIO_OVER_FIRST) return shared / p;
  return ratio == VESICA_RATIO_OVER_SECOND || q < p ? mpq_class(shared / q) : mpq_class(shared / p);
}

/// How far from the definition, in u.
inline double error_of(std::int32_t ratio, const Box& a, const Box& b) {
  const mpq_class off = mpq_class(ratio_of(ratio, a, b)) - expected(ratio, a, b);
  return std::fabs(off.get_d()) / u;
}
/// How far from what the IoU of the bases makes, relative, in u.
inline double further_error_of(std::int32_t ratio, const Box& a, const Box& b) {
  const mpq_class want = from_iou(ratio, a, b);
  const double got = ratio_of(ratio, a, b);
  if (want == 0) return got == 0 ? 0 : 1 / u;
  const mpq_class off = (mpq_class(got) - want) / want;
  return std::fabs(off.get_d()) / u;
}

/// ---- Boxes

inline Box any_box(Random& random, double scale) {
  const auto pair = [&] {
    const double x = random.between(0, 4), y = random.between(0, 4);
    return std::array{std::min(x, y) * scale, std::max(x, y) * scale};
  };
  const auto [x0, x1] = pair();
  const auto [y0, y1] = pair();
  const auto [z0, z1] = pair();
  return {{x0, y0, x1, y1}, {z0, z1}};
}

TEST(VolumeRatio, BoxesAreAsDefined) {
  Random random(properties::seed());
  double worst = 0, further = 0;
  int shared = 0;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const double scale = std::ldexp(1, random.integer(-150, 150));
    const Box a = any_box(random, scale);
    Box b = any_box(random, scale);
    if (random.chance(0.3)) b = a, b.span.high += 0x1p-40 * b.span.high;
    if (random.chance(0.2)) b.span = {a.span.high, a.span.high + scale};  // one on the other
    shared += ratio_of(0, a, b) > 0;
    for (const std::int32_t ratio : ratios) {
      worst = std::max(worst, error_of(ratio, a, b));
      further = std::max(further, further_error_of(ratio, a, b));
    }
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, b, a), ratio_of(VESICA_RATIO_OVER_UNION, a, b));
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_SMALLER, b, a), ratio_of(VESICA_RATIO_OVER_SMALLER, a, b));
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, b, a), ratio_of(VESICA_RATIO_OVER_SECOND, a, b));
  }
  EXPECT_GT(shared, 100);
  EXPECT_LE(worst, 16);
  EXPECT_LE(further, 12);
  RecordProperty("error", std::to_string(worst));
  RecordProperty("further", std::to_string(further));
}

TEST(VolumeRatio, KnownAnswers) {
  const Box cube{{0, 0, 1, 1}, {0, 1}}, half{{0, 0, 1, 1}, {0.5, 1.5}}, tower{{0, 0, 1, 1}, {-4, 4}};
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, cube, cube), 1);
  EXPECT_DOUBLE_EQ(ratio_of(VESICA_RATIO_OVER_UNION, cube, half), 1 / 3.0);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, cube, half), 0.5);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, cube, tower), 0.125);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, cube, tower), 1);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_SECOND, cube, tower), 0.125);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_SMALLER, cube, tower), 1);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_SMALLER, tower, cube), 1);
  const Box above{{0, 0, 1, 1}, {1, 2}}, beside{{1, 0, 2, 1}, {0, 1}};
  for (const std::int32_t ratio : ratios) {
    EXPECT_EQ(ratio_of(ratio, cube, above), 0);
    EXPECT_EQ(ratio_of(ratio, cube, beside), 0);
  }
  // Heights whose difference overflows.
  const Box endless{{0, 0, 1, 1}, {-1.7e308, 1.7e308}}, upper{{0, 0, 1, 1}, {0, 1.7e308}};
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, endless, upper), 0.5);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, cube, endless), 1);
  const Box least{{0, 0, 1, 1}, {0, 0x1p-1074}};
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, least, cube), 1);
  EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, least, endless), 0);
}

TEST(VolumeRatio, SameBitsInEveryRoundingMode) {
  Random random(properties::seed());
  for (int i = 0; i < 200; ++i) {
    const Box a = any_box(random, 1), b = any_box(random, 1);
    for (const std::int32_t ratio : ratios) {
      const double expected = ratio_of(ratio, a, b);
      for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const double got = ratio_of(ratio, a, b);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(got, expected);
      }
    }
  }
}

/// A volume of 0 shares nothing, and cannot be divided by.
TEST(VolumeRatio, FlatPrisms) {
  const Box cube{{0, 0, 1, 1}, {0, 1}}, plate{{0, 0, 1, 1}, {0.5, 0.5}}, wall{{0.5, 0, 0.5, 1}, {0, 1}};
  double out = -7;
  for (const Box& flat : {plate, wall}) {
    const auto ask = [&](std::int32_t ratio, const Box& a, const Box& b) {
      return vesica_volume_ratio_f64(ratio, VESICA_AABB, &a.base, &a.span, VESICA_AABB, &b.base, &b.span, &out);
    };
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, cube, flat), 0);
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_UNION, flat, cube), 0);
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_FIRST, cube, flat), 0);
    EXPECT_EQ(ratio_of(VESICA_RATIO_OVER_SECOND, flat, cube), 0);
    EXPECT_EQ(ask(VESICA_RATIO_OVER_SECOND, cube, flat), VESICA_E_ARGUMENT);
    EXPECT_EQ(ask(VESICA_RATIO_OVER_FIRST, flat, cube), VESICA_E_ARGUMENT);
    EXPECT_EQ(ask(VESICA_RATIO_OVER_SMALLER, flat, cube), VESICA_E_ARGUMENT);
    EXPECT_EQ(ask(VESICA_RATIO_OVER_UNION, flat, flat), VESICA_E_ARGUMENT);
    EXPECT_EQ(out, -7);
  }
}

/// ---- Other bases

constexpr double corners[] = {-1, -1, 2, -1, 2, 1, 0, 3, -1, 1};

/// Some shape of each kind that has an area, and a polygon; numbers as doubles.
struct Base {
  std::int32_t kind;
  std::array<double, 7> numbers;
  vesica_polygon_f64 polygon{corners, corners + 1, 16, nullptr, 5};
  const void* shape() const { return kind == VESICA_POLYGON ? static_cast<const void*>(&polygon) : numbers.data(); }
};
const std::array<Base, 7> bases = {{{VESICA_CIRCLE, {0.2, 0.1, 1.5}},
                                    {VESICA_AABB, {-1, -1, 2, 1.5}},
                                    {VESICA_RECT, {0.3, 0, 0.8, 0.7, 1.5, 1}},
                                    {VESICA_ELLIPSE, {0, 0.4, 0.9, -0.3, 2, 0.7}},
                                    {VESICA_CAPSULE, {-1, 0, 1, 1, 0.5}},
                                    {VESICA_ROUND_RECT, {0, 0, 1, 1, 0.7, 0.4, 0.3}},
                                    {VESICA_POLYGON, {}}}};

TEST(VolumeRatio, OfOneHeightIsTheRatioOfAreas) {
  const vesica_span_f64 span{-2, 3}, higher{0.5, 3};
  for (const Base& a : bases) {
    for (const Base& b : bases) {
      for (const std::int32_t ratio : ratios) {
        double area = -1, volume = -1;
        ASSERT_EQ(vesica_ratio_f64(ratio, a.kind, a.shape(), b.kind, b.shape(), &area), 0);
        ASSERT_EQ(vesica_volume_ratio_f64(ratio, a.kind, a.shape(), &span, b.kind, b.shape(), &span, &volume), 0);
        EXPECT_NEAR(volume, area, 24 * u);
      }
      double first = -1, volume = -1;
      ASSERT_EQ(vesica_ratio_f64(VESICA_RATIO_OVER_FIRST, a.kind, a.shape(), b.kind, b.shape(), &first), 0);
      ASSERT_EQ(vesica_volume_ratio_f64(VESICA_RATIO_OVER_FIRST, a.kind, a.shape(), &span, b.kind, b.shape(), &higher,
                                        &volume),
                0);
      EXPECT_NEAR(volume, first * 0.5, 24 * u);
    }
  }
}

/// ---- Arrays

TEST(VolumeRatio, ArraysHaveTheBitsOfCalls) {
  Random random(properties::seed());
  constexpr std::int64_t n = 30, m = 300, stride = 310;
  for (const Base& base : bases) {
    if (base.kind == VESICA_POLYGON) continue;
    std::vector<std::array<double, 7>> rows;
    std::vector<vesica_polygon_f64> polygons;
    std::vector<vesica_span_f64> spans_a, spans_b;
    for (int i = 0; i < n; ++i) {
      auto row = base.numbers;
      row[0] += random.between(-0.5, 0.1);
      rows.push_back(row);
      spans_a.push_back({random.between(-1, 0), random.between(0, 1)});
    }
    for (int i = 0; i < m; ++i) {
      polygons.push_back({corners, corners + 1, 16, nullptr, random.integer(3, 5)});
      spans_b.push_back({random.between(-1, 0.5), random.between(0.5, 1)});
    }
    vesica_shapes_f64 a, b;
    ASSERT_EQ(vesica_shapes_from_records_f64(base.kind, n, rows.data(), sizeof rows[0], &a), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, m, polygons.data(), sizeof polygons[0], &b), 0);
    const auto call = [&](std::int32_t ratio, std::size_t i, std::size_t j) {
      double out = -1;
      EXPECT_EQ(vesica_volume_ratio_f64(ratio, base.kind, &rows[i], &spans_a[i], VESICA_POLYGON, &polygons[j],
                                        &spans_b[j], &out),
                0);
      return out;
    };
    for (const std::int32_t ratio : ratios) {
      std::vector<double> out(n * stride, -1);
      std::int64_t positive = 0;
      const std::int64_t found =
          vesica_volume_ratio_matrix_f64(ratio, &a, spans_a.data(), &b, spans_b.data(), out.data(), stride);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) {
          ASSERT_EQ(out[i * stride + j], call(ratio, i, j));
          positive += out[i * stride + j] > 0;
        }
        ASSERT_EQ(out[i * stride + m], -1);
      }
      EXPECT_EQ(found, positive);
      b.count = n;
      EXPECT_GT(vesica_volume_ratio_many_f64(ratio, &a, spans_a.data(), &b, spans_b.data(), out.data()), 0);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(out[i], call(ratio, i, i));
      b.count = 1;
      EXPECT_GT(vesica_volume_ratio_many_f64(ratio, &a, spans_a.data(), &b, spans_b.data(), out.data()), 0);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(out[i], call(ratio, i, 0));
      b.count = m;
    }
  }
}

TEST(VolumeRatio, Float) {
  Random random(properties::seed());
  vesica_rect_f32 rows[20];
  vesica_span_f32 spans[20];
  for (int i = 0; i < 20; ++i) {
    const auto draw = [&] { return static_cast<float>(random.between(0.5, 1.5)); };
    rows[i] = {draw(), draw(), draw(), draw(), draw(), draw()};
    spans[i] = {-draw(), draw()};
  }
  vesica_shapes_f32 a;
  ASSERT_EQ(vesica_shapes_from_records_f32(VESICA_RECT, 20, rows, sizeof rows[0], &a), 0);
  float out[400];
  for (const std::int32_t ratio : ratios) {
    ASSERT_EQ(vesica_volume_ratio_matrix_f32(ratio, &a, spans, &a, spans, out, 20), 400);
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        float single = -1;
        double wide = -1;
        const auto widen = [](const vesica_rect_f32& r) { return vesica_rect_f64{r.cx, r.cy, r.ux, r.uy, r.hx, r.hy}; };
        const vesica_rect_f64 first = widen(rows[i]), second = widen(rows[j]);
        const vesica_span_f64 p{spans[i].low, spans[i].high}, q{spans[j].low, spans[j].high};
        ASSERT_EQ(
            vesica_volume_ratio_f32(ratio, VESICA_RECT, &rows[i], &spans[i], VESICA_RECT, &rows[j], &spans[j], &single),
            0);
        ASSERT_EQ(vesica_volume_ratio_f64(ratio, VESICA_RECT, &first, &p, VESICA_RECT, &second, &q, &wide), 0);
        EXPECT_EQ(out[20 * i + j], single);
        EXPECT_NEAR(static_cast<double>(single), wide, 4 * 0x1p-24);
      }
    }
  }
}

TEST(VolumeRatio, ElementsWithErrorsAreNaN) {
  vesica_aabb_f64 boxes[] = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1e200, 1e200}};
  vesica_span_f64 spans[] = {{0, 1}, {0, 1}, {0, 1}};
  vesica_shapes_f64 a, one;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 3, boxes, sizeof boxes[0], &a), 0);
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1, boxes, 0, &one), 0);
  double out[3];
  const auto ask = [&](std::int32_t ratio) { return vesica_volume_ratio_many_f64(ratio, &a, spans, &one, spans, out); };
  EXPECT_EQ(ask(0), VESICA_E_RANGE);
  EXPECT_TRUE(out[0] == 1 && out[1] == 1 && std::isnan(out[2]));
  spans[1] = {1, 1};
  EXPECT_EQ(ask(VESICA_RATIO_OVER_FIRST), VESICA_E_ARGUMENT);
  EXPECT_TRUE(out[0] == 1 && std::isnan(out[1]) && std::isnan(out[2]));
  spans[1] = {1, 0};
  EXPECT_EQ(ask(0), VESICA_E_SHAPE);
  EXPECT_TRUE(out[0] == 1 && std::isnan(out[1]) && std::isnan(out[2]));
  spans[1] = {0, INFINITY};
  EXPECT_EQ(ask(0), VESICA_E_SHAPE);
}

TEST(VolumeRatio, Errors) {
  const vesica_aabb_f64 box{0, 0, 1, 1}, bad{1, 0, 0, 1};
  const vesica_span_f64 span{0, 1}, wrong{1, 0}, unknown{0, nan};
  double out = -7;
  const auto ask = [&](std::int32_t ratio, std::int32_t kind, const void* b, const vesica_span_f64* high) {
    return vesica_volume_ratio_f64(ratio, VESICA_AABB, &box, &span, kind, b, high, &out);
  };
  EXPECT_EQ(ask(0, VESICA_AABB, nullptr, &span), VESICA_E_NULL);
  EXPECT_EQ(ask(0, VESICA_AABB, &box, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_volume_ratio_f64(0, VESICA_AABB, &box, &span, VESICA_AABB, &box, &span, nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask(0, -1, &box, &span), VESICA_E_KIND);
  EXPECT_EQ(ask(0, 10, &box, &span), VESICA_E_KIND);
  for (const std::int32_t ratio : {-1, VESICA_RATIO_GENERALIZED, VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE, 7})
    EXPECT_EQ(ask(ratio, VESICA_AABB, &box, &span), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, VESICA_AABB, &bad, &span), VESICA_E_SHAPE);
  EXPECT_EQ(ask(0, VESICA_AABB, &box, &wrong), VESICA_E_SHAPE);
  EXPECT_EQ(ask(0, VESICA_AABB, &box, &unknown), VESICA_E_SHAPE);
  EXPECT_EQ(out, -7);
  EXPECT_EQ(ask(0, VESICA_POINT, &box, &span), 0);
  EXPECT_EQ(out, 0);
  const vesica_shapes_f64 none{VESICA_AABB, 0, 0, 0, {}, nullptr, nullptr, 0};
  EXPECT_EQ(vesica_volume_ratio_many_f64(0, &none, nullptr, &none, nullptr, nullptr), 0);
  EXPECT_EQ(vesica_volume_ratio_matrix_f64(0, &none, nullptr, &none, nullptr, nullptr, 0), 0);
  EXPECT_EQ(vesica_volume_ratio_many_f64(9, &none, nullptr, &none, nullptr, nullptr), VESICA_E_ARGUMENT);
  vesica_shapes_f64 some;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1, &box, 0, &some), 0);
  EXPECT_EQ(vesica_volume_ratio_many_f64(0, &some, nullptr, &some, &span, &out), VESICA_E_NULL);
}

}  // namespace volume_ratios
