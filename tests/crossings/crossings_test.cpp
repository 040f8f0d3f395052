// SPDX-License-Identifier: Apache-2.0
// Crossings of outlines: known places, their number against exact integers, their accuracy.
#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "area/hard_pairs.hpp"
#include "area/reference.hpp"
#include "capi/face.hpp"
#include "crossings/crossing_count.hpp"
#include "properties/generators.hpp"
#include "relation/nesting.hpp"

namespace crossings_test {
namespace {

using namespace properties;

struct Point {
  double x, y;
};

struct Kinded {
  int kind;
  std::vector<double> numbers;
};

/// Exactly these places, in this order, and nothing after them.
void expect_places(const Kinded& a, const Kinded& b, const std::vector<Point>& places, int shared = 0) {
  capi_tests::Crossings<double> out;
  const auto count = static_cast<int>(places.size());
  ASSERT_EQ(capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), count);
  EXPECT_EQ(out.count, count);
  EXPECT_EQ(out.shared, shared);
  for (int i = 0; i < 8; ++i) {
    const Point p = i < count ? places[static_cast<std::size_t>(i)] : Point{0, 0};
    EXPECT_DOUBLE_EQ(out.x[i], p.x) << "place " << i;
    EXPECT_DOUBLE_EQ(out.y[i], p.y) << "place " << i;
  }
}

const Kinded square{VESICA_AABB, {0, 0, 2, 2}};
const Kinded unit_circle{VESICA_CIRCLE, {0, 0, 1}};

TEST(Crossings, Boxes) {
  expect_places(square, {VESICA_AABB, {1, 1, 3, 3}}, {{2, 1}, {1, 2}});
  expect_places({VESICA_AABB, {1, 1, 3, 3}}, square, {{2, 1}, {1, 2}});
  expect_places(square, {VESICA_AABB, {2, 2, 3, 3}}, {{2, 2}});
  expect_places(square, {VESICA_AABB, {3, 3, 4, 4}}, {});
  expect_places(square, {VESICA_AABB, {0.5, 0.5, 1, 1}}, {});
  // A cross, and an octagon.
  expect_places(square, {VESICA_AABB, {0.5, -1, 1.5, 3}}, {{0.5, 0}, {1.5, 0}, {1.5, 2}, {0.5, 2}});
  expect_places(square, {VESICA_RECT, {1, 1, 1, 1, 0.75, 0.75}},
                {{0.5, 0}, {1.5, 0}, {2, 0.5}, {2, 1.5}, {1.5, 2}, {0.5, 2}, {0, 1.5}, {0, 0.5}});
  // A diamond whose edges run through the corners.
  expect_places(square, {VESICA_RECT, {1, 1, 1, 1, 1, 1}}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST(Crossings, CommonStretches) {
  expect_places(square, {VESICA_AABB, {2, 0, 4, 2}}, {{2, 0}, {2, 2}}, 1);
  expect_places(square, {VESICA_AABB, {2, 1, 4, 3}}, {{2, 1}, {2, 2}}, 1);
  expect_places(square, {VESICA_AABB, {1, 0, 2, 1}}, {{1, 0}, {2, 0}, {2, 1}}, 1);
  expect_places(square, square, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1);
  expect_places(square, {VESICA_RECT, {1, 1, 0, -2, 0.5, 0.5}}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1);
  expect_places({VESICA_SEGMENT, {0, 0, 4, 4}}, {VESICA_SEGMENT, {3, 3, 1, 1}}, {{1, 1}, {3, 3}}, 1);
  expect_places(unit_circle, unit_circle, {}, 1);
  expect_places(unit_circle, {VESICA_ELLIPSE, {0, 0, 0, 2, 0.5, 0.5}}, {}, 1);
}

TEST(Crossings, PointsAndSegments) {
  expect_places(square, {VESICA_POINT, {1, 0}}, {{1, 0}});
  expect_places(square, {VESICA_POINT, {1, 1}}, {});
  expect_places({VESICA_POINT, {1, 1}}, {VESICA_CIRCLE, {1, 1, 0}}, {{1, 1}});
  expect_places({VESICA_SEGMENT, {3, 1, -1, 1}}, square, {{2, 1}, {0, 1}});
  expect_places(square, {VESICA_SEGMENT, {1, 1, 1, 5}}, {{1, 2}});
  expect_places(square, {VESICA_SEGMENT, {0, 0, 2, 0}}, {{0, 0}, {2, 0}}, 1);
  expect_places(square, {VESICA_SEGMENT, {0.5, 0.5, 1, 1}}, {});
  expect_places({VESICA_SEGMENT, {-1, 0, 1, 0}}, {VESICA_SEGMENT, {0, -1, 0, 0}}, {{0, 0}});
  expect_places({VESICA_SEGMENT, {-2, 1, 2, 1}}, unit_circle, {{0, 1}});
  expect_places({VESICA_RECT, {0, 0, 1, 0, 2, 0}}, unit_circle, {{-1, 0}, {1, 0}});
}

TEST(Crossings, BoxAndEllipse) {
  expect_places({VESICA_AABB, {-3, -4, 3, 4}}, {VESICA_CIRCLE, {0, 0, 5}}, {{-3, -4}, {3, -4}, {3, 4}, {-3, 4}});
  expect_places({VESICA_CIRCLE, {0, 0, 5}}, {VESICA_AABB, {-3, -4, 3, 4}}, {{3, 4}, {-3, 4}, {-3, -4}, {3, -4}});
  expect_places(unit_circle, {VESICA_AABB, {-1, -1, 1, 1}}, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  expect_places({VESICA_AABB, {-4, -4, 4, 4}}, {VESICA_CIRCLE, {0, 0, 5}},
                {{-3, -4}, {3, -4}, {4, -3}, {4, 3}, {3, 4}, {-3, 4}, {-4, 3}, {-4, -3}});
  expect_places({VESICA_AABB, {0, -9, 9, 9}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {{0, 1}, {0, -1}});
}

TEST(Crossings, Ellipses) {
  expect_places(unit_circle, {VESICA_CIRCLE, {3, 0, 1}}, {});
  expect_places(unit_circle, {VESICA_CIRCLE, {2, 0, 1}}, {{1, 0}});
  expect_places(unit_circle, {VESICA_CIRCLE, {0.5, 0, 0.5}}, {{1, 0}});
  expect_places({VESICA_CIRCLE, {0, 0, 5}}, {VESICA_CIRCLE, {6, 0, 5}}, {{3, 4}, {3, -4}});
  expect_places({VESICA_CIRCLE, {0, 0, 5}}, {VESICA_CIRCLE, {0, 6, 5}}, {{4, 3}, {-4, 3}});
  expect_places({VESICA_CIRCLE, {0, 6, 5}}, {VESICA_CIRCLE, {0, 0, 5}}, {{-4, 3}, {4, 3}});
  // Bitangent without a common centre.
  expect_places({VESICA_ELLIPSE, {0, 0, 5, 0, 5, 3}}, {VESICA_CIRCLE, {12, 0, 12}},
                {{18.75, 15 * std::sqrt(7.0) / 4}, {18.75, -15 * std::sqrt(7.0) / 4}});
  // Bitangent, four-fold contact, tangent with two crossings.
  expect_places(unit_circle, {VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {{0, 1}, {0, -1}});
  expect_places({VESICA_CIRCLE, {1.5, 0, 0.5}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {{2, 0}});
  expect_places({VESICA_CIRCLE, {1.25, 0, 0.75}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}},
                {{2, 0}, {4.0 / 3, std::sqrt(5.0) / 3}, {4.0 / 3, -std::sqrt(5.0) / 3}});
}

/// Some shapes of a kind with few integers for numbers, about the origin.
std::vector<Kinded> small_shapes(int kind) {
  std::vector<Kinded> shapes;
  for (const double x : {-2.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0}) {
      for (const double size : {1.0, 2.0, 3.0}) {
        const std::vector<double> of_kind[] = {{x, y},
                                               {x, y, x + size, y - 1},
                                               {x, y, size},
                                               {x, y, x + size, y + 2},
                                               {x, y, 1, 1, size, 1},
                                               {x, y, 0, 1, size, 2},
                                               {x, y, x + size, y + 2, 1},
                                               {x, y, 1, 1, size, 1, 2}};
        shapes.push_back({kind, of_kind[kind]});
      }
    }
  }
  return shapes;
}

/// An ellipse without area is a segment or a point, and so is a rectangle of the same numbers: along any other outline
/// both have the same places.
TEST(Crossings, OfFlatEllipsesAreThoseOfFlatRectangles) {
  const auto ask = [](const Kinded& a, const Kinded& b) {
    capi_tests::Crossings<double> out{};
    EXPECT_GE(capi_tests::crossings<double>(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 0);
    return out;
  };
  const std::vector<double> flat[] = {{0, 0, 1, 0, 3, 0},  {0, 0, 1, 0, 0, 3},  {0, -1, 0, -1, 2, 0},
                                      {1, 0, 3, -4, 1, 0}, {1, 0, -1, 2, 0, 1}, {0, 0, 1, 1, 0, 0}};
  int places = 0;
  for (const std::vector<double>& numbers : flat) {
    const Kinded ellipse{VESICA_ELLIPSE, numbers}, rect{VESICA_RECT, numbers};
    for (int kind = 0; kind < properties::kinds; ++kind) {
      for (const Kinded& other : small_shapes(kind)) {
        const auto of_ellipse = ask(other, ellipse), of_rect = ask(other, rect), exchanged = ask(ellipse, other);
        EXPECT_EQ(std::memcmp(&of_ellipse, &of_rect, sizeof of_rect), 0) << kind_name(kind) << ' ' << places;
        EXPECT_EQ(exchanged.count, of_ellipse.count) << kind_name(kind) << ' ' << places;
        EXPECT_EQ(exchanged.shared, of_ellipse.shared) << kind_name(kind) << ' ' << places;
        places += of_ellipse.count;
      }
    }
  }
  EXPECT_GT(places, 500);
}

struct Worst {
  int asked = 0, meeting = 0, wrong = 0;
  double distance = 0;

  void ask(const Pair& p, bool places_too) {
    capi_tests::Crossings<double> out;
    const std::int32_t count = capi_tests::crossings<double>(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
    const reference::Meeting truth = reference::meeting(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    ++asked;
    if (count == VESICA_E_RANGE) return;
    meeting += truth.count > 0;
    if ((count != truth.count || (out.shared == 1) != truth.shared) && ++wrong <= 3) {
      ADD_FAILURE() << count << " places, shared " << out.shared << ", where " << truth.count << ", " << truth.shared
                    << " is right, seed " << seed() << "\n  " << describe(p);
    }
    for (int i = 0; places_too && i < count; ++i) place(p, out.x[i], out.y[i]);
  }

  /// In units of 2^-53 of the greatest coordinate and size.
  void place(const Pair& p, double x, double y) {
    double extent = 0;
    for (const auto& [kind, n] : {std::pair(p.kind_a, p.a), std::pair(p.kind_b, p.b)}) {
      vesica_aabb_f64 box;
      ASSERT_EQ(vesica_bounds_f64(kind, n.data(), &box), 0);
      extent = std::fmax(
          extent, std::fmax(std::fmax(std::fabs(box.min_x), box.max_x), std::fmax(std::fabs(box.min_y), box.max_y)));
      extent = std::fmax(extent, std::fmax(box.max_x - box.min_x, box.max_y - box.min_y));
    }
    const double unit = 0x1p-53 * extent;
    for (const auto& [kind, n] : {std::pair(p.kind_a, p.a), std::pair(p.kind_b, p.b)}) {
      if (kind < VESICA_CIRCLE) continue;
      const double off = reference::distance_to_outline(kind, n.data(), x, y) / unit;
      distance = std::fmax(distance, off);
      EXPECT_LE(off, 16) << describe(p) << ", seed " << seed();
    }
    if (p.kind_a >= VESICA_AABB && p.kind_b == VESICA_RECT) return;
    if (p.kind_a == VESICA_AABB && p.kind_b == VESICA_AABB) return;
    const double off = reference::distance_to_meeting(p.kind_a, p.a.data(), p.kind_b, p.b.data(), x, y) / extent;
    // Four-fold contact: 2^(-90 / 4). Outlines that all but coincide: 2^-90 over their difference.
    const double apart = reference::difference(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    EXPECT_LE(off, std::fmax(0x1p-22, 0x1p-90 / apart)) << describe(p) << ", seed " << seed();
  }
};

// Below 2^-500 the second place came first: an edge along x was taken for one along y, because a zero was compared by
// an exponent that it does not have.
TEST(Crossings, ComeInOneOrderAtEveryMagnitude) {
  for (int e = -1000; e <= 1000; e += 20) {
    const double q = std::ldexp(1, e);
    const double circle[] = {0, 0, q}, box[] = {0, q / 2, q, 2 * q};
    capi_tests::Crossings<double> out;
    ASSERT_EQ(capi_tests::crossings<double>(VESICA_CIRCLE, circle, VESICA_AABB, box, &out), 2) << e;
    EXPECT_EQ(out.y[0], q / 2) << e;
    EXPECT_EQ(out.y[1], q) << e;
  }
}

TEST(Crossings, AsManyAsExactIntegersTell) {
  for (int a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_POINT; b <= VESICA_ELLIPSE; ++b) {
      Worst worst;
      for (const Workload workload : all_workloads) {
        const bool slow = workload == Workload::mixed_scale || workload == Workload::huge || workload == Workload::tiny;
        Stream stream(workload, a, b, Scalar::f64, seed());
        for (int i = 0; i < (slow ? 10 : 40) * repeat(); ++i) worst.ask(stream.next(), false);
      }
      std::printf("%-8s %-8s %5d asked, %5d meet\n", kind_name(a), kind_name(b), worst.asked, worst.meeting);
      EXPECT_GT(worst.meeting, 0);
    }
  }
}

/// Contact of every order, from inside and from outside, by construction.
TEST(Crossings, AsManyAsExactIntegersTellOfNestedShapes) {
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_CIRCLE; b <= VESICA_ELLIPSE; ++b) {
      Worst worst;
      for (const relations::Nesting nesting : relations::all_nestings) {
        if (!relations::exists(nesting, a, b)) continue;
        relations::NestingStream stream(nesting, a, b, Scalar::f64, seed());
        for (int i = 0; i < 25 * repeat(); ++i) worst.ask(stream.next(), false);
      }
      EXPECT_GT(worst.meeting, 0);
    }
  }
}

TEST(Crossings, ArePlacesOfBothOutlines) {
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_CIRCLE; b <= VESICA_ELLIPSE; ++b) {
      Random random(seed());
      Worst worst;
      for (const hard::Case c : hard::all_cases) {
        for (int i = 0; i < 15 * repeat(); ++i) worst.ask(hard::draw(c, a, b, 2, random), true);
      }
      std::printf("%-8s %-8s %5d asked, %5d meet, at most %.2g u x extent off\n", kind_name(a), kind_name(b),
                  worst.asked, worst.meeting, worst.distance);
    }
  }
}

/// If the outlines cross at an angle, the places are exact.
TEST(Crossings, AreWhereTheyShouldBe) {
  double furthest = 0;
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (const int b : {VESICA_CIRCLE, VESICA_ELLIPSE}) {
      Stream stream(Workload::random, a, b, Scalar::f64, seed());
      for (int i = 0; i < 60 * repeat(); ++i) {
        const Pair p = stream.next();
        capi_tests::Crossings<double> out;
        const std::int32_t count = capi_tests::crossings<double>(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
        for (int k = 0; k < count; ++k) {
          double extent = 1;
          for (const double x : p.a) extent = std::fmax(extent, std::fabs(x));
          for (const double x : p.b) extent = std::fmax(extent, std::fabs(x));
          const double off =
              reference::distance_to_meeting(p.kind_a, p.a.data(), p.kind_b, p.b.data(), out.x[k], out.y[k]);
          furthest = std::fmax(furthest, off / (0x1p-53 * extent));
          EXPECT_LE(off, 16 * 0x1p-53 * extent) << describe(p) << ", seed " << seed();
        }
      }
    }
  }
  std::printf("at most %.2g u x extent from the true place\n", furthest);
}

TEST(Crossings, OfFloatsAreTheDoublesRounded) {
  for (int a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_POINT; b <= VESICA_ELLIPSE; ++b) {
      Stream stream(Workload::random, a, b, Scalar::f32, seed());
      for (int i = 0; i < 60 * repeat(); ++i) {
        const Pair p = stream.next();
        capi_tests::Crossings<double> wide;
        capi_tests::Crossings<float> out;
        const auto f = narrow(p.a), g = narrow(p.b);
        const std::int32_t count = capi_tests::crossings<double>(a, p.a.data(), b, p.b.data(), &wide);
        ASSERT_EQ(capi_tests::crossings<float>(a, f.data(), b, g.data(), &out), count) << describe(p);
        ASSERT_EQ(out.shared, wide.shared);
        for (int k = 0; k < 8; ++k) {
          ASSERT_EQ(out.x[k], static_cast<float>(wide.x[k]));
          ASSERT_EQ(out.y[k], static_cast<float>(wide.y[k]));
        }
      }
    }
  }
}

}  // namespace
}  // namespace crossings_test
