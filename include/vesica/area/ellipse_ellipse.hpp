// SPDX-License-Identifier: Apache-2.0
/// The area that two ellipses share, in the frame in which the one of lesser area is the unit disc and the axes of the
/// other lie along x and y. Across that frame the shared region is cut into slices, each under one arc and above
/// another.
///
/// Why slices: each is a trapezium and two circular segments, none of them negative, between points that lie on their
/// own arcs. A cut that misses its crossing changes the area only by the gap there times the distance missed. So
/// tangent, osculating and nearly equal outlines, whose crossings are ill-conditioned, do no harm. And the arc above or
/// below a slice is less than half a turn, so no angle has to be distinguished from its complement.
#pragma once

#include <vesica/area/box_ellipse.hpp>

namespace vesica::detail::area {

/// The other ellipse in the unit disc's frame: centre (x, y) in the first quadrant, half lengths p >= q along x and y;
/// and by how much areas are smaller there.
template <class V>
struct Against {
  V x, y, p, q, scale;
  V over_p, over_q;
};

/// How that frame lies in the one in which e is the unit disc along its own axes: turned, then reflected where a number
/// is negative, then with its axes exchanged.
template <class V>
struct Placed {
  Against<V> against;
  V cosine, sine, x, y;  ///< x, y: f's centre, turned only
  bool exchange;

  /// A point as it was before.
  Vector<V> undone(const Vector<V>& p) const noexcept {
    const V along = exchange ? p.y : p.x, across = exchange ? p.x : p.y, zero(0.0);
    const V p0 = x < zero ? -along : along, p1 = y < zero ? -across : across;
    return {cosine * p0 + sine * p1, cosine * p1 - sine * p0};
  }
};

/// One Jacobi rotation makes the image of f's matrix diagonal. Its rounding turns f as a whole, centre and axes, about
/// the disc; this does not change the shared area. d: from e's centre to f's.
template <class V>
Placed<V> placed(const Oval<V>& e, const Oval<V>& f, const filter::Centre<V>& d) noexcept {
  const V one(1.0), zero(0.0);
  const V vv = e.ux * e.ux + e.uy * e.uy, over_a = one / (e.a * vv), over_b = one / (e.b * vv);
  const V c = e.ux * f.ux + e.uy * f.uy, s = e.ux * f.uy - e.uy * f.ux, overs = over_a * over_b;
  const V k0 = (e.ux * d.x + e.uy * d.y) * over_a, k1 = (e.ux * d.y - e.uy * d.x) * over_b;
  const V ac = f.a * c, as = f.a * s, bc = f.b * c, bs = f.b * s;
  const V s00 = (ac * ac + bs * bs) * (over_a * over_a), s11 = (as * as + bc * bc) * (over_b * over_b);
  const V s01 = (f.a - f.b) * (f.a + f.b) * (c * s) * overs;
  V tangent = zero;
  // A negligible s01 may underflow at another scale. It is ignored at every scale: of a disc's image it would otherwise
  // determine the axes.
  if (abs(s01) > V(0x1p-200) * (s00 + s11)) {
    const V cotangent = (s11 - s00) / (V(2.0) * s01);  // of twice the angle
    const V size = one / (abs(cotangent) + sqrt(one + cotangent * cotangent));
    tangent = cotangent < zero ? -size : size;
  }
  const V cosine = one / sqrt(one + tangent * tangent), sine = tangent * cosine;
  const V x = cosine * k0 - sine * k1, y = sine * k0 + cosine * k1;
  const V l0 = s00 - tangent * s01, l1 = s11 + tangent * s01;
  const bool exchange = l1 > l0;
  const V p = sqrt(exchange ? l1 : l0), det = f.a * f.b * (f.ux * f.ux + f.uy * f.uy) * vv * overs;
  const V over_p = one / p, q = det * over_p;
  return {{abs(exchange ? y : x), abs(exchange ? x : y), p, q, e.a * e.b * vv, over_p, one / q},
          cosine,
          sine,
          x,
          y,
          exchange};
}

template <class V>
Against<V> against(const Oval<V>& e, const Oval<V>& f, const filter::Centre<V>& d) noexcept {
  return placed(e, f, d).against;
}

/// Both outlines' heights at one x, which must be in the disc: +-disc, and middle +- other. `unit` is other / q.
template <class V>
struct Heights {
  V disc, unit, other;
};

template <class V>
Heights<V> heights(const Against<V>& f, double at) noexcept {
  const V x(at), one(1.0), off = x - f.x;
  const V unit_square = (f.p - off) * f.over_p * ((f.p + off) * f.over_p);
  const V unit = unit_square > V(0.0) ? sqrt(unit_square) : V(0.0);
  return {sqrt((one - x) * (one + x)), unit, f.q * unit};
}

/// The upper (side 1) or lower (side -1) half of the circle. Points are named by their x.
template <class V>
struct HalfCircle {
  const Against<V>& f;
  double side;

  /// A point: how high it is above the diameter, and where it is in the frame in which the other ellipse is the unit
  /// disc.
  struct Point {
    V height, z0, z1;
    /// Outside the other ellipse positive, inside negative.
    double value() const noexcept { return rounded(z0 * z0 + z1 * z1 - 1.0); }
  };
  Point point(double at) const noexcept {
    const V height = sqrt(arithmetic::difference<V>(1, at) * arithmetic::difference<V>(1, -at));
    return {height, (at - f.x) * f.over_p, ((side < 0 ? -height : height) - f.y) * f.over_q};
  }

  double value(double at) const noexcept { return point(at).value(); }
  /// The slope of the value along x at a point, up to a positive factor.
  double slope(double at, const Point& p) const noexcept {
    const V qq = f.over_q * f.over_q;
    const V shallow = (at - f.x) * (f.over_p * f.over_p) - V(at) * qq, steep = V(side * at) * f.y * qq;
    // At the ends of the circle's diameter the slope counts that there is just inside, at no height below 2^-27.
    return rounded((p.height > V(0.0) ? p.height : V(0x1p-27)) * shallow + steep);
  }
  double slope(double at) const noexcept { return slope(at, point(at)); }
  /// A point's value, and the angle along the circle to the nearer zero of the parabola that fits the value there: so a
  /// pair of zeros that nearly coincide is found as soon as one alone.
  struct Step {
    double at, height, value, angle;
    double next() const noexcept { return (at - height * angle) / std::sqrt(1 + angle * angle); }
  };
  Step step(double at) const noexcept {
    const Point p = point(at);
    const double value = p.value(), height = side * rounded(p.height), q = rounded(f.q), flat = q * rounded(f.over_p);
    // In the frame shrunk by q, in which no thin ellipse makes a product overflow: halves of both derivatives.
    const double z0 = q * rounded(p.z0), z1 = q * rounded(p.z1), x0 = flat * at, y0 = flat * height;
    const double here = value < 0x1p1000 ? value * q * q : z0 * z0 + z1 * z1;
    const double slope = z1 * at - z0 * y0, bend = at * at + y0 * y0 - (z0 * x0 + z1 * height);
    const double newton = -0.5 * here / slope, discriminant = 1 + 2 * newton * (bend / slope);  // over slope^2
    return {at, height, value, 2 * newton / (1 + (discriminant > 0 ? std::sqrt(discriminant) : 0))};
  }
};

/// A place and the value there.
struct Place {
  double x, value;
};

/// Between 0 <= low < high: halfway, or of numbers of unlike magnitude as far from either in magnitude.
inline double between_magnitudes(double low, double high) noexcept {
  if (high <= 4 * low) return low + 0.5 * (high - low);
  const double least = 0x1p-40 * high;
  return std::sqrt((low > least ? low : least) * high);
}
/// A place between two of the diameter. Places near its middle or its ends are stored by their distance from there.
inline double between(double low, double high) noexcept {
  if (low < 0 && high > 0) return 0;
  if (low < 0) return -between(-high, -low);
  return low < 0.5 ? between_magnitudes(low, high) : 1 - between_magnitudes(1 - high, 1 - low);
}

/// A lesser value is as good as 0: its terms are about 1, and known to 2^-104 or less well.
inline constexpr double least_value = 0x1p-104;

/// The search for a sign change of the value between two places at which its signs differ, step by step from the
/// secant's zero. The interval is halved where a step would leave it or does not shrink.
template <class V>
class Search {
 public:
  Search() noexcept = default;
  Search(const HalfCircle<V>& half, const Place& from, const Place& to) noexcept
      : half_(&half),
        low_(from.x),
        high_(to.x),
        x_(from.x - from.value * ((to.x - from.x) / (to.value - from.value))),
        negative_at_low_(from.value < 0) {}

  bool found() const noexcept { return found_; }
  double place() const noexcept { return x_; }
  bool begins_at(double x) const noexcept { return low_ == x; }
  /// Ends, for every step narrows the interval, and of some thirty in a row one halves it.
  void step() noexcept { found_ = stepped(); }

 private:
  const HalfCircle<V>* half_ = nullptr;
  double low_ = 0, high_ = 0, x_ = 0, last_angle_ = 4;
  bool negative_at_low_ = false, found_ = false;

  bool is_inside() const noexcept { return x_ > low_ && x_ < high_; }
  /// True if x is the place now.
  bool stepped() noexcept {
    if (!is_inside()) {
      x_ = between(low_, high_);
      if (!is_inside()) return true;
      last_angle_ = 4;
    }
    const auto step = half_->step(x_);
    if (std::fabs(step.value) < least_value) return true;
    ((step.value < 0) == negative_at_low_ ? low_ : high_) = x_;
    // All places so near to the middle are one: what is between them is nothing beside any rounding.
    if (low_ > -0x1p-115 && high_ < 0x1p-115) return true;
    const double angle = std::fabs(step.angle), last_angle = last_angle_;
    last_angle_ = angle < 4 ? angle : 4;
    // If outlines coincide as far as slopes show, a cut may be anywhere.
    if (!(angle < 4) && std::fabs(step.value) * rounded(half_->f.p) < 0x1p-64) return true;
    if (angle < 0x1p-28 || angle <= 0.5 * last_angle) {
      const double next = step.next();
      // The error is then squared once more by the step already made.
      const bool is_near = angle < 0x1p-28 && next >= low_ && next <= high_;
      if (is_near || angle <= 0.5 * last_angle) {
        x_ = next;
        return is_near;
      }
    }
    x_ = between(low_, high_);
    return false;
  }
};

/// All searches of a pair, a step of each at a time: a step is one long chain of operations, and the processor works on
/// the chains of several at once.
template <class V>
struct Searches {
  Search<V> search[8];  ///< two at most on the lower half circle, and two on each of the three parts of the upper
  int count = 0;
  /// If f's centre is on the diameter, both half circles see the same and search the same places: once will do. Such
  /// searches begin at the same place, and searches of one half circle at different ones.
  void add(const HalfCircle<V>& half, const Place& low, const Place& high) noexcept {
    for (int i = 0; i < count && rounded(half.f.y) == 0; ++i) {
      if (search[i].begins_at(low.x)) return;
    }
    search[count++] = Search<V>(half, low, high);
  }
  void run() noexcept {
    for (bool any = true; any;) {
      any = false;
      for (int i = 0; i < count; ++i) {
        if (search[i].found()) continue;
        search[i].step();
        any = true;
      }
    }
  }
};

/// The places along x at which the outlines cross, and the ends of the shared stretch of x, ascending.
struct Cuts {
  double x[10];  ///< two ends, and what Searches finds
  int count = 0;
  void add(double at) noexcept {
    int i = count++;
    for (; i > 0 && x[i - 1] > at; --i) x[i] = x[i - 1];
    x[i] = at;
  }
};

/// The search for where a slope is 0 between two places at which its signs differ: by secants, where the slope of an
/// end that stays twice counts half (the Illinois rule). The interval is halved where three of them do not narrow it.
class LevelSearch {
 public:
  LevelSearch(double from, double slope_from, double to, double slope_to) noexcept
      : from_(from), to_(to), slope_from_(slope_from), slope_to_(slope_to), width_(to - from) {}

  bool holds(double x) const noexcept { return x > from_ && x < to_; }
  bool is_narrow() const noexcept { return to_ - from_ < 0x1p-40; }
  double next() noexcept {
    const bool is_third = ++steps_ % 3 == 0, halved = is_third && to_ - from_ > 0.25 * width_;
    if (is_third) width_ = to_ - from_;
    const double x = zero_of_secant();
    return halved || !holds(x) ? between(from_, to_) : x;
  }
  void take(double x, double slope) noexcept {
    const bool after = (slope < 0) == (slope_to_ < 0);
    (after ? to_ : from_) = x;
    (after ? slope_to_ : slope_from_) = slope;
    const int moved = after ? 1 : -1;
    if (moved == moved_) (after ? slope_from_ : slope_to_) *= 0.5;
    moved_ = moved;
  }

 private:
  double from_, to_, slope_from_, slope_to_, width_;
  int steps_ = 0;
  int moved_ = 0;  ///< the end that the last place replaced: -1 the first, 1 the other

  /// A little off an end that it all but meets.
  double zero_of_secant() const noexcept {
    const double width = to_ - from_, x = to_ - slope_to_ * (width / (slope_to_ - slope_from_));
    return x >= to_ ? to_ - 0x1p-30 * width : x <= from_ ? from_ + 0x1p-30 * width : x;
  }
};

/// Crossings on a part of a half circle on which the value along x is convex (bend 1) or concave (bend -1): one where
/// the ends differ in sign; else two if the extreme value between them differs. That is first sought at `guess`, if it
/// is between them.
template <class V>
void add_crossings(const HalfCircle<V>& half, const Place& low, const Place& high, double bend, double guess,
                   Searches<V>& crossings) noexcept {
  if (!(low.x < high.x)) return;
  const bool negative = low.value < 0;
  if (negative != (high.value < 0)) {
    crossings.add(half, low, high);
    return;
  }
  if ((bend > 0) == negative) return;
  const double slope_low = half.slope(low.x), slope_high = half.slope(high.x);
  if ((slope_low < 0) == (slope_high < 0) || (slope_low < 0) != (bend > 0)) return;
  LevelSearch extreme(low.x, slope_low, high.x, slope_high);
  double x = extreme.holds(guess) ? guess : extreme.next();
  for (int i = 0; i < 60 && extreme.holds(x) && !extreme.is_narrow(); ++i) {
    const auto point = half.point(x);
    const double value = point.value();
    if ((value < 0) != negative) {
      crossings.add(half, low, {x, value});
      crossings.add(half, {x, value}, high);
      return;
    }
    extreme.take(x, half.slope(x, point));
    x = extreme.next();
  }
}

/// r^(1/3) for 0 < r < 1, to a few digits: it only divides intervals.
inline double cube_root(double r) noexcept {
  double x = arithmetic::power_of_two(arithmetic::exponent_of(r) / 3);
  for (int i = 0; i < 6; ++i) x = (2 * x + r / (x * x)) / 3;
  return x;
}

/// On the lower half circle the value is concave along x, f's centre being above; on the upper it is convex, but
/// concave within +-`reach`, sqrt(1 - r^(2/3)), r = y p^2 / (p^2 - q^2), where r < 1; for r >= 1 that is 0. With f's
/// centre at x = 0 it is least at +-`least`, sqrt(1 - r^2).
struct Upper {
  double reach = 0, least = 0;
};
/// If outlines nearly coincide, a double would not distinguish p from q.
template <class V>
Upper upper_half(const Against<V>& f) noexcept {
  const V one(1.0), ratio = f.q * f.over_p, flatness = (one - ratio) * (one + ratio);
  if (!(f.y < flatness)) return {};
  const double r = rounded(f.y / flatness), root = r > 0 ? cube_root(r) : 0;
  const double least = std::sqrt(rounded((flatness - f.y) / flatness) * (1 + r));
  return {root < 1 ? std::sqrt((1 - root) * (1 + root)) : 0, least};
}

/// Crossings along a half circle, from the first of n places on to the last. At those between them the bend changes.
/// The extreme value is likely near -guess on the first part, and near guess on the last.
template <class V>
void add_crossings(const HalfCircle<V>& half, const double* x, int n, double bend, double guess,
                   Searches<V>& crossings) noexcept {
  Place before{x[0], half.value(x[0])};
  for (int i = 1; i < n; ++i, bend = -bend) {
    const Place here{x[i], half.value(x[i])};
    add_crossings(half, before, here, bend, i == 1 ? -guess : guess, crossings);
    before = here;
  }
}

/// All cuts.
template <class V>
Cuts cuts(const Against<V>& f) noexcept {
  const double low = rounded(f.x - f.p), high = rounded(f.x + f.p);
  const double ends[] = {low > -1 ? low : -1, high < 1 ? high : 1};
  Cuts all;
  if (!(ends[0] < ends[1])) return all;
  for (const double end : ends) all.add(end);
  const HalfCircle<V> upper{f, 1}, lower{f, -1};
  const Upper shape = upper_half(f);
  const double bends[] = {ends[0], clamp(-shape.reach, ends[0], ends[1]), clamp(shape.reach, ends[0], ends[1]),
                          ends[1]};
  Searches<V> crossings;
  constexpr double no_guess = 2;
  add_crossings(lower, ends, 2, -1, no_guess, crossings);
  add_crossings(upper, shape.reach == 0 ? ends : bends, shape.reach == 0 ? 2 : 4, 1, shape.least, crossings);
  crossings.run();
  for (int i = 0; i < crossings.count; ++i) all.add(crossings.search[i].place());
  return all;
}

/// Between the circle and its chord over a slice.
inline double disc_segment(double x0, double y0, double x1, double y1) noexcept {
  const double dx = x1 - x0, dy = y1 - y0, sx = x1 + x0, sy = y1 + y0;
  return segment_area(dx * dx + dy * dy, sx * sx + sy * sy);
}

/// By how much the disc's outline is inside the other's at one x, above and below.
struct Gaps {
  double above = 0, below = 0;
  /// If outlines touch between two cuts, one look may find that very place: the widest gap of several counts.
  template <class V>
  void look(const Against<V>& f, const Heights<V>& h) noexcept {
    const double above_here = rounded(f.y + h.other - h.disc), below_here = rounded(h.other - f.y - h.disc);
    if (std::fabs(above_here) > std::fabs(above)) above = above_here;
    if (std::fabs(below_here) > std::fabs(below)) below = below_here;
  }
  bool clear() const noexcept { return std::fabs(above) > 0x1p-20 && std::fabs(below) > 0x1p-20; }
};

/// The shared area between two cuts.
template <class V>
double slice(const Against<V>& f, double x0, const Heights<V>& h0, double x1, const Heights<V>& h1) noexcept {
  const double width = x1 - x0;
  const double middle = x0 + 0.5 * width;
  const Heights<V> m = heights(f, middle);
  if (!(f.y - m.other < m.disc && -m.disc < f.y + m.other))
    return 0;  // between the outlines' crossing and the end of either
  Gaps gaps;
  gaps.look(f, m);
  if (!gaps.clear()) {
    gaps.look(f, heights(f, x0 + 0.1875 * width));
    gaps.look(f, heights(f, x0 + 0.84375 * width));
  }
  const bool disc_above = gaps.above > 0, disc_below = gaps.below > 0;
  const auto top = [&](const Heights<V>& h) { return disc_above ? h.disc : f.y + h.other; };
  const auto bottom = [&](const Heights<V>& h) { return disc_below ? -h.disc : f.y - h.other; };
  const double at_0 = rounded(top(h0) - bottom(h0)), at_1 = rounded(top(h1) - bottom(h1));
  double arcs = 0;
  if (disc_above || disc_below) {
    const double one = disc_segment(x0, rounded(h0.disc), x1, rounded(h1.disc));
    arcs += disc_above && disc_below ? 2 * one : one;
  }
  if (!(disc_above && disc_below)) {
    const double dx = rounded(V(width) * f.over_p), dy = rounded(h1.unit - h0.unit);
    const double sx = rounded((V(x0) - f.x + (V(x1) - f.x)) * f.over_p), sy = rounded(h1.unit + h0.unit);
    const double one = segment_area(dx * dx + dy * dy, sx * sx + sy * sy);
    arcs += rounded(f.p * f.q) * (!disc_above && !disc_below ? 2 * one : one);
  }
  return 0.5 * width * (at_0 + at_1) + arcs;
}

template <class V>
double area_in_disc(const Against<V>& f) noexcept {
  const Cuts all = cuts(f);
  if (all.count == 0) return 0;
  double area = 0;
  Heights<V> before = heights(f, all.x[0]);
  for (int i = 1; i < all.count; ++i) {
    if (!(all.x[i - 1] < all.x[i])) continue;
    const Heights<V> here = heights(f, all.x[i]);
    area += slice(f, all.x[i - 1], before, all.x[i], here);
    before = here;
  }
  return area > 0 ? area : 0;
}

/// The same, as a function of its own: in double-doubles it is what takes longest of an area, and the library has it
/// once more for processors that fuse (src/queries/area_in_disc.cpp).
template <class V>
VESICA_CALLED double called_area_in_disc(const Against<V>& f) noexcept {
  return area_in_disc(f);
}

/// As for boxes.
inline bool goes_first(const Oval<double>& e, const Oval<double>& f, const filter::Centre<double>& d) noexcept {
  const auto area = [](const Oval<double>& o) { return o.a * o.b * (o.ux * o.ux + o.uy * o.uy); };
  return order(filter::Box<double>{e.ux, e.uy, e.a, e.b}, filter::Box<double>{f.ux, f.uy, f.a, f.b}, d, area(e),
               area(f))
      .first;
}

inline Settled<double, bool> crossing_area_in_order(const Oval<double>& e, const Oval<double>& f,
                                                    const filter::Centre<double>& d) noexcept {
  const double a0 = aspect(e.a, e.b), a1 = aspect(f.a, f.b), span = span_about(e, f.ux, f.uy, f.a, f.b, d);
  if (!(span <= 64 * (a0 > a1 ? a0 : a1))) return {0, false};
  const Against<double> g = against(e, f, d);
  const double area = area_in_disc(g), error = 0x1p-46 * span;
  return {area * g.scale, area > error && pi_high - area > error};
}

/// The area of two ellipses, d from e's centre to f's. Settled as for a box and an ellipse.
inline Settled<double, bool> crossing_area(const Oval<double>& e, const Oval<double>& f,
                                           const filter::Centre<double>& d) noexcept {
  if (!in_clip_range(filter::Box<double>{e.ux, e.uy, e.a, e.b}, f, d)) return {0, false};
  if (!goes_first(e, f, d)) return crossing_area_in_order(f, e, {-d.x, -d.y});
  return crossing_area_in_order(e, f, d);
}

}  // namespace vesica::detail::area
