// SPDX-License-Identifier: Apache-2.0
/// Shared by tests of error bounds: the search over pairs of two kinds, and an estimate beside the truth.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vesica/filter/box.hpp>
#include <vesica/filter/estimate.hpp>

#include "filter/inputs.hpp"
#include "filter/polynomials.hpp"
#include "filter/rounding.hpp"
#include "filter/search.hpp"

namespace bounds {

template <class V, int effort>
class Bound : public testing::Test {
 protected:
  /// Searches pairs of two kinds in every rounding mode. ratio(a, b) is the error over its bound; negative outside of
  /// the guard.
  template <template <class> class A, template <class> class B, class Ratio>
  static void measure(const std::string& what, const inputs::Exponents& e, Ratio ratio) {
    properties::Random random(properties::seed());
    inputs::Inputs<V> pairs(vesica::ShapeTraits<A<V>>::kind, vesica::ShapeTraits<B<V>>::kind, inputs::widened<V>(e),
                            random);
    for (const rounding::Mode& mode : rounding::modes_of<V>) {
      const auto of = [&](const inputs::Numbers<V>& n) {
        return rounding::in(mode, n, [&](const inputs::Numbers<V>& m) {
          return ratio(inputs::shape_at<A<V>>(m.data()), inputs::shape_at<B<V>>(m.data() + pairs.first_count()));
        });
      };
      search::expect_within_bound(what + mode.name, pairs, of, effort / 2);
    }
  }
};

/// Error over bound; 0 where the bound is NaN or beyond every filter's limit, and decides nothing.
template <class V>
double error_over_bound(const vesica::filter::Estimate<V>& estimate, const truth::Dyadic& exact) {
  if (!(estimate.error <= vesica::filter::guard_power<V, 100>())) return 0;
  // Beyond any error: a value that overflowed under a finite bound.
  if (!std::isfinite(estimate.value)) return std::numeric_limits<double>::infinity();
  return truth::error_over_bound(truth::Dyadic(estimate.value) - exact, truth::Dyadic(estimate.error));
}

/// The offset of centres, rounded and exact.
template <class A, class B>
auto offset(const A& a, const B& b) {
  return vesica::filter::offset(vesica::filter::place(a), vesica::filter::place(b));
}
template <class A, class B>
truth::Vector true_offset(const A& a, const B& b) {
  return truth::centre(b) - truth::centre(a);
}

}  // namespace bounds
