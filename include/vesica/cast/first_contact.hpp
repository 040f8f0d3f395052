// SPDX-License-Identifier: Apache-2.0
/// The first contact of two shapes that are apart at the start: the greatest double with no contact before it, the
/// point and the normal.
///
/// Usually there is no double between the bounds of bound.hpp; then the lower one is the time, rounded down. Otherwise,
/// and for extreme magnitudes, it is found by bisection: exact predicates decide whether there is contact before a
/// time.
#pragma once

#include <vesica/cast/direction.hpp>
#include <vesica/cast/exact.hpp>
#include <vesica/cast/filter.hpp>
#include <vesica/cast/place.hpp>

namespace vesica {

/// The result of cast(); members as in the C struct.
template <class T>
struct Impact {
  T t;       ///< the greatest number with no contact before it
  T x, y;    ///< the point of contact
  T nx, ny;  ///< unit normal from the first shape to the second
};

/// The return values of casts that are not errors.
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

/// The time rounded down to a double; negative if the bounds do not decide it.
inline double time_from_bounds(const Scene& scene, const TimeBounds& time) noexcept {
  const Twofold<double> t = arithmetic::renormalised(time.value);
  const double above = time.error + time.gain;
  if (!scene.faithful || !time.is_known() || !time.certain || !(above < 0x1p-56 * t.high)) return -1;
  const bool usual = scene.time == 0 && t.high >= 0x1p-1000 && t.high <= 0x1p1000;
  const int exponent = usual ? 0 : form::length_exponent(t.high, scene.time);
  if (exponent < -1000 || exponent > 1020) return -1;
  if (t.low - time.error <= 0 && t.low + above >= 0) return -1;
  const double nearest = in_units(t.high, scene.time);
  return t.low < 0 ? arithmetic::at_rank<double>(arithmetic::rank(nearest) - 1) : nearest;
}

/// A line that grazes enters at the point of M farthest across v, or at the first end of an edge along v.
inline Found grazing(const Scene& scene, int side) noexcept {
  using Products = SplitProducts;
  using arithmetic::factor;
  const double sign = side < 0 ? -1 : 1;
  const Vector across{{-sign * scene.vy, 0}, {sign * scene.vx, 0}};
  // Turned by a quarter `beside` is x.v, and `edge` what lies along v.
  const VectorFactor<Products> turned{factor(Twofold<double>{scene.vy, 0}), factor(Twofold<double>{-scene.vx, 0})};
  const auto n = factor(across);
  SideSupport a, b;
  supports_of<Products>(scene, n, turned, scene.speed(), a, b);
  const auto v = factor_of_v<Products>(scene);
  const Twofold<double> way = a.beside + b.beside - dot(factor(scene.d), v);
  const double vv = scene.vx * scene.vx + scene.vy * scene.vy;
  const double first = (way.high - (a.edge + b.edge)) / vv;
  const Twofold<double> left = (way - Twofold<double>{a.edge, 0} - Twofold<double>{b.edge, 0}) -
                               factor(Twofold<double>{first, 0}) * factor(renormalised(dot(v, v)));
  const Vector back{{-scene.vx, 0}, {-scene.vy, 0}};
  return {side == 0 ? back : across, {{first, arithmetic::rounded(left) / vv}, 0, 0, 0, false}};
}

/// How the shapes meet first, and their parts farthest along the normal: b's only if a is hit on an edge.
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

using FindMeeting = bool (*)(const Scene&, Meeting&);
/// find_meeting by fused products, or null where the processor has none.
#if defined(VESICA_HAS_FUSED)
inline constexpr FindMeeting fused_meeting = find_meeting<FusedProducts>;
#else
inline constexpr FindMeeting fused_meeting = nullptr;
#endif

/// `line`: the exact line test's result, if that was needed.
inline void meet(const Scene& scene, const LineMeeting* line, FindMeeting fused, Meeting& m) noexcept {
  if (line != nullptr && line->grazes) {
    m.found = grazing(scene, line->side);
    look_along_normal<SplitProducts>(scene, m);
  } else if (fused == nullptr || !has_fused_products(scene) || !fused(scene, m)) {
    find_meeting<SplitProducts>(scene, m);
  }
}

/// The time in units of the scene, and what it means.
inline Impact<double> impact(const Body& a, const Scene& scene, const Meeting& m, double t) noexcept {
  const double in_scene = in_units(t, -scene.time);
  const Offset offset{scene.d.x.high + in_scene * scene.vx, scene.d.y.high + in_scene * scene.vy};
  const Vector& normal = m.found.normal;
  const double x = normal.x.high, y = normal.y.high, length = sqrt(x * x + y * y);
  Offset touching = touching_point(m.of_a, m.of_b, offset);
  if (a.radius > 0) {
    const double radius = in_units(a.radius, -scene.length);
    touching = touching + Offset{radius * (x / length), radius * (y / length)};
  }
  const Offset at = located(a, touching, scene.length);
  return {t, at.x, at.y, x / length + 0.0, y / length + 0.0};
}

/// The exact stage of first_contact(). A function of its own: its numbers need a lot of stack.
VESICA_COLD inline std::int32_t exact_time_of(const Body& a, const Body& b, const Motion& motion, bool late,
                                              double estimate, double& out) noexcept {
  return exact_time_by(ExactPair(a, b, motion), motion.end, late, estimate, out);
}
VESICA_COLD inline std::int32_t exact_contact_at_end(const Body& a, const Body& b, const Motion& motion) noexcept {
  return exact_contact_at(ExactPair(a, b, motion), motion.end);
}
VESICA_COLD inline LineMeeting exact_line_of(const Body& a, const Body& b, const Motion& motion) noexcept {
  return exact_line(ExactPair(a, b, motion), motion.end);
}

/// Requires shapes that are apart at the start, and a line that enters M after it. `late`: the witness comes after the
/// end, so there may be contact only then. `line`: the exact line test's result, if that was needed.
[[gnu::noinline]] inline std::int32_t first_contact(const Body& a, const Body& b, const Motion& motion, bool late,
                                                    const LineMeeting* line, FindMeeting fused,
                                                    Impact<double>& out) noexcept {
  Scene scene;
  set_scene(a, b, motion, scene);
  Meeting met;
  meet(scene, line, fused, met);
  const Found& found = met.found;
  double t = line != nullptr && line->grazes ? -1 : time_from_bounds(scene, found.time);
  std::int32_t reached = 1;
  if (t < 0) {
    const double estimate = arithmetic::scale_far(arithmetic::rounded(found.time.value), scene.time);
    reached = exact_time_of(a, b, motion, late, estimate, t);
  } else if (late && t >= motion.end) {
    reached = t > motion.end ? 0 : exact_contact_at_end(a, b, motion);
  }
  if (reached <= 0) return reached;
  if (found.is_met_beside(in_units(t, -scene.time))) look_beside(scene, met);
  const Impact<double> impact = cast::impact(a, scene, met, t);
  if (!all_finite(impact.x, impact.y, impact.nx, impact.ny)) return error_range;
  out = impact;
  return cast_hit;
}

/// first_contact() after the exact line test.
VESICA_COLD inline std::int32_t first_contact_of_undecided(const Body& a, const Body& b, const Motion& motion,
                                                           FindMeeting fused, Impact<double>& out) noexcept {
  const LineMeeting line = exact_line_of(a, b, motion);
  return line.meets ? first_contact(a, b, motion, line.late, &line, fused, out) : static_cast<std::int32_t>(cast_miss);
}

/// 1 if the shapes touch after the start and by the end, else 0, or error_range. For pairs that the filter leaves open.
/// Computes no time and no point, so these need not be finite.
VESICA_COLD inline std::int32_t exactly_meets(const Body& a, const Body& b, const Motion& motion) noexcept {
  const ExactPair exact(a, b, motion);
  const LineMeeting line = exact_line(exact, motion.end);
  return line.late ? exact_contact_at(exact, motion.end) : line.meets ? 1 : 0;
}

/// The answer after the filter, or error_range. The caller describes contact at the start. overlap_at_start() answers
/// as overlap_or_error() does.
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
  return first_contact(a, b, motion, verdict == Verdict::late, nullptr, fused, out);
}

}  // namespace detail::cast
}  // namespace vesica
