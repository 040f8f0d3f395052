// SPDX-License-Identifier: Apache-2.0
/// cast() of polygons and polylines: the earliest of the casts of their edges. Decisions and times are exact, since
/// those of segments are.
///
/// Several edges may be hit at one time. Then an edge hit from the front counts before one that is only slid along, and
/// both count before an edge along the motion that is hit at its end by something along it. Otherwise the first edge
/// counts. A point that hits the vertex between two edges dead on gets the normal of the first of them.
#pragma once

#include <vesica/cast.hpp>
#include <vesica/cast/before.hpp>
#include <vesica/polygon/depth.hpp>
#include <vesica/polygon/least.hpp>
#include <vesica/polygon/overlap.hpp>

namespace vesica {

namespace detail::polygon {

using cast::Motion;

/// Can a box b that moves touch a box a? If this is false it cannot: rounding is allowed for.
inline bool may_touch(const Box& a, const Box& b, const Motion& v) noexcept {
  // The offsets by which b touches a.
  const double low_x = a.min_x - b.max_x, high_x = a.max_x - b.min_x;
  const double low_y = a.min_y - b.max_y, high_y = a.max_y - b.min_y;
  const auto reaches = [&v](double low, double high, double speed) {
    const double way = speed == 0 ? 0 : speed * v.end, slack = lane::abs(way) * 0x1p-50 + 0x1p-1060;
    return low <= greater(way, 0.0) + slack && high >= lesser(way, 0.0) - slack;
  };
  if (!reaches(low_x, high_x, v.vx) || !reaches(low_y, high_y, v.vy)) return false;
  // Does the line of the offsets v t pass by the box of these offsets?
  const double x = 0.5 * low_x + 0.5 * high_x, y = 0.5 * low_y + 0.5 * high_y;
  const double half_x = 0.5 * high_x - 0.5 * low_x, half_y = 0.5 * high_y - 0.5 * low_y;
  const double vx = lane::abs(v.vx), vy = lane::abs(v.vy), reach = vx * half_y + vy * half_x;
  const double size = reach + (vx * lane::abs(y) + vy * lane::abs(x));
  return !(lane::abs(v.vx * y - v.vy * x) > reach + (size * 0x1p-48 + 0x1p-1000));
}

constexpr Motion opposite(const Motion& v) noexcept { return {-v.vx, -v.vy, v.end}; }

/// A velocity's direction, about a unit.
struct Heading {
  double x, y;

  explicit Heading(const Motion& v) noexcept {
    const double most = greater(lane::abs(v.vx), lane::abs(v.vy)), size = most > 0 ? most : 1;
    x = v.vx / size;
    y = v.vy / size;
  }
  /// Not above 0 on contact that is the first.
  double closing(const Impact<double>& i) const noexcept { return i.nx * x + i.ny * y; }
  bool is_along(double dx, double dy) const noexcept {
    return lane::abs(dx * y - dy * x) <= negligible * (lane::abs(dx) + lane::abs(dy));
  }
  bool is_along(const Edge& e) const noexcept { return is_along(e.x1 - e.x0, e.y1 - e.y0); }

  static constexpr double negligible = 0x1p-40;
};

/// True if a shape surely has no extent across a motion.
template <class Other>
bool is_thin(const Other&, const Heading&) noexcept {
  return false;
}
inline bool is_thin(const Point<double>&, const Heading&) noexcept { return true; }
inline bool is_thin(const Edge& s, const Heading& v) noexcept { return v.is_along(s); }

/// Do two edges have a common end, or are they the same?
inline bool joined(const Edge& e, const Edge& f) noexcept {
  const auto same = [](double x, double y, double z, double w) { return x == z && y == w; };
  return same(e.x0, e.y0, f.x0, f.y0) || same(e.x0, e.y0, f.x1, f.y1) || same(e.x1, e.y1, f.x0, f.y0) ||
         same(e.x1, e.y1, f.x1, f.y1);
}

/// The first contact among edges that are apart from the other shape at the start. Of a pair of edges, f is the other
/// shape's; of other shapes it is not used.
class FirstContact {
 public:
  explicit FirstContact(const Motion& motion) noexcept : motion_(motion), heading_(motion), limit_(motion.end) {}

  /// Contact after this end is none of the first ones.
  Motion until() const noexcept { return {motion_.vx, motion_.vy, limit_}; }
  bool is_unsure() const noexcept { return error_ != 0 && impact_.t < infinite; }
  const Heading& heading() const noexcept { return heading_; }

  /// ask(motion, impact) answers for two edges, or an edge and another shape; thin: the latter is.
  template <class Ask>
  void look(const Edge& e, const Edge& f, bool thin, const Ask& ask) noexcept {
    Impact<double> impact;
    const std::int32_t code = cast::cast_before(limit_, motion_.end, [&](double end) {
      return ask(Motion{motion_.vx, motion_.vy, end}, impact);
    });
    if (code < 0) error_ = code;
    if (code > 0) take(impact, e, f, thin);
  }
  /// An edge that was out of range may come after contact that was found later: all are asked again.
  void forget_error() noexcept { error_ = 0; }

  std::int32_t answer(Impact<double>& out) const noexcept {
    if (error_ != 0) return error_;
    if (!(impact_.t < infinite)) return cast_miss;
    out = impact_;
    return cast_hit;
  }

 private:
  enum class Manner { in_front, beside, end_on };

  Manner manner(const Impact<double>& i, const Edge& e, bool thin) const noexcept {
    if (heading_.closing(i) > -Heading::negligible) return Manner::beside;
    return thin && heading_.is_along(e) && heading_.is_along(i.nx, i.ny) ? Manner::end_on : Manner::in_front;
  }

  void take(const Impact<double>& impact, const Edge& e, const Edge& f, bool thin) noexcept {
    if (impact.t > impact_.t) return;
    const Manner now = manner(impact, e, thin);
    if (impact.t < impact_.t || now < manner_) {
      impact_ = impact;
      manner_ = now;
      e_ = e;
      f_ = f;
      const double after = arithmetic::next_above(impact.t);
      limit_ = after < motion_.end ? after : motion_.end;
      return;
    }
    const bool between = now == Manner::beside && manner_ == Manner::beside && thin &&
                         impact.nx * impact_.nx + impact.ny * impact_.ny < 0;
    if (between && joined(e, e_) && joined(f, f_)) face_first_edge();
  }
  /// The edges end on either side of a line that both only touch.
  void face_first_edge() noexcept {
    const double x = e_.y0 - e_.y1, y = e_.x1 - e_.x0, size = greater(lane::abs(x), lane::abs(y));
    if (!(size > 0 && size < infinite)) return;
    const double p = x / size, q = y / size, length = lane::sqrt(p * p + q * q);
    const double side = p * heading_.x + q * heading_.y > 0 ? -1 : 1;
    impact_.nx = side * (p / length) + 0.0;
    impact_.ny = side * (q / length) + 0.0;
    manner_ = Manner::in_front;
  }

  Motion motion_;
  Heading heading_;
  double limit_;
  std::int32_t error_ = 0;
  Manner manner_ = Manner::end_on;
  Impact<double> impact_ = cast::no_impact<double>();
  Edge e_{}, f_{};
};

/// Contact at the start: of edges that the other shape overlaps, the one that it comes nearest to moving straight into.
class StartContact {
 public:
  explicit StartContact(const Motion& motion) noexcept : motion_(motion), heading_(motion) {}

  template <class Ask>
  void look(const Ask& ask) noexcept {
    Impact<double> impact;
    const std::int32_t code = ask(Motion{motion_.vx, motion_.vy, 0}, impact);
    if (code < 0) error_ = code;
    if (code != cast_start) return;
    const double closing = heading_.closing(impact);
    if (closing > closing_ - Heading::negligible) return;
    closing_ = closing;
    impact_ = impact;
  }
  /// If no edge is overlapped, one shape holds the other, and that is a common point.
  std::int32_t answer(const Point<double>& held, Impact<double>& out) const noexcept {
    const bool found = closing_ < infinite;
    if (!found && error_ != 0) return error_;
    out = found ? impact_ : Impact<double>{0, held.x, held.y, 0, 0};
    return cast_start;
  }

 private:
  Motion motion_;
  Heading heading_;
  std::int32_t error_ = 0;
  double closing_ = infinite;
  Impact<double> impact_{};
};

/// Turns the normal at the start to the direction of the depth, if both shapes are convex and the path is no segment.
template <class T, class Other>
void turn_to_depth(const Edges<T>& a, const Other& b, bool reversed, Impact<double>& out) noexcept {
  Penetration<double> p;
  if (convexity(a).flat || convex_depth(a, b, p) != 0) return;
  if (reversed) p = depth::turned_round(p);
  out.nx = p.x;
  out.ny = p.y;
}

/// visit(contact) looks at all edges; more than once only where numbers are out of range.
template <class Visit>
std::int32_t first_contact(const Motion& motion, const Visit& visit, Impact<double>& out) noexcept {
  FirstContact contact(motion);
  visit(contact);
  if (contact.is_unsure()) {
    contact.forget_error();
    visit(contact);
  }
  return contact.answer(out);
}

/// A path and another shape; reversed: the path is the one that moves. ask(a, b, motion, impact) answers as
/// cast_or_error() for an edge and a shape, in either order. The motion is sound.
template <class T, class Other, class Ask>
std::int32_t cast_or_error(const Edges<T>& a, const Other& b, bool reversed, const Motion& motion, const Ask& ask,
                           Impact<double>& out) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(b, about)) return error_shape;
  const auto relative = [reversed](const Motion& m) { return reversed ? opposite(m) : m; };
  if (!may_touch(box, about, relative(motion))) return cast_miss;
  const auto ask_edge = [&](const Edge& e) {
    return
        [&](const Motion& m, Impact<double>& impact) { return reversed ? ask(b, e, m, impact) : ask(e, b, m, impact); };
  };
  if (overlap_valid(a, box, b, about)) {
    StartContact start(motion);
    a.for_edges([&](const Edge& e, std::int64_t) {
      if (meet(box_of(e), about)) start.look(ask_edge(e));
      return false;
    });
    const std::int32_t code = start.answer(stored_point(b), out);
    if (code == cast_start) turn_to_depth(a, b, reversed, out);
    return code;
  }
  const auto visit = [&](FirstContact& contact) {
    const bool thin = is_thin(b, contact.heading());
    a.for_edges([&](const Edge& e, std::int64_t) {
      if (may_touch(box_of(e), about, relative(contact.until()))) contact.look(e, {}, thin, ask_edge(e));
      return false;
    });
  };
  return first_contact(motion, visit, out);
}

/// A pair of paths whose edges are visited in the same order if the paths are exchanged.
template <class T, class Ask>
struct CastPair {
  const Edges<T>&a, &b;
  bool exchanged;  // the path that moves is the outer one
  const Ask& ask;

  CastPair(const Edges<T>& first, const Edges<T>& second, const Ask& asked) noexcept
      : a(first), b(second), exchanged(compared(first, second) > 0), ask(asked) {}

  template <class Policy>
  void walk(const Box& box_a, const Box& box_b, Policy policy) const noexcept {
    exchanged ? polygon::walk(b, box_b, a, box_a, policy) : polygon::walk(a, box_a, b, box_b, policy);
  }
  auto question(const Edge& outer, const Edge& inner) const noexcept {
    return [this, &e = exchanged ? inner : outer, &f = exchanged ? outer : inner](
               const Motion& m, Impact<double>& impact) { return ask(e, f, m, impact); };
  }
};

template <class Pair>
struct LookAtStarts {
  const Pair& pair;
  StartContact& start;
  bool keeps(const Box& a, const Box& b) const noexcept { return meet(a, b); }
  bool visit(const Edge& e, std::int64_t, const Edge& f, std::int64_t) const noexcept {
    start.look(pair.question(e, f));
    return false;
  }
};

template <class Pair>
struct LookAtContacts {
  const Pair& pair;
  FirstContact& contact;
  bool keeps(const Box& outer, const Box& inner) const noexcept {
    return may_touch(outer, inner, pair.exchanged ? opposite(contact.until()) : contact.until());
  }
  bool visit(const Edge& e, std::int64_t, const Edge& f, std::int64_t) const noexcept {
    const Edge& of_a = pair.exchanged ? f : e;
    const Edge& of_b = pair.exchanged ? e : f;
    contact.look(of_a, of_b, contact.heading().is_along(of_b), pair.question(e, f));
    return false;
  }
};

template <class T, class Ask>
std::int32_t cast_or_error(const Edges<T>& a, const Edges<T>& b, bool, const Motion& motion, const Ask& ask,
                           Impact<double>& out) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  if (!may_touch(box_a, box_b, motion)) return cast_miss;
  const CastPair<T, Ask> pair(a, b, ask);
  if (overlap_valid(a, box_a, b, box_b)) {
    StartContact start(motion);
    pair.walk(box_a, box_b, LookAtStarts<CastPair<T, Ask>>{pair, start});
    Point<double> held{};
    point_inside(a, box_a, b, box_b, held);
    const std::int32_t code = start.answer(held, out);
    if (code == cast_start) turn_to_depth(a, b, false, out);
    return code;
  }
  const auto visit = [&](FirstContact& contact) {
    pair.walk(box_a, box_b, LookAtContacts<CastPair<T, Ask>>{pair, contact});
  };
  return first_contact(motion, visit, out);
}

struct AskCast {
  template <class A, class B>
  std::int32_t operator()(const A& a, const B& b, const Motion& m, Impact<double>& out) const noexcept {
    return vesica::cast_or_error(a, b, m.vx, m.vy, m.end, out);
  }
};

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, in either order. If the shapes overlap at the start, the normal is
/// the direction of their depth if both are convex, else that of an edge there, or 0 if one of them holds the other.
template <template <class> class A, template <class> class B, class T>
std::int32_t cast_or_error(const A<T>& a, const B<T>& b, std::type_identity_t<T> vx, std::type_identity_t<T> vy,
                           std::type_identity_t<T> t_end, Impact<T>& out) noexcept requires AnyPath<A<T>, B<T>> {
  using namespace detail::polygon;
  const Motion motion{static_cast<double>(vx), static_cast<double>(vy), static_cast<double>(t_end)};
  if (!detail::cast::is_sound(motion)) return error_argument;
  Impact<double> found;
  const std::int32_t code = with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::cast_or_error(edges, other, reversed, motion, AskCast{}, found);
  });
  if (code == cast_miss) out = detail::cast::no_impact<T>();
  return code > 0 && !detail::cast::rounded_to(found, out) ? static_cast<std::int32_t>(error_range) : code;
}

}  // namespace vesica
