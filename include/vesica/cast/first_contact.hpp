// SPDX-License-Identifier: Apache-2.0
/// The first contact of two shapes that are apart at the start: the greatest double with no contact before it, the
/// point and the normal.
///
/// Mostly there is no double between the bounds of bound.hpp; then the lower one is the time, rounded down. Otherwise,
/// and for extreme magnitudes, doubles are tried: exact predicates tell whether there is contact before one of them.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/direction.hpp>
#include <vesica/cast/exact_floor.hpp>
#include <vesica/cast/filter.hpp>
#include <vesica/cast/place.hpp>

namespace vesica {

/// What cast() writes; members as in the C struct.
template <class T>
struct Impact {
  T t;       ///< the greatest number with no contact before it
  T x, y;    ///< the point of contact
  T nx, ny;  ///< unit normal from the first shape to the second
};

/// What casting returns, where it is not an error.
enum CastAnswer : std::int32_t {
  cast_miss = 0,
  cast_hit = 1,
  cast_start = 2,  ///< the shapes overlap at the start
};

namespace detail::cast {

/// The result of a miss.
template <class T>
constexpr Impact<T> no_impact() noexcept {
  constexpr T none = std::numeric_limits<T>::quiet_NaN();
  return {std::numeric_limits<T>::infinity(), none, none, none, none};
}

/// A line that grazes, and on which side of it the second shape's centre passes.
struct Graze {
  bool grazes;
  int side;
};

/// The greatest double that is at most t0; negative where the bounds leave it open.
inline double known_floor(const Scene& scene, const TimeBounds& time) noexcept {
  const Twofold<double> t = arithmetic::renormalised(time.value);
  const double above = time.error + time.gain;
  if (!scene.faithful || !time.tells() || !time.certain || !(above < 0x1p-56 * t.high)) return -1;
  const bool usual = scene.time == 0 && t.high >= 0x1p-1000 && t.high <= 0x1p1000;
  const int exponent = usual ? 0 : form::length_exponent(t.high, scene.time);
  if (exponent < -1000 || exponent > 1020) return -1;
  if (t.low - time.error <= 0 && t.low + above >= 0) return -1;
  const double nearest = in_units(t.high, scene.time);
  return t.low < 0 ? arithmetic::at_rank<double>(arithmetic::rank(nearest) - 1) : nearest;
}

/// What the bounds tell of t0.
inline WideTime as_wide(const Scene& scene, const TimeBounds& time) noexcept {
  const double error = time.error + time.gain;
  if (!scene.faithful || !time.tells() || !time.certain) return {};
  const Twofold<double> t = arithmetic::renormalised(time.value);
  return {Rough({t.high, t.low}, 1.01 * error, scene.time), true};
}

/// Where a line that grazes enters: the point of M farthest across v, of an edge along v the end that comes first.
inline Found grazing(const Scene& scene, int side) noexcept {
  using Products = SplitProducts;
  using arithmetic::factor;
  const double sign = side < 0 ? -1 : 1;
  const Vector across{{-sign * scene.vy, 0}, {sign * scene.vx, 0}};
  // Turned by a quarter `beside` is x.v, and `edge` what lies along v.
  const VectorFactor<Products> turned{factor(Twofold<double>{scene.vy, 0}), factor(Twofold<double>{-scene.vx, 0})};
  const auto n = factor(across);
  const SideSupport a = support_of<Products>(scene.a, n, turned, scene.speed()),
                    b = support_of<Products>(scene.b, n, turned, scene.speed());
  const auto v = factor_of_v<Products>(scene);
  const Twofold<double> way = a.beside + b.beside - dot(factor(scene.d), v);
  const double vv = scene.vx * scene.vx + scene.vy * scene.vy;
  const double first = (way.high - (a.edge + b.edge)) / vv;
  const Twofold<double> left = (way - Twofold<double>{a.edge, 0} - Twofold<double>{b.edge, 0}) -
                               factor(Twofold<double>{first, 0}) * factor(renormalised(dot(v, v)));
  const Vector back{{-scene.vx, 0}, {-scene.vy, 0}};
  return {side == 0 ? back : across, {{first, arithmetic::rounded(left) / vv}, 0, 0, 0, false}};
}

/// How the shapes meet first, and what of them lies farthest along the normal: of b where a meets by an edge.
struct Meeting {
  Found found;
  Foremost of_a, of_b;
};

template <class Products>
void look_along_normal(const Scene& scene, Meeting& m) noexcept {
  const Vector normal = settled(scene.a, m.found.normal);
  m.of_a = foremost<Products>(scene.a, normal);
  if (m.of_a.is_edge()) m.of_b = foremost<Products>(scene.b, opposite(normal));
}

VESICA_COLD inline void look_beside(const Scene& scene, Meeting& m) noexcept {
  m.found.normal = m.found.beside;
  look_along_normal<SplitProducts>(scene, m);
}

/// False where these products do not suffice.
template <class Products>
bool find_meeting(const Scene& scene, Meeting& out) noexcept {
  int steps;
  out.found = latest_direction<Products>(scene, steps);
  if (!out.found.has_direction()) return false;
  look_along_normal<Products>(scene, out);
  return true;
}

/// find_meeting by fused products, or null where the processor has none.
using FindMeeting = bool (*)(const Scene&, Meeting&);

inline void meet(const Scene& scene, const Graze& graze, FindMeeting fused, Meeting& m) noexcept {
  if (graze.grazes) {
    m.found = grazing(scene, graze.side);
    look_along_normal<SplitProducts>(scene, m);
  } else if (fused == nullptr || !has_fused_products(scene) || !fused(scene, m)) {
    find_meeting<SplitProducts>(scene, m);
  }
}

/// Whether the line meets M after the start; if so, whether its witness comes after the end, and how it meets M.
struct LineMeeting {
  bool meets, late;
  Graze graze;
};
VESICA_COLD inline LineMeeting exact_line(const ExactPair& pair, double end) noexcept {
  if (pair.line_misses() || pair.witness_after(0) <= 0) return {false, false, {false, 0}};
  const bool late = end < std::numeric_limits<double>::infinity() && pair.witness_after(end) > 0;
  return {true, late, {pair.line_grazes(), pair.side()}};
}

/// A pair that moves. Exact numbers are formed where they are asked for, unless they are there already; in functions of
/// its own, so that they are not twice on the stack.
struct MovingPair {
  const Body &a, &b;
  const Motion& motion;
  const ExactPair* known = nullptr;

  template <class Question>
  std::int32_t exactly(const Question& question) const noexcept {
    return known != nullptr ? question(*known) : exactly_anew(question);
  }

 private:
  template <class Question>
  VESICA_COLD std::int32_t exactly_anew(const Question& question) const noexcept {
    return question(ExactPair(a, b, motion));
  }
};

/// The time in units of the scene, and what it means.
inline Impact<double> impact(const Body& a, const Scene& scene, const Meeting& m, double t) noexcept {
  const double in_scene = in_units(t, -scene.time);
  const Offset offset{scene.d.x.high + in_scene * scene.vx, scene.d.y.high + in_scene * scene.vy};
  const Offset at = located(a, touching_point(m.of_a, m.of_b, offset), scene.length);
  const Vector& normal = m.found.normal;
  const double x = normal.x.high, y = normal.y.high, length = sqrt(x * x + y * y);
  return {t, at.x, at.y, x / length + 0.0, y / length + 0.0};
}

/// For shapes that do not overlap at the start, and a line that meets M after it. late: whether the witness comes after
/// the end, so that there may be contact only then.
[[gnu::noinline]] inline std::int32_t first_contact(const MovingPair& pair, bool late, const Graze& graze,
                                                    FindMeeting fused, Impact<double>& out) noexcept {
  const double end = pair.motion.end;
  Scene seen;
  set_scene(pair.a, pair.b, pair.motion, seen);
  Meeting met;
  meet(seen, graze, fused, met);
  const Found& found = met.found;
  double t = graze.grazes ? -1 : known_floor(seen, found.time);
  std::int32_t reached = 1;
  if (t < 0) {
    const double estimate = arithmetic::scale_far(arithmetic::rounded(found.time.value), seen.time);
    const WideTime bounds = graze.grazes ? WideTime{} : as_wide(seen, found.time);
    reached = pair.exactly([&](const ExactPair& exact) { return exact_floor(exact, end, late, estimate, bounds, t); });
  } else if (late && t >= end) {
    reached = t > end ? 0 : pair.exactly([t](const ExactPair& exact) { return exact_contact_at(exact, t); });
  }
  if (reached <= 0) return reached;
  if (found.is_met_beside(in_units(t, -seen.time))) look_beside(seen, met);
  const Impact<double> impact = cast::impact(pair.a, seen, met, t);
  if (!all_finite(impact.x, impact.y, impact.nx, impact.ny)) return error_range;
  out = impact;
  return cast_hit;
}

/// The same, where whether the line meets M is still to be asked.
VESICA_COLD inline std::int32_t first_contact_of_undecided(const Body& a, const Body& b, const Motion& motion,
                                                           FindMeeting fused, Impact<double>& out) noexcept {
  const ExactPair exact(a, b, motion);
  const LineMeeting line = exact_line(exact, motion.end);
  return line.meets ? first_contact({a, b, motion, &exact}, line.late, line.graze, fused, out)
                    : static_cast<std::int32_t>(cast_miss);
}

/// Whether a line that is still to be asked meets M after the start and by the end: 1, or 0, or error_range where the
/// place at the end is beyond exact numbers. Neither the time nor a point has to be a number.
VESICA_COLD inline std::int32_t exactly_meets(const Body& a, const Body& b, const Motion& motion) noexcept {
  const ExactPair exact(a, b, motion);
  const LineMeeting line = exact_line(exact, motion.end);
  return line.late ? exact_contact_at(exact, motion.end) : line.meets ? 1 : 0;
}

/// The answer, or error_range, where the filter has told `known`. Contact at the start is for the caller to describe.
/// overlap_at_start() answers as overlap_or_error() does.
template <class Overlap>
VESICA_INLINE std::int32_t cast_bodies(const Body& a, const Body& b, const Motion& motion, const Filtered& known,
                                       const Overlap& overlap_at_start, FindMeeting fused,
                                       Impact<double>& out) noexcept {
  const auto [verdict, apart] = known;
  if (verdict == Verdict::missed) return cast_miss;
  const std::int32_t overlapping = apart ? 0 : overlap_at_start();
  if (overlapping != 0) return overlapping < 0 ? overlapping : static_cast<std::int32_t>(cast_start);
  if (verdict == Verdict::passed || motion.is_still()) return cast_miss;
  if (verdict == Verdict::undecided) return first_contact_of_undecided(a, b, motion, fused, out);
  return first_contact({a, b, motion}, verdict == Verdict::late, {false, 0}, fused, out);
}

}  // namespace detail::cast
}  // namespace vesica
