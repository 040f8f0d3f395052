// SPDX-License-Identifier: Apache-2.0
/// An ellipse-ellipse method may be uncertain only here: the second ellipse, a little larger, overlaps the
/// first, and a little smaller does not.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "methods/typed_method.hpp"

namespace method_pairs {

/// `change` makes pairs fit for the method, and knows which are random; n from 0 to 8.
template <class Function>
void expect_uncertain_within_bound(Function function, const std::function<Pair(const Pair&, Random&)>& change) {
  Random random(properties::seed());
  int uncertain = 0, shrunk = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const std::int32_t n = i % 9;
    Pair pair = properties::draw(properties::Workload::random, VESICA_ELLIPSE, VESICA_ELLIPSE, Scalar::f64, random);
    pair = moved_near_contact(change(pair, random), Scalar::f64, random.unit() * std::pow(4.0, -n), random);
    const auto& [ax, ay, ux, uy, a0, a1, radius_a] = pair.a;
    const auto& [bx, by, wx, wy, b0, b1, radius_b] = pair.b;
    const vesica_ellipse_f64 a{ax, ay, ux, uy, a0, a1}, b{bx, by, wx, wy, b0, b1};
    vesica_approximation_f64 out;
    if (function(&a, &b, n, &out) != VESICA_UNCERTAIN) continue;
    ++uncertain;
    ASSERT_EQ(out.iterations, n);
    const double growth = out.outline_error / (std::min(b0, b1) * std::hypot(wx, wy));
    const vesica_ellipse_f64 larger{bx, by, wx, wy, b0 * (1 + growth), b1 * (1 + growth)};
    ASSERT_EQ(vesica_overlap_ellipse_ellipse_f64(&a, &larger), 1) << properties::describe(pair);
    if (growth >= 1) continue;
    ++shrunk;
    const vesica_ellipse_f64 smaller{bx, by, wx, wy, b0 * (1 - growth), b1 * (1 - growth)};
    ASSERT_EQ(vesica_overlap_ellipse_ellipse_f64(&a, &smaller), 0) << properties::describe(pair);
  }
  EXPECT_GT(uncertain, 1000 * properties::repeat());
  EXPECT_GT(shrunk, 500 * properties::repeat());
}

}  // namespace method_pairs
