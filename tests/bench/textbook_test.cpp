// SPDX-License-Identifier: Apache-2.0
/// The benchmark's yardsticks answer the question they are timed on: on pairs that are not ties, as the library does.
#include <gtest/gtest.h>

#include <cstdlib>

#include "textbook/ellipse_ellipse.hpp"
#include "textbook/rect_ellipse.hpp"
#include "textbook/rect_rect.hpp"
#include "workloads.hpp"

namespace {

using namespace vesica::bench;

int repeats() {
  const char* text = std::getenv("VESICA_REPEAT");
  return text ? std::atoi(text) : 1;
}

/// Pairs of the pool on which the two differ.
template <class A, class B>
int disagreements(const Pool& pool, std::int32_t (*library)(const A*, const B*),
                  bool (*yardstick)(const A&, const B&)) {
  int different = 0;
  for (std::size_t i = 0; i < pool.a.size(); ++i) {
    const A a = to_shape<A>(pool.a[i]);
    const B b = to_shape<B>(pool.b[i]);
    different += yardstick(a, b) != (library(&a, &b) == 1);
  }
  return different;
}

// Even the near pairs, 1e-6 from contact, are a thousand million roundings of a double away from a tie.
template <class A, class B>
void expect_agreement(std::int32_t (*library)(const A*, const B*), bool (*yardstick)(const A&, const B&)) {
  for (int i = 0; i < repeats(); ++i) {
    const std::uint64_t seed = seed_of_run() + static_cast<std::uint64_t>(i);
    for (const Workload workload : {Workload::mixed, Workload::sparse, Workload::near}) {
      SCOPED_TRACE(testing::Message() << name_of(workload) << ", VESICA_SEED=" << seed);
      EXPECT_EQ(disagreements(make_pool(kind_of<A>, kind_of<B>, workload, seed), library, yardstick), 0);
    }
  }
}

TEST(Textbook, RectRectAgreesWithTheLibrary) {
  expect_agreement(vesica_overlap_rect_rect_f64, vesica::textbook::rect_rect<vesica_rect_f64>);
}

TEST(Textbook, RectEllipseAgreesWithTheLibrary) {
  expect_agreement(vesica_overlap_rect_ellipse_f64,
                   vesica::textbook::rect_ellipse<vesica_rect_f64, vesica_ellipse_f64>);
}

TEST(Textbook, EllipseEllipseAgreesWithTheLibrary) {
  expect_agreement(vesica_overlap_ellipse_ellipse_f64, vesica::textbook::ellipse_ellipse<vesica_ellipse_f64>);
}

// An ellipse overlapping each feature of the rectangle in turn, and just not: half extents 2 and 1 at the origin.
TEST(Textbook, RectEllipseMeetsEveryFeature) {
  const vesica_rect_f64 rect{0, 0, 1, 0, 2, 1};
  const auto meets = [&](double cx, double cy, double a, double b) {
    return vesica::textbook::rect_ellipse(rect, vesica_ellipse_f64{cx, cy, 1, 0, a, b});
  };
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      EXPECT_TRUE(meets(x * 1.5, y * 0.5, 0.1, 0.1)) << "centre inside";
      EXPECT_TRUE(meets(x * 3, y * 0.5, 1.01, 0.1)) << "one edge";
      EXPECT_FALSE(meets(x * 3, y * 0.5, 0.99, 0.1)) << "one edge";
      EXPECT_TRUE(meets(x * 0.5, y * 2, 0.1, 1.01)) << "other edge";
      EXPECT_FALSE(meets(x * 0.5, y * 2, 0.1, 0.99)) << "other edge";
      EXPECT_TRUE(meets(x * 5, y * 5, 5.01, 5.01)) << "corner: 3, 4, 5";
      EXPECT_FALSE(meets(x * 5, y * 5, 4.99, 4.99)) << "corner: 3, 4, 5";
    }
  }
}

}  // namespace
