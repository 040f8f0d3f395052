// SPDX-License-Identifier: Apache-2.0
// Pairs at contact: found by bisection, then nudged by single places. Filters may say nothing there but what exact
// arithmetic says, and lanes neither.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>
#include <vesica/overlap.hpp>

#include "inflated/shapes.hpp"

namespace inflated_contact_test {
namespace {

using namespace inflated;
using properties::Random;

bool overlap(const Shape& a, const Shape& b) {
  return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data()) == 1;
}

/// Finds how far b moves along x until it leaves a: two places that no double lies between, or a few.
bool contact(const Shape& a, const Shape& b, double& from, double& to) {
  from = 0, to = 16;
  if (!overlap(a, moved(b, from)) || overlap(a, moved(b, to))) return false;
  for (int i = 0; i < 60; ++i) {
    const double middle = from + (to - from) / 2;
    (overlap(a, moved(b, middle)) ? from : to) = middle;
  }
  return true;
}

template <class B>
void expect_filter_to_agree(const vesica::Ellipse<double>& a, const B& b) {
  const auto verdict = vesica::detail::overlap::filter(a, b);
  const std::int32_t estimate = vesica::detail::overlap::estimate_within(a, b, 0);
  const bool truth = vesica::detail::overlap::exact(a, b);
  ASSERT_FALSE(verdict.overlap && !truth);
  ASSERT_FALSE(verdict.disjoint && truth);
  ASSERT_TRUE(estimate < 0 || estimate == truth);
}
template <class A, class B>
void expect_filter_to_agree(const A& a, const B& b) {
  const auto verdict = vesica::detail::overlap::filter(a, b);
  const bool truth = vesica::detail::overlap::exact(a, b);
  ASSERT_FALSE(verdict.overlap && !truth);
  ASSERT_FALSE(verdict.disjoint && truth);
}

template <class B>
void ask(const Shape& a, const B& b) {
  const auto& n = a.number;
  switch (a.kind) {
    case VESICA_POINT:
      return expect_filter_to_agree(vesica::Point<double>{n[0], n[1]}, b);
    case VESICA_SEGMENT:
      return expect_filter_to_agree(vesica::Segment<double>{n[0], n[1], n[2], n[3]}, b);
    case VESICA_CIRCLE:
      return expect_filter_to_agree(vesica::Circle<double>{n[0], n[1], n[2]}, b);
    case VESICA_AABB:
      return expect_filter_to_agree(vesica::Aabb<double>{n[0], n[1], n[2], n[3]}, b);
    case VESICA_RECT:
      return expect_filter_to_agree(vesica::Rect<double>{n[0], n[1], n[2], n[3], n[4], n[5]}, b);
    case VESICA_ELLIPSE:
      return expect_filter_to_agree(vesica::Ellipse<double>{n[0], n[1], n[2], n[3], n[4], n[5]}, b);
    default:
      return expect_filter_to_agree(vesica::Capsule<double>{n[0], n[1], n[2], n[3], n[4]}, b);
  }
}
void ask(const Shape& a, const Shape& b) {
  const auto& n = b.number;
  if (b.kind == VESICA_CAPSULE) return ask(a, vesica::Capsule<double>{n[0], n[1], n[2], n[3], n[4]});
  ask(a, vesica::RoundRect<double>{n[0], n[1], n[2], n[3], n[4], n[5], n[6]});
}

void ask_beside_contact(Shape a, Shape b, Random& random) {
  for (int step = 0; step < 12; ++step) {
    ask(a, b);
    if (::testing::Test::HasFatalFailure()) return;
    Shape& s = random.chance(0.5) ? a : b;
    double& x = s.number[static_cast<std::size_t>(random.below(vesica_field_count(s.kind)))];
    const double next = std::nextafter(x, random.sign() * std::numeric_limits<double>::infinity());
    if (next >= 0 || x < 0) x = next;  // sizes stay valid
  }
}

TEST(InflatedContact, FiltersAgreeWithExactArithmetic) {
  Random random(properties::seed());
  int found = 0;
  for (int i = 0; i < 12000 * properties::repeat(); ++i) {
    const Shape b = inflated_shape(random);
    Shape a = any_shape(random, b.kind == VESICA_CAPSULE ? 6 : 7);
    if (random.chance(0.2)) a.number[5] *= std::exp2(-random.between(0, 40));  // thin
    double from, to;
    if (!contact(a, b, from, to)) continue;
    ++found;
    for (const double place : {from, to}) {
      for (const double k : {1.0, 0x1p-20, 0x1p30, 0x1p-300, 0x1p-1040}) {
        ask_beside_contact(times(a, k), times(moved(b, place), k), random);
        ASSERT_FALSE(::testing::Test::HasFatalFailure()) << i << ": " << a.kind << ", " << b.kind << ", " << k;
      }
    }
  }
  EXPECT_GT(found, 500 * properties::repeat());
}

TEST(InflatedContact, LanesAgreeWithSingleCalls) {
  Random random(properties::seed());
  for (std::int32_t kind = 0; kind < 7; ++kind) {
    std::vector<Shape> first, second;
    while (first.size() < 200) {
      const Shape b = shape(VESICA_ROUND_RECT, random), a = shape(kind, random);
      double from, to;
      if (!contact(a, b, from, to)) continue;
      for (const double place : {from, to}) {
        first.push_back(a);
        second.push_back(moved(b, place));
      }
    }
    std::vector<std::uint8_t> out(first.size());
    vesica_shapes_f64 a{}, b{};
    const auto n = static_cast<std::int64_t>(first.size());
    ASSERT_EQ(vesica_shapes_from_records_f64(kind, n, first[0].number.data(), sizeof(Shape), &a), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_ROUND_RECT, n, second[0].number.data(), sizeof(Shape), &b), 0);
    ASSERT_GE(vesica_overlap_many_f64(&a, &b, out.data()), 0);
    for (std::size_t i = 0; i < out.size(); ++i) ASSERT_EQ(out[i], overlap(first[i], second[i])) << kind << ", " << i;
    // The same as floats: rounding moves them off contact by places of float, which is contact enough for lanes.
    std::vector<std::array<float, 7>> p, q;
    for (std::size_t i = 0; i < first.size(); ++i) {
      std::array<float, 7> x{}, y{};
      for (std::size_t k = 0; k < 7; ++k) {
        x[k] = static_cast<float>(first[i].number[k]);
        y[k] = static_cast<float>(second[i].number[k]);
      }
      p.push_back(x);
      q.push_back(y);
    }
    vesica_shapes_f32 c{}, d{};
    ASSERT_EQ(vesica_shapes_from_records_f32(kind, n, p[0].data(), sizeof p[0], &c), 0);
    ASSERT_EQ(vesica_shapes_from_records_f32(VESICA_ROUND_RECT, n, q[0].data(), sizeof q[0], &d), 0);
    ASSERT_GE(vesica_overlap_many_f32(&c, &d, out.data()), 0);
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_EQ(out[i], vesica_overlap_f32(kind, p[i].data(), VESICA_ROUND_RECT, q[i].data())) << kind << ", " << i;
    }
  }
}

}  // namespace
}  // namespace inflated_contact_test
