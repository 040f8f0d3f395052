// SPDX-License-Identifier: Apache-2.0
// Distances of Gaussians: against their definitions by matrices in 384 bits, known answers, laws, arrays, errors.
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
#include <vesica/arithmetic/exponential.hpp>
#include <vesica/arithmetic/logarithm.hpp>

#include "area/real.hpp"
#include "properties/random.hpp"

namespace gaussian_distances {

using properties::Random;
using reference::Real;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double u = 0x1p-53;
constexpr std::array kinds = {VESICA_CIRCLE, VESICA_AABB, VESICA_RECT, VESICA_ELLIPSE};
constexpr std::array names = {"Bhattacharyya", "Hellinger", "Kullback-Leibler", "Wasserstein"};

struct Shape {
  std::int32_t kind;
  std::array<double, 6> numbers;
};

/// ---- The definitions

struct Matrix {
  Real xx, xy, yy;
};
inline Matrix operator+(const Matrix& a, const Matrix& b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
inline Real det(const Matrix& m) { return m.xx * m.yy - m.xy * m.xy; }
inline Real trace_of_product(const Matrix& a, const Matrix& b) {
  return a.xx * b.xx + Real(2.0) * a.xy * b.xy + a.yy * b.yy;
}
inline Matrix adjoint(const Matrix& m) { return {m.yy, -m.xy, m.xx}; }
/// v' m v
inline Real form(const Matrix& m, const Real& x, const Real& y) {
  return m.xx * x * x + Real(2.0) * m.xy * x * y + m.yy * y * y;
}

struct Gaussian {
  Real x, y;
  Matrix covariance;
};

/// Half sizes along and across an axis, the variances of which are the squares by a third or a quarter.
inline Gaussian of_axis(const Real& x, const Real& y, const Real& ux, const Real& uy, const Real& along,
                        const Real& across, double divisor) {
  const Real p = along * along / Real(divisor), q = across * across / Real(divisor);
  return {x, y, {p * ux * ux + q * uy * uy, (p - q) * ux * uy, p * uy * uy + q * ux * ux}};
}
inline Gaussian gaussian(const Shape& s) {
  const auto& [a, b, c, d, e, f] = s.numbers;
  const Real half(0.5);
  switch (s.kind) {
    case VESICA_CIRCLE:
      return of_axis(a, b, 1, 0, c, c, 4);
    case VESICA_AABB:
      return of_axis(half * (Real(a) + Real(c)), half * (Real(b) + Real(d)), 1, 0, half * (Real(c) - Real(a)),
                     half * (Real(d) - Real(b)), 3);
    case VESICA_RECT:
      return of_axis(a, b, c, d, e, f, 3);
    default:
      return of_axis(a, b, c, d, e, f, 4);
  }
}

inline Real expected(std::int32_t which, const Shape& s, const Shape& t) {
  const Gaussian a = gaussian(s), b = gaussian(t);
  const Real x = a.x - b.x, y = a.y - b.y, det_a = det(a.covariance), det_b = det(b.covariance);
  if (which == VESICA_GAUSSIAN_WASSERSTEIN) {
    const Real root = sqrt(trace_of_product(a.covariance, b.covariance) + Real(2.0) * sqrt(det_a * det_b));
    return x * x + y * y + a.covariance.xx + a.covariance.yy + b.covariance.xx + b.covariance.yy - Real(2.0) * root;
  }
  if (which == VESICA_GAUSSIAN_KULLBACK_LEIBLER) {
    const Matrix inverse = adjoint(b.covariance);  // times det_b
    return Real(0.5) * (trace_of_product(inverse, a.covariance) / det_b - Real(2.0) + form(inverse, x, y) / det_b +
                        log(det_b / det_a));
  }
  const Matrix sum = a.covariance + b.covariance;
  const Real det_mean = det(sum) / Real(4.0);
  const Real distance =
      form(adjoint(sum), x, y) / det(sum) / Real(4.0) + Real(0.5) * log(det_mean / sqrt(det_a * det_b));
  if (which == VESICA_GAUSSIAN_BHATTACHARYYA) return distance;
  const Real square = Real(1.0) - exp(-distance);
  return square < Real(0.0) ? Real(0.0) : sqrt(square);
}

/// ---- Shapes

inline Shape any(std::int32_t kind, Random& random, double thin = 1) {
  const double x = random.between(-3, 3), y = random.between(-3, 3), size = random.between(0.2, 2);
  const double angle = random.between(0, 7), other = random.between(0.2, 2) / thin;
  if (kind == VESICA_CIRCLE) return {kind, {x, y, size}};
  if (kind == VESICA_AABB) return {kind, {x, y, x + size, y + other}};
  return {kind, {x, y, std::cos(angle), std::sin(angle), size, other}};
}
/// Each number changed by at most `part` of it, or the shape itself if that is no shape with an area.
inline Shape nearly(const Shape& from, double part, Random& random) {
  Shape s = from;
  for (double& x : s.numbers) x += x * part * random.between(-1, 1);
  const bool empty = s.kind == VESICA_AABB && !(s.numbers[0] < s.numbers[2] && s.numbers[1] < s.numbers[3]);
  return empty ? from : s;
}
inline double distance(std::int32_t which, const Shape& a, const Shape& b) {
  double out = -1;
  EXPECT_EQ(vesica_gaussian_distance_f64(which, a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 0);
  return out;
}

/// The largest error in units of u, of the result or of the least number.
struct Worst {
  std::array<double, 4> error{};

  void check(const Shape& a, const Shape& b) {
    for (std::int32_t which = 0; which < 4; ++which) {
      const Real want = expected(which, a, b);
      const double got = distance(which, a, b);
      const Real off = abs(Real(got) - want);
      if (off <= Real(0x1p-300)) continue;  // rounding of the reference
      auto& most = error[static_cast<std::size_t>(which)];
      most = std::max(most, static_cast<double>(off / want / Real(u)));
    }
  }
  void expect_at_most(double bound) const {
    for (std::size_t which = 0; which < 4; ++which) {
      EXPECT_LE(error[which], bound) << names[which];
      ::testing::Test::RecordProperty(names[which], std::to_string(error[which]));
    }
  }
};

TEST(GaussianDistance, AnyShapesAreAsDefined) {
  Random random(properties::seed());
  Worst worst;
  const int cases = 200 * properties::repeat();
  for (const std::int32_t a : kinds) {
    for (const std::int32_t b : kinds) {
      for (int i = 0; i < cases; ++i) worst.check(any(a, random), any(b, random));
    }
  }
  worst.expect_at_most(24);
}

TEST(GaussianDistance, NearlyEqualShapesAreAsDefined) {
  Random random(properties::seed());
  Worst worst;
  const int cases = 1000 * properties::repeat();
  for (const std::int32_t kind : kinds) {
    for (int i = 0; i < cases; ++i) {
      const Shape a = any(kind, random, std::ldexp(1, random.below(40)));
      worst.check(a, nearly(a, std::ldexp(1, -random.integer(2, 52)), random));
    }
  }
  worst.expect_at_most(24);
}

TEST(GaussianDistance, ThinShapesFarAwayOrOfUnlikeSizesAreAsDefined) {
  Random random(properties::seed());
  Worst worst;
  const int cases = 300 * properties::repeat();
  for (const std::int32_t a : {VESICA_AABB, VESICA_RECT, VESICA_ELLIPSE}) {
    for (const std::int32_t b : kinds) {
      for (int i = 0; i < cases; ++i) {
        const Shape first = any(a, random, std::ldexp(1, random.below(45)));
        Shape second = any(b, random, std::ldexp(1, random.below(45)));
        if (random.chance(0.3)) second = nearly(second, 0x1p-30, random);
        if (random.chance(0.5)) {
          const double away = std::ldexp(1, random.below(30));
          const double x = away * random.between(-1, 1), y = away * random.between(-1, 1);
          Shape moved = second;
          for (const std::size_t k : {0U, 2U}) {
            if (k > 0 && b != VESICA_AABB) continue;
            moved.numbers[k] += x;
            moved.numbers[k + 1] += y;
          }
          if (vesica_check_f64(b, moved.numbers.data()) == 0 && moved.numbers[1] != moved.numbers[3]) second = moved;
        }
        worst.check(first, second);
      }
    }
  }
  worst.expect_at_most(24);
}

/// A rectangle 1e12 times as long as wide, and one beside it: in its own direction, across it, and turned a little.
TEST(GaussianDistance, NeedlesAreAsDefined) {
  Worst worst;
  const Shape needle{VESICA_RECT, {1e15, -1e15, 0.6, 0.8, 1e6, 1e-6}};
  for (const double turn : {0.0, 1e-18, 1e-12, 1e-6, 0.5}) {
    for (const double along : {0.0, 0.125, 6e5, 1e9}) {
      Shape other = needle;
      other.numbers[0] += along * 0.5;
      other.numbers[1] += along * 0.625;
      other.numbers[2] -= 0.8 * turn;
      other.numbers[3] += 0.6 * turn;
      worst.check(needle, other);
      other.numbers[5] *= 1 + 0x1p-40;
      worst.check(needle, other);
    }
  }
  worst.expect_at_most(24);
}

/// Along the axes nothing cancels in the definition, whatever the sizes are.
TEST(GaussianDistance, SizesAsUnlikeAsTheyMayBe) {
  Worst worst;
  for (const double p : {1.0, 0x1p-200, 0x1p-399}) {
    for (const double q : {1.0, 0x1p-200, 0x1p-399}) {
      for (const double r : {1.0, 0x1p-200, 0x1p-399}) {
        worst.check({VESICA_RECT, {0, 0, 1, 0, 1, p}}, {VESICA_RECT, {0, 0, 1, 0, q, r}});
        worst.check({VESICA_RECT, {0, 0, 1, 0, q, r}}, {VESICA_RECT, {0, 0, 1, 0, p, 1}});
      }
    }
  }
  worst.expect_at_most(24);
}

TEST(GaussianDistance, KnownAnswers) {
  // Squares of width sqrt(12) have variances 1; discs of radius 2 do too.
  const Shape square{VESICA_AABB, {0, 0, 1, 1}}, moved{VESICA_AABB, {3, 4, 4, 5}},
      large{VESICA_AABB, {-1.5, -1.5, 2.5, 2.5}};
  EXPECT_EQ(distance(VESICA_GAUSSIAN_WASSERSTEIN, square, moved), 25);
  EXPECT_EQ(distance(VESICA_GAUSSIAN_KULLBACK_LEIBLER, square, moved), 150);
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_BHATTACHARYYA, square, moved), 37.5);
  EXPECT_EQ(distance(VESICA_GAUSSIAN_HELLINGER, square, moved), 1);
  // Deviations 1 and 4, times 1 / sqrt(12).
  EXPECT_EQ(distance(VESICA_GAUSSIAN_WASSERSTEIN, square, large), 1.5);
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_KULLBACK_LEIBLER, square, large), 1.0 / 16 - 1 + std::log(16.0));
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_KULLBACK_LEIBLER, large, square), 16 - 1 - std::log(16.0));
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_BHATTACHARYYA, square, large), std::log(17.0 / 8));
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_HELLINGER, square, large), std::sqrt(9.0 / 17));
  // Crossed rectangles of 2 x 1: the deviations 2 and 1 change places.
  const Shape lying{VESICA_RECT, {0, 0, 1, 0, 1, 0.5}}, standing{VESICA_RECT, {0, 0, 0, 1, 1, 0.5}};
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_WASSERSTEIN, lying, standing), (5 + 5 - 8) / 12.0);
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_KULLBACK_LEIBLER, lying, standing), 0.5 * (4.25 - 2));
  EXPECT_DOUBLE_EQ(distance(VESICA_GAUSSIAN_BHATTACHARYYA, lying, standing), 0.5 * std::log(25.0 / 16));
}

TEST(GaussianDistance, EqualGaussiansHaveZero) {
  const Shape same[][2] = {
      {{VESICA_RECT, {1, 2, 0.3, 0.7, 2, 5}}, {VESICA_RECT, {1, 2, -0.3, -0.7, 2, 5}}},
      {{VESICA_RECT, {1, 2, 0.3, 0.7, 2, 5}}, {VESICA_RECT, {1, 2, -0.7, 0.3, 5, 2}}},
      {{VESICA_RECT, {1, 2, 0.3, 0.7, 2, 5}}, {VESICA_RECT, {1, 2, 0.6, 1.4, 1, 2.5}}},
      {{VESICA_AABB, {-1, -3, 5, 1}}, {VESICA_RECT, {2, -1, 0, 1, 2, 3}}},
      {{VESICA_CIRCLE, {1, 2, 3}}, {VESICA_ELLIPSE, {1, 2, 0, 1, 3, 3}}},
      {{VESICA_RECT, {1, 2, 1, 0, 0x1p-200, 1}}, {VESICA_RECT, {1, 2, 0, 4, 0.25, 0x1p-202}}},
      {{VESICA_ELLIPSE, {1e300, 2, 3, 4, 1e-3, 1e-9}}, {VESICA_ELLIPSE, {1e300, 2, 3, 4, 1e-3, 1e-9}}},
  };
  for (const auto& [a, b] : same) {
    for (std::int32_t which = 0; which < 4; ++which) {
      EXPECT_EQ(distance(which, a, b), 0) << which;
      EXPECT_EQ(distance(which, b, a), 0) << which;
    }
  }
}

TEST(GaussianDistance, ExchangeAndScaleChangeNoBit) {
  Random random(properties::seed());
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const auto kind_a = kinds[static_cast<std::size_t>(random.below(4))],
               kind_b = kinds[static_cast<std::size_t>(random.below(4))];
    const Shape a = any(kind_a, random), b = any(kind_b, random);
    for (std::int32_t which = 0; which < 4; ++which) {
      const double d = distance(which, a, b);
      if (which != VESICA_GAUSSIAN_KULLBACK_LEIBLER) {
        EXPECT_EQ(distance(which, b, a), d) << which;
      }
      for (const int k : {-950, -400, 400, 500}) {
        const auto scaled = [&](Shape s) {
          const bool has_axis = s.kind == VESICA_RECT || s.kind == VESICA_ELLIPSE;
          for (std::size_t j = 0; j < (has_axis ? 4 : 6); ++j) s.numbers[j] = std::ldexp(s.numbers[j], k);
          return s;
        };
        const bool is_area = which == VESICA_GAUSSIAN_WASSERSTEIN;
        EXPECT_EQ(distance(which, scaled(a), scaled(b)), is_area ? std::ldexp(d, 2 * k) : d) << which << ' ' << k;
      }
    }
  }
}

/// Circles and boxes keep all digits of their numbers at both ends of the range, where products would not.
TEST(GaussianDistance, EndsOfTheRange) {
  const auto all = [](double k) {
    const Shape a{VESICA_AABB, {k, k, 3 * k, 2 * k}}, b{VESICA_CIRCLE, {2 * k, 2 * k, k}};
    std::array<double, 3> out{};
    for (std::int32_t which = 0; which < 3; ++which) out[static_cast<std::size_t>(which)] = distance(which, a, b);
    return out;
  };
  EXPECT_EQ(all(1), all(0x1p-1060));
  EXPECT_EQ(all(1), all(0x1p1000));
  EXPECT_EQ(all(1), all(0x1p1021));
}

TEST(GaussianDistance, SameBitsInEveryRoundingMode) {
  Random random(properties::seed());
  for (int i = 0; i < 50; ++i) {
    const Shape a = any(VESICA_RECT, random), b = any(VESICA_ELLIPSE, random);
    for (std::int32_t which = 0; which < 4; ++which) {
      const double expected = distance(which, a, b);
      for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const double got = distance(which, a, b);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(got, expected);
      }
    }
  }
}

TEST(GaussianDistance, FloatIsDoubleRounded) {
  Random random(properties::seed());
  for (int i = 0; i < 200; ++i) {
    vesica_rect_f32 a{}, b{};
    vesica_rect_f64 wide_a{}, wide_b{};
    const auto draw = [&](vesica_rect_f32& s, vesica_rect_f64& wide) {
      s = {static_cast<float>(random.unit()), static_cast<float>(random.unit()),
           static_cast<float>(random.unit()), 0.5f,
           static_cast<float>(random.unit()), 0.25f};
      wide = {s.cx, s.cy, s.ux, s.uy, s.hx, s.hy};
    };
    draw(a, wide_a);
    draw(b, wide_b);
    for (std::int32_t which = 0; which < 4; ++which) {
      float got = -1;
      double want = -1;
      ASSERT_EQ(vesica_gaussian_distance_f32(which, VESICA_RECT, &a, VESICA_RECT, &b, &got), 0);
      ASSERT_EQ(vesica_gaussian_distance_f64(which, VESICA_RECT, &wide_a, VESICA_RECT, &wide_b, &want), 0);
      EXPECT_EQ(got, static_cast<float>(want));
    }
  }
}

/// ---- Arrays

struct Columns {
  std::vector<std::array<double, 6>> rows;
  vesica_shapes_f64 shapes{};

  Columns(std::int32_t kind, int count, Random& random) {
    for (int i = 0; i < count; ++i) rows.push_back(any(kind, random).numbers);
    EXPECT_EQ(vesica_shapes_from_records_f64(kind, count, rows.data(), sizeof rows[0], &shapes), 0);
  }
  Shape at(std::size_t i) const { return {shapes.kind, rows[i]}; }
};

TEST(GaussianDistance, ArraysHaveTheBitsOfCalls) {
  Random random(properties::seed());
  const std::int64_t n = 70, m = 131, stride = 140;
  for (const std::int32_t kind : kinds) {
    const Columns a(kind, n, random), b(VESICA_RECT, m, random), one(VESICA_ELLIPSE, 1, random);
    for (std::int32_t which = 0; which < 4; ++which) {
      std::vector<double> out(static_cast<std::size_t>(n * stride), -1);
      EXPECT_EQ(vesica_gaussian_distance_matrix_f64(which, &a.shapes, &b.shapes, out.data(), stride), 0);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) EXPECT_EQ(out[i * stride + j], distance(which, a.at(i), b.at(j)));
        EXPECT_EQ(out[i * stride + m], -1);
      }
      EXPECT_EQ(vesica_gaussian_distance_many_f64(which, &a.shapes, &a.shapes, out.data()), n);
      EXPECT_EQ(vesica_gaussian_distance_many_f64(which, &one.shapes, &a.shapes, out.data()), 0);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(out[i], distance(which, one.at(0), a.at(i)));
    }
  }
}

TEST(GaussianDistance, ElementsWithErrorsAreNaN) {
  Random random(properties::seed());
  Columns a(VESICA_RECT, 4, random), b(VESICA_RECT, 4, random);
  double out[4];
  const auto is_nan = [&] {
    return std::array{std::isnan(out[0]), std::isnan(out[1]), std::isnan(out[2]), std::isnan(out[3])};
  };
  a.rows[1][4] = 0x1p-500;
  EXPECT_EQ(vesica_gaussian_distance_many_f64(0, &a.shapes, &b.shapes, out), VESICA_E_RANGE);
  EXPECT_EQ(is_nan(), (std::array{false, true, false, false}));
  b.rows[2][5] = 0;
  EXPECT_EQ(vesica_gaussian_distance_many_f64(0, &a.shapes, &b.shapes, out), VESICA_E_ARGUMENT);
  EXPECT_EQ(is_nan(), (std::array{false, true, true, false}));
  EXPECT_EQ(vesica_gaussian_distance_many_f64(3, &a.shapes, &b.shapes, out), 0);
  EXPECT_EQ(is_nan(), (std::array{false, false, false, false}));
  a.rows[0][2] = a.rows[0][3] = 0;
  EXPECT_EQ(vesica_gaussian_distance_many_f64(0, &a.shapes, &b.shapes, out), VESICA_E_SHAPE);
  EXPECT_EQ(is_nan(), (std::array{true, true, true, false}));
  EXPECT_EQ(vesica_gaussian_distance_matrix_f64(3, &a.shapes, &b.shapes, std::vector<double>(16).data(), 4),
            VESICA_E_SHAPE);
}

TEST(GaussianDistance, Errors) {
  const vesica_rect_f64 good{0, 0, 1, 0, 1, 1}, flat{0, 0, 1, 0, 1, 0}, bad{0, 0, 1, 0, nan, 1},
      huge{0, 0, 1, 0, 1e200, 1e200};
  const vesica_point_f64 point{0, 0};
  double out = -7;
  const auto ask = [&](std::int32_t which, std::int32_t kind, const void* b) {
    return vesica_gaussian_distance_f64(which, VESICA_RECT, &good, kind, b, &out);
  };
  EXPECT_EQ(ask(0, VESICA_RECT, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_gaussian_distance_f64(0, VESICA_RECT, &good, VESICA_RECT, &good, nullptr), VESICA_E_NULL);
  for (const std::int32_t kind :
       {-1, VESICA_POINT, VESICA_SEGMENT, VESICA_CAPSULE, VESICA_ROUND_RECT, VESICA_POLYGON, 10}) {
    EXPECT_EQ(ask(0, kind, &point), VESICA_E_KIND) << kind;
  }
  EXPECT_EQ(ask(-1, VESICA_RECT, &good), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(4, VESICA_RECT, &good), VESICA_E_ARGUMENT);
  for (std::int32_t which = 0; which < 3; ++which) EXPECT_EQ(ask(which, VESICA_RECT, &flat), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, VESICA_RECT, &bad), VESICA_E_SHAPE);
  EXPECT_EQ(ask(3, VESICA_RECT, &huge), VESICA_E_RANGE);
  EXPECT_EQ(out, -7);
  EXPECT_EQ(ask(3, VESICA_RECT, &flat), 0);
  EXPECT_DOUBLE_EQ(out, 1 / 3.0);
  const vesica_rect_f64 far{1e300, 0, 1, 0, 1, 1};
  EXPECT_EQ(ask(0, VESICA_RECT, &far), VESICA_E_RANGE);
  EXPECT_EQ(ask(1, VESICA_RECT, &far), 0);
  EXPECT_EQ(out, 1);
  const vesica_shapes_f64 none{VESICA_RECT, 0, 0, 0, {}, nullptr, nullptr, 0};
  EXPECT_EQ(vesica_gaussian_distance_many_f64(0, &none, &none, nullptr), 0);
  EXPECT_EQ(vesica_gaussian_distance_matrix_f64(0, &none, &none, nullptr, 0), 0);
  EXPECT_EQ(vesica_gaussian_distance_many_f64(9, &none, &none, nullptr), VESICA_E_ARGUMENT);
  vesica_rect_f32 small{0, 0, 1, 0, 1, 1}, beyond{3e38f, 0, 1, 0, 1, 1};
  float single = -7;
  EXPECT_EQ(vesica_gaussian_distance_f32(3, VESICA_RECT, &small, VESICA_RECT, &beyond, &single), VESICA_E_RANGE);
}

/// ---- The functions of arithmetic

TEST(Logarithms, AreRightRelativeToThemselves) {
  namespace arithmetic = vesica::detail::arithmetic;
  Random random(properties::seed());
  double worst[4] = {};
  const auto note = [](double& most, double got, const Real& want) {
    most = std::max(most, static_cast<double>(abs((Real(got) - want) / want) / Real(u)));
  };
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const double tiny = std::ldexp(random.between(0.5, 1), -random.below(60));
    const double x = random.chance(0.5) ? tiny : -0.5 * tiny;
    note(worst[0], arithmetic::excess_over_log(x), Real(x) - log(Real(1.0) + Real(x)));
    const double any = random.chance(0.5) ? 1 + x : std::ldexp(random.between(0.5, 1), random.integer(-1020, 1020));
    if (any != 1) note(worst[1], arithmetic::log_of(any), log(Real(any)));
    const double positive = std::ldexp(random.between(0.5, 1), random.integer(-100, 100));
    note(worst[2], arithmetic::log_of_1_plus(positive), log(Real(1.0) + Real(positive)));
    const double way = std::ldexp(random.between(0.5, 1), random.integer(-100, 5));
    note(worst[3], arithmetic::one_minus_exp_of_minus(way), Real(1.0) - exp(-Real(way)));
  }
  EXPECT_LE(worst[0], 8);
  EXPECT_LE(worst[1], 2);
  EXPECT_LE(worst[2], 4);
  EXPECT_LE(worst[3], 4);
  RecordProperty("excess", std::to_string(worst[0]));
  RecordProperty("log", std::to_string(worst[1]));
  RecordProperty("log1p", std::to_string(worst[2]));
  RecordProperty("expm1", std::to_string(worst[3]));
  EXPECT_EQ(arithmetic::excess_over_log(0), 0);
  EXPECT_EQ(arithmetic::log_of(1), 0);
  EXPECT_EQ(arithmetic::log_of_1_plus(0), 0);
  EXPECT_EQ(arithmetic::one_minus_exp_of_minus(0), 0);
  EXPECT_EQ(arithmetic::one_minus_exp_of_minus(infinity), 1);
}

}  // namespace gaussian_distances
