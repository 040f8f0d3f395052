// SPDX-License-Identifier: Apache-2.0
/// The direction n along which the shapes are separated longest, found in double. Terms that cancel where the line
/// grazes M are computed in twofold arithmetic. bound.hpp measures afterwards how good n is.
///
/// With n = -v + s perp(v) and q = D.v it maximises the concave g(s) = v.v T(n) + q,
///
///     g(s) = w s - sum of p_j |s - k_j| - sum of sqrt(al_i (s - s_i)^2 + de_i)
///     an ellipse with c = u.v, k = u x v:
///         al = (a k)^2 + (b c)^2, s_i = (b^2 - a^2) c k / al, de = (a b u.u v.v)^2 / al
///     a box: p = hx |k| at s = -c / k, the normal perp(u), and p = hy |c| at s = k / c, the normal u.
#pragma once

#include <bit>
#include <limits>
#include <vesica/cast/bound.hpp>

namespace vesica::detail::cast {

/// One of two results, of lanes by selecting, of scalars by a branch: it is mostly foreseen, and a select would wait.
template <class V, class Yes, class No>
VESICA_INLINE auto foreseen(V mask, const Yes& yes, const No& no) noexcept {
  if constexpr (std::is_same_v<V, bool>) {
    return mask ? yes() : no();
  } else if constexpr (requires { yes().x; }) {
    const auto first = yes(), second = no();
    return decltype(yes()){choose(mask, first.x, second.x), choose(mask, first.y, second.y)};
  } else {
    return select(mask, yes(), no());
  }
}

template <class V>
struct CurveOf {
  V s, al, de, reach;

  /// Slope of sqrt(al (s - s_i)^2 + de).
  VESICA_INLINE V slope(V at) const noexcept {
    const auto bent = [&] {
      const V y = at - s;
      return al * y / sqrt(al * y * y + de);
    };
    return foreseen(abs(at) < V(0x1p500), bent, [&] { return flip_sign(reach, at); });
  }
  /// How wide the bend is: a unit of s.
  VESICA_INLINE V width() const noexcept { return sqrt(de) / reach; }
};
using Curve = CurveOf<double>;

inline double dot_of(const Scene& scene, const Vector& u) noexcept { return u.x.high * scene.vx + u.y.high * scene.vy; }
inline double cross_of(const Scene& scene, const Vector& u) noexcept {
  return u.x.high * scene.vy - u.y.high * scene.vx;
}

inline Curve curve(const Scene& scene, const Side& e) noexcept {
  const double c = dot_of(scene, e.u), k = cross_of(scene, e.u), a = e.hx.high, b = e.hy.high;
  const double al = (a * k) * (a * k) + (b * c) * (b * c);
  const double uu = e.u.x.high * e.u.x.high + e.u.y.high * e.u.y.high, vv = scene.vx * scene.vx + scene.vy * scene.vy;
  const double area = a * b * uu * vv;
  return {((b - a) * (b + a)) * (c * k) / al, al, area * area / al, sqrt(al)};
}

/// The normal turned against v. Double usually decides whether to turn it; unpredictable, so no branch.
template <class Products>
Vector against(const Scene& scene, const Vector& n) noexcept {
  const double x = n.x.high * scene.vx, y = n.y.high * scene.vy;
  double forward = x + y;
  if (!(abs(forward) > 0x1p-48 * (abs(x) + abs(y)) + 0x1p-900)) {
    forward = arithmetic::renormalised(Products::factor(n.x) * Products::factor(scene.vx) +
                                       Products::factor(n.y) * Products::factor(scene.vy))
                  .high;
  }
  const double turn = lane::select(forward > 0, -1.0, 1.0);
  return {{turn * n.x.high, turn * n.x.low}, {turn * n.y.high, turn * n.y.low}};
}

/// -v + s perp(v).
template <class Products>
Vector direction(const Scene& scene, double s) noexcept {
  const auto by = Products::factor(s);
  const Twofold<double> x = by * Products::factor(scene.vy), y = by * Products::factor(scene.vx);
  return {renormalised(-(x + Twofold<double>{scene.vx, 0})), renormalised(y - Twofold<double>{scene.vy, 0})};
}

/// A face of a box, whose normal is its axis (`lengthwise`) or across that, or a vertex: w without the terms of the
/// box, each with its sign there.
template <class V>
struct Feature {
  MaskOf<V> face, lengthwise;
  Twofold<V> w;
};

/// Which of them a curve meets; c = u.v, k = u x v.
template <class Products, class V>
VESICA_INLINE Feature<V> feature(const nearest::Box<V>& box, const Twofold<V>& c, const Twofold<V>& k,
                                 const Twofold<V>& w, const CurveOf<V>& e) noexcept {
  const V zero(0.0);
  const Twofold<V> of_hx = magnitude(Products::factor(box.hx) * Products::factor(k));
  const Twofold<V> of_hy = magnitude(Products::factor(box.hy) * Products::factor(c));
  const V across_at = select(k.high == zero, V(-0x1p600), -c.high / k.high);
  const V along_at = select(c.high == zero, V(0x1p600), k.high / c.high);
  const MaskOf<V> along_first = along_at < across_at;
  const Twofold<V> first = choose(along_first, of_hy, of_hx), second = choose(along_first, of_hx, of_hy);
  const V at_first = e.slope(min(across_at, along_at)), at_second = e.slope(max(across_at, along_at));
  // The terms cancel where the curve is far less than the box: what is left is then in the lower part.
  const auto left_over = [&](const Twofold<V>& a, const Twofold<V>& b) { return renormalised(w + a + b); };
  const Twofold<V> left = left_over(first, second), middle = left_over(-first, second),
                   right = left_over(-first, -second);
  // A side of no length is no face, however exactly the curve's slope is that between the two beside it.
  const MaskOf<V> on_left = left.high < at_first;
  const MaskOf<V> first_face = and_not(and_not(middle.high <= at_first, is_zero(first)), on_left);
  const MaskOf<V> on_middle = and_not(middle.high < at_second, either(on_left, first_face));
  const MaskOf<V> before_second = either(either(on_left, first_face), on_middle);
  const MaskOf<V> second_face = and_not(and_not(right.high <= at_second, is_zero(second)), before_second);
  const MaskOf<V> lengthwise = either(both(first_face, along_first), and_not(second_face, along_first));
  return {either(first_face, second_face), lengthwise, choose(on_left, left, choose(on_middle, middle, right))};
}

/// How far the ellipse reaches across v.
template <class Products>
Twofold<double> reach_across(const Scene& scene, const Side& e) noexcept {
  const DotAndCross of_v = dot_and_cross<Products>(e.u, factor_of_v<Products>(scene));
  const Twofold<double> p = Products::factor(e.hx) * Products::factor(of_v.cross);
  const Twofold<double> q = Products::factor(e.hy) * Products::factor(of_v.dot);
  return renormalised(Products::root(square(Products::factor(p)) + square(Products::factor(q))).value);
}

/// How far the line stays within the reach: at least 2^-106 of that, for what rounding makes of nothing.
template <class V>
VESICA_INLINE V gap_of(const Twofold<V>& reach, const Twofold<V>& w) noexcept {
  const Twofold<V> side = arithmetic::renormalised(w);
  return max(arithmetic::rounded(reach - flipped(side, side.high)), V(0x1p-106) * reach.high);
}

/// Returns the s at which the curve's slope is w.
template <class V>
VESICA_INLINE V maximum_of_one(const CurveOf<V>& e, V w, V gap) noexcept {
  const V side = abs(w);
  return e.s + flip_sign(e.width() * (side / sqrt(gap * (e.reach + side))), w);
}

/// r - al y / h without cancellation, the root of h and its bend.
template <class V>
struct Tail {
  V rest, h, bend;
};
template <class V>
VESICA_INLINE Tail<V> tail(const CurveOf<V>& e, V s) noexcept {
  const V y = s - e.s, h = sqrt(e.al * y * y + e.de), t = e.reach * y;
  const auto before = [&] { return e.reach * (V(1.0) - t / h); };
  const auto behind = [&] { return e.reach * (e.de / (h * (h + t))); };
  return {foreseen(t > V(0.0), behind, before), h, e.al * (e.de / (h * h * h))};
}

/// Finds the s at which the slopes of two curves have the sum w >= 0: each rest falls from twice its reach to 0, and
/// both together are the gap. Newton's method on the power -1/2 of their sum, which is nearly straight where the line
/// grazes; within a bracket, the places at which either alone has its share of w. Returns the number of steps; lanes
/// take as many as the last of them, and those in which nothing is asked, `idle`, do not count.
template <class V>
VESICA_INLINE int maximum_of_two(const CurveOf<V>& a, const CurveOf<V>& b, V gap, MaskOf<V> idle, V& s) noexcept {
  const V sum = a.reach + b.reach, share = V(1.0) - gap / sum, widths = share / sqrt((gap / sum) * (V(1.0) + share));
  const V at_a = a.s + a.width() * widths, at_b = b.s + b.width() * widths;
  V low = min(at_a, at_b), high = max(at_a, at_b);
  const V weight_a = a.al / sqrt(a.de), weight_b = b.al / sqrt(b.de);
  s = (weight_a * at_a + weight_b * at_b) / (weight_a + weight_b);
  const auto old = [&] { return s; };
  s = foreseen(both(s >= low, s <= high), old, [&] { return low; });
  int steps = 1;
  for (; steps < 80; ++steps) {
    const Tail<V> ta = tail(a, s), tb = tail(b, s);
    const V rest = ta.rest + tb.rest, bend = ta.bend + tb.bend;
    const MaskOf<V> above = rest > gap;
    low = foreseen(above, old, [&] { return low; });
    high = foreseen(
        above, [&] { return high; }, old);
    V next = s + V(2.0) * rest * (rest - gap) / ((sqrt(rest * gap) + gap) * bend);
    const auto newton = [&] { return next; };
    const auto middle = [&] { return V(0.5) * (low + high); };
    next = foreseen(both(next >= low, next <= high), newton, middle);
    if (steps > 52) next = middle();  // Newton's method goes in a circle: of millions that end none took more than 50
    const MaskOf<V> done =
        either(abs(next - s) <= V(0x1p-28) * min(ta.h / a.reach, tb.h / b.reach), nearest::negated<V>(low < high));
    s = foreseen(idle, old, newton);
    idle = either(idle, done);
    if (all(idle)) break;
  }
  return steps;
}
inline double maximum_of_two(const Curve& a, const Curve& b, double gap, int& steps) noexcept {
  double s;
  steps = maximum_of_two(a, b, gap, false, s);
  return s;
}

/// The maximum for two ellipses, w being renormalised. If w < 0, it is found in the mirror image.
template <class Products>
double maximum_of_ellipses(const Scene& scene, const Side& first, const Side& second, const Twofold<double>& w,
                           int& steps) noexcept {
  const double gap =
      gap_of(arithmetic::renormalised(reach_across<Products>(scene, first) + reach_across<Products>(scene, second)), w);
  Curve a = curve(scene, first), b = curve(scene, second);
  a.s = lane::flip_sign(a.s, w.high);
  b.s = lane::flip_sign(b.s, w.high);
  return lane::flip_sign(maximum_of_two(a, b, gap, steps), w.high);
}

/// A direction and its bounds of t0; no direction if the products chosen do not suffice. `beside`, if not 0, is the
/// normal of a face nearly along v, whose time is known poorly: that face is hit instead if contact comes after
/// `until`.
struct Found {
  Vector normal;
  TimeBounds time;
  Vector beside{};
  double until = 0;

  bool has_beside() const noexcept { return beside.x.high != 0 || beside.y.high != 0; }
  bool is_met_beside(double t) const noexcept { return t > until && has_beside(); }
  bool has_direction() const noexcept { return normal.x.high != 0 || normal.y.high != 0; }
};

inline double difference(const Twofold<double>& a, const Twofold<double>& b) noexcept {
  return (a.high - b.high) + (a.low - b.low);
}

/// True if n is chosen rather than m, two normals with the same time: the one more opposed to v; among mirror images
/// the one to the left of v; among parallel ones the longer. So exchanging the shapes changes nothing.
inline bool preferred(const Scene& scene, const Vector& n, const Vector& m) noexcept {
  const auto length = [](const Vector& x) { return x.x.high * x.x.high + x.y.high * x.y.high; };
  const double forward_n = dot_of(scene, n), forward_m = dot_of(scene, m);
  const double share_n = forward_n * forward_n * length(m), share_m = forward_m * forward_m * length(n);
  if (share_n != share_m) return share_n > share_m;
  const double side_n = cross_of(scene, n), side_m = cross_of(scene, m);
  if ((side_n > 0) != (side_m > 0)) return side_n > 0;
  return length(n) > length(m);
}

/// A normal of two boxes and its time in double, with errors.
struct Axis {
  Vector normal;
  double least, most;
};

/// Its time is certain to be between `least` and `most`: 16u of the sum of all terms covers four products and as many
/// sums of each.
template <class Products>
Axis axis(const Scene& scene, const Vector& normal) noexcept {
  const Vector n = against<Products>(scene, normal);
  const double nx = n.x.high, ny = n.y.high, approach = -(nx * scene.vx + ny * scene.vy), n_size = abs(nx) + abs(ny);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(approach > 0x1p-40 * n_size * scene.speed())) return {n, -infinity, infinity};
  double height = 0;
  for (const Side* s : {&scene.a, &scene.b}) {
    const double ux = s->u.x.high, uy = s->u.y.high;
    height += s->hx.high * abs(ux * nx + uy * ny) + s->hy.high * abs(ux * ny - uy * nx);
  }
  const double t = (nx * scene.d.x.high + ny * scene.d.y.high - height) / approach;
  const double error = 16 * 0x1p-53 * n_size * (scene.size + scene.speed() * abs(t)) / approach;
  return {n, t - error, t + error};
}

/// Adds a face's normal to what was found: contact after the time found so far is with that face.
VESICA_COLD inline Found with_beside(const Found& found, const Vector& beside) noexcept {
  const double t = found.time.value.high;
  return {found.normal, found.time, beside, t + (0x1p-50 * abs(t) + found.time.error)};
}

/// Chooses between two axes whose times are equal within their errors. Only the second may have a normal beside it.
VESICA_COLD inline Found preferred_of(const Scene& scene, const Found& n, const Found& m) noexcept {
  const bool is_first = n.time.error < m.time.error;
  const Found &nearer = is_first ? n : m, &farther = is_first ? m : n;
  const bool hides_much = farther.time.error * scene.speed() > 0x1p-60 * scene.size;
  if (!hides_much || n.time.error == m.time.error) {
    Found out = preferred(scene, n.normal, m.normal) ? n : m;
    out.beside = m.beside;
    out.until = lane::max(0.0, m.until) + 4 * farther.time.error;
    return out;
  }
  return with_beside(nearer, farther.normal);
}

/// Fallback if no axis separates after the start, and yet the shapes touch then: the axis most nearly across v. A thin
/// ellipse that is taken for a segment is hit beside the segment, along v.
VESICA_COLD inline Vector across_way(const Scene& scene, const Axis* axes, int count) noexcept {
  const auto share = [&](const Axis& x) {
    return abs(dot_of(scene, x.normal)) / (abs(x.normal.x.high) + abs(x.normal.y.high));
  };
  const Axis* most = axes;
  for (int i = 1; i < count; ++i) most = share(axes[i]) < share(*most) ? axes + i : most;
  const Vector& n = most->normal;
  return n.x.high * scene.d.x.high + n.y.high * scene.d.y.high < 0 ? opposite(n) : n;
}

/// Two boxes: the latest of the times at which an axis separates no more. An axis across v separates always or never,
/// and the line test has decided which. Double selects the axes that may be the latest, usually one.
template <class Products>
Found latest_axis(const Scene& scene) noexcept {
  Axis axes[4];
  int count = 0;
  double least = 0;
  const Vector &u = scene.a.u, &w = scene.b.u;
  const bool same = u.x.high == w.x.high && u.y.high == w.y.high && u.x.low == w.x.low && u.y.low == w.y.low;
  // The axes of a point are none of the sum's, and those of two that are parallel are the same.
  const bool no_a = has_no_size(scene.a), no_b = has_no_size(scene.b);
  const bool only_a = same || (no_b && !no_a), only_b = !same && no_a && !no_b;
  for (const Side* side : {&scene.a, &scene.b}) {
    if (side == &scene.a ? only_b : only_a) continue;
    for (const Vector& n : {side->u, perpendicular(side->u)}) {
      axes[count] = axis<Products>(scene, n);
      least = lane::max(axes[count++].least, least);
    }
  }
  Found best{};
  bool found = false, certain = true;
  double error = 0;
  const auto v = factor_of_v<Products>(scene);
  // Bits, not branches: usually one axis is left, and which one is unpredictable.
  unsigned left = 0;
  for (int i = 0; i < count; ++i) left |= static_cast<unsigned>(!(axes[i].most < least)) << i;
  for (; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const Vector& normal = axes[i].normal;
    const auto n = Products::factor(normal);
    const TimeBounds time =
        lower_bound<Products>(scene, n, v, height_of<Products>(scene.a, n) + height_of<Products>(scene.b, n));
    if (!time.is_known()) {
      certain = certain && time.certain;
      if (!found && !time.certain) best.normal = normal;
      continue;
    }
    error = lane::max(time.error, error);
    const double later = found ? difference(time.value, best.time.value) : 0;
    const bool equal = found && abs(later) <= 2 * (time.error + best.time.error);
    if (equal) {
      best = preferred_of(scene, {normal, time}, best);
    } else if (!found || later > 0) {
      // A face of whose time errors hide much may still be met after this.
      best = best.has_beside() ? with_beside({normal, time}, best.beside) : Found{normal, time};
    }
    found = true;
  }
  if (!best.has_direction()) best.normal = across_way(scene, axes, count);
  best.time.error = 6 * error;  // the normal that is preferred may tell a time that little earlier
  best.time.certain = certain && found;
  return best;
}

/// Certainly.
inline bool is_later(const TimeBounds& a, const TimeBounds& b) noexcept {
  return difference(a.value, b.value) > a.error + b.error;
}

/// Contact with a curve: Newton's method removes the remaining slope until the gain no longer counts.
template <class Products>
Found polished(const Scene& scene, double s) noexcept {
  Found found{};
  for (int i = 0;; ++i) {
    if (!Products::holds(s)) return {};
    const Vector n = direction<Products>(scene, s);
    const TimeBounds t = time_bounds<Products>(scene, n);
    if (i > 0 && (!t.is_known() || (found.time.certain && !t.certain) || is_later(found.time, t))) return found;
    found = {n, t};
    if (i == 3 || !finite(t.step) || (t.certain && t.gain <= 0x1p-70 * abs(t.value.high))) return found;
    s += t.step;
  }
}

/// The latest of the vertex and face-normal times. Beside a face the range of the vertex's normals may be narrower than
/// the step of s, and beyond it another vertex lies farthest. If the vertex has no time, it is hit if contact comes
/// after the faces' times. One face always has a time: a face is at most 45 degrees from across v.
template <class Products>
VESICA_COLD Found latest_beside_faces(const Scene& scene, const Found& at_vertex) noexcept {
  Found found = at_vertex;
  for (const Side* box : {&scene.a, &scene.b}) {
    if (box->round || (scene.has_radius() && has_no_size(*box))) continue;
    for (const Vector& u : {box->u, perpendicular(box->u)}) {
      const Vector n = against<Products>(scene, u);
      const TimeBounds time = time_bounds<Products>(scene, n);
      if (time.is_known() && (!found.time.is_known() || is_later(time, found.time))) found = {n, time};
    }
  }
  return at_vertex.time.is_known() ? found : with_beside(found, at_vertex.normal);
}

/// A face of two boxes' sum: at s its normal becomes the farthest; `slope` is what it takes from w.
struct Kink {
  double s;
  Twofold<double> slope;
  Vector normal;
};

/// The disc of both radii with two boxes, or a box and an ellipse: the face whose time is the latest, or a vertex.
template <class Products>
Found latest_with_radius(const Scene& scene, int& steps) noexcept {
  const Side disc = scene.disc(), &ellipse = scene.a.round ? scene.a : scene.b;
  const Curve e = curve(scene, disc), f = curve(scene, ellipse);
  const auto v = factor_of_v<Products>(scene);
  Kink kinks[4];
  int count = 0;
  Twofold<double> w = renormalised(cross(v, Products::factor(scene.d)));
  const auto add = [&](const Twofold<double>& slope, double along, double across, const Vector& normal) {
    if (is_zero(slope) || across == 0) return;
    const Kink kink{along / across, magnitude(slope), normal};
    int at = count++;
    for (; at > 0 && kinks[at - 1].s > kink.s; --at) kinks[at] = kinks[at - 1];
    kinks[at] = kink;
  };
  for (const Side* box : {&scene.a, &scene.b}) {
    if (box->round) continue;
    const DotAndCross of_v = dot_and_cross<Products>(box->u, v);
    const Twofold<double> c = renormalised(of_v.dot), k = renormalised(of_v.cross);
    add(Products::factor(box->hx) * Products::factor(k), -c.high, k.high, perpendicular(box->u));
    add(Products::factor(box->hy) * Products::factor(c), k.high, c.high, box->u);
  }
  // Terms cancel where the disc is far smaller than a box: each sum begins with w.
  const auto left_over = [&](int passed) {
    Twofold<double> sum = w;
    for (int i = 0; i < count; ++i) sum = i < passed ? sum - kinks[i].slope : sum + kinks[i].slope;
    return renormalised(sum);
  };
  Twofold<double> rest = left_over(0);
  for (int i = 0; i < count; ++i) {
    const double slope = ellipse.round ? e.slope(kinks[i].s) + f.slope(kinks[i].s) : e.slope(kinks[i].s);
    if (rest.high < slope) break;
    rest = left_over(i + 1);
    if (rest.high <= slope) {
      const Vector normal = against<Products>(scene, kinks[i].normal);
      const Found face{normal, time_bounds<Products>(scene, normal)};
      return face.time.certain ? face : latest_beside_faces<Products>(scene, face);
    }
  }
  const double s = ellipse.round ? maximum_of_ellipses<Products>(scene, ellipse, disc, rest, steps)
                                 : maximum_of_one(e, rest.high, gap_of(reach_across<Products>(scene, disc), rest));
  const Found found = polished<Products>(scene, s);
  if (found.time.certain || !found.has_direction()) return found;
  return latest_beside_faces<Products>(scene, found);
}

/// steps: how many the search of two ellipses took, which tests look at.
template <class Products>
Found latest_direction(const Scene& scene, int& steps) noexcept {
  steps = 0;
  if (scene.has_radius()) return latest_with_radius<Products>(scene, steps);
  if (!scene.a.round && !scene.b.round) return latest_axis<Products>(scene);
  const bool of_box = scene.a.round != scene.b.round;
  const Side &round = scene.a.round ? scene.a : scene.b, &box = scene.a.round ? scene.b : scene.a;
  double s;
  if (of_box) {
    const Curve e = curve(scene, round);
    const auto v = factor_of_v<Products>(scene);
    const DotAndCross of_v = dot_and_cross<Products>(box.u, v);
    const Feature<double> met = feature<Products>(nearest::Box<double>{box.u, box.hx, box.hy}, of_v.dot, of_v.cross,
                                                  cross(v, Products::factor(scene.d)), e);
    if (met.face) {
      const Vector normal = against<Products>(scene, met.lengthwise ? box.u : perpendicular(box.u));
      return {normal, time_bounds<Products>(scene, normal)};
    }
    const Twofold<double> w = arithmetic::renormalised(met.w);
    s = maximum_of_one(e, w.high, gap_of(reach_across<Products>(scene, round), w));
  } else {
    const auto w = arithmetic::renormalised(cross(factor_of_v<Products>(scene), Products::factor(scene.d)));
    s = maximum_of_ellipses<Products>(scene, scene.a, scene.b, w, steps);
  }
  const Found found = polished<Products>(scene, s);
  if (!of_box || found.time.certain || !found.has_direction()) return found;
  return latest_beside_faces<Products>(scene, found);
}

}  // namespace vesica::detail::cast
