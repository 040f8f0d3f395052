// SPDX-License-Identifier: Apache-2.0
/// The pieces of a segment that are in a polygon or on a polyline, in order along the segment. Which pieces there are,
/// and which of them are single points, is decided by exact signs.
///
/// Edges cut the segment's line at places: at a stored vertex or a stored end, or where an edge crosses. Between two
/// places the segment is along an edge, inside or outside. Counts of edges that begin and end at each place say which:
///
/// - edges along the segment, by how many cover the part behind the place;
/// - edges from the left of the line to the line or across it. Each changes whether the left of the segment is inside,
///   by the even-odd rule. A part along no edge lies as its left does.
#pragma once

#include <vesica/arithmetic/double_double.hpp>
#include <vesica/polygon/crossings.hpp>
#include <vesica/polygon/overlap.hpp>

namespace vesica {

namespace detail::polygon {

/// The caller's room for the vertices of a shared region, as points of doubles or floats. A zero becomes +0.
struct RegionRoom {
  void* out;
  bool is_float;
  std::int64_t capacity, count = 0;
  std::int32_t error = 0;

  /// The numbers that are written for a vertex.
  Point<double> rounded(const Point<double>& p) noexcept {
    return is_float ? rounded_to<float>(p) : rounded_to<double>(p);
  }
  void write(std::int64_t k, const Point<double>& p) const noexcept {
    if (k >= capacity) return;
    if (is_float) {
      static_cast<Point<float>*>(out)[k] = {static_cast<float>(p.x), static_cast<float>(p.y)};
    } else {
      static_cast<Point<double>*>(out)[k] = p;
    }
  }
  void add(const Point<double>& p) noexcept { write(count++, rounded(p)); }
  std::int64_t result() const noexcept { return error != 0 ? error : count; }

 private:
  template <class T>
  Point<double> rounded_to(const Point<double>& p) noexcept {
    const T x = static_cast<T>(p.x) + T{0}, y = static_cast<T>(p.y) + T{0};
    if (!all_finite(x, y)) error = error_range;
    return {static_cast<double>(x), static_cast<double>(y)};
  }
};

/// The place at which e crosses f, as a part of e, from its nearer end. Returns false where products are too far off.
///
/// Proved: the point is within 4u of the largest coordinate and size. Differences are exact, so each cross product is
/// off by less than 2^-100 of its terms, and the part, at most 1/2, by less than 2^-59 + u / 2. Three roundings of the
/// part, the step and their product are at most 1.5u of the step, and the sum adds u of the coordinate.
inline bool cross_at(const Edge& e, const Edge& f, Point<double>& p) noexcept {
  using Twice = arithmetic::FastDoubleDouble<double>;
  double terms = 0;
  const auto cross = [&](double x, double y) {
    const Twice left = arithmetic::sum(f.x0, -x) * arithmetic::sum(f.y1, -y),
                right = arithmetic::sum(f.y0, -y) * arithmetic::sum(f.x1, -x);
    terms = greater(terms, greater(lane::abs(left.high), lane::abs(right.high)));
    return left - right;
  };
  const Twice start = cross(e.x0, e.y0), end = cross(e.x1, e.y1), whole = start - end;
  const double size = lane::abs(whole.high);
  if (!(terms > 0x1p-800 && terms < 0x1p900 && size > 0x1p-40 * terms)) return false;
  const double part = lane::abs(start.high) / size, rest = lane::abs(end.high) / size;
  const auto at = [&](double from, double to) {
    return part <= rest ? from + part * (to - from) : to - rest * (to - from);
  };
  p = {at(e.x0, e.x1), at(e.y0, e.y1)};
  return true;
}

/// The crossing of two edges, the same for every order and direction of them. Infinite where it is out of range. The
/// shorter edge gives the place more precisely.
inline Point<double> crossing_of(const Edge& first, const Edge& second) noexcept {
  const Edge e = upward(first), f = upward(second);
  const auto length = [](const Edge& s) { return lane::abs(s.x1 - s.x0) + lane::abs(s.y1 - s.y0); };
  const int order = compared(length(e), length(f));
  Point<double> p, q;
  if ((order > 0 || cross_at(e, f, p)) && (order < 0 || cross_at(f, e, q))) {
    if (order != 0) return order < 0 ? p : q;
    return p.x < q.x || (p.x == q.x && p.y < q.y) ? p : q;
  }
  CrossingPoints<double> met;
  if (vesica::crossings_or_error(e, f, met) != 1) return {infinite, infinite};
  return {met.x[0], met.y[0]};
}

/// A place on the segment, and what changes there.
struct Cut {
  OnEdge at;
  bool turns = false;  // the left of the segment changes between inside and outside
  int covers = 0;      // edges along the segment that begin here, less those that end here

  void join(const Cut& other) noexcept {
    if (!at.stored && (other.at.stored || comes_before(other.at.across, at.across))) at = other.at;
    turns ^= other.turns;
    covers += other.covers;
  }

 private:
  /// One of the edges that cross at a place gives its numbers, wherever the rings begin.
  static bool comes_before(const Edge& first, const Edge& second) noexcept {
    const Edge e = upward(first), f = upward(second);
    const double p[] = {e.x0, e.y0, e.x1, e.y1}, q[] = {f.x0, f.y0, f.x1, f.y1};
    return std::lexicographical_compare(p, p + 4, q, q + 4);
  }
};

/// The cuts of a path in a segment of some length.
template <class T>
class PiecesAlong {
 public:
  PiecesAlong(const Edges<T>& path, const Edge& segment) noexcept
      : path_(path), segment_(segment), box_(box_of(segment)), left_is_inside_(path.closed() && is_odd_ahead()) {}

  /// Calls visit(from, to, is_point) for each piece. The rounded ends of a piece that is no point may be equal.
  template <class Visit>
  void find(const Visit& visit) noexcept {
    constexpr int most = 32;
    Cut found[most];
    std::optional<OnEdge> last;
    int count = 0;
    do {  // some cuts at a time: those behind the last one
      count = 0;
      path_.for_edges([&](const Edge& f, std::int64_t) {
        if (!meet(box_of(f), box_)) return false;
        for_cuts(f, [&](const Cut& cut) {
          if (last && order_along(segment_, cut.at, *last) <= 0) return;
          count = insert(cut, found, count, most);
        });
        return false;
      });
      for (int k = 0; k < count; ++k) pass(found[k], visit);
      if (count > 0) last = found[count - 1].at;
    } while (count == most);
    if (open_ || (first_ && left_is_inside_)) visit(open_ ? from_ : start_of(segment_), end_of(segment_), false);
  }

 private:
  /// Is the left of the segment inside, just behind its start? By the edges that its line crosses from there on.
  bool is_odd_ahead() const noexcept {
    bool odd = false;
    path_.for_edges([&](const Edge& f, std::int64_t) {
      const bool from_left = side(f.x0, f.y0, segment_) > 0, to_left = side(f.x1, f.y1, segment_) > 0;
      if (from_left != to_left) odd ^= side(segment_.x0, segment_.y0, f) == (to_left ? 1 : -1);
      return false;
    });
    return odd;
  }

  /// Keeps the first `most` cuts in order, each place once. Returns how many there are.
  int insert(const Cut& cut, Cut* found, int count, int most) const noexcept {
    int k = count;
    for (; k > 0; --k) {
      const int order = order_along(segment_, cut.at, found[k - 1].at);
      if (order > 0) break;
      if (order == 0) {
        found[k - 1].join(cut);
        return count;
      }
    }
    if (k == most) return count;
    count = std::min(count + 1, most);
    for (int n = count - 1; n > k; --n) found[n] = found[n - 1];
    found[k] = cut;
    return count;
  }

  /// The cuts that an edge makes within the segment. What changes at its two ends needs no care.
  template <class Visit>
  void for_cuts(const Edge& f, const Visit& visit) const noexcept {
    const int s0 = side(f.x0, f.y0, segment_), s1 = side(f.x1, f.y1, segment_);
    if (s0 * s1 > 0) return;
    const int t0 = side(segment_.x0, segment_.y0, f), t1 = side(segment_.x1, segment_.y1, f);
    if (t0 * t1 > 0) return;
    if (s0 == 0 && s1 == 0) return for_stretch(f, visit);
    const bool turns = (s0 > 0) != (s1 > 0);
    if (s0 == 0 || s1 == 0) {
      const Point<double> p = s0 == 0 ? start_of(f) : end_of(f);
      if (holds(box_, p)) visit(Cut{{p, {}}, turns});
    } else if (t0 == 0 || t1 == 0) {
      visit(Cut{{t0 == 0 ? start_of(segment_) : end_of(segment_), {}}, turns});
    } else {
      visit(Cut{{{}, f}, turns});
    }
  }
  /// The cuts that an edge on the segment's line makes.
  template <class Visit>
  void for_stretch(const Edge& f, const Visit& visit) const noexcept {
    const bool forward = order_along(segment_, start_of(f), end_of(f)) <= 0;
    Point<double> from = forward ? start_of(f) : end_of(f), to = forward ? end_of(f) : start_of(f);
    if (order_along(segment_, from, start_of(segment_)) < 0) from = start_of(segment_);
    if (order_along(segment_, to, end_of(segment_)) > 0) to = end_of(segment_);
    const int order = order_along(segment_, from, to);
    if (order > 0) return;
    visit(Cut{{from, {}}, false, order < 0 ? 1 : 0});
    if (order < 0) visit(Cut{{to, {}}, false, -1});
  }

  /// Goes on to the next cut. It is a point of the path.
  template <class Visit>
  void pass(const Cut& cut, const Visit& visit) noexcept {
    const bool at_start = cut.at.stored && same(*cut.at.stored, start_of(segment_)),
               at_end = cut.at.stored && same(*cut.at.stored, end_of(segment_));
    if (first_ && !at_start && left_is_inside_) {
      open_ = true;
      from_ = start_of(segment_);
    }
    first_ = false;
    if (!at_start) left_is_inside_ ^= cut.turns;
    covers_ += cut.covers;
    const bool inside_behind = !at_end && ((path_.closed() && left_is_inside_) || covers_ > 0);
    if (open_ && inside_behind) return;
    const Point<double> p = cut.at.stored ? *cut.at.stored : crossing_of(segment_, cut.at.across);
    if (!inside_behind) visit(open_ ? from_ : p, p, !open_);
    from_ = p;
    open_ = inside_behind;
  }

  const Edges<T>& path_;
  const Edge& segment_;
  Box box_;
  bool left_is_inside_;   // behind the last cut
  bool first_ = true;     // no cut was passed
  bool open_ = false;     // a piece began
  int covers_ = 0;        // edges along the segment behind the last cut
  Point<double> from_{};  // where the piece began
};

/// A segment and a valid path, in order along the segment.
template <class T, class Visit>
void find_pieces(const Edges<T>& path, const Box& box, const Edge& segment, const Visit& visit) noexcept {
  if (!meet(box, box_of(segment))) return;
  if (has_length(segment)) return PiecesAlong<T>(path, segment).find(visit);
  const Point<double> p = start_of(segment);
  if (overlap_valid(path, box, p, box_of(segment))) visit(p, p, true);
}

}  // namespace detail::polygon

}  // namespace vesica
