// SPDX-License-Identifier: Apache-2.0
/// Arcs of an ellipse, halved again and again: what the polygonal and the circle approximation share.
///
/// Every ellipse about the origin is cos(t) p + sin(t) q for conjugate half diameters p, q. The point in the middle of
/// an arc in t, and the derivative there, are the sums of those at its ends times 1 / (2 cos h), h half the arc's
/// angle: linear, so that any linear image of the ellipse is halved by the same sums.
#pragma once

#include <vesica/methods/rect_ellipse_metric.hpp>

namespace vesica::methods {

/// The most halvings that may be asked for. Beyond about 22 (float: 8) rounding leaves nothing to be gained.
inline constexpr std::int32_t most_sandwich_iterations = 30;

namespace detail {

/// A point of the outline, and the derivative by the angle there, counter-clockwise.
template <class T>
struct ArcEnd {
  Vector<T> at, tangent;
};

/// At most a quarter turn in the angle, counter-clockwise.
template <class T>
struct Arc {
  ArcEnd<T> from, to;
};

template <class T>
VESICA_INLINE Vector<T> plus(const Vector<T>& p, const Vector<T>& q) noexcept {
  return {p.x + q.x, p.y + q.y};
}
template <class T>
VESICA_INLINE Vector<T> minus(const Vector<T>& p, const Vector<T>& q) noexcept {
  return {p.x - q.x, p.y - q.y};
}
template <class T>
VESICA_INLINE Vector<T> times(T s, const Vector<T>& p) noexcept {
  return {s * p.x, s * p.y};
}

/// 1 / (2 cos h) for h = pi / 4, pi / 8 ...: half the angle of an arc halved 0, 1 ... times. To 2 roundoffs.
template <class T>
struct HalfSecants {
  T of[most_sandwich_iterations + 1];

  consteval HalfSecants() noexcept : of{} {
    double h = 0x1.921fb54442d18p-1;
    for (T& secant : of) {
      double cosine = 1, term = 1;
      for (int i = 1; i < 20; i += 2) {
        term *= -h * h / (i * (i + 1));
        cosine += term;
      }
      secant = static_cast<T>(0.5 / cosine);
      h /= 2;
    }
  }
};
template <class T>
inline constexpr HalfSecants<T> half_secants;

/// The quarter from p to q.
template <class T>
VESICA_INLINE Arc<T> quarter(const Vector<T>& p, const Vector<T>& q) noexcept {
  return {{p, q}, {q, {-p.x, -p.y}}};
}

/// The middle of an arc that was halved `depth` times.
template <class T>
VESICA_INLINE ArcEnd<T> middle(const Arc<T>& arc, std::int32_t depth) noexcept {
  const T k = half_secants<T>.of[depth];
  return {times(k, plus(arc.from.at, arc.to.at)), times(k, plus(arc.from.tangent, arc.to.tangent))};
}

/// The intersection of the tangents at the ends of an arc that was halved `depth` times.
template <class T>
VESICA_INLINE Vector<T> tip(const Arc<T>& arc, std::int32_t depth) noexcept {
  const T k = half_secants<T>.of[depth];
  return times(2 * k * k, plus(arc.from.at, arc.to.at));
}

/// Is the outline's point nearest to x after `end`? The arc holds that point, and x must not be inside.
///
/// x sees a connected part of the outline, with the nearest point in it and no other place where the tangent is at
/// right angles to the line of sight. In an image in which the ellipse is a disc that part lies about the direction of
/// x, less than a quarter turn to either side: so from what x cannot see, the way is towards that direction.
template <class T>
VESICA_INLINE bool nearest_is_after(const ArcEnd<T>& end, const Vector<T>& x) noexcept {
  const Vector<T> seen = minus(x, end.at);
  const T turn = cross(end.at, x);
  // Seen end on, a segment has no sides either, and only the distance decides.
  if (cross(seen, end.tangent) > 0 || turn == 0) return dot(seen, end.tangent) >= 0;
  return turn > 0;
}

/// The half that holds the outline's point nearest to x.
template <class T>
VESICA_INLINE Arc<T> nearest_half(const Arc<T>& arc, const ArcEnd<T>& middle, const Vector<T>& x) noexcept {
  return nearest_is_after(middle, x) ? Arc<T>{middle, arc.to} : Arc<T>{arc.from, middle};
}

/// The quarter, between two of p, q, -p, -q or a quarter turn on, that holds the outline's point nearest to x.
/// cross(p, q) >= 0.
template <class T>
Arc<T> nearest_quarter(const Vector<T>& p, const Vector<T>& q, const Vector<T>& x) noexcept {
  const Vector<T> back_p{-p.x, -p.y}, back_q{-q.x, -q.y};
  const bool left = cross(x, q) < 0, below = cross(p, x) < 0;
  const Arc<T> arc = left    ? below ? quarter(back_p, back_q) : quarter(q, back_p)
                        : below ? quarter(back_q, p)
                             : quarter(p, q);
  // The direction of x is in this quarter, the nearest point in it or in a neighbour.
  if (!nearest_is_after(arc.from, x)) return {{{-arc.to.at.x, -arc.to.at.y}, arc.from.at}, arc.from};
  if (nearest_is_after(arc.to, x)) return {arc.to, {arc.to.tangent, {-arc.to.at.x, -arc.to.at.y}}};
  return arc;
}

}  // namespace detail
}  // namespace vesica::methods
