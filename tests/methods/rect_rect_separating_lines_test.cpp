// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vesica/methods/rect_rect_separating_lines.hpp>

#include "methods/exact_method.hpp"

namespace rect_rect_separating_lines_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_rect_rect_separating_lines_f64;
constexpr auto f32 = vesica_method_rect_rect_separating_lines_f32;

struct Known {
  const char* what;
  properties::Numbers a, b;
  std::int32_t answer;
};

// Numbers at which the method does not round.
constexpr Known cases[] = {
    {"equal", {1, 2, 3, 4, 2, 1}, {1, 2, 3, 4, 2, 1}, 1},
    {"shared edge", {0, 0, 1, 0, 1, 1}, {2, 0.5, 1, 0, 1, 1}, 1},
    {"apart along x", {0, 0, 1, 0, 1, 1}, {2.125, 0.5, 1, 0, 1, 1}, 0},
    {"apart along y", {0, 0, 1, 0, 1, 1}, {0.5, -2.125, 0, 1, 1, 1}, 0},
    {"shared corner", {0, 0, 1, 0, 1, 1}, {2, 2, 1, 0, 1, 1}, 1},
    {"plus sign", {0, 0, 1, 0, 8, 1}, {0, 0, 0, 1, 8, 1}, 1},
    {"inside", {0, 0, 3, 4, 8, 8}, {1, 1, 1, 0, 1, 1}, 1},
    {"diamond on an edge", {0, 0, 1, 0, 1, 1}, {2, 0, 0.5, 0.5, 1, 1}, 1},
    {"diamond off an edge", {0, 0, 1, 0, 1, 1}, {2.125, 0, 0.5, 0.5, 1, 1}, 0},
    // A corner of the square in (1, 1), the diamond's edge on x + y = 2 or beyond: only its own line separates them.
    {"diamond on a corner", {0, 0, 1, 0, 1, 1}, {1.5, 1.5, 0.5, 0.5, 1, 1}, 1},
    {"diamond off a corner", {0, 0, 1, 0, 1, 1}, {1.5, 1.625, 0.5, 0.5, 1, 1}, 0},
    // Axes (2, 1) and (1, 2): u.D = 5 hx + 4 gx + 3 gy.
    {"rotated corner on a face", {0, 0, 2, 1, 1, 3}, {5, 2, 1, 2, 1, 1}, 1},
    {"rotated corner off a face", {0, 0, 2, 1, 1, 3}, {5, 2.125, 1, 2, 1, 1}, 0},
    {"segments crossing", {0, 0, 1, 1, 2, 0}, {0, 0, 1, -1, 2, 0}, 1},
    {"segments in one line, touching", {0, 0, 1, 1, 2, 0}, {3, 3, 1, 1, 1, 0}, 1},
    {"segments in one line, apart", {0, 0, 1, 1, 2, 0}, {3, 3, 1, 1, 0.875, 0}, 0},
    {"segments side by side", {0, 0, 1, 1, 2, 0}, {0, 0.125, 1, 1, 2, 0}, 0},
    {"point on a corner", {0, 0, 3, 4, 1, 1}, {-1, 7, 1, 0, 0, 0}, 1},
    {"point off a corner", {0, 0, 3, 4, 1, 1}, {-1, 7.125, 1, 0, 0, 0}, 0},
    {"two equal points", {3, 4, 1, 0, 0, 0}, {3, 4, 0, 1, 0, 0}, 1},
    {"two points", {3, 4, 1, 0, 0, 0}, {3, 4.5, 0, 1, 0, 0}, 0},
};

TEST(RectRectSeparatingLines, KnownAnswersAtEveryScale) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const auto exponents =
        scalar == Scalar::f64 ? std::array{0, -1000, -300, 300, 1000} : std::array{0, -120, -30, 30, 110};
    for (const Known& known : cases) {
      for (const int exponent : exponents) {
        Pair pair{VESICA_RECT, VESICA_RECT, known.a, known.b};
        for (const std::size_t i : {0U, 1U, 4U, 5U}) {
          pair.a[i] = std::ldexp(pair.a[i], exponent);
          pair.b[i] = std::ldexp(pair.b[i], exponent);
        }
        EXPECT_EQ((call<f64, f32>(scalar, pair)), known.answer)
            << known.what << ", " << properties::name(scalar) << ", times 2^" << exponent;
        std::swap(pair.a, pair.b);
        EXPECT_EQ((call<f64, f32>(scalar, pair)), known.answer) << known.what << ", exchanged";
      }
    }
  }
}

TEST(RectRectSeparatingLines, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(RectRectSeparatingLines, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("rect_rect_separating_lines", method<f64, f32>(scalar), VESICA_RECT, VESICA_RECT, scalar);
  }
}

TEST(RectRectSeparatingLines, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("rect_rect_separating_lines", method<f64, f32>(scalar), VESICA_RECT, VESICA_RECT,
                               scalar);
  }
}

std::int32_t turned(const vesica_turned_rect_f64& a, const vesica_turned_rect_f64& b) {
  return vesica_method_turned_rects_separating_lines_f64(&a, &b);
}
std::int32_t turned(const vesica_turned_rect_f32& a, const vesica_turned_rect_f32& b) {
  return vesica_method_turned_rects_separating_lines_f32(&a, &b);
}

TEST(TurnedRectsSeparatingLines, KnownAnswers) {
  constexpr double quarter = std::numbers::pi / 4;
  const vesica_turned_rect_f64 square{0, 0, 0, 2, 2};
  EXPECT_EQ(turned(square, {2, 0, 0, 2, 2}), 1) << "shared edge";
  EXPECT_EQ(turned(square, {2.001, 0, 0, 2, 2}), 0);
  EXPECT_EQ(turned(square, {1 + std::numbers::sqrt2 - 0.001, 0, quarter, 2, 2}), 1) << "diamond over an edge";
  EXPECT_EQ(turned(square, {1 + std::numbers::sqrt2 + 0.001, 0, quarter, 2, 2}), 0) << "diamond off an edge";
  EXPECT_EQ(turned(square, {2.41, 2.41, 0, 2, 2}), 0) << "beyond the corner";
  // Width along the angle: upright it reaches 4 up and 1 to the right.
  EXPECT_EQ(turned(square, {0, 4.9, 2 * quarter, 8, 2}), 1);
  EXPECT_EQ(turned(square, {0, 5.1, 2 * quarter, 8, 2}), 0);
  EXPECT_EQ(turned(square, {1.9, 0, 2 * quarter, 8, 2}), 1);
  EXPECT_EQ(turned(square, {2.1, 0, 2 * quarter, 8, 2}), 0);
  EXPECT_EQ(turned(vesica_turned_rect_f32{0, 0, 0, 2, 2}, {2.001F, 0, 0, 2, 2}), 0);
  EXPECT_EQ(turned(vesica_turned_rect_f32{0, 0, 0.785398F, 2, 2}, {1.414F, 1.414F, 0.785398F, 2, 2}), 1);
  EXPECT_EQ(turned(vesica_turned_rect_f32{0, 0, 0.785398F, 2, 2}, {1.415F, 1.415F, 0.785398F, 2, 2}), 0);
}

template <class Turned, class T>
void expect_errors() {
  using Limits = std::numeric_limits<T>;
  const Turned valid{1, 2, 3, 2, 1};
  EXPECT_EQ(turned(valid, valid), 1);
  const auto expect = [&](T Turned::*field, T number) {
    Turned broken = valid;
    broken.*field = number;
    EXPECT_EQ(turned(broken, valid), VESICA_E_SHAPE);
    EXPECT_EQ(turned(valid, broken), VESICA_E_SHAPE);
  };
  for (T Turned::*field : {&Turned::cx, &Turned::cy, &Turned::angle, &Turned::width, &Turned::height}) {
    for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) expect(field, bad);
  }
  for (T Turned::*field : {&Turned::width, &Turned::height}) expect(field, -Limits::denorm_min());
}

TEST(TurnedRectsSeparatingLines, InvalidInput) {
  expect_errors<vesica_turned_rect_f64, double>();
  expect_errors<vesica_turned_rect_f32, float>();
  const vesica_turned_rect_f64 rect{1, 2, 3, 2, 1};
  const vesica_turned_rect_f32 rect_f32{1, 2, 3, 2, 1};
  EXPECT_EQ(vesica_method_turned_rects_separating_lines_f64(&rect, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_turned_rects_separating_lines_f64(nullptr, &rect), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_turned_rects_separating_lines_f32(&rect_f32, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_turned_rects_separating_lines_f32(nullptr, &rect_f32), VESICA_E_NULL);
}

// The same answers as the standard form of the same rectangles, whatever the angle; and that form's agree with the
// exact default beyond the gap. Large angles are where a difference of angles would have lost its digits.
TEST(TurnedRectsSeparatingLines, AgreesAtAnyAngle) {
  Random random(properties::seed());
  int overlapping = 0, wrong = 0;
  for (int i = 0; i < 100000 * properties::repeat(); ++i) {
    const double most = random.chance(0.5) ? 7 : 1e12;
    const auto draw = [&] {
      return vesica_turned_rect_f64{random.between(-2, 2), random.between(-2, 2), random.between(-most, most),
                                    random.between(0, 3), random.between(0, 3)};
    };
    const vesica_turned_rect_f64 a = draw(), b = draw();
    vesica_rect_f64 first, second;
    ASSERT_EQ(vesica_rect_from_angle_f64(a.cx, a.cy, a.angle, a.width, a.height, &first), 0);
    ASSERT_EQ(vesica_rect_from_angle_f64(b.cx, b.cy, b.angle, b.width, b.height, &second), 0);
    const std::int32_t answer = turned(a, b);
    ASSERT_EQ(answer, f64(&first, &second));
    overlapping += answer;
    const Pair pair{VESICA_RECT,
                    VESICA_RECT,
                    {first.cx, first.cy, first.ux, first.uy, first.hx, first.hy},
                    {second.cx, second.cy, second.ux, second.uy, second.hx, second.hy}};
    if (answer == truth(Scalar::f64, pair)) continue;
    ++wrong;
    ASSERT_TRUE(within_gap(pair, decided_gap(Scalar::f64))) << properties::describe(pair);
  }
  std::printf("turned_rects_separating_lines f64: %d overlapping, %d wrong, VESICA_SEED=%llu\n", overlapping, wrong,
              static_cast<unsigned long long>(properties::seed()));
  EXPECT_GT(overlapping, 10000 * properties::repeat());
}

TEST(RectRectSeparatingLines, Core) {
  using namespace vesica;
  using methods::TurnedRect;
  static_assert(noexcept(methods::separating_lines(Rect<float>{}, Rect<float>{})));
  static_assert(noexcept(methods::separating_lines(TurnedRect<float>{}, TurnedRect<float>{})));
  EXPECT_EQ(methods::separating_lines(Rect<double>{0, 0, 1, 0, 1, 1}, Rect<double>{2, 2, 1, 0, 1, 1}), 1);
  EXPECT_EQ(methods::separating_lines(TurnedRect<float>{0, 0, 0, 2, 2}, TurnedRect<float>{3, 0, 0, 2, 2}), 0);
}

}  // namespace
}  // namespace rect_rect_separating_lines_test
