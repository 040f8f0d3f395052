// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vesica::textbook {

/// The discriminant test: the cubic d1 + c1 x + c2 x^2 + d2 x^3 stays >= 0 for x > 0 exactly when the ellipses overlap
/// (from the contact function of Perram and Wertheim, 1985, by Descartes' rule and the discriminant). No error bound,
/// no validity check. Written as one would; with & and | for && and || it has no branch to mispredict and takes half
/// the time if half of the pairs overlap.
template <class Ellipse>
inline bool ellipse_ellipse(const Ellipse& p, const Ellipse& q) {
  const auto dx = q.cx - p.cx, dy = q.cy - p.cy;
  const auto vv = p.ux * p.ux + p.uy * p.uy, ww = q.ux * q.ux + q.uy * q.uy;
  const auto c = p.ux * q.ux + p.uy * q.uy, s = p.ux * q.uy - p.uy * q.ux;
  const auto cc = c * c, ss = s * s;
  const auto pa = p.a * p.a, pb = p.b * p.b, qa = q.a * q.a, qb = q.b * q.b;
  const auto px = p.ux * dx + p.uy * dy, py = p.ux * dy - p.uy * dx;
  const auto qx = q.ux * dx + q.uy * dy, qy = q.ux * dy - q.uy * dx;
  const auto d1 = pa * pb * (vv * vv), d2 = qa * qb * (ww * ww);
  const auto mu = cc * (pa * qb + pb * qa) + ss * (pa * qa + pb * qb);
  const auto c1 = d1 + mu - (pb * (px * px) + pa * (py * py));
  const auto c2 = d2 + mu - (qb * (qx * qx) + qa * (qy * qy));
  if (c1 >= 0 && c2 >= 0) return true;
  const auto A = c2 * c2 - 3 * d2 * c1;
  const auto B = c1 * c2 - 9 * d1 * d2;
  const auto C = c1 * c1 - 3 * d1 * c2;
  return 4 * A * C - B * B <= 0;
}

}  // namespace vesica::textbook
