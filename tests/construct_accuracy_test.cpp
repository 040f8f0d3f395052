// SPDX-License-Identifier: Apache-2.0
// Constructors that round, against their definitions evaluated to 8192 bits: more than any sum or difference of
// products of doubles has, so that only roots and quotients are rounded at all. The bounds are those of vesica.h.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vesica/arithmetic/length.hpp>

#include "capi/constructors.hpp"
#include "properties/random.hpp"

namespace {

using properties::Random;
using properties::repeat;
using properties::seed;

/// A real number, as good as exact.
using Real = mpf_class;
[[maybe_unused]] const bool precision_is_set = (mpf_set_default_prec(8192), true);

Real root(const Real& x) { return sqrt(x); }
Real length(const Real& x, const Real& y) { return root(Real(x * x + y * y)); }

/// 2^exponent.
Real power_of_two(long exponent) {
  Real power(1.0);
  if (exponent >= 0) {
    mpf_mul_2exp(power.get_mpf_t(), power.get_mpf_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpf_div_2exp(power.get_mpf_t(), power.get_mpf_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return power;
}

/// The unit in the last place of a T at x: the spacing of the Ts around it.
template <class T>
Real last_place(const Real& x) {
  using Limits = std::numeric_limits<T>;
  long exponent = Limits::min_exponent;
  if (x != 0) mpf_get_d_2exp(&exponent, x.get_mpf_t());
  return power_of_two(std::max<long>(exponent, Limits::min_exponent) - Limits::digits);
}

/// How far a number is off, in units in the last place of what it should be.
template <class T>
double error_in_ulps(T found, const Real& exact) {
  return Real(abs(static_cast<double>(found) - exact) / last_place<T>(exact)).get_d();
}

/// Eigenvalues and the unit eigenvector of the larger, x >= 0; (1, 0) when they are equal.
struct Eigen {
  Real larger, smaller, x, y;
};

Eigen eigen(double xx, double xy, double yy) {
  const Real d = Real(xx) - yy, twice = 2 * Real(xy), difference = length(d, twice);
  const Real larger = (Real(xx) + yy + difference) / 2, determinant = Real(xx) * yy - Real(xy) * xy;
  Real x = 1.0, y = 0.0;
  if (difference > 0) {
    x = d >= 0 ? Real(d + difference) : Real(abs(twice));
    y = d >= 0 ? twice : Real(xy < 0 ? Real(d - difference) : Real(difference - d));
    const Real norm = length(x, y);
    x /= norm;
    y /= norm;
  }
  return {larger, larger > 0 ? Real(determinant / larger) : Real(0.0), x, y};
}

template <class Api>
class ConstructAccuracy : public testing::Test {
 protected:
  using Scalar = typename Api::Scalar;
  using Limits = std::numeric_limits<Scalar>;
  static constexpr int lowest = Limits::min_exponent - Limits::digits, highest = Limits::max_exponent;

  void SetUp() override { std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(seed())); }
  void TearDown() override { std::printf("largest error %.3f\n", worst_); }

  void expect_at_most(double bound, double error) {
    worst_ = std::max(worst_, error);
    EXPECT_LE(error, bound);
  }

  template <class Ellipse>
  void expect_axis(const Ellipse& e, const Eigen& exact) {
    expect_at_most(8, error_in_ulps(e.ux, exact.x));
    expect_at_most(8, error_in_ulps(e.uy, exact.y));
  }

  Scalar any(int low, int high) {
    return static_cast<Scalar>(std::ldexp(random_.between(1, 2), random_.integer(low, high)));
  }

  /// A symmetric matrix: x^2, x y t, y^2 with t mostly within +-1, rounded; often near singular, or near isotropic.
  std::array<Scalar, 3> matrix() {
    const int reach = random_.chance(0.5) ? 6 : highest / 2 - 2;
    const double x = std::ldexp(random_.between(1, 2), random_.integer(-reach, reach));
    const double y = random_.chance(0.3) ? x : std::ldexp(random_.between(1, 2), random_.integer(-reach, reach));
    const double near_one = 1 - std::ldexp(random_.unit(), random_.integer(-70, 0));
    const double t = random_.chance(0.2) ? std::ldexp(1, random_.integer(-900, 0)) : near_one;
    const Scalar xx = static_cast<Scalar>(x * x), yy = static_cast<Scalar>(y * y),
                 xy = static_cast<Scalar>(random_.sign() * t * x * y);
    const int places = random_.chance(0.5) ? 0 : random_.integer(-3, 3);
    return {xx, xy, places == 0 ? yy : static_cast<Scalar>(yy * (1 + static_cast<Scalar>(places) * Limits::epsilon()))};
  }

  void check_covariance(const std::array<Scalar, 3>& c, Scalar k);
  void check_matrix(const std::array<Scalar, 3>& m);
  void check_corners(const Scalar (&p)[8]);
  void check_misfit(const Scalar (&corners)[8], const typename Api::Rect& r);

  Random random_{seed()};
  double worst_ = 0;
  int made_ = 0, refused_ = 0, singular_ = 0;
};

using Scalars = testing::Types<capi::F64, capi::F32>;
TYPED_TEST_SUITE(ConstructAccuracy, Scalars);

template <class Api>
void ConstructAccuracy<Api>::check_covariance(const std::array<Scalar, 3>& c, Scalar k) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << c[0] << ' ' << c[1] << ' ' << c[2] << ", k " << k);
  typename Api::Ellipse e{};
  errno = 0;
  const std::int32_t result = Api::ellipse_from_covariance(1, 2, c[0], c[1], c[2], k, &e);
  EXPECT_EQ(errno, 0);
  const Eigen exact = eigen(c[0], c[1], c[2]);
  const bool semidefinite = c[0] >= 0 && c[2] >= 0 && exact.smaller >= 0;
  if (!semidefinite) {
    ++refused_;
    EXPECT_EQ(result, VESICA_E_ARGUMENT);
    return;
  }
  const Real a = static_cast<double>(k) * root(exact.larger), b = static_cast<double>(k) * root(exact.smaller);
  if (result == VESICA_E_RANGE) {
    EXPECT_GT(a, static_cast<double>(Limits::max()) * (1 - 8 * static_cast<double>(Limits::epsilon())));
    return;
  }
  ASSERT_EQ(result, 0);
  ++made_;
  singular_ += exact.smaller == 0;
  EXPECT_TRUE(exact.smaller != 0 || e.b == 0);
  EXPECT_EQ(e.cx, 1);
  EXPECT_EQ(e.cy, 2);
  expect_at_most(8, error_in_ulps(e.a, a));
  expect_at_most(8, error_in_ulps(e.b, b));
  expect_axis(e, exact);
  EXPECT_EQ(Api::check(VESICA_ELLIPSE, &e), 0);
  EXPECT_GE(e.a, e.b);
}

template <class Api>
void ConstructAccuracy<Api>::check_matrix(const std::array<Scalar, 3>& m) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << m[0] << ' ' << m[1] << ' ' << m[2]);
  typename Api::Ellipse e{};
  errno = 0;
  const std::int32_t result = Api::ellipse_from_matrix(1, 2, m[0], m[1], m[2], &e);
  EXPECT_EQ(errno, 0);
  const Eigen exact = eigen(m[2], -static_cast<double>(m[1]), m[0]);  // a positive multiple of the inverse
  if (!(m[0] > 0 && m[2] > 0 && exact.smaller > 0)) {
    ++refused_;
    EXPECT_EQ(result, VESICA_E_ARGUMENT);
    return;
  }
  ASSERT_EQ(result, 0);
  ++made_;
  expect_at_most(8, error_in_ulps(e.a, Real(1 / root(exact.smaller))));
  expect_at_most(8, error_in_ulps(e.b, Real(1 / root(exact.larger))));
  expect_axis(e, exact);
  EXPECT_EQ(Api::check(VESICA_ELLIPSE, &e), 0);
  EXPECT_GE(e.a, e.b);
}

TYPED_TEST(ConstructAccuracy, CovarianceAndMatrix) {
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const auto matrix = this->matrix();
    const int reach = this->random_.chance(0.5) ? 2 : this->highest;
    this->check_covariance(matrix, this->any(-reach, reach - 1));
    this->check_matrix(matrix);
  }
  EXPECT_GT(this->made_, 4000 * repeat());
  EXPECT_GT(this->refused_, 400 * repeat());
}

// Every entry with an exponent of its own: mostly no covariance, and to be refused; else far from any scale.
TYPED_TEST(ConstructAccuracy, CovarianceAtMixedExponents) {
  using T = typename TypeParam::Scalar;
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const T x = this->any(this->lowest, this->highest - 1), y = this->any(this->lowest, this->highest - 1);
    const T off = static_cast<T>(this->random_.sign()) * this->any(this->lowest, this->highest - 1);
    this->check_covariance({x, off, y}, 1);
    this->check_matrix({x, off, y});
  }
  EXPECT_GT(this->made_, 1000 * repeat());
  EXPECT_GT(this->refused_, 1000 * repeat());
}

// (p, q) times its transpose, in few digits: singular exactly, and one place from it.
TYPED_TEST(ConstructAccuracy, SingularCovariance) {
  using T = typename TypeParam::Scalar;
  for (int i = 0; i < 2000 * repeat(); ++i) {
    const T p = static_cast<T>(this->random_.integer(-2048, 2047)), q = static_cast<T>(this->random_.integer(0, 2047));
    const T scale = std::ldexp(T{1}, this->random_.integer(-60, 60));
    this->check_covariance({p * p * scale, p * q * scale, q * q * scale}, 1);
    this->check_covariance({p * p * scale, p * q * scale, std::nextafter(q * q * scale, T{0})}, 1);
    this->check_matrix({p * p * scale, p * q * scale, std::nextafter(q * q * scale, T{1e30f})});
  }
  EXPECT_GT(this->singular_, 1900 * repeat());
}

/// Twice the mean of the edges from corner 0 to 1 and 3 to 2 (first), and from 0 to 3 and 1 to 2 (second).
struct Edges {
  Real first_x, first_y, second_x, second_y;
};

/// The mean rectangle by its definition.
struct MeanRect {
  Real cx, cy, ux, uy, hx, hy;
};

Edges edges(const std::array<Real, 8>& p) {
  return {p[2] - p[0] + p[4] - p[6], p[3] - p[1] + p[5] - p[7], p[6] - p[0] + p[4] - p[2], p[7] - p[1] + p[5] - p[3]};
}

/// `turn` is the sense from the first edge to the second; it matters only when the second gives the direction.
MeanRect mean_rect(const std::array<Real, 8>& p, bool from_first, int turn) {
  const Edges e = edges(p);
  const Real cx = (p[0] + p[2] + p[4] + p[6]) / 4, cy = (p[1] + p[3] + p[5] + p[7]) / 4;
  const Real across = abs(e.first_x * e.second_y - e.first_y * e.second_x) / 4;
  const Real first = length(e.first_x, e.first_y), second = length(e.second_x, e.second_y);
  if (from_first) return {cx, cy, e.first_x / first, e.first_y / first, first / 4, across / first};
  return {cx, cy, turn * e.second_y / second, -turn * e.second_x / second, across / second, second / 4};
}

/// The largest error among a rectangle's numbers, in units: vesica.h allows 8 of them, and 1 for the centre.
template <class T, class Rect>
double worst_error(const Rect& r, const MeanRect& exact, double largest) {
  const Real& longer = exact.hx > exact.hy ? exact.hx : exact.hy;
  const auto error = [&](T found, const Real& wanted, const Real& factor, const Real& at) {
    const Real off = abs(static_cast<double>(found) - wanted) * factor;
    return Real(off / (last_place<T>(at) + 0x1p-101 * Real(largest))).get_d();
  };
  return std::max({error(r.cx, exact.cx, 8.0, exact.cx), error(r.cy, exact.cy, 8.0, exact.cy),
                   error(r.hx, exact.hx, 1.0, longer), error(r.hy, exact.hy, 1.0, longer),
                   error(r.ux, exact.ux, longer, longer), error(r.uy, exact.uy, longer, longer)});
}

/// The least of the largest distances from corners to a rectangle's, over the eight ways in which they may correspond.
template <class Rect>
Real misfit(const std::array<Real, 8>& p, const Rect& r) {
  const auto number = [](auto x) { return Real(static_cast<double>(x)); };
  const Real cx = number(r.cx), cy = number(r.cy);
  const Real px = number(r.hx) * number(r.ux), py = number(r.hx) * number(r.uy);
  const Real qx = number(r.hy) * -number(r.uy), qy = number(r.hy) * number(r.ux);
  const Real own[4][2] = {{cx - px - qx, cy - py - qy},
                          {cx + px - qx, cy + py - qy},
                          {cx + px + qx, cy + py + qy},
                          {cx - px + qx, cy - py + qy}};
  Real least = -1.0;
  for (std::size_t way = 0; way < 8; ++way) {
    Real most = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& corner = own[(way + (way < 4 ? i : 4 - i)) % 4];
      const Real distance = length(Real(corner[0] - p[2 * i]), Real(corner[1] - p[2 * i + 1]));
      if (distance > most) most = distance;
    }
    if (least < 0 || most < least) least = most;
  }
  return least;
}

/// The cosine of the angle between the edges from corner i to j and from l to k: 1 if one of them is `noise` or shorter
/// along both axes.
double cosine(const std::array<Real, 8>& p, const Real& noise, std::size_t i, std::size_t j, std::size_t k,
              std::size_t l) {
  const Real ax = p[2 * j] - p[2 * i], ay = p[2 * j + 1] - p[2 * i + 1];
  const Real bx = p[2 * k] - p[2 * l], by = p[2 * k + 1] - p[2 * l + 1];
  if ((abs(ax) <= noise && abs(ay) <= noise) || (abs(bx) <= noise && abs(by) <= noise)) return 1;
  return Real((ax * bx + ay * by) / (length(ax, ay) * length(bx, by))).get_d();
}

template <class Api>
void ConstructAccuracy<Api>::check_misfit(const Scalar (&corners)[8], const typename Api::Rect& r) {
  std::array<Real, 8> p;
  const auto size = [](auto x) { return std::fabs(static_cast<double>(x)); };
  double largest = std::max({size(r.cx), size(r.cy), size(r.hx) * size(r.ux), size(r.hx) * size(r.uy),
                             size(r.hy) * size(r.ux), size(r.hy) * size(r.uy)});
  for (std::size_t i = 0; i < 8; ++i) {
    p[i] = static_cast<double>(corners[i]);
    largest = std::max(largest, size(corners[i]));
  }
  Scalar found = -1;
  errno = 0;
  const std::int32_t code = Api::rect_corners_misfit(corners, &r, &found);
  EXPECT_EQ(errno, 0);
  const Real exact = misfit(p, r);
  if (code == VESICA_E_RANGE) {
    EXPECT_GT(exact, static_cast<double>(Limits::max()) * (1 - 8 * static_cast<double>(Limits::epsilon())));
    return;
  }
  ASSERT_EQ(code, 0);
  const Real off = abs(static_cast<double>(found) - exact);
  expect_at_most(3, Real(off / (last_place<Scalar>(exact) + 0x1p-96 / 3 * Real(largest))).get_d());
}

template <class Api>
void ConstructAccuracy<Api>::check_corners(const Scalar (&corners)[8]) {
  std::array<Real, 8> p;
  double largest = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    p[i] = static_cast<double>(corners[i]);
    largest = std::max(largest, std::fabs(static_cast<double>(corners[i])));
  }
  typename Api::Rect r{};
  errno = 0;
  const std::int32_t code = Api::rect_from_corners(corners, &r);
  EXPECT_EQ(errno, 0);
  const Real noise = 8 * static_cast<double>(Limits::epsilon()) * Real(largest);
  const double least = std::min(cosine(p, noise, 0, 1, 2, 3), cosine(p, noise, 1, 2, 3, 0));
  if (code == VESICA_E_ARGUMENT) {
    ++refused_;
    EXPECT_LT(least, 0x1p-50);
    return;
  }
  ASSERT_EQ(code, 0);
  EXPECT_GT(least, -0x1p-50);
  EXPECT_EQ(Api::check(VESICA_RECT, &r), 0);
  check_misfit(corners, r);
  const Edges e = edges(p);
  const Real first = length(e.first_x, e.first_y), second = length(e.second_x, e.second_y);
  if (first == 0 && second == 0) return;
  // Edges nearly equal in length may exchange their parts, and nearly parallel ones have no sense of turning.
  const Real cross = e.first_x * e.second_y - e.first_y * e.second_x;
  const bool equal = abs(first - second) * 0x1p20 <= first, parallel = abs(cross) * 0x1p40 <= first * second;
  double error = std::numeric_limits<double>::infinity();
  for (const int turn : {-1, 1}) {
    if (!parallel && turn != sgn(cross)) continue;
    if (equal || first > second) error = std::min(error, worst_error<Scalar>(r, mean_rect(p, true, turn), largest));
    if (equal || first < second) error = std::min(error, worst_error<Scalar>(r, mean_rect(p, false, turn), largest));
  }
  expect_at_most(8, error);
  ++made_;
}

// However thin a rectangle is and however its corners were rounded, they are in order.
TYPED_TEST(ConstructAccuracy, CornersOfRectangles) {
  using T = typename TypeParam::Scalar;
  Random& random = this->random_;
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const int thin = random.chance(0.3) ? -40 : 0;
    const double angle = random.between(-4, 4), hx = this->any(-12 + thin, 12 + thin), hy = this->any(-12, 12);
    const double px = hx * std::cos(angle), py = hx * std::sin(angle);
    const double qx = -hy * std::sin(angle), qy = hy * std::cos(angle), turn = random.sign();
    const int far = random.chance(0.5) ? 0 : 30;
    const double cx = std::ldexp(random.between(-1, 1), far), cy = std::ldexp(random.between(-1, 1), far);
    const double scale = std::ldexp(1, random.integer(this->lowest / 2, this->highest - 45));
    T p[8];
    for (int j = 0; j < 4; ++j) {
      const double s = j == 1 || j == 2 ? 1 : -1, t = j >= 2 ? turn : -turn;
      p[2 * j] = static_cast<T>(scale * (cx + s * px + t * qx));
      p[2 * j + 1] = static_cast<T>(scale * (cy + s * py + t * qy));
    }
    this->check_corners(p);
  }
  EXPECT_GT(this->made_, 3000 * repeat());
  EXPECT_EQ(this->refused_, 0);
}

// Any four points, in any order, at one scale or at one each.
TYPED_TEST(ConstructAccuracy, CornersOfNothingInParticular) {
  using T = typename TypeParam::Scalar;
  Random& random = this->random_;
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const bool mixed = random.chance(0.5);
    T p[8];
    for (auto& number : p) {
      number = static_cast<T>(random.sign()) * (mixed ? this->any(this->lowest, this->highest - 2) : this->any(-1, 1));
    }
    this->check_corners(p);
    const auto x = [&] { return static_cast<T>(random.sign()) * this->any(mixed ? -30 : -1, mixed ? 30 : 1); };
    this->check_misfit(p, {x(), x(), x(), x(), std::fabs(x()), std::fabs(x())});
  }
  EXPECT_GT(this->made_, 500 * repeat());
  EXPECT_GT(this->refused_, 500 * repeat());
}

// A rectangle whose centre and half extents are representable comes back exactly from its corners.
TYPED_TEST(ConstructAccuracy, CornersOfAxisParallelRectanglesRoundTrip) {
  using T = typename TypeParam::Scalar;
  Random& random = this->random_;
  for (int i = 0; i < 2000 * repeat(); ++i) {
    const T scale = std::ldexp(T{1}, random.integer(this->lowest, this->highest - 20));
    const auto whole = [&](int low) { return static_cast<T>(random.integer(low, 4096)) * scale; };
    const T cx = whole(-4096), cy = whole(-4096), hx = whole(1), hy = whole(1);
    const T p[] = {cx - hx, cy - hy, cx + hx, cy - hy, cx + hx, cy + hy, cx - hx, cy + hy};
    typename TypeParam::Rect r{};
    ASSERT_EQ(TypeParam::rect_from_corners(p, &r), 0);
    EXPECT_TRUE(r.cx == cx && r.cy == cy && r.ux == 1 && r.uy == 0 && r.hx == hx && r.hy == hy) << cx << ' ' << cy;
  }
}

// Lengths have the same bits everywhere: the nearest double, unless the length is halfway between two to 2^-48 units.
TEST(Length, IsTheNearest) {
  namespace arithmetic = vesica::detail::arithmetic;
  EXPECT_EQ(arithmetic::length(0, -0.0), 0);
  EXPECT_EQ(arithmetic::length(3, -4), 5);
  EXPECT_EQ(arithmetic::length(-0x5p1020, 0xcp1020), 0xdp1020);
  EXPECT_EQ(arithmetic::length(0x3p-1074, 0x4p-1074), 0x5p-1074);
  EXPECT_EQ(arithmetic::length(std::numeric_limits<double>::max(), 0x1p1000), std::numeric_limits<double>::infinity());
  EXPECT_EQ(arithmetic::length(std::numeric_limits<double>::max(), 1), std::numeric_limits<double>::max());
  Random random(seed());
  for (int i = 0; i < 20000 * repeat(); ++i) {
    const double x = std::ldexp(random.between(-1, 1), random.integer(-60, 60));
    const double y = random.chance(0.5) ? x * random.between(0, 2) : std::ldexp(random.unit(), random.integer(-60, 60));
    EXPECT_LE(error_in_ulps(arithmetic::length(x, y), length(Real(x), Real(y))), 0.5 + 0x1p-48) << x << ' ' << y;
  }
}

// The reference is the C library's long double, whose 64 bits leave no doubt about one unit of double or float.
TYPED_TEST(ConstructAccuracy, AngleToOneUnit) {
  using T = typename TypeParam::Scalar;
  static_assert(std::numeric_limits<long double>::digits >= 64, "the reference must be finer than double");
  for (int i = 0; i < 20000 * repeat(); ++i) {
    const T angle = static_cast<T>(this->random_.sign()) * this->any(-60, 50);
    typename TypeParam::Rect r{};
    typename TypeParam::Ellipse e{};
    errno = 0;
    ASSERT_EQ(TypeParam::rect_from_angle(0, 0, angle, 2, 4, &r), 0);
    ASSERT_EQ(TypeParam::ellipse_from_angle(0, 0, angle, 1, 2, &e), 0);
    EXPECT_EQ(errno, 0);
    EXPECT_TRUE(r.ux == e.ux && r.uy == e.uy && r.hx == e.a && r.hy == e.b);
    const auto error = [](T found, long double exact) {
      int exponent;
      std::frexp(exact, &exponent);
      return static_cast<double>(std::fabs(static_cast<long double>(found) - exact) *
                                 std::ldexp(1.0L, std::numeric_limits<T>::digits - exponent));
    };
    this->expect_at_most(1, error(r.ux, std::cos(static_cast<long double>(angle))));
    this->expect_at_most(1, error(r.uy, std::sin(static_cast<long double>(angle))));
  }
}

// Sizes of any exponents, often near each other. width - 2 radius in Reals is exact, so half a unit is one rounding.
TYPED_TEST(ConstructAccuracy, RoundRectFromOuterSize) {
  using T = typename TypeParam::Scalar;
  Random& random = this->random_;
  for (int i = 0; i < 20000 * repeat(); ++i) {
    const T width = this->any(this->lowest, this->highest - 2);
    const T height = random.chance(0.5) ? width : this->any(this->lowest, this->highest - 2);
    const T angle = this->any(-60, 50), lesser = std::min(width, height);
    const T part = random.chance(0.5) ? static_cast<T>(random.unit()) : this->any(this->lowest / 2, -1);
    const T radius = random.chance(0.2) ? std::nextafter(lesser / 2, T{0}) : lesser / 2 * std::min(part, T{1});
    typename TypeParam::RoundRect made{};
    typename TypeParam::Rect rect{};
    errno = 0;
    const std::int32_t code = TypeParam::round_rect_from_angle(3, 4, angle, width, height, radius, &made);
    EXPECT_EQ(errno, 0);
    const Real twice = 2 * Real(static_cast<double>(radius));
    const Real w = Real(static_cast<double>(width)) - twice, h = Real(static_cast<double>(height)) - twice;
    if (code == VESICA_E_ARGUMENT) {
      EXPECT_TRUE(w < 0 || h < 0);  // half of a subnormal number was rounded up
      continue;
    }
    ASSERT_EQ(code, 0);
    ASSERT_EQ(TypeParam::rect_from_angle(3, 4, angle, 2, 2, &rect), 0);
    EXPECT_TRUE(made.cx == 3 && made.cy == 4 && made.r == radius);
    // The axis is the rectangle's, or half of it; the core's half sizes are in its unit.
    const T axis = made.ux == rect.ux && made.uy == rect.uy ? T{1} : T{1} / 2;
    EXPECT_TRUE(made.ux == rect.ux * axis && made.uy == rect.uy * axis);
    const auto off = [&](T found, const Real& full) {
      const Real unit = last_place<T>(full);
      return Real(abs(2 * static_cast<double>(axis) * Real(static_cast<double>(found)) - full) / unit).get_d();
    };
    this->expect_at_most(0.5, off(made.hx, w));
    this->expect_at_most(0.5, off(made.hy, h));
    ++this->made_;
  }
  EXPECT_GT(this->made_, 19000 * repeat());
}

// The axis is that of the rectangle, which AngleToOneUnit tests; often the centre and the offset cancel.
TYPED_TEST(ConstructAccuracy, EndsOfCapsules) {
  using T = typename TypeParam::Scalar;
  Random& random = this->random_;
  const auto real = [](T x) { return Real(static_cast<double>(x)); };
  for (int i = 0; i < 20000 * repeat(); ++i) {
    const int middle = random.integer(this->lowest + 12, this->highest - 16);
    const auto near = [&] { return static_cast<T>(random.sign()) * this->any(middle - 12, middle + 12); };
    const T angle = static_cast<T>(random.sign()) * this->any(-60, 50), length = std::fabs(near());
    typename TypeParam::Rect r{};
    ASSERT_EQ(TypeParam::rect_from_angle(0, 0, angle, length, 0, &r), 0);
    T cx = random.chance(0.2) ? T{0} : near(), cy = random.chance(0.2) ? T{0} : near();
    if (random.chance(0.3)) cx = r.hx * r.ux, cy = -r.hx * r.uy;
    typename TypeParam::Capsule made{};
    errno = 0;
    ASSERT_EQ(TypeParam::capsule_from_angle(cx, cy, angle, length, 7, &made), 0);
    EXPECT_EQ(errno, 0);
    EXPECT_EQ(made.r, 7);
    const Real x = real(r.hx) * real(r.ux), y = real(r.hx) * real(r.uy);
    this->expect_at_most(0.51, error_in_ulps(made.x0, Real(real(cx) - x)));
    this->expect_at_most(0.51, error_in_ulps(made.y0, Real(real(cy) - y)));
    this->expect_at_most(0.51, error_in_ulps(made.x1, Real(real(cx) + x)));
    this->expect_at_most(0.51, error_in_ulps(made.y1, Real(real(cy) + y)));
  }
}

}  // namespace
