// SPDX-License-Identifier: Apache-2.0
// The core that batches run in lanes, and scalar calls first: what it settles is what the general search finds, and on
// random pairs it settles nearly all, so that batches are not scalar calls in disguise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <vesica/boundary_distance.hpp>
#include <vesica/depth.hpp>

#include "properties/generators.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica;
using properties::Random;

/// Each of the two rounds; neither by as much as this times 2^-53 of the sizes, which are about 1.
constexpr double noise = 8 * 0x1p-53;

template <class Shape>
Shape draw(Random& random, double aspect, double spread) {
  const double angle = random.between(0, 6.283185307179586), longer = random.between(0.5, 1);
  const double x = random.between(-spread, spread), y = random.between(-spread, spread);
  if constexpr (std::is_same_v<Shape, Circle<double>>) {
    return {x, y, longer};
  } else {
    return {x, y, std::cos(angle), std::sin(angle), longer, longer * std::pow(aspect, -random.unit())};
  }
}

template <class Shape>
Shape shrunk(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Circle<double>>) {
    return {0.8 * s.cx, 0.8 * s.cy, 0.7 * s.r};
  } else if constexpr (std::is_same_v<Shape, Rect<double>>) {
    return {0.8 * s.cx, 0.8 * s.cy, s.ux, s.uy, 0.7 * s.hx, 0.7 * s.hy};
  } else {
    return {0.8 * s.cx, 0.8 * s.cy, s.ux, s.uy, 0.7 * s.a, 0.7 * s.b};
  }
}

struct Tally {
  int pairs = 0, settled = 0;
  double worst = 0;

  void report(const char* what, double aspect, double share) const {
    std::printf("%s, aspect up to %g: %d pairs, %.2f%% settled, off by %.2f u at most\n", what, aspect, pairs,
                100.0 * settled / pairs, worst * 0x1p53);
    EXPECT_GE(settled, share * pairs);
    EXPECT_LE(worst, noise);
  }
};

template <class Shape>
const Shape& in_lanes(const Shape& s) {
  return s;
}
Ellipse<double> in_lanes(const Circle<double>& c) { return detail::support_minimum::as_ellipse(c); }

template <class A, class B>
void depths(const char* what, double aspect, double share) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const A a = draw<A>(random, aspect, 0);
    const B b = draw<B>(random, aspect, 1);
    if (!overlap(a, b)) continue;
    ++tally.pairs;
    const auto found = detail::depth::lane_depth(in_lanes(a), b, false);
    if (!found.settled) continue;
    ++tally.settled;
    const auto d = detail::depth::searched_depth(detail::support_minimum::form(a), detail::support_minimum::form(b));
    tally.worst = std::max(tally.worst, std::abs(found.depth - std::ldexp(d.value.high, d.exponent)));
  }
  tally.report(what, aspect, share);
}

/// inner in outer, whichever way round the pair is in.
template <class A, class B>
void nested(const char* what, double aspect, bool a_inside, double share) {
  Random random(properties::seed());
  Tally tally;
  const Relation wanted = a_inside ? Relation::inside : Relation::contains;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    A a = draw<A>(random, aspect, 0.3);
    B b = draw<B>(random, aspect, 0.3);
    for (int k = 0; k < 30 && relation(a, b) != wanted; ++k) {
      if (a_inside) {
        a = shrunk(a);
      } else {
        b = shrunk(b);
      }
    }
    if (relation(a, b) != wanted) continue;
    ++tally.pairs;
    const auto found = detail::boundary_distance::lane_nested(in_lanes(a), b, a_inside, false);
    if (!found.settled) continue;
    ++tally.settled;
    const auto f = detail::support_minimum::form(a), g = detail::support_minimum::form(b);
    const auto n =
        a_inside ? detail::boundary_distance::nested_distance(g, f) : detail::boundary_distance::nested_distance(f, g);
    tally.worst = std::max(tally.worst, std::abs(found.distance - std::ldexp(n.distance.high, n.exponent)));
  }
  tally.report(what, aspect, share);
}

using R = Rect<double>;
using C = Circle<double>;
using E = Ellipse<double>;

TEST(OutlineCores, Depths) {
  for (const double aspect : {1.5, 5.0, 20.0}) {
    depths<R, E>("depth of rectangle and ellipse", aspect, 0.93);
    depths<C, E>("depth of circle and ellipse", aspect, 0.93);
    depths<E, E>("depth of ellipses", aspect, 0.93);
  }
}

TEST(OutlineCores, NestedOutlines) {
  for (const double aspect : {1.5, 5.0, 20.0}) {
    nested<R, E>("ellipse in rectangle", aspect, false, 0.99);
    nested<R, E>("rectangle in ellipse", aspect, true, 0.93);
    nested<C, E>("circle in ellipse", aspect, true, 0.93);
    nested<C, E>("ellipse in circle", aspect, false, 0.93);
    nested<E, E>("ellipse in ellipse", aspect, false, 0.93);
  }
}

/// Lanes work on the two in the order of the general search, which does not depend on the arguments' order: of equal
/// ones the lower or left one comes first.
TEST(OutlineCores, OrderOfTwoEllipses) {
  using vesica::detail::support_minimum::form, vesica::detail::support_minimum::place;
  const double numbers[] = {-0.5, 0, 0.5};
  int equal = 0;
  for (const double x : numbers) {
    for (const double y : numbers) {
      for (const double axis : numbers) {
        for (const double size : numbers) {
          const E a{1, 1, 1, 0, 1, 0.5}, b{1 + x, 1 + y, 1, axis, 1 + size, 0.5};
          const auto exchanged = [](const E& p, const E& q) {
            const auto d = vesica::detail::support_minimum::offset(p.cx, p.cy, q.cx, q.cy);
            const bool in_lanes = vesica::detail::depth::out_of_order<double>(p, q, d);
            EXPECT_EQ(in_lanes,
                      vesica::detail::support_minimum::out_of_order(form(p), form(q), place(form(p), form(q))))
                << q.cx - p.cx << ' ' << q.cy - p.cy;
            return in_lanes;
          };
          const bool same = x == 0 && y == 0 && axis == 0 && size == 0;
          EXPECT_EQ(exchanged(a, b) != exchanged(b, a), !same);
          equal += axis == 0 && size == 0 && exchanged(a, b) == (x < 0 || (x == 0 && y < 0));
        }
      }
    }
  }
  EXPECT_EQ(equal, 9);
}

// Thin ones are settled less often, but what is settled is right.
TEST(OutlineCores, ThinShapes) {
  for (const double aspect : {1e3, 1e6}) {
    depths<R, E>("depth of rectangle and ellipse", aspect, 0);
    depths<E, E>("depth of ellipses", aspect, 0);
    nested<R, E>("rectangle in ellipse", aspect, true, 0);
    nested<E, E>("ellipse in ellipse", aspect, false, 0);
  }
}

}  // namespace
