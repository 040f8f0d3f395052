// SPDX-License-Identifier: Apache-2.0
// Depths and distances of outlines where the cores in lanes have to work hardest or to give up: batches have the bits
// of scalar calls, whichever of several equal minima that is.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "properties/generators.hpp"
#include "properties/random.hpp"

namespace hard_outlines_test {
namespace {

using properties::Numbers;
using properties::Random;

enum class Case { any, evolute, concentric, equal, mirrored, inner_touch, two_minima };
constexpr Case all_cases[] = {Case::any,      Case::evolute,     Case::concentric, Case::equal,
                              Case::mirrored, Case::inner_touch, Case::two_minima};

struct Draw {
  Numbers a, b;
};

/// Aspect ratio 1 to 1e6 by its logarithm, or to 20; the axis not of length 1.
Numbers shape(Random& random, double x, double y, double size) {
  const double angle = random.between(0, 6.283185307179586), length = std::exp2(random.between(-1, 1));
  const double aspect = std::pow(10, random.unit() * (random.chance(0.7) ? 1.3 : 6));
  return {x, y, length * std::cos(angle), length * std::sin(angle), size / length, size / (length * aspect)};
}

/// The centre of curvature of an ellipse at the eccentric angle t.
std::array<double, 2> centre_of_curvature(const Numbers& e, double t) {
  const double c = std::cos(t), s = std::sin(t), difference = e[4] * e[4] - e[5] * e[5];
  const double p = difference / e[4] * c * c * c, q = -difference / e[5] * s * s * s;
  return {e[0] + p * e[2] - q * e[3], e[1] + p * e[3] + q * e[2]};
}

Draw draw(Case which, Random& random) {
  Draw d{shape(random, random.between(-1, 1), random.between(-1, 1), 1), {}};
  const double size = random.chance(0.5) ? 1 : std::pow(10, random.between(-3, 0)),
               near = random.chance(0.5) ? 1e-9 : 0;
  d.b = shape(random, d.a[0] + random.between(-1, 1), d.a[1] + random.between(-1, 1), size);
  switch (which) {
    case Case::any:
      break;
    case Case::evolute: {
      const auto centre = centre_of_curvature(d.a, random.between(0, 6.283185307179586));
      d.b[0] = centre[0] + near * random.between(-1, 1);
      d.b[1] = centre[1] + near * random.between(-1, 1);
      break;
    }
    case Case::concentric:
      d.b[0] = d.a[0] + near * random.between(-1, 1);
      d.b[1] = d.a[1];
      break;
    case Case::equal:
      d.b = d.a;
      d.b[4] *= 1 - near;
      break;
    case Case::mirrored:
      d.b = d.a;
      d.b[2] = -d.a[2];
      d.b[0] += random.chance(0.5) ? 0.25 : 0;
      break;
    case Case::inner_touch: {  // at the end of an axis, or short of it
      d.b = d.a;
      const double share = random.between(0.1, 0.9), step = (1 - share) * (1 - near) * d.a[4];
      d.b[4] *= share, d.b[5] *= share;
      d.b[0] += step * d.a[2], d.b[1] += step * d.a[3];
      break;
    }
    case Case::two_minima: {  // the second centre on an axis of the first, axes parallel: mirrored minima
      const double step = random.between(-0.5, 0.5);
      d.b = {
          d.a[0] + step * d.a[2] * d.a[4], d.a[1] + step * d.a[3] * d.a[4], d.a[2], d.a[3], 0.3 * d.a[4], 0.3 * d.a[5]};
      break;
    }
  }
  return d;
}

Numbers of_kind(int kind, const Numbers& n) {
  return kind == VESICA_CIRCLE ? Numbers{n[0], n[1], std::hypot(n[2], n[3]) * std::fmin(n[4], n[5])} : n;
}

struct Columns {
  std::array<std::vector<double>, 6> a, b;
  std::size_t size() const { return a[0].size(); }
  void add(const Numbers& of_a, const Numbers& of_b) {
    for (std::size_t k = 0; k < 6; ++k) a[k].push_back(of_a[k]), b[k].push_back(of_b[k]);
  }
  static vesica_shapes_f64 shapes(int kind, const std::array<std::vector<double>, 6>& fields) {
    vesica_shapes_f64 s{};
    s.kind = kind;
    s.count = static_cast<std::int64_t>(fields[0].size());
    s.stride = sizeof(double);
    for (int k = 0; k < properties::field_count(kind); ++k) s.field[k] = fields[static_cast<std::size_t>(k)].data();
    return s;
  }
  static Numbers element(const std::array<std::vector<double>, 6>& fields, std::size_t i) {
    Numbers n{};
    for (std::size_t k = 0; k < 6; ++k) n[k] = fields[k][i];
    return n;
  }
};

bool same(double x, double y) {
  return std::isnan(y) ? std::isnan(x) : std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

void check_depth(int ka, int kb, const Columns& c) {
  std::vector<double> depth(c.size()), x(c.size()), y(c.size());
  const auto a = Columns::shapes(ka, c.a), b = Columns::shapes(kb, c.b);
  ASSERT_GE(vesica_depth_many_f64(&a, &b, depth.data(), x.data(), y.data()), 0);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Numbers of_a = Columns::element(c.a, i), of_b = Columns::element(c.b, i);
    vesica_penetration_f64 one;
    ASSERT_EQ(vesica_depth_f64(ka, of_a.data(), kb, of_b.data(), &one), 0);
    ASSERT_TRUE(same(depth[i], one.depth) && same(x[i], one.x) && same(y[i], one.y))
        << properties::describe({ka, kb, of_a, of_b}) << ' ' << depth[i] << ' ' << one.depth;
  }
}

void check_boundary_distance(int ka, int kb, const Columns& c) {
  std::array<std::vector<double>, 5> out;
  for (auto& column : out) column.resize(c.size());
  const auto a = Columns::shapes(ka, c.a), b = Columns::shapes(kb, c.b);
  ASSERT_GE(vesica_boundary_distance_many_f64(&a, &b, out[0].data(), out[1].data(), out[2].data(), out[3].data(),
                                              out[4].data()),
            0);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Numbers of_a = Columns::element(c.a, i), of_b = Columns::element(c.b, i);
    vesica_closest_points_f64 one;
    ASSERT_EQ(vesica_boundary_distance_f64(ka, of_a.data(), kb, of_b.data(), &one), 0);
    ASSERT_TRUE(same(out[0][i], one.distance) && same(out[1][i], one.ax) && same(out[2][i], one.ay) &&
                same(out[3][i], one.bx) && same(out[4][i], one.by))
        << properties::describe({ka, kb, of_a, of_b}) << ' ' << out[0][i] << ' ' << one.distance;
  }
}

void run(int ka, int kb) {
  Random random(properties::seed() + static_cast<unsigned>(10 * ka + kb));
  for (const Case which : all_cases) {
    Columns columns;
    for (int i = 0; i < 400 * properties::repeat(); ++i) {
      Draw d = draw(which, random);
      if (random.chance(0.5)) std::swap(d.a, d.b);
      columns.add(of_kind(ka, d.a), of_kind(kb, d.b));
    }
    check_depth(ka, kb, columns);
    check_boundary_distance(ka, kb, columns);
  }
}

TEST(HardOutlines, RectRect) { run(VESICA_RECT, VESICA_RECT); }
TEST(HardOutlines, RectEllipse) { run(VESICA_RECT, VESICA_ELLIPSE); }
TEST(HardOutlines, EllipseRect) { run(VESICA_ELLIPSE, VESICA_RECT); }
TEST(HardOutlines, CircleEllipse) { run(VESICA_CIRCLE, VESICA_ELLIPSE); }
TEST(HardOutlines, EllipseEllipse) { run(VESICA_ELLIPSE, VESICA_ELLIPSE); }

}  // namespace
}  // namespace hard_outlines_test
