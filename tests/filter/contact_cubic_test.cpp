// SPDX-License-Identifier: Apache-2.0
// The contact cubic's coefficients err by no more than filter/contact_cubic.hpp says, and the sign that least_value()
// is sure of is the true one: for a cubic that is truly non-negative its value is no lower than -error, for one that is
// negative somewhere no higher than error. With exact roots and quotients and with ones as rough as lanes may have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vesica/filter/contact_cubic.hpp>

#include "filter/inputs.hpp"
#include "filter/polynomials.hpp"
#include "filter/rounding.hpp"
#include "filter/search.hpp"

namespace {

using namespace vesica;
using inputs::Numbers;
using inputs::shape_at;

constexpr int coefficients_effort = 25000, sign_effort = 3000;

/// A pair's cubic in the filter's arithmetic and exactly, and whether the filter would look at it.
template <class V>
struct Contact {
  filter::ContactCubic<V> computed;
  truth::Cubic exact;
  bool in_guard;
};

template <class V>
Contact<V> contact(const Ellipse<V>& e, const Ellipse<V>& f) {
  const V vv = e.ux * e.ux + e.uy * e.uy, ww = f.ux * f.ux + f.uy * f.uy;
  const auto p = filter::contact_cubic(e, f, filter::offset(filter::place(e), filter::place(f)), vv, ww);
  const bool in_guard = std::min({e.a, e.b, f.a, f.b, vv, ww}) >= filter::guard_power<V, -6>();
  return {p, truth::contact_cubic(truth::ellipse(e), truth::ellipse(f), truth::centre(f) - truth::centre(e)),
          in_guard && filter::totals_in_range(p)};
}

template <class V>
Contact<V> contact(const Circle<V>& disc, const Ellipse<V>& e) {
  const V vv = e.ux * e.ux + e.uy * e.uy;
  const auto p = filter::contact_cubic(disc, e, filter::offset(filter::place(disc), filter::place(e)), vv);
  const bool in_guard =
      std::min({e.a, e.b, disc.r}) >= filter::guard_power<V, -8>() && vv >= filter::guard_power<V, -16>();
  return {p, truth::contact_cubic(disc.r, truth::ellipse(e), truth::centre(e) - truth::centre(disc)),
          in_guard && filter::totals_in_range(p)};
}

/// The worst coefficient, by 11u of d1 and d2 and 14u of the totals.
template <class V>
double coefficient_error(const Contact<V>& c) {
  if (!c.in_guard) return -1;
  using truth::Dyadic;
  const Dyadic u(filter::roundoffs<V>(1) * V(1 + 0x1p-18));  // some room for the second order
  const auto ratio = [&](V computed, const Dyadic& exact, int roundoffs, const Dyadic& of) {
    return truth::error_over_bound(Dyadic(computed) - exact, roundoffs * u * of);
  };
  return std::max({ratio(c.computed.d1, c.exact.d1, 11, c.exact.d1), ratio(c.computed.d2, c.exact.d2, 11, c.exact.d2),
                   ratio(c.computed.c1, c.exact.c1, 14, c.computed.total1),
                   ratio(c.computed.c2, c.exact.c2, 14, c.computed.total2)});
}

/// A scalar whose root and quotient are as rough as lanes' may be (scalar.hpp), to the side that the signs give.
template <class T, int RootSide, int QuotientSide>
struct Rough {
  using Element = T;
  static constexpr T most = sizeof(T) == 4 ? T(0x1p-13) : T(0x1p-26);
  T v;
  explicit Rough(T x) : v(x) {}
  friend Rough operator+(Rough a, Rough b) { return Rough(a.v + b.v); }
  friend Rough operator-(Rough a, Rough b) { return Rough(a.v - b.v); }
  friend Rough operator*(Rough a, Rough b) { return Rough(a.v * b.v); }
  friend bool operator>(Rough a, Rough b) { return a.v > b.v; }
  friend Rough select(bool m, Rough yes, Rough no) { return m ? yes : no; }
  friend Rough positive_part(Rough a) { return Rough(lane::positive_part(a.v)); }
  friend Rough rough_sqrt(Rough a) { return Rough(std::sqrt(a.v) * (1 + RootSide * most)); }
  friend Rough rough_quotient(Rough a, Rough b) { return Rough(a.v / b.v * (1 + QuotientSide * most)); }
};

/// How far the computed value lies on the wrong side of zero, by its error: above 1, the filter's answer is wrong.
template <class V>
double wrong_side(bool nonnegative, V value, V error) {
  if (!(error <= filter::guard_power<V, 100>())) return 0;
  if ((nonnegative ? -value : value) <= 0) return 0;
  return truth::error_over_bound(truth::Dyadic(value), truth::Dyadic(error));
}

template <class R, class V>
double rough_wrong_side(bool nonnegative, const filter::ContactCubic<V>& p) {
  const auto least =
      filter::least_value(filter::ContactCubic<R>{R(p.d1), R(p.c1), R(p.c2), R(p.d2), R(p.total1), R(p.total2)});
  return wrong_side(nonnegative, least.value.v, least.error.v);
}

template <class V>
double wrong_side(const Contact<V>& c) {
  if (!c.in_guard) return -1;
  const bool nonnegative = truth::nonnegative(c.exact);
  const filter::Estimate<V> least = filter::least_value(c.computed);
  return std::max({wrong_side(nonnegative, least.value, least.error),
                   rough_wrong_side<Rough<V, 1, 1>>(nonnegative, c.computed),
                   rough_wrong_side<Rough<V, 1, -1>>(nonnegative, c.computed),
                   rough_wrong_side<Rough<V, -1, 1>>(nonnegative, c.computed),
                   rough_wrong_side<Rough<V, -1, -1>>(nonnegative, c.computed)});
}

template <class V>
class ContactCubicBound : public testing::Test {
 protected:
  template <template <class> class A, class Measure>
  static void measure(const std::string& what, const inputs::Exponents& e, bool near_contact, int effort,
                      Measure ratio) {
    properties::Random random(properties::seed());
    inputs::Inputs<V> pairs(ShapeTraits<A<V>>::kind, Kind::ellipse, inputs::widened<V>(e), random);
    const auto of = [&](const Numbers<V>& n) {
      return contact(shape_at<A<V>>(n.data()), shape_at<Ellipse<V>>(n.data() + pairs.first_count()));
    };
    const auto draw = [&] {
      Numbers<V> n = pairs.draw();
      while (near_contact && !of(n).in_guard) n = pairs.draw();
      return near_contact ? pairs.near_contact(n, [&](const auto& m) { return truth::nonnegative(of(m).exact); }) : n;
    };
    for (const rounding::Mode& mode : rounding::modes_of<V>) {
      const auto measured = [&](const Numbers<V>& n) {
        return rounding::in(mode, n, [&](const Numbers<V>& m) { return ratio(of(m)); });
      };
      search::expect_within_bound(what + mode.name, pairs, draw, measured, effort / 2);
    }
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ContactCubicBound, Scalars);

TYPED_TEST(ContactCubicBound, CoefficientsOfTwoEllipses) {
  this->template measure<Ellipse>("contact_cubic ellipse ellipse", {-3, 8, -6, 12}, false, coefficients_effort,
                                  coefficient_error<TypeParam>);
}
TYPED_TEST(ContactCubicBound, CoefficientsOfCircleAndEllipse) {
  this->template measure<Circle>("contact_cubic circle ellipse", {-8, 10, -8, 12}, false, coefficients_effort,
                                 coefficient_error<TypeParam>);
}
TYPED_TEST(ContactCubicBound, SignForTwoEllipses) {
  this->template measure<Ellipse>("least_value ellipse ellipse", {-3, 5, -6, 10}, true, sign_effort,
                                  [](const auto& c) { return wrong_side(c); });
}
TYPED_TEST(ContactCubicBound, SignForCircleAndEllipse) {
  this->template measure<Circle>("least_value circle ellipse", {-8, 6, -8, 10}, true, sign_effort,
                                 [](const auto& c) { return wrong_side(c); });
}

}  // namespace
