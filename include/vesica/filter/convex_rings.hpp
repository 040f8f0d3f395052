// SPDX-License-Identifier: Apache-2.0
/// Two convex polygons of few vertices: separating axes with an error bound. Other polygons stay undecided.
#pragma once

#include <cstddef>
#include <utility>
#include <vesica/filter/estimate.hpp>

namespace vesica::filter {

/// An array of a size known beforehand, indexed by int.
template <class V, int n>
struct Few {
  V number[std::size_t{n}];
  VESICA_INLINE constexpr const V& operator[](int i) const noexcept { return number[i]; }
};

/// The vertices of a polygon of one ring, in their order.
template <class V, int n>
struct Ring {
  Few<V, n> x, y;
};

template <class Make, int... i>
VESICA_INLINE constexpr auto made(Make make, std::integer_sequence<int, i...>) noexcept {
  return Few<decltype(make(0)), sizeof...(i)>{make(i)...};
}
/// make(0) ... make(n - 1).
template <int n, class Make>
VESICA_INLINE constexpr auto numbers(Make make) noexcept {
  return made(make, std::make_integer_sequence<int, n>{});
}
template <class V, int n>
VESICA_INLINE constexpr V least_of(const Few<V, n>& x) noexcept {
  V least = x[0];
  for (int i = 1; i < n; ++i) least = min(least, x[i]);
  return least;
}
template <class V, int n>
VESICA_INLINE constexpr V most_of(const Few<V, n>& x) noexcept {
  V most = x[0];
  for (int i = 1; i < n; ++i) most = max(most, x[i]);
  return most;
}

template <class V, int n>
VESICA_INLINE constexpr Aabb<V> box_of(const Ring<V, n>& r) noexcept {
  return {least_of(r.x), least_of(r.y), most_of(r.x), most_of(r.y)};
}

/// NaN if a vertex has one.
template <class V, int n>
VESICA_INLINE constexpr V sum_of(const Ring<V, n>& r) noexcept {
  V sum = r.x[0] + r.y[0];
  for (int i = 1; i < n; ++i) sum = sum + (r.x[i] + r.y[i]);
  return sum;
}

/// The vertices seen from a stored point.
template <class V, int n>
VESICA_INLINE constexpr Ring<V, n> seen_from(const Ring<V, n>& r, V x, V y) noexcept {
  return {numbers<n>([&](int i) { return r.x[i] - x; }), numbers<n>([&](int i) { return r.y[i] - y; })};
}

/// Bounds the errors below: of a polygon with a box of this width and height, in a box about both polygons.
template <class V>
VESICA_INLINE constexpr V side_error(V width, V height, V whole_width, V whole_height) noexcept {
  return roundoffs<V>(12) * (width * whole_height + height * whole_width) + guard_power<V, -120>();
}

/// From the edges of one polygon.
template <class V>
struct Sides {
  V reach;  // the least over the edges of the farthest that the other polygon reaches inwards, times the edge's length
  V turn;   // the least turn from an edge to the next, in the sense of the first; a triangle's are equal
};

/// The farthest inwards from edge i. No lambda: g++ 12 would call it in large sources.
template <class V, int n>
struct Reach {
  const Few<V, n>&dx, &dy;
  V sense;
  const Ring<V, n>&own_seen, &other_seen;

  VESICA_INLINE constexpr V operator()(int i) const noexcept {
    const V ex = flip_sign(dx[i], sense), ey = flip_sign(dy[i], sense);
    const auto side = numbers<n>([&](int j) { return ex * other_seen.y[j] - ey * other_seen.x[j]; });
    return most_of(side) - (ex * own_seen.y[i] - ey * own_seen.x[i]);
  }
};

/// Proved: with E from side_error(), a reach or a turn beyond E has the right sign. So
///
///   - turns above E show a convex polygon with area, if it has at most 4 vertices;
///   - a reach below -E of a convex polygon shows that the two are apart, reaches above E of both that insides meet.
///
/// (u: the greatest relative error of one operation. w, h: the sizes of the polygon's box; W, H: of the box about both.
/// o: a stored vertex, from which vertices are seen.)
///
///   - Edges d and vertices seen from o are differences of stored numbers: they err by u of themselves, and by nothing
///     where they are subnormal. |d| is at most (w, h), |q - o| at most (W, H).
///   - Each product of d x (q - o) errs by 3u of itself, and their difference by u: 4u (w H + h W). So does
///     d x (p - o), p a vertex on the edge.
///   - The difference of the two is at most 2 (w H + h W) and adds u of itself. In all 10u (w H + h W). A maximum or a
///     minimum adds nothing. A turn d x d' errs by 4u 2 w h, which is less.
///   - 12u leaves room for the roundings of E itself and for terms of second order. Products that underflow lose less
///     than the power of two that is added.
///   - Turns of one sign are each less than a half turn, and add up to whole turns. Four of them are less than two
///     whole turns, so the outline winds once.
///   - Two convex polygons with area are apart if and only if an edge of one has all of the other strictly outside: the
///     edges of their difference, a convex polygon too, have the directions of theirs. Insides meet if and only if the
///     origin is strictly inside each edge of the difference.
///
/// own_seen, other_seen: seen from one point. Compares all edges with all vertices, so nothing depends on branches.
template <class V, int n>
VESICA_INLINE constexpr Sides<V> sides(const Ring<V, n>& own, const Ring<V, n>& own_seen,
                                       const Ring<V, n>& other_seen) noexcept {
  static_assert(n == 3 || n == 4);
  const auto dx = numbers<n>([&](int i) { return own.x[(i + 1) % n] - own.x[i]; });
  const auto dy = numbers<n>([&](int i) { return own.y[(i + 1) % n] - own.y[i]; });
  constexpr int turns = n == 3 ? 1 : n;
  const auto turn = numbers<turns>([&](int i) {
    const int next = (i + 1) % n;
    return dx[i] * dy[next] - dy[i] * dx[next];
  });
  const V sense = turn[0];
  const auto reach = numbers<n>(Reach<V, n>{dx, dy, sense, own_seen, other_seen});
  return {least_of(reach), least_of(numbers<turns>([&](int i) { return flip_sign(turn[i], sense); }))};
}

/// The boxes of two rings, in lanes of pairs, and what follows from them.
template <class V>
struct RingBoxes {
  Aabb<V> a, b;
  V error_a, error_b;

  template <int n>
  VESICA_INLINE constexpr RingBoxes(const Ring<V, n>& p, const Ring<V, n>& q) noexcept : a(box_of(p)), b(box_of(q)) {
    const V width = max(a.max_x, b.max_x) - min(a.min_x, b.min_x);
    const V height = max(a.max_y, b.max_y) - min(a.min_y, b.min_y);
    error_a = side_error(a.max_x - a.min_x, a.max_y - a.min_y, width, height);
    error_b = side_error(b.max_x - b.min_x, b.max_y - b.min_y, width, height);
  }

  /// Holds for finite numbers only: of others a sum is NaN, or a width infinite or NaN.
  template <int n>
  VESICA_INLINE constexpr auto usable(const Ring<V, n>& p, const Ring<V, n>& q) const noexcept {
    const V sum = sum_of(p) + sum_of(q);
    return both(sum == sum, error_a + error_b <= greatest_error<V>());
  }
  VESICA_INLINE constexpr auto apart() const noexcept {
    return either(either(a.max_x < b.min_x, b.max_x < a.min_x), either(a.max_y < b.min_y, b.max_y < a.min_y));
  }
};
template <class V, int n>
RingBoxes(const Ring<V, n>&, const Ring<V, n>&) -> RingBoxes<V>;

/// In lanes of pairs; what the boxes decide is left out.
template <class V, int n>
VESICA_INLINE constexpr auto convex_rings(const Ring<V, n>& a, const Ring<V, n>& b,
                                          const RingBoxes<V>& boxes) noexcept {
  const V ox = a.x[0], oy = a.y[0];
  const Ring<V, n> a_seen = seen_from(a, ox, oy), b_seen = seen_from(b, ox, oy);
  const Sides<V> s = sides(a, a_seen, b_seen), t = sides(b, b_seen, a_seen);
  const V e = boxes.error_a, f = boxes.error_b;
  return guarded(both(boxes.usable(a, b), both(s.turn > e, t.turn > f)), both(s.reach > e, t.reach > f),
                 either(s.reach < -e, t.reach < -f));
}

/// In place of 1 or 0.
inline constexpr int undecided = -1;

#if VESICA_HAS_TWO_DOUBLES
/// The answer of the boxes: do they meet, and what follows? The first number is the first polygon's.
struct TwoBoxes {
  Aabb<TwoDoubles> box;

  /// In no rounding mode is a size that is not finite below the limit.
  VESICA_INLINE bool usable(TwoDoubles sum) const noexcept {
    return in_both(both(sum == sum, whole_width() + whole_height() <= guard_power<TwoDoubles, 110>()));
  }
  VESICA_INLINE bool apart() const noexcept {
    return !in_both(both(box.min_x <= exchanged(box.max_x), box.min_y <= exchanged(box.max_y)));
  }
  VESICA_INLINE TwoDoubles error() const noexcept {
    return side_error(box.max_x - box.min_x, box.max_y - box.min_y, whole_width(), whole_height());
  }

 private:
  VESICA_INLINE TwoDoubles whole_width() const noexcept {
    return max(box.max_x, exchanged(box.max_x)) - min(box.min_x, exchanged(box.min_x));
  }
  VESICA_INLINE TwoDoubles whole_height() const noexcept {
    return max(box.max_y, exchanged(box.max_y)) - min(box.min_y, exchanged(box.min_y));
  }
};

VESICA_INLINE int decided(const Sides<TwoDoubles>& s, TwoDoubles error) noexcept {
  if (!in_both(both(error < s.turn, error <= greatest_error<TwoDoubles>()))) return undecided;
  if (signs(s.reach - error) == 0) return 1;
  return signs(s.reach + error) != 0 ? 0 : undecided;
}

/// One pair, the same for both polygons at once.
template <int n>
VESICA_INLINE int convex_rings(const Ring<TwoDoubles, n>& own) noexcept {
  const TwoBoxes boxes{box_of(own)};
  if (!boxes.usable(sum_of(own))) return undecided;
  if (boxes.apart()) return 0;
  const auto seen = seen_from(own, TwoDoubles(own.x[0].first()), TwoDoubles(own.y[0].first()));
  const Ring<TwoDoubles, n> other{numbers<n>([&](int i) { return exchanged(seen.x[i]); }),
                                  numbers<n>([&](int i) { return exchanged(seen.y[i]); })};
  return decided(sides(own, seen, other), boxes.error());
}
#endif

}  // namespace vesica::filter
