// SPDX-License-Identifier: Apache-2.0
/// area() of polygons, without clipping.
///
/// With another polygon: over each x, the edges of a polygon from above bound parts inside and outside in turn. With
/// s = 1 for an edge whose inside is below and -1 for one whose inside is above, the shared area is the sum over pairs
/// of edges of s_e s_f times the integral of min(y_e, y_f) over their common x. Over each x the signs of a polygon add
/// up to 0, so y_f may be taken off: min(y_e - y_f, 0) remains, and a pair with e above f adds nothing.
///
/// With a row of numbers: in its frame the polygon's outline is clamped to it, as area/rounded_boxes.hpp does it.
///
/// An area within its own error of 0 is 0, and one within its error of the lesser shape's area is that area. So the
/// answer is exact where the shapes touch, and where one contains the other. If both hold, a shape is so thin that the
/// exact relation decides.
#pragma once

#include <optional>
#include <vesica/area.hpp>
#include <vesica/polygon/line.hpp>
#include <vesica/polygon/own_area.hpp>
#include <vesica/polygon/relation.hpp>

namespace vesica {

namespace detail::polygon {

/// A computed area in units of 2^exponent, and twice a bound of its error, since a shape's own area is off too.
struct Estimate {
  double area, error;
  int exponent;
};

/// find_relation() returns the exact relation.
template <class FindRelation>
Measure settled(const Estimate& e, const Measure& a, const Measure& b, const FindRelation& find_relation) noexcept {
  const Measure least = area::least(a, b);
  const bool nearly_none = !(e.area > e.error), nearly_all = area::in_units(least, e.exponent) - e.area <= e.error;
  if (nearly_none && !(nearly_all && find_relation() > Relation::cross)) return {0, 0};
  return nearly_all ? least : Measure{e.area, e.exponent};
}

// ---- Two polygons.

/// Heights are counted from a level. An edge that is_wide() does not find wide gets a line that adds nothing.
VESICA_INLINE Line<double> line(const Edge& e, double level, bool is_wide) noexcept {
  if (!is_wide) return {0, 0, 0, 0, 0};
  const bool right = e.x0 < e.x1;
  return {right ? e.x0 : e.x1, right ? e.x1 : e.x0, (right ? e.y0 : e.y1) - level, (e.y1 - e.y0) / (e.x1 - e.x0),
          right ? 1.0 : -1.0};
}

/// Lines side by side, for loops that compilers turn into vectors.
struct Lines {
  int count = 0;
  double x0[few_edges + 2], x1[few_edges + 2], y0[few_edges + 2], slope[few_edges + 2], sign[few_edges + 2];

  VESICA_INLINE void set(int i, const Line<double>& l, double sense) noexcept {
    x0[i] = l.x0;
    x1[i] = l.x1;
    y0[i] = l.y0;
    slope[i] = l.slope;
    sign[i] = l.sign * sense;
  }
  VESICA_INLINE Line<double> operator[](int i) const noexcept { return {x0[i], x1[i], y0[i], slope[i], sign[i]}; }
};

/// The terms of pairs of edges, for walk().
///
/// Each height is off by at most 10u times the greatest height g, so the first difference by 22u g, and the second, as
/// the slopes times the common width are at most 2g, by 40u g. A term is off by at most 46u g times that width. The
/// terms of an edge with up to 32 others are added as they are: all are within 64u g times all their widths.
template <class T>
class SharedArea {
 public:
  SharedArea(const Edges<T>& a, const Edges<T>& b, Senses<T>& sense_a, Senses<T>& sense_b, const Box& box_a,
             const Box& box_b) noexcept
      : sense_a_(sense_a),
        sense_b_(sense_b),
        scale_({lesser(box_a.min_x, box_b.min_x), lesser(box_a.min_y, box_b.min_y), greater(box_a.max_x, box_b.max_x),
                greater(box_a.max_y, box_b.max_y)}) {
    const Box p = scale_(box_a), q = scale_(box_b), common = shared(p, q);
    level_ = 0.5 * common.min_y + 0.5 * common.max_y;
    height_ = greater(greater(p.max_y, q.max_y) - level_, level_ - lesser(p.min_y, q.min_y));
    least_width_ = 0x1p-200 * (common.max_x - common.min_x);
    walk(a, box_a, b, box_b, Policy{*this});
  }

  Estimate estimate() const noexcept { return {lane::abs(sum_.value()), 0x1p-46 * height_ * widths_, scale_.exponent}; }

 private:
  struct Policy {
    SharedArea& all;

    /// Edges above others add nothing.
    bool keeps(const Box& a, const Box& b) const noexcept {
      using lane::both;
      return both(both(a.min_x < b.max_x, b.min_x < a.max_x), a.min_y < b.max_y);
    }
    bool visit_few(const Edges<T>&, const Range& range_a, const Edges<T>&, const Range& range_b,
                   const Box& box_b) const noexcept {
      Lines lines;
      all.sense_b_.for_edges(range_b, [&](const Edge& stored, double sense) {
        const Edge f = all.scale_(stored);
        lines.set(lines.count++, line(f, all.level_, all.is_wide(f)), sense);
      });
      lines.set(lines.count, {0, 0, 0, 0, 0}, 1);  // beside an odd one
      all.sense_a_.for_edges(range_a, [&](const Edge& stored, double sense) {
        if (!keeps(box_of(stored), box_b)) return;
        const Edge e = all.scale_(stored);
        if (all.is_wide(e)) all.add(line(e, all.level_, true), sense, lines);
      });
      return false;
    }
  };

  bool is_wide(const Edge& e) const noexcept { return lane::abs(e.x1 - e.x0) > least_width_; }

  VESICA_INLINE void add(const Line<double>& e, double sense, const Lines& f) noexcept {
    double sum[2] = {0, 0}, widths[2] = {0, 0};
    for (int k = 0; k < f.count; k += 2) {
      for (int lane = 0; lane < 2; ++lane) {
        const Term<double> t = term(e, f[k + lane]);
        sum[lane] += t.area;
        widths[lane] += t.width;
      }
    }
    sum_ += 0.5 * (e.sign * sense) * (sum[0] + sum[1]);
    widths_ += widths[0] + widths[1];
  }

  Senses<T>&sense_a_, &sense_b_;
  Scale scale_;
  double level_, height_, least_width_, widths_ = 0;
  Sum sum_;
};

/// An order of two polygons by their numbers, so that exchanging them changes no bit.
template <class T>
bool precedes(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept {
  if (box_a.min_x != box_b.min_x) return box_a.min_x < box_b.min_x;
  if (box_a.min_y != box_b.min_y) return box_a.min_y < box_b.min_y;
  if (box_a.max_x != box_b.max_x) return box_a.max_x < box_b.max_x;
  if (box_a.max_y != box_b.max_y) return box_a.max_y < box_b.max_y;
  if (a.rings() != b.rings()) return a.rings() < b.rings();
  for (std::int64_t j = 0; j < a.rings(); ++j) {
    const Range p = a.ring(j), q = b.ring(j);
    if (p.length() != q.length()) return p.length() < q.length();
    for (std::int64_t i = 0; i < p.length(); ++i) {
      const Point<double> s = a.vertex(p.first + i), t = b.vertex(q.first + i);
      if (s.x != t.x) return s.x < t.x;
      if (s.y != t.y) return s.y < t.y;
    }
  }
  return true;
}

/// The shared area and both own ones, and boxes about both. Returns 0 or error_shape.
struct PathShares : area::Shares {
  Box box_a, box_b;
};

template <class T>
std::int32_t shares(const Edges<T>& a, const Edges<T>& b, PathShares& out) noexcept {
  if (a.check(out.box_a) != 0 || b.check(out.box_b) != 0) return error_shape;
  Senses<T> sense_a(a), sense_b(b);
  out.a = measure(a, out.box_a, sense_a);
  out.b = measure(b, out.box_b, sense_b);
  out.shared = {0, 0};
  out.equal = false;
  const Box common = polygon::shared(out.box_a, out.box_b);
  if (out.a.value == 0 || out.b.value == 0 || !(common.min_x < common.max_x && common.min_y < common.max_y)) return 0;
  const Estimate e = precedes(a, out.box_a, b, out.box_b)
                         ? SharedArea<T>(a, b, sense_a, sense_b, out.box_a, out.box_b).estimate()
                         : SharedArea<T>(b, a, sense_b, sense_a, out.box_b, out.box_a).estimate();
  out.shared = settled(e, out.a, out.b, [&] { return relation_valid(a, out.box_a, b, out.box_b); });
  return 0;
}

// ---- A polygon and a row of numbers.

/// A row as a rounded box or an ellipse, in units of 2^unit, and its own area, 0 if it has none.
struct RowArea {
  area::RoundedBox<double> box{};
  form::Corners<double> place{};
  int unit = 0;
  Measure own{0, 0};
};

/// reach: the greatest coordinate of the polygon, for the unit.
template <template <class> class Shape>
RowArea row_area(const Shape<double>& s, double reach) noexcept {
  return form::with_simplest(s, [&](const auto& shape) {
    RowArea row;
    if constexpr (area::has_area<std::remove_cvref_t<decltype(shape)>>) {
      row.own = area::shape_measure(shape);
      if (row.own.value == 0) return row;
      row.box = area::rounded_box(shape);
      form::Corners<double>& p = row.place;
      p = form::corners(filter::place(form::inflated(shape).core));
      for (const double c : {p.x0, p.y0, p.x1, p.y1}) reach = greater(reach, lane::abs(c));
      if (area::in_clip_range(row.box) && reach <= 0x1p150) [[likely]]
        return row;
      const int lift = area::lift_for(reach);
      const area::Core core = area::core(shape, lift);
      row.unit = std::clamp(std::max(core.exponent(), arithmetic::exponent_of(reach)), -1000, 1000);
      row.box = core.in_units<double>(row.unit);
      const double k = arithmetic::power_of_two(-row.unit);
      p = {p.x0 * k, p.y0 * k, p.x1 * k, p.y1 * k};
    }
    return row;
  });
}

/// Where the row is a rounded box about the origin, or the unit disc.
class RowFrame {
 public:
  explicit RowFrame(const RowArea& row) noexcept
      : row_(row),
        scale_(row.unit == 0 ? 1 : arithmetic::power_of_two(-row.unit)),
        over_x_(row.box.is_oval ? 1 / row.box.hx : 1),
        over_y_(row.box.is_oval ? 1 / row.box.hy : 1) {}

  area::RoundedFrame<double> frame() const noexcept {
    const auto& b = row_.box;
    if (b.is_oval) return {0, 0, 1, 1, 1};
    return {b.hx, b.hy, b.r, b.hx + b.r, b.hy + b.r};
  }
  /// How many times larger areas are there.
  double unit_area() const noexcept { return row_.box.is_oval ? row_.box.hx * row_.box.hy : 1; }

  VESICA_INLINE area::Vector<double> image(double x, double y) const noexcept {
    const auto d = offset(x, y);
    const auto& b = row_.box;
    return {(b.ux * d.x + b.uy * d.y) * over_x_, (b.ux * d.y - b.uy * d.x) * over_y_};
  }
  /// The sum of the numbers that an image of a point of a box is made of, at most.
  double terms(const Box& box) const noexcept {
    const auto low = offset(box.min_x, box.min_y), high = offset(box.max_x, box.max_y);
    const double apart = greater(lane::abs(low.x), lane::abs(high.x)) + greater(lane::abs(low.y), lane::abs(high.y));
    return apart * greater(over_x_, over_y_);
  }

 private:
  VESICA_INLINE area::Vector<double> offset(double x, double y) const noexcept {
    const auto& p = row_.place;
    return {filter::offset_of_ends(p.x0, p.x1, x * scale_, x * scale_),
            filter::offset_of_ends(p.y0, p.y1, y * scale_, y * scale_)};
  }

  const RowArea& row_;
  double scale_, over_x_, over_y_;
};

/// No vertex's image is off by more than 16u times terms(), u = 2^-53; what lies within the row of each edge is at most
/// two of its lengths. The sum and what its terms round to is less.
template <class T>
Estimate estimate(const Edges<T>& edges, const Box& box, Senses<T>& senses, const RowArea& row) noexcept {
  const RowFrame frame(row);
  const area::RoundedFrame<double> f = frame.frame();
  const area::Profile profile(f);
  const double around = f.ex + f.ey;
  double lengths = 0;
  Sum total;
  std::int64_t steps = 0;
  for (std::int64_t j = 0; j < edges.rings(); ++j) {
    std::optional<area::Walk> walk(profile);
    const double sense = senses.of_ring(j);
    const Range vertices = edges.ring(j);
    if (vertices.length() < 3) continue;
    const auto image = [&](std::int64_t i) {
      const Point<double> v = edges.vertex(i);
      return frame.image(v.x, v.y);
    };
    area::Vector<double> to = image(vertices.last - 1);
    bool to_inside = profile.holds(to);
    for (std::int64_t i = vertices.first; i < vertices.last; ++i) {
      const area::Vector<double> from = to;
      const bool from_inside = to_inside;
      to = image(i);
      to_inside = profile.holds(to);
      const area::Vector<double> along = to - from;
      if (along.x == 0 && along.y == 0) continue;
      const bool beside = lesser(from.x, to.x) >= f.ex || greater(from.x, to.x) <= -f.ex;
      const bool beyond = lesser(from.y, to.y) >= f.ey || greater(from.y, to.y) <= -f.ey;
      if (beside) continue;
      if (beyond) {
        walk->outside(from.x, to.x, from.y);
      } else {
        lengths += lesser(lane::abs(along.x) + lane::abs(along.y), 2 * around);
        area::add_edge(f, profile, from, area::EdgeDirection<double>(along), from_inside && to_inside, *walk);
      }
      if (++steps % few_edges == 0) {  // few are added as they are
        total += sense * walk->sum();
        walk.emplace(profile);
        lengths += 0x1p-6 * around;
      }
    }
    total += sense * walk->sum();
  }
  const double unit = frame.unit_area();
  return {unit * lane::abs(total.value()), unit * (0x1p-46 * (frame.terms(box) + around) * (lengths + around)),
          2 * row.unit};
}

/// Returns 0 or error_shape.
template <class T, class Other>
std::int32_t shares(const Edges<T>& a, const Other& b, PathShares& out) noexcept {
  if (a.check(out.box_a) != 0 || check_other(b) != 0) return error_shape;
  const Box& box = out.box_a;
  Senses<T> senses(a);
  const RowArea row = row_area(b, greater(greater(lane::abs(box.min_x), lane::abs(box.max_x)),
                                          greater(lane::abs(box.min_y), lane::abs(box.max_y))));
  out.a = measure(a, box, senses);
  out.b = row.own;
  out.shared = {0, 0};
  out.equal = false;
  if (out.a.value == 0 || out.b.value == 0 || !meet(box, box_about(b))) return 0;
  out.shared = settled(estimate(a, box, senses, row), out.a, out.b, [&] { return relation_valid(a, box, b); });
  return 0;
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline: 0, error_shape or error_range. Edges of a polygon must not cross.
///
/// The error of two polygons' area is at most 192u g w, u = 2^-53: g is the greater of the two heights from the middle
/// of the common box to the ends of both, and w the sum of the common widths of pairs of edges, for convex polygons
/// four times the width of the common box. With a row of numbers it is at most 192u t l: t is the row's half width and
/// height plus the greatest distance of the polygon from its centre, and l the length of the outline about the row plus
/// the row's half width and height.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t area_or_error(const A<T>& a, const B<T>& b, T& out)
noexcept {
  using namespace detail::polygon;
  if constexpr (!Path<A<T>>) {
    return vesica::area_or_error(b, a, out);
  } else {
    PathShares shares;
    std::int32_t error;
    if constexpr (Path<B<T>>) {
      error = detail::polygon::shares(Edges<T>(a), Edges<T>(b), shares);
    } else {
      error = detail::polygon::shares(Edges<T>(a), widen(b), shares);
    }
    return error != 0 ? error : detail::area::store(shares.shared, out);
  }
}

}  // namespace vesica
