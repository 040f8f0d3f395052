// SPDX-License-Identifier: Apache-2.0
#include <vesica/methods/point_rect_frame.hpp>

#include "methods/typed_method.hpp"

namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_point_rect_frame_f64;
constexpr auto f32 = vesica_method_point_rect_frame_f32;

std::int32_t answer(const vesica_point_f64& point, const vesica_rect_f64& rect) { return f64(&point, &rect); }

TEST(PointRectFrame, KnownAnswers) {
  const vesica_rect_f64 turned{10, 20, 3, 4, 2, 1}, segment{0, 0, 1, 1, 2, 0}, point{3, 4, 1, 0, 0, 0};
  EXPECT_EQ(answer({10, 20}, turned), 1);
  EXPECT_EQ(answer({12, 31}, turned), 1) << "corner";
  EXPECT_EQ(answer({12, 31.125}, turned), 0);
  EXPECT_EQ(answer({16, 28}, turned), 1) << "edge";
  EXPECT_EQ(answer({16.125, 28}, turned), 0);
  EXPECT_EQ(answer({2, 2}, segment), 1);
  EXPECT_EQ(answer({2.125, 2.125}, segment), 0);
  EXPECT_EQ(answer({1, 1.125}, segment), 0);
  EXPECT_EQ(answer({3, 4}, point), 1);
  EXPECT_EQ(answer({3, 4.5}, point), 0);
  EXPECT_EQ(answer({12 * 0x1p1000, 31 * 0x1p1000}, {10 * 0x1p1000, 20 * 0x1p1000, 3 * 0x1p1000, 4 * 0x1p1000, 2, 1}),
            1);
  EXPECT_EQ(answer({12 * 0x1p-1000, 31 * 0x1p-1000}, {10 * 0x1p-1000, 20 * 0x1p-1000, 3, 4, 0x1p-999, 0x1p-1000}), 1);
}

TEST(PointRectFrame, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

// Against the exact default: a point has no size, so the gap is the rectangle's.
TEST(PointRectFrame, ExactBeyondTheGap) {
  using properties::Workload;
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    for (const Workload workload :
         {Workload::random, Workload::grid, Workload::far, Workload::tiny, Workload::huge, Workload::axis_length}) {
      const Counts counts = count(method<f64, f32>(scalar), workload, VESICA_POINT, VESICA_RECT, scalar, 20000);
      print("point_rect_frame", scalar, properties::name(workload), counts);
      EXPECT_GT(counts.overlapping, counts.cases / 20);
      EXPECT_EQ(counts.wrong_beyond_gap, 0) << counts.first_wrong << " VESICA_SEED=" << properties::seed();
    }
  }
}

}  // namespace
