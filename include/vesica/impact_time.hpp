// SPDX-License-Identifier: Apache-2.0
/// impact_time(a, turn_a, b, turn_b, tolerance): both shapes move and turn while t runs from 0 to 1. When do they touch
/// first? The answer is a time before which they surely do not, however thin they are and however fast they turn.
///
/// At t the centre has moved by t v, and the axis has turned by t times the angle, without rounding. Such positions are
/// not representable, so unlike cast() the function does not find the true time; it finds one before it:
///
///   - a miss is proved: no contact from 0 to 1;
///   - a hit is proved: no contact before t, contact at some later time, and at t the shapes are `gap` apart;
///   - near: no contact before t, and at t the shapes are at most `gap` apart. There may be contact later.
///   - a start: the shapes overlap as they are stored. This is exact.
///
/// The gap is at most the tolerance, except in two cases: the tolerance is below what rounding can resolve, which is
/// (300 + 10 |angles|) u times the sum of all lengths, the motion's included, u = 2^-53; or the search stopped after
/// 256 directions or 4096 poses.
#pragma once

#include <type_traits>
#include <vesica/cast.hpp>
#include <vesica/impact_time/advance.hpp>

namespace vesica {

/// Answers of impact_time beside those of casting.
inline constexpr std::int32_t cast_near = 3;

namespace detail::impact_time {

template <class T>
bool is_sound(const Turn<T>& turn) noexcept {
  return all_finite(turn.vx, turn.vy) && lane::abs(turn.angle) <= static_cast<T>(arithmetic::most_radians);
}

inline bool is_valid(const Body& body) noexcept {
  return cast::with_shape(body, [](const auto& s) { return check(s) == 0; });
}

/// The point of a given its offset from a's centre at t.
inline PlaneVector placed_point(const Body& a, const Turn<double>& turn, double t, const PlaneVector& offset,
                                int exponent) noexcept {
  const cast::Offset still = cast::located(a, {offset.x, offset.y}, exponent);
  return {still.x + t * turn.vx + 0.0, still.y + t * turn.vy + 0.0};
}

/// The result for a time t with no contact before it.
template <class T, class Ask>
std::int32_t contact_at(const Body& a, const Turn<double>& turn_a, const Scene& s, const Advanced& found,
                        double tolerance, const Ask& ask, Impact<double>& out, double& gap) noexcept {
  T minus_t = 0;
  arithmetic::round_up_to(-found.t, minus_t);
  const double t = 0 - static_cast<double>(minus_t);
  const Pose at = pose(s, t);
  const bool face = s.has_boxes() && t == found.t;
  Gap closest = face ? gap_at_face(s, at, found.along.heading) : gap_at(s, at, ask);
  if (face && closest.distance + 2 * s.error > tolerance) closest = gap_at(s, at, ask);
  const bool meet = surely_meet_after(s, t, found.along.by.rate, closest.distance, ask);
  const PlaneVector p = placed_point(a, turn_a, t, closest.a, s.exponent);
  // The distance is right to 4u of the largest length, and the pose to the error.
  const double most = arithmetic::scale_far((closest.distance + 2 * s.error) * (1 + 0x1p-50), s.exponent);
  if (!all_finite(p.x, p.y, most)) return error_range;
  out = {t, p.x, p.y, found.along.heading.n.x + 0.0, found.along.heading.n.y + 0.0};
  gap = most;
  return meet ? static_cast<std::int32_t>(cast_hit) : cast_near;
}

/// cast_miss, cast_near, cast_hit or an error; cast_start is for the caller to describe. `ask` knows
/// overlap_at_start(), and nearest() and depth() of bodies. T: what the time is rounded down to.
template <class T, class Ask>
std::int32_t impact_time(const Body& of_a, const Turn<double>& turn_a, const Body& of_b, const Turn<double>& turn_b,
                         double tolerance, const Ask& ask, Impact<double>& out, double& gap) noexcept {
  const Body a = cast::core_of(of_a), b = cast::core_of(of_b);
  if (!is_valid(a) || !is_valid(b)) return error_shape;
  const Scene s = scene(a, turn_a, b, turn_b);
  const Window w = window(s);
  if (w.never) return cast_miss;
  constexpr Heading any{{1, 0}, Kept::still, {}};
  const Direction first = best_direction(s, pose(s, w.from), any, ask);
  if (!w.apart && !(first.by.least > 0)) {
    const std::int32_t overlapping = ask.overlap_at_start();
    if (overlapping != 0) return overlapping < 0 ? overlapping : static_cast<std::int32_t>(cast_start);
  }
  if (s.still) return cast_miss;
  const double enough = s.exponent == 0 ? tolerance : arithmetic::scale_far(tolerance, -s.exponent);
  const Advanced found = advance(s, w, first, enough, ask);
  if (found.outcome == Outcome::missed) return cast_miss;
  return contact_at<T>(a, turn_a, s, found, enough, ask, out, gap);
}

/// Rounded to T: the time is one already, the gap up, the rest to the nearest.
template <class T>
bool rounded_to(const Impact<double>& i, double gap, Impact<T>& out, T& out_gap) noexcept {
  Impact<T> impact;
  T most;
  if (!cast::rounded_to(i, impact) || !arithmetic::round_up_to(gap, most)) return false;
  out = impact;
  out_gap = most;
  return true;
}

/// Writes what an answer has to say, and returns it or an error. A contact at the start has the place of a cast without
/// motion.
template <class A, class B, class T>
std::int32_t finish(std::int32_t answer, const A& a, const B& b, const Impact<double>& found, double found_gap,
                    Impact<T>& out, T& gap) noexcept {
  if (answer < 0) return answer;
  if (answer == cast_start) {
    const std::int32_t code = cast_or_error(a, b, T(0), T(0), T(0), out);
    if (code >= 0) gap = 0;
    return code;
  }
  if (answer == cast_miss) {
    out = cast::no_impact<T>();
    gap = std::numeric_limits<T>::quiet_NaN();
    return answer;
  }
  return rounded_to(found, found_gap, out, gap) ? answer : static_cast<std::int32_t>(error_range);
}

/// Asks shapes as they were given, and poses of rectangles, rounded ones and ellipses.
template <class A, class B>
struct AskShapes {
  const A& a;
  const B& b;

  template <class Action>
  static void with_pose(const Body& body, const Action& action) noexcept {
    if (body.kind == Kind::rect) return action(cast::shape<Rect>(body));
    if (body.kind == Kind::round_rect) return action(cast::shape<RoundRect>(body));
    action(cast::shape<Ellipse>(body));
  }
  std::int32_t overlap_at_start() const noexcept { return overlap_or_error(a, b); }
  void nearest(const Body& p, const Body& q, ClosestPoints<double>& out) const noexcept {
    with_pose(p, [&](const auto& x) { with_pose(q, [&](const auto& y) { nearest_or_error(x, y, out); }); });
  }
  void depth(const Body& p, const Body& q, Penetration<double>& out) const noexcept {
    with_pose(p, [&](const auto& x) { with_pose(q, [&](const auto& y) { depth_or_error(x, y, out); }); });
  }
};

template <class T>
Turn<double> widen(const Turn<T>& t) noexcept {
  return {static_cast<double>(t.vx), static_cast<double>(t.vy), static_cast<double>(t.angle)};
}

}  // namespace detail::impact_time

/// The checked form: cast_miss, cast_hit, cast_start or cast_near; error_argument for a motion that is not finite, an
/// angle beyond 2^20 or a tolerance that is not above 0; error_shape or error_range, the point being beyond the finite
/// numbers. Writes the place at t, as cast_or_error() does, and the gap; after a miss t is infinite, all else NaN. On
/// error nothing is written. Any kinds, in either order.
template <template <class> class A, template <class> class B, class T>
std::int32_t impact_time_or_error(const A<T>& a, const Turn<T>& turn_a, const B<T>& b, const Turn<T>& turn_b,
                                  std::type_identity_t<T> tolerance, Impact<T>& out, T& gap) noexcept {
  namespace impl = detail::impact_time;
  if (!impl::is_sound(turn_a) || !impl::is_sound(turn_b) || !(tolerance > 0)) return error_argument;
  Impact<double> found{};
  double found_gap = 0;
  const std::int32_t answer =
      impl::impact_time<T>(detail::cast::body(a), impl::widen(turn_a), detail::cast::body(b), impl::widen(turn_b),
                           static_cast<double>(tolerance), impl::AskShapes<A<T>, B<T>>{a, b}, found, found_gap);
  return impl::finish(answer, a, b, found, found_gap, out, gap);
}

/// An impact and the gap at its time.
template <class T>
struct ImpactTime {
  Impact<T> impact;
  T gap;
};

/// The same for valid shapes and motions: t is infinite after a miss, and all numbers are NaN where the checked form
/// returns an error.
template <template <class> class A, template <class> class B, class T>
ImpactTime<T> impact_time(const A<T>& a, const Turn<T>& turn_a, const B<T>& b, const Turn<T>& turn_b,
                          std::type_identity_t<T> tolerance) noexcept {
  constexpr T none = std::numeric_limits<T>::quiet_NaN();
  ImpactTime<T> out{{none, none, none, none, none}, none};
  impact_time_or_error(a, turn_a, b, turn_b, tolerance, out.impact, out.gap);
  return out;
}

}  // namespace vesica
