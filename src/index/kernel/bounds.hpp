// SPDX-License-Identifier: Apache-2.0
// Boxes that hold shapes, from their numbers.
#pragma once

#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

/// c - room and c + room, where the extent is e up to three roundings and 2^-1073. With u = 2^-53: the room as computed
/// is at least e (1 + 13 u) + 3.9 u |c| + 2^-1071, which leaves more than u (|c| + room) for the last rounding.
inline void about(double c, double extent, double& low, double& high) noexcept {
  const double room = extent * (1 + 0x1p-49) + (__builtin_fabs(c) * 0x1p-51 + 0x1p-1070);
  low = c - room;
  high = c + room;
}

/// sqrt(x^2 + y^2) where squares of the greater neither overflow nor lose digits, else x + y, which is more.
inline double hypotenuse(double x, double y) noexcept {
  const double most = x > y ? x : y;
  const bool usable = (most >= 0x1p-480) & (most <= 0x1p480);
  const double sx = usable ? x : 1, sy = usable ? y : 1;
  const double root = __builtin_sqrt(sx * sx + sy * sy);
  return usable ? root : x + y;
}

/// 1 where a number is finite, else NaN.
inline double one_if_finite(double x) noexcept { return x * 0 + 1; }

inline void bounds_of(Named<Point>, const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x = f.column[0][i], y = f.column[1][i];
    out.min_x[i] = out.max_x[i] = x;
    out.min_y[i] = out.max_y[i] = y;
    out.valid[i] = one_if_finite(x) * one_if_finite(y) == 1;
  }
}

inline void bounds_of(Named<Segment>, const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x0 = f.column[0][i], y0 = f.column[1][i], x1 = f.column[2][i], y1 = f.column[3][i];
    out.min_x[i] = x0 < x1 ? x0 : x1;
    out.max_x[i] = x0 < x1 ? x1 : x0;
    out.min_y[i] = y0 < y1 ? y0 : y1;
    out.max_y[i] = y0 < y1 ? y1 : y0;
    out.valid[i] = one_if_finite(x0) * one_if_finite(y0) * one_if_finite(x1) * one_if_finite(y1) == 1;
  }
}

inline void bounds_of(Named<Circle>, const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x = f.column[0][i], y = f.column[1][i], r = f.column[2][i];
    about(x, r, out.min_x[i], out.max_x[i]);
    about(y, r, out.min_y[i], out.max_y[i]);
    out.valid[i] = (one_if_finite(x) * one_if_finite(y) * one_if_finite(r) == 1) & (r >= 0);
  }
}

inline void bounds_of(Named<Aabb>, const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x0 = f.column[0][i], y0 = f.column[1][i], x1 = f.column[2][i], y1 = f.column[3][i];
    out.min_x[i] = x0;
    out.min_y[i] = y0;
    out.max_x[i] = x1;
    out.max_y[i] = y1;
    const bool finite = one_if_finite(x0) * one_if_finite(y0) * one_if_finite(x1) * one_if_finite(y1) == 1;
    out.valid[i] = finite & (x0 <= x1) & (y0 <= y1);
  }
}

template <bool is_ellipse>
inline void bounds_of_oblique(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double cx = f.column[0][i], cy = f.column[1][i], ux = f.column[2][i], uy = f.column[3][i];
    const double h0 = f.column[4][i], h1 = f.column[5][i];
    const double x = __builtin_fabs(ux), y = __builtin_fabs(uy);
    about(cx, is_ellipse ? hypotenuse(x * h0, y * h1) : x * h0 + y * h1, out.min_x[i], out.max_x[i]);
    about(cy, is_ellipse ? hypotenuse(y * h0, x * h1) : y * h0 + x * h1, out.min_y[i], out.max_y[i]);
    const double finite = one_if_finite(cx) * one_if_finite(cy) * one_if_finite(ux) * one_if_finite(uy) *
                          one_if_finite(h0) * one_if_finite(h1);
    out.valid[i] = (finite == 1) & (h0 >= 0) & (h1 >= 0) & ((x > 0) | (y > 0));
  }
}

inline void bounds_of(Named<Rect>, const Fields& f, int n, Boxes& out) noexcept { bounds_of_oblique<false>(f, n, out); }
inline void bounds_of(Named<Ellipse>, const Fields& f, int n, Boxes& out) noexcept {
  bounds_of_oblique<true>(f, n, out);
}

inline void bounds_of(Named<Capsule>, const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x0 = f.column[0][i], y0 = f.column[1][i], x1 = f.column[2][i], y1 = f.column[3][i];
    const double r = f.column[4][i];
    double inner;
    about(x0 < x1 ? x0 : x1, r, out.min_x[i], inner);
    about(x0 < x1 ? x1 : x0, r, inner, out.max_x[i]);
    about(y0 < y1 ? y0 : y1, r, out.min_y[i], inner);
    about(y0 < y1 ? y1 : y0, r, inner, out.max_y[i]);
    const double finite =
        one_if_finite(x0) * one_if_finite(y0) * one_if_finite(x1) * one_if_finite(y1) * one_if_finite(r);
    out.valid[i] = (finite == 1) & (r >= 0);
  }
}

inline void bounds_of(Named<RoundRect>, const Fields& f, int n, Boxes& out) noexcept {
  bounds_of_oblique<false>(f, n, out);
  for (int i = 0; i < n; ++i) {
    const double r = f.column[6][i];
    double inner;
    about(out.min_x[i], r, out.min_x[i], inner);
    about(out.max_x[i], r, inner, out.max_x[i]);
    about(out.min_y[i], r, out.min_y[i], inner);
    about(out.max_y[i], r, inner, out.max_y[i]);
    out.valid[i] = (out.valid[i] == 1) & (one_if_finite(r) == 1) & (r >= 0);
  }
}

inline void bounds(std::int32_t kind, const Fields& fields, int n, Boxes& out) noexcept {
  with_core(kind, [&]<template <class> class Shape>(Named<Shape> shape) {
    bounds_of(shape, fields, n, out);
    return 0;
  });
}

}  // namespace
}  // namespace vesica::index
