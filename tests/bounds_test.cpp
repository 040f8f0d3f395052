// SPDX-License-Identifier: Apache-2.0
// Bounds are the smallest box of representable numbers: each side contains the shape, and the next number inward does
// not. Both are decided in exact integers, so nothing here has a tolerance.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <type_traits>

#include "capi/constructors.hpp"
#include "properties/generators.hpp"

namespace {

using namespace properties;

template <class Api>
class Bounds : public testing::Test {
 protected:
  using Scalar = typename Api::Scalar;

  static void expect(std::int32_t kind, std::array<Scalar, 6> n, std::array<Scalar, 4> box) {
    typename Api::Aabb out{};
    EXPECT_EQ(Api::bounds(kind, n.data(), &out), 0);
    EXPECT_EQ(out.min_x, box[0]);
    EXPECT_EQ(out.min_y, box[1]);
    EXPECT_EQ(out.max_x, box[2]);
    EXPECT_EQ(out.max_y, box[3]);
  }

  static void expect_error(std::int32_t kind, const Scalar* n, std::int32_t error) {
    typename Api::Aabb out{1, 2, 3, 4};
    EXPECT_EQ(Api::bounds(kind, n, &out), error);
    EXPECT_TRUE(out.min_x == 1 && out.min_y == 2 && out.max_x == 3 && out.max_y == 4);
  }
};

using Scalars = testing::Types<capi::F64, capi::F32>;
TYPED_TEST_SUITE(Bounds, Scalars);

TYPED_TEST(Bounds, RepresentableBoxesAreExact) {
  this->expect(VESICA_POINT, {3, -4}, {3, -4, 3, -4});
  this->expect(VESICA_SEGMENT, {3, -4, 1, 5}, {1, -4, 3, 5});
  this->expect(VESICA_CIRCLE, {1, 2, 3}, {-2, -1, 4, 5});
  this->expect(VESICA_AABB, {1, 2, 3, 4}, {1, 2, 3, 4});
  this->expect(VESICA_RECT, {1, 2, 1, 0, 3, 4}, {-2, -2, 4, 6});
  this->expect(VESICA_RECT, {1, 2, 0, -1, 3, 4}, {-3, -1, 5, 5});
  this->expect(VESICA_RECT, {0, 0, 3, 4, 2, 1}, {-10, -11, 10, 11});
  this->expect(VESICA_RECT, {5, 6, -3, 4, 0, 0}, {5, 6, 5, 6});
  this->expect(VESICA_ELLIPSE, {1, 2, 1, 0, 3, 4}, {-2, -2, 4, 6});
  this->expect(VESICA_ELLIPSE, {1, 2, 3, 4, 1, 1}, {-4, -3, 6, 7});  // a circle of radius 5
  this->expect(VESICA_ELLIPSE, {0, 0, 1, 1, 3, 4}, {-5, -5, 5, 5});  // sqrt(9 + 16)
  this->expect(VESICA_ELLIPSE, {1, 1, 3, 4, 2, 0}, {-5, -7, 7, 9});  // a segment
  this->expect(VESICA_ELLIPSE, {0, 0, 5, 12, 1, 1}, {-13, -13, 13, 13});
}

TYPED_TEST(Bounds, AnyMagnitude) {
  using T = typename TypeParam::Scalar;
  using Limits = std::numeric_limits<T>;
  const T eps = Limits::epsilon(), tiny = Limits::denorm_min(), max = Limits::max();
  const T huge = std::ldexp(T{1}, Limits::max_exponent - 4);
  this->expect(VESICA_CIRCLE, {1, 0, tiny}, {1 - eps / 2, -tiny, 1 + eps, tiny});
  this->expect(VESICA_RECT, {max / 2, 0, 1, 0, max / 2, 0}, {0, 0, max, 0});
  this->expect(VESICA_RECT, {0, 0, tiny, 0, tiny, 0}, {-tiny, 0, tiny, 0});
  this->expect(VESICA_RECT, {0, 0, tiny, 0, max, 0}, {-max * tiny, 0, max * tiny, 0});
  this->expect(VESICA_ELLIPSE, {1, 1, 1, 1, 0, tiny}, {1 - eps / 2, 1 - eps / 2, 1 + eps, 1 + eps});
  this->expect(VESICA_ELLIPSE, {0, 0, 1, 1, 3 * tiny, 4 * tiny}, {-5 * tiny, -5 * tiny, 5 * tiny, 5 * tiny});
  this->expect(VESICA_ELLIPSE, {0, 0, 1, 1, tiny, tiny}, {-2 * tiny, -2 * tiny, 2 * tiny, 2 * tiny});
  this->expect(VESICA_ELLIPSE, {0, 0, 1, 1, 3 * huge, 4 * huge}, {-5 * huge, -5 * huge, 5 * huge, 5 * huge});
  this->expect(VESICA_ELLIPSE, {5 * huge, 0, 1, 1, 3 * huge, 4 * huge}, {0, -5 * huge, 10 * huge, 5 * huge});
}

// The extent 3 (2^52 + 1) is 1 below the double nearest to it, and with the centre's 1 - 2^-53 that makes a remainder
// which rounds to 2, so that the side seems representable. It is 2^-53 beyond.
TEST(BoundsOfDouble, RemainderThatRounds) {
  const double rect[] = {-1 + 0x1p-53, 0, 3, 0, 0x1p52 + 1, 0};
  vesica_aabb_f64 out{};
  EXPECT_EQ(vesica_bounds_f64(VESICA_RECT, rect, &out), 0);
  EXPECT_EQ(out.max_x, 0x3p52 + 4);
  EXPECT_EQ(out.min_x, -(0x3p52 + 4));
}

TYPED_TEST(Bounds, Errors) {
  using T = typename TypeParam::Scalar;
  using Limits = std::numeric_limits<T>;
  const T max = Limits::max(), nan = Limits::quiet_NaN(), infinity = Limits::infinity();
  const T circle[] = {0, 0, 1}, not_finite[] = {nan, 0, -1}, unbounded[] = {0, infinity, 1}, negative[] = {0, 0, -1};
  const T no_axis[] = {0, 0, 0, 0, 1, 1}, inverted[] = {1, 0, 0, 0};
  this->expect_error(VESICA_CIRCLE, nullptr, VESICA_E_NULL);
  this->expect_error(17, nullptr, VESICA_E_NULL);
  EXPECT_EQ(TypeParam::bounds(VESICA_CIRCLE, circle, nullptr), VESICA_E_NULL);
  this->expect_error(-1, circle, VESICA_E_KIND);
  this->expect_error(VESICA_POLYLINE + 1, circle, VESICA_E_KIND);
  this->expect_error(VESICA_CIRCLE, not_finite, VESICA_E_SHAPE);
  this->expect_error(VESICA_POINT, not_finite, VESICA_E_SHAPE);
  this->expect_error(VESICA_CIRCLE, unbounded, VESICA_E_SHAPE);
  this->expect_error(VESICA_CIRCLE, negative, VESICA_E_SHAPE);
  this->expect_error(VESICA_RECT, no_axis, VESICA_E_SHAPE);
  this->expect_error(VESICA_ELLIPSE, no_axis, VESICA_E_SHAPE);
  this->expect_error(VESICA_AABB, inverted, VESICA_E_SHAPE);
  const T beyond[] = {max, 0, 1}, far_beyond[] = {0, 0, max, max, max, max}, below[] = {0, -max, 1};
  this->expect_error(VESICA_CIRCLE, beyond, VESICA_E_RANGE);
  this->expect_error(VESICA_CIRCLE, below, VESICA_E_RANGE);
  this->expect_error(VESICA_RECT, far_beyond, VESICA_E_RANGE);
  this->expect_error(VESICA_ELLIPSE, far_beyond, VESICA_E_RANGE);
}

TYPED_TEST(Bounds, NumbersNeedNoAlignment) {
  using T = typename TypeParam::Scalar;
  const T circle[] = {1, 2, 3};
  alignas(T) char bytes[sizeof circle + 1];
  std::memcpy(bytes + 1, circle, sizeof circle);
  typename TypeParam::Aabb out{};
  EXPECT_EQ(TypeParam::bounds(VESICA_CIRCLE, reinterpret_cast<const T*>(bytes + 1), &out), 0);
  EXPECT_EQ(out.min_x, -2);
  EXPECT_EQ(out.max_y, 5);
}

/// x * 2^1074, whole for every finite double.
mpz_class fixed_point(double x) {
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  const mpz_class mantissa(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? mpz_class(mantissa << static_cast<mp_bitcnt_t>(shift))
                    : mpz_class(mantissa >> static_cast<mp_bitcnt_t>(-shift));
}

constexpr mp_bitcnt_t unit = 1074;

/// One side of a shape: along x (0) or y (1), upward (1) or downward (-1).
struct Side {
  int coordinate, sign;
};

/// True if no point of the shape lies beyond m on that side: the definition, in whole numbers.
bool holds(int kind, const Numbers& n, const Side& side, double m) {
  const std::size_t i = static_cast<std::size_t>(side.coordinate);
  const mpz_class distance = side.sign * (fixed_point(m) - fixed_point(n[i]));
  if (kind == VESICA_POINT) return distance >= 0;
  if (kind == VESICA_CIRCLE) return distance >= fixed_point(n[2]);
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB) {
    return distance >= 0 && side.sign * (fixed_point(m) - fixed_point(n[i + 2])) >= 0;
  }
  const mpz_class along = fixed_point(n[2 + i]) * fixed_point(n[4]), across = fixed_point(n[3 - i]) * fixed_point(n[5]);
  if (kind == VESICA_RECT) return distance << unit >= abs(along) + abs(across);
  return distance >= 0 && (distance * distance) << (2 * unit) >= along * along + across * across;
}

/// Counts of the cases drawn, so that no random test passes without any.
struct Met {
  int boxes = 0, out_of_range = 0, broken = 0;
};

template <class Api>
class RandomBounds : public testing::Test {
 protected:
  void SetUp() override { std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(seed())); }

  using T = typename Api::Scalar;
  static constexpr Scalar scalar = std::is_same_v<T, float> ? Scalar::f32 : Scalar::f64;
  static constexpr Side sides[] = {{0, -1}, {1, -1}, {0, 1}, {1, 1}};

  static bool right(int kind, const Numbers& n, const Side& side, double m) {
    if (!holds(kind, n, side, m)) return false;
    const std::int64_t place = ordinal(scalar, m);
    const double inward = at_ordinal(scalar, place - side.sign);
    return inward == m || !holds(kind, n, side, inward);  // equal only at the last finite number
  }

  static bool reaches_beyond(int kind, const Numbers& n) {
    for (const Side& side : sides) {
      if (!holds(kind, n, side, side.sign * static_cast<double>(std::numeric_limits<T>::max()))) return true;
    }
    return false;
  }

  void check(int kind, const Numbers& n) {
    T numbers[6];
    for (std::size_t i = 0; i < 6; ++i) numbers[i] = static_cast<T>(n[i]);
    typename Api::Aabb box{1, 2, 3, 4};
    errno = 0;
    const std::int32_t error = Api::bounds(kind, numbers, &box);
    bool good = errno == 0;
    if (error == 0) {
      ++met_.boxes;
      const double found[] = {box.min_x, box.min_y, box.max_x, box.max_y};
      for (std::size_t i = 0; i < 4; ++i) good = good && right(kind, n, sides[i], found[i]);
    } else {
      ++met_.out_of_range;
      good = good && error == VESICA_E_RANGE && reaches_beyond(kind, n) && box.min_x == 1 && box.max_y == 4;
    }
    if (good || ++met_.broken > 3) return;
    ADD_FAILURE() << "seed " << seed() << ", result " << error << ", box " << box.min_x << ' ' << box.min_y << ' '
                  << box.max_x << ' ' << box.max_y << "\n  " << describe({kind, kind, n, n});
  }

  void check_workload(Workload workload, int cases, Random& random) {
    for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
      for (int i = 0; i < cases * repeat(); ++i) {
        const Pair pair = draw(workload, kind, kind, scalar, random);
        check(kind, pair.a);
        check(kind, pair.b);
      }
    }
  }

  Met met_;
};

TYPED_TEST_SUITE(RandomBounds, Scalars);

TYPED_TEST(RandomBounds, SmallestOnEveryWorkload) {
  Random random(seed());
  for (const Workload workload : all_workloads) {
    SCOPED_TRACE(name(workload));
    if (workload != Workload::near_contact) this->check_workload(workload, 200, random);
  }
  EXPECT_GT(this->met_.boxes, 10000 * repeat());
}

// Every number with an exponent of its own; half of the boxes are out of range.
TYPED_TEST(RandomBounds, SmallestAtMixedExponents) {
  using Limits = std::numeric_limits<typename TypeParam::Scalar>;
  Random random(seed() + 1);
  const auto any = [&](int low, int high) {
    return nearest(this->scalar, random.sign() * std::ldexp(1 + random.unit(), random.integer(low, high)));
  };
  constexpr int lowest = Limits::min_exponent - Limits::digits, highest = Limits::max_exponent - 2;
  for (int i = 0; i < 3000 * repeat(); ++i) {
    Numbers n{};
    for (double& number : n) number = any(lowest, highest);
    this->check(VESICA_RECT, nearest_shape(this->scalar, VESICA_RECT, n));
    this->check(VESICA_ELLIPSE, nearest_shape(this->scalar, VESICA_ELLIPSE, n));
    n[2] = std::fabs(n[2]);
    this->check(VESICA_CIRCLE, n);
  }
  EXPECT_GT(this->met_.boxes, 1000 * repeat());
  EXPECT_GT(this->met_.out_of_range, 1000 * repeat());
}

// A centre that cancels the extent leaves a side near 0, far below the roundings of both.
TYPED_TEST(RandomBounds, SmallestWhenCentreCancelsExtent) {
  Random random(seed() + 2);
  for (const int kind : {VESICA_CIRCLE, VESICA_RECT, VESICA_ELLIPSE}) {
    for (int i = 0; i < 2000 * repeat(); ++i) {
      const Workload workload = all_workloads[static_cast<std::size_t>(random.below(2) * 5)];  // random, thin
      Numbers n = draw(workload, kind, kind, this->scalar, random).a;
      n[0] = n[1] = 0;
      typename TypeParam::Scalar numbers[6];
      for (std::size_t j = 0; j < 6; ++j) numbers[j] = static_cast<typename TypeParam::Scalar>(n[j]);
      typename TypeParam::Aabb box{};
      ASSERT_EQ(TypeParam::bounds(kind, numbers, &box), 0);
      n[0] = at_ordinal(this->scalar, ordinal(this->scalar, box.max_x) + random.integer(-3, 3));
      n[1] = at_ordinal(this->scalar, ordinal(this->scalar, box.min_y) + random.integer(-3, 3));
      this->check(kind, n);
    }
  }
  EXPECT_GT(this->met_.boxes, 5000 * repeat());
}

// Pythagorean ellipses: irrational in general, here with representable sides, one place in one number off, or between.
TYPED_TEST(RandomBounds, SmallestNearRepresentableRoots) {
  constexpr int triples[][2] = {{3, 4}, {5, 12}, {8, 15}, {7, 24}, {20, 21}, {12, 35}};
  Random random(seed() + 3);
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const int* legs = triples[random.below(6)];
    const double length = std::ldexp(random.integer(1, 1 << 8), random.integer(-30, 30));
    Numbers n{std::ldexp(random.integer(-4096, 4096), random.integer(-20, 20)),
              static_cast<double>(random.integer(-9, 9)),
              length,
              length,
              static_cast<double>(legs[0]),
              static_cast<double>(legs[1])};
    this->check(VESICA_ELLIPSE, n);
    double& number = n[static_cast<std::size_t>(random.below(6))];
    number = at_ordinal(this->scalar, ordinal(this->scalar, number) + random.integer(-2, 2));
    this->check(VESICA_ELLIPSE, nearest_shape(this->scalar, VESICA_ELLIPSE, n));
  }
  EXPECT_GT(this->met_.boxes, 5000 * repeat());
}

/// The unit in the last place of the largest of three numbers.
double last_place(double a, double b, double c) {
  const double largest = std::fmax(std::fabs(a), std::fmax(std::fabs(b), std::fabs(c)));
  return largest < 0x1p-1022 ? 0x1p-1074 : std::ldexp(1, std::ilogb(largest) - 52);
}

/// How far a moving side of a point's swept box is beyond its end, in units in the last place of the largest of the
/// three numbers that vesica_motion.h names.
double sweep_excess(double x, double v, double end) {
  const double point[] = {x, 0};
  vesica_aabb_f64 box{};
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POINT, point, v, 0, end, &box), 0);
  EXPECT_EQ(v > 0 ? box.min_x : box.max_x, x);
  const mpq_class way = mpq_class(v) * mpq_class(end), stop = x + way, excess = (v > 0 ? box.max_x : box.min_x) - stop;
  // mpq_class::get_d rounds towards 0, as the unit in the last place does.
  return mpq_class(excess / last_place(x, way.get_d(), stop.get_d())).get_d() * (v > 0 ? 1 : -1);
}

// Just below a power of two a rounding leads to numbers whose steps are twice as long.
TEST(SweptBounds, EndBelowAPowerOfTwo) {
  EXPECT_EQ(sweep_excess(0, 7, 0x1.2492492492492p-3), 4.5);
  EXPECT_EQ(sweep_excess(0, -7, 0x1.2492492492492p-3), 4.5);
  const double excess = sweep_excess(-0x1.fffffffffffffp-54, 7, 0x1.2492492492492p-3);
  EXPECT_GT(excess, 5.49);
  EXPECT_LT(excess, 5.5);
}

TEST(SweptBounds, HoldTheEndWithin5AndAHalfUnits) {
  Random random(seed() + 4);
  double worst = 0;
  for (int i = 0; i < 50000 * repeat(); ++i) {
    const double v = random.sign() * random.between(1, 16);
    // Ways about a power of two, to the last place; sides that hardly count, or that end there.
    const double end = std::nextafter(std::ldexp(1, random.integer(-3, 3)) / std::fabs(v), 0);
    const double x = random.chance(0.8) ? std::ldexp(random.between(-1, 1), random.integer(-56, -48))
                                        : random.between(-1, 1) - v * end;
    const double excess = sweep_excess(x, v, end);
    EXPECT_TRUE(excess >= 0 && excess < 5.5) << excess << ": " << x << ' ' << v << ' ' << end;
    worst = std::fmax(worst, excess);
  }
  EXPECT_GT(worst, 4);
}

}  // namespace
