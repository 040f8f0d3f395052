// SPDX-License-Identifier: Apache-2.0
/// A box and an ellipse, disjoint: the face or the vertex of the box that the ellipse is closest to, and the distance
/// from it.
#pragma once

#include <vesica/nearest/box_box.hpp>
#include <vesica/nearest/point_ellipse.hpp>

namespace vesica::detail::nearest {

/// A face or a vertex of a box: a vertex (signs of its half extents), and whether it stands for the face across x, or
/// across y, that it belongs to.
template <class V>
struct Feature {
  V i, j;
  MaskOf<V> face_x, face_y;
};

/// In the frame of the box, folded so that the ellipse's centre k lies in the first quadrant, only the faces towards
/// +x and +y can be closest.
///
/// If the shapes have a gap along a face's normal, the ellipse's support point decides: it is above the face, and the
/// face is closest, or beyond one of its ends, and the vertex there is closest. If there is no gap along either normal,
/// the closest feature is the vertex that is closest to the ellipse's centre in the ellipse's own metric. The reason:
/// the normal there separates the shapes, and so does every direction from it to the best one, so no face's normal lies
/// between. The regions are those of D. Eberly, "Intersection of Rectangle and Ellipse" (Geometric Tools).
template <class V>
VESICA_INLINE Feature<V> closest_feature(const Box<V>& box, const Axes<V>& e, V dx, V dy) noexcept {
  const V zero(0.0), one(1.0);
  const V ux = box.u.x.high, uy = box.u.y.high, uu = ux * ux + uy * uy;
  const V kx = ux * dx + uy * dy, ky = ux * dy - uy * dx, ex = box.hx.high * uu, ey = box.hy.high * uu;
  const V c = ux * e.ux + uy * e.uy, s = ux * e.uy - uy * e.ux, aa = e.a * e.a, bb = e.b * e.b;
  const V pxx = aa * (c * c) + bb * (s * s), pyy = aa * (s * s) + bb * (c * c);
  const V pxy = flip_sign(flip_sign((e.a - e.b) * (e.a + e.b) * (c * s), kx), ky);
  const V fx = abs(kx), fy = abs(ky), beyond_x = fx - ex, beyond_y = fy - ey;
  const V reach_x = sqrt(pxx), reach_y = sqrt(pyy);
  const auto seen_x = beyond_x > reach_x, seen_y = beyond_y > reach_y, unseen = negated<V>(either(seen_x, seen_y));
  const auto use_x = either(seen_x, both(unseen, beyond_x > zero));
  const auto use_y = either(seen_y, both(unseen, beyond_y > zero));
  // The support point's (its step towards the face is reach), or the metric foot's (the step is all of beyond).
  const V along_y = fy - pxy * (select(seen_x, reach_x, beyond_x) / pxx);
  const V along_x = fx - pxy * (select(seen_y, reach_y, beyond_y) / pyy);
  const auto face_x = both(use_x, abs(along_y) <= ey), face_y = and_not(both(use_y, abs(along_x) <= ex), face_x);
  const V i = select(both(use_y, along_x < -ex), -one, one), j = select(both(use_x, along_y < -ey), -one, one);
  return {flip_sign(select(face_x, one, i), kx), flip_sign(select(face_y, one, j), ky), face_x, face_y};
}

/// The result for a disjoint box and ellipse: the distance, the place in the box, the offset from the ellipse's centre,
/// and the unit vector from the box to the ellipse.
template <class V>
struct BoxEllipse {
  Twofold<V> distance;
  Spot<V> spot;
  V bx, by, nx, ny;
  MaskOf<V> settled;
  V doubt = V(0.0);  ///< as of ClosestOffsets
};

/// A direction in twice the precision.
template <class V>
VESICA_INLINE Vector<V> twofold(const Direction<V>& n) noexcept {
  return {{n.x, V(0.0)}, {n.y, V(0.0)}};
}

/// How far beyond a face's end, as a share of the distance, a point counts as above the face: this changes the distance
/// by far less than its last place. The point may be off by rounding, by this share of the size.
inline constexpr double beyond_face = 0x1p-28, foot_rounding = 0x1p-50;

template <class V>
using NormalOf = Normal<V, TwofoldFactor<V>>;

/// The normal of a face, or that which was found from a vertex.
template <class V>
VESICA_INLINE NormalOf<V> feature_normal(const Box<V>& box, const Feature<V>& f, const Vector<V>& found) noexcept {
  const Vector<V> across_x = flipped(box.u, f.i);
  const Vector<V> across_y{flipped(box.u.y, -f.j), flipped(box.u.x, f.j)};
  const auto pick = [&](const Twofold<V>& n, const Twofold<V>& x, const Twofold<V>& y) {
    return choose(f.face_x, x, choose(f.face_y, y, n));
  };
  return normal(VectorFactor<TwofoldFactor<V>>{factor(pick(found.x, across_x.x, across_y.x)),
                                               factor(pick(found.y, across_x.y, across_y.y))});
}

/// The result along a normal from a feature, with the place in the box that the ellipse's point stands above.
/// Settled where the direction, if it was found, lies between the normals of the vertex's faces, or the foot in the
/// face: then nothing of the box is closer.
template <class V>
VESICA_INLINE BoxEllipse<V> on_feature(const Box<V>& box, const Vector<V>& d, V size, const Feature<V>& f,
                                       const Direction<V>& unit, MaskOf<V> direction_found,
                                       const ClosestOffsets<V>& found) noexcept {
  const V zero(0.0), one(1.0);
  const auto face = either(f.face_x, f.face_y);
  const V ux = box.u.x.high, uy = box.u.y.high, scale = one / (ux * ux + uy * uy);
  const V px = d.x.high + found.bx, py = d.y.high + found.by, hx = box.hx.high, hy = box.hy.high;
  const V above_x = (ux * px + uy * py) * scale, above_y = (ux * py - uy * px) * scale;
  const V foot_x = max(-hx, min(hx, above_x)), foot_y = max(-hy, min(hy, above_y));
  const V beyond = select(f.face_x, abs(above_y) - hy, abs(above_x) - hx);
  const V nx = ux * unit.x + uy * unit.y, ny = ux * unit.y - uy * unit.x;
  const V slack = V(-0x1p-40) * (abs(ux) + abs(uy));
  const auto between = both(either(f.i * nx >= slack, hx == zero), either(f.j * ny >= slack, hy == zero));
  const auto above =
      beyond * (abs(ux) + abs(uy)) + V(foot_rounding) * size <= V(beyond_face) * abs(found.distance.high);
  const auto ended = either(both(face, above), both(and_not(direction_found, face), between));
  return {found.distance,
          {select(f.face_y, foot_x, f.i * hx), select(f.face_x, foot_y, f.j * hy)},
          found.bx,
          found.by,
          found.nx,
          found.ny,
          both(found.settled, ended),
          found.doubt};
}

/// The distance of an ellipse from one feature of a box, of a vertex along a direction; d from the box's centre to the
/// ellipse's. The ellipse may not contain the feature's vertex.
template <class V>
VESICA_INLINE BoxEllipse<V> feature_ellipse(const Box<V>& box, const OneEllipse<V>& e, const Vector<V>& d, V size,
                                            const Feature<V>& f, const Vector<V>& from_vertex,
                                            const FoundDirection<V>& direction) noexcept {
  const auto n = feature_normal(box, f, twofold(direction.n));
  const V smooth = select(either(f.face_x, f.face_y), V(0.0), V(1.0));
  return on_feature(box, d, size, f, n.unit, direction.found, separation(e, from_vertex, n, size, smooth));
}

/// The distance between a box and an ellipse that are disjoint; d from the box's centre to the ellipse's.
template <class V>
VESICA_INLINE BoxEllipse<V> box_ellipse(const Box<V>& box, const Axes<V>& e, const Vector<V>& d, V size,
                                        int& steps) noexcept {
  const V zero(0.0);
  const Feature<V> f = closest_feature(box, e, d.x.high, d.y.high);
  const Vector<V> from_vertex = renormalised(d - vertex(box, f.i, f.j));
  const OneEllipse<V> shape = one_ellipse(e);
  // No search if faces settle all lanes.
  FoundDirection<V> direction{{}, zero > zero, 0};
  if (!all(either(f.face_x, f.face_y))) {
    direction = farthest_direction(shape, Direction<V>{from_vertex.x.high, from_vertex.y.high}, size);
  }
  steps = direction.steps;
  return feature_ellipse(box, shape, d, size, f, from_vertex, direction);
}

}  // namespace vesica::detail::nearest
