// SPDX-License-Identifier: Apache-2.0
// As printed the test made a segment without length meet every circle: all its comparisons were 0 <= 0.
#include <cmath>
#include <vesica/methods/segment_circle_division_free.hpp>

#include "methods/ellipse_cases.hpp"
#include "methods/exact_method.hpp"

namespace segment_circle_division_free_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_segment_circle_division_free_f64;
constexpr auto f32 = vesica_method_segment_circle_division_free_f32;

// Numbers at which the method does not round.
constexpr KnownAnswer cases[] = {
    {"touching the middle", {-4, 2, 4, 2}, {0, 0, 2}, 1},
    {"off the middle", {-4, 2.125, 4, 2.125}, {0, 0, 2}, 0},
    {"touching a slanting one", {-4, 3, 12, -9}, {6, 8, 10}, 1},
    {"off a slanting one", {-4, 3, 12, -9}, {6, 8, 9.875}, 0},
    {"at the first end", {3, 4, 9, 9}, {0, 0, 5}, 1},
    {"off the first end", {3, 4.125, 9, 9}, {0, 0, 5}, 0},
    {"at the second end", {-9, 9, -3, 4}, {0, 0, 5}, 1},
    {"off the second end", {-9, 9, -3, 4.125}, {0, 0, 5}, 0},
    {"the line, not the segment", {3, 0, 9, 0}, {0, 0, 2}, 0},
    {"the line, past the second end", {3, 0, 9, 0}, {12, 0, 2}, 0},
    {"inside", {-1, 0, 1, 1}, {0, 0, 5}, 1},
    {"through", {-9, 1, 9, 2}, {0, 0, 5}, 1},
    {"without length, in the circle", {1, 1, 1, 1}, {0, 0, 5}, 1},
    {"without length, on the circle", {3, 4, 3, 4}, {0, 0, 5}, 1},
    {"without length, off the circle", {3, 4.125, 3, 4.125}, {0, 0, 5}, 0},
    {"point on the segment", {0, 0, 9, 6}, {3, 2, 0}, 1},
    {"point off the segment", {0, 0, 9, 6}, {3, 2.125, 0}, 0},
    {"point at an end", {0, 0, 9, 6}, {9, 6, 0}, 1},
    {"three equal points", {3, 4, 3, 4}, {3, 4, 0}, 1},
};

TEST(SegmentCircleDivisionFree, KnownAnswers) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_known_answers(cases, VESICA_SEGMENT, VESICA_CIRCLE, scalar, method<f64, f32>(scalar));
  }
}

/// The comparisons as printed.
bool printed(double a, double b, double c, double d, double r) {
  const double above = d * a - c * b, length = a * a + b * b, foot = c * a + d * b;
  if (above * above > r * r * length) return false;
  if (c * c + d * d <= r * r || (a - c) * (a - c) + (b - d) * (b - d) <= r * r) return true;
  return foot >= 0 && foot <= length;
}

TEST(SegmentCircleDivisionFree, PrintedTestFailsWithoutLength) {
  const vesica_segment_f64 point{0, 0, 0, 0};
  const vesica_circle_f64 circle{100, 0, 1};
  EXPECT_TRUE(printed(0, 0, 100, 0, 1));
  EXPECT_EQ(f64(&point, &circle), 0);
  EXPECT_EQ(vesica_overlap_segment_circle_f64(&point, &circle), 0);
}

// Numbers whose squares leave the range, which the exact overlap answers.
TEST(SegmentCircleDivisionFree, SmallBesideTheLargest) {
  const double small = 0x1p-600;
  const vesica_segment_f64 segment{0, 0, 1, 0}, slanting{0, 0, 1, 0x1p-20};
  const auto answer = [](const vesica_segment_f64& s, const vesica_circle_f64& c) { return f64(&s, &c); };
  EXPECT_EQ(answer(segment, {0.5, small, small}), 1);
  EXPECT_EQ(answer(segment, {0.5, 2 * small, small}), 0);
  EXPECT_EQ(answer(segment, {-2 * small, 0, small}), 0);
  EXPECT_EQ(answer(segment, {-small, 0, small}), 1);
  EXPECT_EQ(answer(segment, {1, small, 0}), 0);
  EXPECT_EQ(answer(slanting, {-3 * small, 4 * small, 5 * small}), 1);
  EXPECT_EQ(answer(slanting, {-3 * small, 4 * small, 4.5 * small}), 0);
  EXPECT_EQ(answer({0, 0, small, 0}, {0, 1, 0.5}), 0);
  EXPECT_EQ(answer({0, 0, small, small}, {0, 1, 1}), 1);
}

TEST(SegmentCircleDivisionFree, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(SegmentCircleDivisionFree, ExactBeyondTheGap) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_exact_beyond_gap("segment_circle_division_free", method<f64, f32>(scalar), VESICA_SEGMENT, VESICA_CIRCLE,
                            scalar);
  }
}

TEST(SegmentCircleDivisionFree, NearTangentCounts) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_counts_near_tangent("segment_circle_division_free", method<f64, f32>(scalar), VESICA_SEGMENT, VESICA_CIRCLE,
                               scalar);
  }
}

TEST(SegmentCircleDivisionFree, Core) {
  using namespace vesica;
  static_assert(noexcept(methods::division_free(Segment<float>{}, Circle<float>{})));
  EXPECT_EQ(methods::division_free(Segment<double>{-4, 2, 4, 2}, Circle<double>{0, 0, 2}), 1);
  EXPECT_EQ(methods::division_free(Segment<float>{-4, 2, 4, 2}, Circle<float>{0, 0, 1.75F}), 0);
  EXPECT_EQ(methods::division_free(Segment<double>{-4, 2, 4, 2}, Circle<double>{0, 0, -2}), error_shape);
}

}  // namespace
}  // namespace segment_circle_division_free_test
