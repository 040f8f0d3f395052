// SPDX-License-Identifier: Apache-2.0
/// Discs, exactly, in polynomials of low degree: touching discs on integer grids are common input, so speed counts.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::exact {

/// The contact of a point and a disc of radius r >= 0 whose centre is at (dx, dy) from it. Two equal points have their
/// insides in common. Degree 2.
constexpr int contact(const Length& dx, const Length& dy, const Length& r) noexcept {
  const int sign = compare(square(dx) + square(dy), square(r));
  return sign == 0 && r.sign == 0 ? -1 : sign;
}

/// A box and the centre of a disc, in the frame of the box and in units of |u|.
struct BoxAndCentre {
  Number<2> uu, kx, ky;
  Number<3> ex, ey;

  constexpr BoxAndCentre(const Box& box, const Circle<double>& disc) noexcept {
    const Length dx = from_double(disc.cx) - box.cx, dy = from_double(disc.cy) - box.cy;
    uu = dot(box.ux, box.uy, box.ux, box.uy);
    kx = abs(dot(box.ux, box.uy, dx, dy));
    ky = abs(cross(box.ux, box.uy, dx, dy));
    ex = box.hx * uu;
    ey = box.hy * uu;
  }
};

/// Sign of the distance from the disc's centre to the box less r: for r > 0, -1 when the disc's inside meets the box, 0
/// when only its rim does, 1 when they are disjoint. Degree 6.
constexpr int contact(const Box& box, const Circle<double>& disc) noexcept {
  const BoxAndCentre f(box, disc);
  auto x = f.kx - f.ex, y = f.ky - f.ey;
  if (x.sign < 0) x = {};
  if (y.sign < 0) y = {};
  return compare(square(x) + square(y), square(from_double(disc.r)) * f.uu);
}

/// The contact of a box and any disc.
constexpr int contact_of_any(const Box& box, const Circle<double>& disc) noexcept {
  return disc.r == 0 ? contact(box, form(Point<double>{disc.cx, disc.cy})) : contact(box, disc);
}

/// How far a box stays within a disc: 1 clear of the rim, 0 up to it, -1 not within. Degree 6.
constexpr int clearance(const Box& box, const Circle<double>& disc) noexcept {
  const BoxAndCentre f(box, disc);
  return compare(square(from_double(disc.r)) * f.uu, square(f.kx + f.ex) + square(f.ky + f.ey));
}

/// How far a disc of radius r > 0 stays within a box. Degree 6.
constexpr int clearance(const Circle<double>& disc, const Box& box) noexcept {
  const BoxAndCentre f(box, disc);
  const auto x = f.ex - f.kx, y = f.ey - f.ky;
  if (x.sign <= 0 || y.sign <= 0) return -1;
  return compare(square(compare(x, y) < 0 ? x : y), square(from_double(disc.r)) * f.uu);
}

/// How two discs of positive radius relate. Degree 2.
constexpr Relation relation(const Circle<double>& a, const Circle<double>& b) noexcept {
  const Length dx = from_double(b.cx) - from_double(a.cx), dy = from_double(b.cy) - from_double(a.cy);
  const Length ra = from_double(a.r), rb = from_double(b.r);
  const auto distance = square(dx) + square(dy);
  const int apart = compare(distance, square(ra + rb));
  if (apart >= 0) return apart > 0 ? Relation::disjoint : Relation::touch;
  const Length difference = ra - rb;
  const int nested = compare(distance, square(difference));
  if (nested > 0) return Relation::cross;
  if (difference.sign == 0) return Relation::equal;
  if (difference.sign < 0) return nested < 0 ? Relation::inside : Relation::inside_touch;
  return nested < 0 ? Relation::contains : Relation::contains_touch;
}

}  // namespace vesica::exact
