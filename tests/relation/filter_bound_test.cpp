// SPDX-License-Identifier: Apache-2.0
// |computed - exact| <= bound for what the filters of relations estimate, in float and in double; and what nesting() is
// sure of is so, with exact roots and quotients and with ones as rough as lanes may have. The truth is computed from
// the stored numbers in exact integers; the inputs are searched for the worst.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vesica/filter/box_ellipse.hpp>
#include <vesica/filter/disc.hpp>
#include <vesica/filter/nesting.hpp>
#include <vesica/relation.hpp>

#include "filter/bounds.hpp"
#include "oracle/oracle.hpp"

namespace {

using namespace vesica;
using bounds::error_over_bound;
using bounds::offset;
using bounds::true_offset;
using inputs::Exponents;
using inputs::Numbers;
using inputs::shape_at;
using truth::Dyadic;

constexpr int sign_effort = 1200;

template <class V>
class RelationBound : public bounds::Bound<V, 5000> {
 protected:
  /// Near where containment, or else overlap, changes.
  template <template <class> class A, class Ratio>
  static void measure_about_contact(const std::string& what, const Exponents& e, Ratio ratio) {
    properties::Random random(properties::seed());
    inputs::Inputs<V> pairs(ShapeTraits<A<V>>::kind, Kind::ellipse, inputs::widened<V>(e), random);
    const auto of = [&](const Numbers<V>& n) {
      return ratio(shape_at<A<V>>(n.data()), shape_at<Ellipse<V>>(n.data() + pairs.first_count()));
    };
    const auto draw = [&] {
      Numbers<V> n = pairs.draw();
      while (of(n) < 0) n = pairs.draw();
      const V factor = std::ldexp(V(1), random.integer(-5, 5));
      n[pairs.count() - 2] *= factor;
      n[pairs.count() - 1] *= factor;
      const auto code = [&](const Numbers<V>& m) {
        return vesica::relation(shape_at<A<V>>(m.data()), shape_at<Ellipse<V>>(m.data() + pairs.first_count()));
      };
      const Relation here = code(n);
      return pairs.near_contact(n, [&](const auto& m) { return code(m) == here; });
    };
    search::expect_within_bound(what, pairs, draw, of, sign_effort);
  }

  static int relation(const Ellipse<V>& a, const Ellipse<V>& b) {
    return oracle::relation(5, numbers(a).data(), 5, numbers(b).data());
  }
  static int relation(const Circle<V>& a, const Ellipse<V>& b) {
    const std::array<double, 3> n{a.cx, a.cy, a.r};
    return oracle::relation(2, n.data(), 5, numbers(b).data());
  }

 private:
  static std::array<double, 6> numbers(const Ellipse<V>& e) { return {e.cx, e.cy, e.ux, e.uy, e.a, e.b}; }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(RelationBound, Scalars);

Dyadic min(const Dyadic& a, const Dyadic& b) { return a < b ? a : b; }

/// How far b reaches out of a along the axes of a, times |u|.
Dyadic farthest_out(const truth::Box& a, const truth::Box& b, const truth::Vector& d) {
  const Dyadic c = abs(dot(a.u, b.u)), s = abs(cross(a.u, b.u)), uu = dot(a.u, a.u);
  return max(abs(dot(a.u, d)) + b.hx * c + b.hy * s - a.hx * uu, abs(cross(a.u, d)) + b.hx * s + b.hy * c - a.hy * uu);
}

constexpr auto boxes = [](const auto& a, const auto& b) {
  const auto axes = filter::separating_axes(filter::box(a), filter::box(b), offset(a, b));
  if (!filter::box_axis_in_range(axes.uu) || !filter::box_axis_in_range(axes.ww)) return -1.0;
  const truth::Box box_a = truth::box(a), box_b = truth::box(b);
  const truth::Vector d = true_offset(a, b);
  return std::max(error_over_bound(axes.b_out_of_a, farthest_out(box_a, box_b, d)),
                  error_over_bound(axes.a_out_of_b, farthest_out(box_b, box_a, d)));
};

TYPED_TEST(RelationBound, BoxOutOfBox) {
  this->template measure<Segment, Segment>("segment segment", {-25, 25, -26, 26}, boxes);
  this->template measure<Segment, Aabb>("segment aabb", {-25, 25, -26, 26}, boxes);
  this->template measure<Segment, Rect>("segment rect", {-25, 25, -26, 26}, boxes);
  this->template measure<Aabb, Rect>("aabb rect", {-25, 25, -90, 75}, boxes);
  this->template measure<Rect, Rect>("rect rect", {-25, 25, -90, 75}, boxes);
}

constexpr auto box_and_ellipse = [](const auto& b, const auto& e) {
  using V = decltype(e.a + 0);
  const auto box = filter::box(b);
  const auto d = offset(b, e);
  const auto f = filter::box_frame(box, e, d);
  const auto in_range = [](V x) { return x >= filter::guard_power<V, -5>() && x <= filter::guard_power<V, 15>(); };
  if (!in_range(f.uu) || !in_range(f.vv) || std::min(e.a, e.b) < filter::guard_power<V, -10>()) return -1.0;
  const auto box_out = filter::box_out_of_ellipse(f, box, e, d), ellipse_out = filter::ellipse_out_of_box(f);
  if (!(box_out.error <= filter::guard_power<V, 100>() && ellipse_out.error <= filter::guard_power<V, 100>()))
    return -1.0;

  const truth::Box tb = truth::box(b);
  const truth::Ellipse te = truth::ellipse(e);
  const truth::Vector td = true_offset(b, e);
  const Dyadic uu = dot(tb.u, tb.u), c = dot(tb.u, te.v), s = cross(tb.u, te.v);
  const Dyadic room_x = max(tb.hx * uu - abs(dot(tb.u, td)), 0), room_y = max(tb.hy * uu - abs(cross(tb.u, td)), 0);
  const Dyadic out =
      max(square(te.a * c) + square(te.b * s) - square(room_x), square(te.a * s) + square(te.b * c) - square(room_y));
  Dyadic farthest = -determinant(te);
  for (const int i : {-1, 1}) {
    for (const int k : {-1, 1}) {
      const truth::Vector corner{i * tb.hx * tb.u.x - k * tb.hy * tb.u.y - td.x,
                                 i * tb.hx * tb.u.y + k * tb.hy * tb.u.x - td.y};
      farthest = max(farthest, truth::outside_ellipse(te, corner));
    }
  }
  return std::max(error_over_bound(box_out, farthest), error_over_bound(ellipse_out, out));
};

TYPED_TEST(RelationBound, BoxAndEllipse) {
  this->template measure<Segment, Ellipse>("segment ellipse", {-2, 6, -9, 7}, box_and_ellipse);
  this->template measure<Aabb, Ellipse>("aabb ellipse", {-2, 6, -10, 14}, box_and_ellipse);
  this->template measure<Rect, Ellipse>("rect ellipse", {-2, 6, -10, 14}, box_and_ellipse);
}

constexpr auto box_and_disc = [](const auto& first, const auto& second) {
  const auto measure = [](const auto& b, const auto& disc) {
    using V = decltype(disc.r + 0);
    const auto box = filter::box(b);
    const auto d = offset(b, disc);
    const V uu = box.ux * box.ux + box.uy * box.uy;
    const auto box_out = filter::box_out_of_disc(box, d, disc.r, uu),
               disc_out = filter::disc_out_of_box(box, d, disc.r, uu);
    if (!filter::in_range(uu, filter::guard_power<V, -20>(), filter::guard_power<V, 20>())) return -1.0;
    if (!(box_out.error <= filter::guard_power<V, 100>())) return -1.0;
    const truth::Box tb = truth::box(b);
    const truth::Vector td = true_offset(b, disc);
    const Dyadic tu = dot(tb.u, tb.u), k0 = abs(dot(tb.u, td)), k1 = abs(cross(tb.u, td)),
                 reached = truth::square(disc.r) * tu;
    const Dyadic room = max(min(tb.hx * tu - k0, tb.hy * tu - k1), 0);
    return std::max(error_over_bound(box_out, square(k0 + tb.hx * tu) + square(k1 + tb.hy * tu) - reached),
                    error_over_bound(disc_out, reached - square(room)));
  };
  if constexpr (requires { first.r; }) {
    return measure(second, first);
  } else {
    return measure(first, second);
  }
};

TYPED_TEST(RelationBound, BoxAndDisc) {
  this->template measure<Segment, Circle>("segment circle", {0, 0, -11, 11}, box_and_disc);
  this->template measure<Circle, Rect>("circle rect", {-10, 9, -40, 50}, box_and_disc);
  this->template measure<Circle, Aabb>("circle aabb", {0, 0, -50, 63}, [](const auto& c, const auto& box) {
    const Dyadic x(c.cx), y(c.cy), r(c.r);
    const auto room = [](const Dyadic& at, double low, double high) {
      return min(at - Dyadic(low), Dyadic(high) - at);
    };
    const auto reach = [](const Dyadic& at, double low, double high) {
      return max(at - Dyadic(low), Dyadic(high) - at);
    };
    const truth::Vector corner{reach(x, box.min_x, box.max_x), reach(y, box.min_y, box.max_y)};
    return std::max(
        error_over_bound(filter::disc_out_of_aabb(c, box),
                         r - min(room(x, box.min_x, box.max_x), room(y, box.min_y, box.max_y))),
        error_over_bound(filter::beyond_reach(filter::farthest_offset(c, box), c.r), truth::beyond_reach(corner, r)));
  });
}

TYPED_TEST(RelationBound, DiscAndDisc) {
  this->template measure<Circle, Circle>("circle circle", {0, 0, -50, 63}, [](const auto& a, const auto& b) {
    return error_over_bound(filter::beyond_reach(offset(a, b), a.r - b.r),
                            truth::beyond_reach(true_offset(a, b), Dyadic(a.r) - Dyadic(b.r)));
  });
}

/// A pair's pencil as the filter sees it and exactly, the ellipse of lesser area first as the filter has it.
template <class V>
struct Pair {
  filter::Pencil<V> computed;
  truth::Cubic exact;
  Dyadic det1, mu, det2;
  bool exchanged, in_guard;

  void exchange() {
    if (!exchanged) return;
    computed = filter::exchanged_where(true, computed);
    std::swap(exact.d1, exact.d2);
    std::swap(exact.c1, exact.c2);
    std::swap(det1, det2);
  }
};

template <class V>
Pair<V> pair_of(const Ellipse<V>& e, const Ellipse<V>& f) {
  const V vv = e.ux * e.ux + e.uy * e.uy, ww = f.ux * f.ux + f.uy * f.uy;
  const auto s = filter::pencil(e, f, offset(e, f), vv, ww);
  const auto te = truth::ellipse(e), tf = truth::ellipse(f);
  const truth::Vector d = true_offset(e, f);
  const truth::Cubic exact = truth::contact_cubic(te, tf, d);
  const bool usable = filter::ellipse_ellipse_usable(s.contact, e, f, vv, ww);
  Pair<V> pair{s, exact, exact.d1, exact.c1 - exact.d1 + adjugate(te, d), exact.d2, s.det1 > s.det2, usable};
  pair.exchange();
  return pair;
}

template <class V>
Pair<V> pair_of(const Circle<V>& disc, const Ellipse<V>& e) {
  const V vv = e.ux * e.ux + e.uy * e.uy, rr = disc.r * disc.r;
  const auto s = filter::pencil(disc, e, offset(disc, e), vv);
  const auto te = truth::ellipse(e);
  const bool sizes = std::min({e.a, e.b, disc.r}) >= filter::guard_power<V, -5>() && vv >= filter::guard_power<V, -8>();
  const Dyadic uu = dot(te.v, te.v), p = square(te.a) * uu, q = square(te.b) * uu;
  Pair<V> pair{s,
               truth::contact_cubic(disc.r, te, true_offset(disc, e)),
               p * q,
               p + q,
               1,
               s.det1 > rr * rr,
               sizes && filter::totals_in_range(s.contact)};
  pair.exchange();
  return pair;
}

/// The values of q and of w |w| - delta at the y that the filter takes.
constexpr auto polynomials = [](const auto& a, const auto& b) {
  const auto pair = pair_of(a, b);
  if (!pair.in_guard) return -1.0;
  const auto n = filter::nesting(pair.computed);
  if (!std::isfinite(n.y)) return 0.0;
  const Dyadic y(n.y), w = 2 * pair.det2 * y - pair.mu;
  const Dyadic q = pair.exact.d1 - ((pair.exact.d2 * y - pair.exact.c2) * y + pair.exact.c1) * y;
  // For a negative y the bounds are none, and only "neither" is said.
  if (n.y < 0) return certainly_nested(n) ? 2.0 : 0.0;
  return std::max(error_over_bound(n.top, q),
                  error_over_bound(n.beyond, w * abs(w) - (square(pair.mu) - 4 * pair.det1 * pair.det2)));
};

TYPED_TEST(RelationBound, Nesting) {
  this->template measure<Ellipse, Ellipse>("ellipse ellipse", {-3, 5, -6, 10}, polynomials);
  this->template measure<Circle, Ellipse>("circle ellipse", {-4, 6, -5, 10}, polynomials);
}

/// A scalar whose root and quotient are as rough as lanes' may be (scalar.hpp), to the side that the signs give.
template <class T, int RootSide, int QuotientSide>
struct Rough {
  using Element = T;
  static constexpr T most = sizeof(T) == 4 ? T(0x1p-13) : T(0x1p-26);
  T v;
  Rough() = default;
  explicit Rough(T x) : v(x) {}
  friend Rough operator+(Rough a, Rough b) { return Rough(a.v + b.v); }
  friend Rough operator-(Rough a, Rough b) { return Rough(a.v - b.v); }
  friend Rough operator-(Rough a) { return Rough(-a.v); }
  friend Rough operator*(Rough a, Rough b) { return Rough(a.v * b.v); }
  friend bool operator>(Rough a, Rough b) { return a.v > b.v; }
  friend bool operator<(Rough a, Rough b) { return a.v < b.v; }
  friend Rough abs(Rough a) { return Rough(std::fabs(a.v)); }
  friend Rough positive_part(Rough a) { return Rough(lane::positive_part(a.v)); }
  friend Rough rough_sqrt(Rough a) { return Rough(std::sqrt(a.v) * (1 + RootSide * most)); }
  friend Rough rough_quotient(Rough a, Rough b) { return Rough(a.v / b.v * (1 + QuotientSide * most)); }
};

/// How far the filter's numbers say that the first ellipse lies within the second, or that neither lies in the other,
/// by the bounds they must exceed to say so for certain.
template <class V>
struct Claims {
  double within, neither;
};

template <class V, class R>
Claims<V> claims(const filter::Pencil<V>& s) {
  const filter::ContactCubic<V>& p = s.contact;
  const filter::Nesting<R> n = filter::nesting(filter::Pencil<R>{
      {R(p.d1), R(p.c1), R(p.c2), R(p.d2), R(p.total1), R(p.total2)}, R(s.det1), R(s.mu), R(s.det2), R(s.turned)});
  // There bounds are none, and "neither" may be said, of what is so.
  if (n.y.v < 0) return {certainly_nested(n) ? 2.0 : 0.0, certainly_not_nested(n) ? 2.0 : 0.0};
  const auto of = [](double value, double error) { return std::isfinite(error) ? value / error : 0; };
  const double top = of(n.top.value.v, n.top.error.v), beyond = of(n.beyond.value.v, n.beyond.error.v);
  const double before = of(-static_cast<double>(n.beyond.value.v) - static_cast<double>(n.slack.v), n.beyond.error.v);
  return {std::min(top, beyond), std::max(-top, before)};
}

/// Above 1 where the filter is sure of what is not so.
template <class V, class R>
double wrong_side(const Pair<V>& pair, int code) {
  const Claims<V> c = claims<V, R>(pair.computed);
  const bool nested = code >= 3;
  const bool within = pair.exchanged ? code == 5 : code == 3;
  return std::max({0.0, nested ? c.neither : 0.0, within ? 0.0 : c.within});
}

template <class V>
double wrong_side(const Pair<V>& pair, int code) {
  if (!pair.in_guard) return -1;
  return std::max({wrong_side<V, Rough<V, 0, 0>>(pair, code), wrong_side<V, Rough<V, 1, 1>>(pair, code),
                   wrong_side<V, Rough<V, 1, -1>>(pair, code), wrong_side<V, Rough<V, -1, 1>>(pair, code),
                   wrong_side<V, Rough<V, -1, -1>>(pair, code)});
}

TYPED_TEST(RelationBound, CertainNesting) {
  this->template measure_about_contact<Ellipse>(
      "certain, ellipse ellipse", {-3, 5, -6, 10},
      [this](const auto& a, const auto& b) { return wrong_side(pair_of(a, b), this->relation(a, b)); });
  // The pencil's first is the ellipse: seen from it, the circle's relation to it is the converse of its own.
  this->template measure_about_contact<Circle>("certain, circle ellipse", {-4, 5, -5, 9},
                                               [this](const auto& a, const auto& b) {
                                                 const int code = this->relation(a, b);
                                                 return wrong_side(pair_of(a, b), code == 3 ? 5 : code == 5 ? 3 : code);
                                               });
}

}  // namespace
