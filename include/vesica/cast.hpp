// SPDX-License-Identifier: Apache-2.0
/// cast(a, b, vx, vy, t_end): a is at rest, b moves by v t while t runs from 0 to t_end. Does b touch a, and if so,
/// when first, where and along which normal? A ray is a point that moves; t_end may be infinite.
///
/// The decision is exact for every valid input, touching included. The time is the greatest number of its
/// type with no contact before it: the true time, rounded down.
///
/// Accuracy, u = 2^-53, scale the largest coordinate of the offset of centres or half length: the point is within 8u
/// scale of a's outline, before the rounding of its coordinates. Along the outline the error may be (8u scale + 4u R) /
/// |n.v| for unit n and v, R being a's greatest radius of curvature; rays reach 0.93 of that. The normal is a unit
/// vector to 4u. If a corner meets a corner, it is the normal of one of the edges there; if b only slides along a it is
/// perpendicular to v. Shapes that overlap at the start have the direction of depth() as normal and the point of
/// nearest(): if their depth is 0 and n.v >= 0, they are moving apart.
///
/// Laws, each tested, of answers and times to the bit: cast(b, a, -v) has the same time and, up to rounding, the
/// opposite normal; mirroring, turning by quarters or scaling by powers of two changes nothing; half the velocity takes
/// twice the time; a later t_end changes no hit; the answer is cast_start iff the shapes overlap.
#pragma once

#include <limits>
#include <type_traits>
#include <vesica/bounds.hpp>
#include <vesica/cast/fast_cast.hpp>
#include <vesica/depth.hpp>
#include <vesica/nearest.hpp>

namespace vesica {

namespace detail::cast {

inline bool is_sound(const Motion& m) noexcept { return all_finite(m.vx, m.vy) && m.end >= 0; }

/// The time is rounded down, the rest to the nearest. False where a number would exceed the finite ones.
template <class T>
bool rounded_to(const Impact<double>& i, Impact<T>& out) noexcept {
  T minus_t;
  if (i.t > static_cast<double>(std::numeric_limits<T>::max()) || !arithmetic::round_up_to(-i.t, minus_t)) return false;
  const Impact<T> r{T(0) - minus_t, static_cast<T>(i.x), static_cast<T>(i.y), static_cast<T>(i.nx),
                    static_cast<T>(i.ny)};
  if (!all_finite(r.x, r.y)) return false;
  out = r;
  return true;
}

/// cast_or_error() without early outs.
template <template <class> class A, template <class> class B, class T>
std::int32_t cast_any(const A<T>& a, const B<T>& b, const Motion& motion, Impact<T>& out) noexcept {
  if (!is_sound(motion)) return error_argument;
  Impact<double> found;
  const auto [first, second] = Cores(body(a), body(b));
  const Filtered known = filter(sketch(first), sketch(second), motion);
  // The result needs the depth of overlapping shapes. Only they have a depth with a direction: so it decides overlap.
  Penetration<T> penetration{};
  const auto overlap_at_start = [&]() -> std::int32_t {
    const std::int32_t error = depth_or_error(a, b, penetration);
    return error != 0 ? error : penetration.x != 0 || penetration.y != 0 ? 1 : 0;
  };
  const std::int32_t answer = cast_bodies(first, second, motion, known, overlap_at_start, fused_meeting, found);
  if (answer == cast_miss) out = no_impact<T>();
  if (answer == cast_hit && !rounded_to(found, out)) return error_range;
  if (answer == cast_start) {
    ClosestPoints<T> common;
    const std::int32_t error = nearest_or_error(a, b, common);
    if (error != 0) return error;
    out = {0, common.ax, common.ay, penetration.x, penetration.y};
  }
  return answer;
}

}  // namespace detail::cast

/// The checked form: cast_miss, cast_hit or cast_start (see CastAnswer), error_argument for a velocity that is not
/// finite or a t_end that is NaN or negative, error_shape when either shape is invalid, or error_range: see
/// vesica_motion.h. Writes the contact; after a miss t is infinite and the rest NaN. On error `out` is untouched. Any
/// kinds, in either order.
template <template <class> class A, template <class> class B, class T>
std::int32_t cast_or_error(const A<T>& a, const B<T>& b, std::type_identity_t<T> vx, std::type_identity_t<T> vy,
                           std::type_identity_t<T> t_end, Impact<T>& out) noexcept {
  const detail::cast::Motion motion{static_cast<double>(vx), static_cast<double>(vy), static_cast<double>(t_end)};
  if constexpr (detail::cast::HasEarlyOut<A<double>, B<double>>) {
    using detail::cast::EarlyOut;
    Impact<double> in_double;
    Impact<double>* found = &in_double;
    if constexpr (std::is_same_v<T, double>) found = &out;
    const EarlyOut early = detail::cast::fast_cast<detail::cast::UsualProducts>(
        detail::cast::in_double(a), detail::cast::in_double(b), motion, *found);
    if (early == EarlyOut::missed) {
      out = detail::cast::no_impact<T>();
      return cast_miss;
    }
    if (early == EarlyOut::hit) {
      // A fast hit is finite in double.
      if (!std::is_same_v<T, double> && !detail::cast::rounded_to(*found, out)) return error_range;
      return cast_hit;
    }
  }
  return detail::cast::cast_any(a, b, motion, out);
}

/// The first contact. For valid shapes and motions: t is infinite after a miss, and all numbers are NaN where
/// cast_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
Impact<T> cast(const A<T>& a, const B<T>& b, std::type_identity_t<T> vx, std::type_identity_t<T> vy,
               std::type_identity_t<T> t_end) noexcept {
  constexpr T none = std::numeric_limits<T>::quiet_NaN();
  Impact<T> out{none, none, none, none, none};
  cast_or_error(a, b, vx, vy, t_end, out);
  return out;
}

/// A box that holds a shape throughout its motion by v t, t from 0 to t_end: its bounds, and those of its end rounded
/// outward. Returns 0, error_shape, error_argument as cast_or_error() does, or error_range when a side would be beyond
/// the finite numbers; on error `out` is untouched.
template <template <class> class Shape, class T>
int sweep_bounds(const Shape<T>& s, std::type_identity_t<T> vx, std::type_identity_t<T> vy,
                 std::type_identity_t<T> t_end, Aabb<T>& out) noexcept {
  const detail::cast::Motion motion{static_cast<double>(vx), static_cast<double>(vy), static_cast<double>(t_end)};
  if (!detail::cast::is_sound(motion)) return error_argument;
  Aabb<T> box;
  const int error = bounds(s, box);
  if (error != 0) return error;
  using detail::all_finite, detail::arithmetic::next_above;
  // Each rounding is at most half a step between numbers of its size, and one step outward exceeds it. In units in the
  // last place of the largest of side, way and end: a way that rounds up to a power of two has steps of 2 units, so it
  // is at most 2.5 too long. The sum may reach that power too: its rounding is at most 1 and its step 2. So a side is
  // less than 5.5 too far out.
  const auto sweep = [t_end](T v, T& low, T& high) {
    if (v == 0 || t_end == 0) return;
    const auto outward = [v](T x) { return v > 0 ? next_above(x) : -next_above(-x); };
    T& side = v > 0 ? high : low;
    const T way = v * t_end;
    side = all_finite(way) ? outward(side + outward(way)) : way;
  };
  sweep(vx, box.min_x, box.max_x);
  sweep(vy, box.min_y, box.max_y);
  if (!all_finite(box.min_x, box.min_y, box.max_x, box.max_y)) return error_range;
  out = box;
  return 0;
}

}  // namespace vesica
