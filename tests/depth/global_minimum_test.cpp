// SPDX-License-Identifier: Apache-2.0
// The depth is the least over all directions, not a local minimum only, and the search ends well within its limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vesica/depth/search.hpp>

#include "boundary_distance/dense_search.hpp"
#include "properties/random.hpp"
#include "vesica.h"

namespace global_minimum_test {
namespace {

using properties::Numbers;
using properties::Random;

/// The dense search and the library each round; neither by as much as this times 2^-53 of the largest length.
constexpr double noise = 16 * 0x1p-53;

double power(Random& random, double low, double high) { return std::pow(10, random.between(low, high)); }

/// About (x, y), the longer half length 1.
Numbers shape(Random& random, double x, double y, double most_aspect, double angle) {
  const double aspect = power(random, 0, most_aspect), length = std::exp2(random.between(-2, 2));
  double a = 1 / length, b = 1 / (length * aspect);
  if (random.chance(0.5)) std::swap(a, b);
  return {x, y, length * std::cos(angle), length * std::sin(angle), a, b};
}

struct Draw {
  Numbers a, b;
};

/// Two shapes that may overlap: their sizes differ up to a thousandfold, their axes are often nearly parallel or at
/// right angles, the centres often close.
Draw draw(Random& random, double most_aspect) {
  const double angle = random.between(0, 6.283185307179586);
  const double turn = random.chance(0.5) ? random.between(0, 6.283185307179586) : power(random, -9, 0);
  Draw d{shape(random, 0, 0, most_aspect, angle), {}};
  const double far = random.chance(0.3) ? power(random, -16, 0) : 2 * random.unit(), way = random.between(0, 6.2831853);
  d.b = shape(random, far * std::cos(way), far * std::sin(way), most_aspect,
              angle + turn + (random.chance(0.3) ? 1.5707963267948966 : 0));
  const double size = random.chance(0.5) ? 1 : power(random, -3, 0);
  d.b[4] *= size;
  d.b[5] *= size;
  return d;
}

template <class Shape>
Shape as(const Numbers& n) {
  return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

vesica::detail::support_minimum::Form form(int kind, const Numbers& n) {
  using namespace vesica;
  return kind == VESICA_RECT ? detail::support_minimum::form(as<Rect<double>>(n))
                             : detail::support_minimum::form(as<Ellipse<double>>(n));
}

void run(int kind_a, int kind_b, double most_aspect, int pairs) {
  Random random(properties::seed() + static_cast<unsigned>(10 * kind_a + kind_b));
  int overlapping = 0, missed = 0, most_evaluations = 0, most_arcs = 0;
  long evaluations = 0;
  for (int i = 0; i < pairs * properties::repeat(); ++i) {
    const Draw d = draw(random, most_aspect);
    vesica_penetration_f64 found;
    ASSERT_EQ(vesica_depth_f64(kind_a, d.a.data(), kind_b, d.b.data(), &found), 0);
    if (found.x == 0 && found.y == 0) continue;
    ++overlapping;
    {
      using namespace vesica::detail::support_minimum;
      const auto placed = place(form(kind_a, d.a), form(kind_b, d.b));
      const Minimum m = minimise(Frame(placed).objective(1));
      EXPECT_TRUE(m.settled);
      evaluations += m.evaluations;
      most_evaluations = std::max(most_evaluations, m.evaluations);
      most_arcs = std::max(most_arcs, m.most_arcs);
    }
    using namespace outline_reference;
    const double least = dense_minimum({dense_shape(kind_a, d.a), dense_shape(kind_b, d.b), 1});
    if (found.depth <= least + noise * 2) continue;
    if (++missed <= 3) {
      ADD_FAILURE() << properties::describe({kind_a, kind_b, d.a, d.b}) << ": " << found.depth << ", not " << least;
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_LE(most_evaluations, vesica::detail::support_minimum::evaluation_limit / 4);
  EXPECT_GT(overlapping, pairs / 3 * properties::repeat());
  std::printf(
      "%s, %s, aspect up to 1e%g: %d pairs, %d missed; evaluations %.1f on average, %d at most, %d arcs at most\n",
      vesica_kind_name(kind_a), vesica_kind_name(kind_b), most_aspect, overlapping, missed,
      static_cast<double>(evaluations) / overlapping, most_evaluations, most_arcs);
}

TEST(DepthGlobalMinimum, EllipseEllipse) {
  run(VESICA_ELLIPSE, VESICA_ELLIPSE, 1.3, 8000);
  run(VESICA_ELLIPSE, VESICA_ELLIPSE, 6, 8000);
}
TEST(DepthGlobalMinimum, RectEllipse) {
  run(VESICA_RECT, VESICA_ELLIPSE, 1.3, 4000);
  run(VESICA_RECT, VESICA_ELLIPSE, 6, 4000);
}
TEST(DepthGlobalMinimum, RectRect) {
  run(VESICA_RECT, VESICA_RECT, 1.3, 2000);
  run(VESICA_RECT, VESICA_RECT, 6, 2000);
}

}  // namespace
}  // namespace global_minimum_test
