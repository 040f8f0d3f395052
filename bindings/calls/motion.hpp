// SPDX-License-Identifier: Apache-2.0
/// Calls of vesica_motion.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lines.hpp"

template <class T>
struct Motion {
  T vx, vy, t_end;
};

template <class T>
void motion_argument(const Motion<T>& m) {
  numbers_argument(std::vector<T>{m.vx, m.vy, m.t_end});
}

/// A code or an item, and the impact that was written.
template <class T>
void impact(long long code, const typename Structs<T>::Impact& out) {
  result(code);
  if (code >= 0) values(std::vector<T>{out.t, out.x, out.y, out.nx, out.ny});
  end();
}

template <class T>
void cast(const Array<T>& a, const Array<T>& b, const Motion<T>& m) {
  typename Structs<T>::Impact out{};
  begin<T>("cast"), argument(a), argument(b), motion_argument(m);
  impact<T>(call::cast(T{}, a.kind, a.data(), b.kind, b.data(), m.vx, m.vy, m.t_end, &out), out);
}

/// As many velocities as shapes in step, or one.
template <class T>
void cast_many(const Array<T>& a, const Array<T>& b, const std::vector<T>& vx, const std::vector<T>& vy, T t_end) {
  const std::size_t n = std::max(a.count(), b.count());
  std::vector<T> out(5 * n);
  T* const t = out.data();
  const auto view_a = a.view(), view_b = b.view();
  const auto stride = static_cast<std::ptrdiff_t>(vx.size() == 1 ? 0 : sizeof(T));
  begin<T>("cast_many"), argument(a), argument(b), numbers_argument(vx), numbers_argument(vy);
  numbers_argument(std::vector<T>{t_end});
  result(call::cast_many(T{}, &view_a, &view_b, vx.data(), vy.data(), stride, t_end, t, t + n, t + 2 * n, t + 3 * n,
                         t + 4 * n));
  values(out), end();
}

template <class T>
void cast_first(const Array<T>& one, const Array<T>& many, const Motion<T>& m) {
  typename Structs<T>::Impact out{};
  const auto view_one = one.view(), view_many = many.view();
  begin<T>("cast_first"), argument(one), argument(many), motion_argument(m);
  impact<T>(call::cast_first(T{}, &view_one, &view_many, m.vx, m.vy, m.t_end, &out), out);
}

template <class T>
void sweep_bounds(const Array<T>& shape, const Motion<T>& m) {
  typename Structs<T>::Aabb box{};
  begin<T>("sweep_bounds"), argument(shape), motion_argument(m);
  const int code = call::sweep_bounds(T{}, shape.kind, shape.data(), m.vx, m.vy, m.t_end, &box);
  result(code);
  if (code >= 0) values(std::vector<T>{box.min_x, box.min_y, box.max_x, box.max_y});
  end();
}

template <class T>
void index_casts(const Built<T>& built, const Array<T>& one, const Motion<T>& m) {
  std::vector<std::int64_t> items(built.count), state(4);
  const auto view = one.view();
  begin<T>("index_cast"), argument(one), motion_argument(m);
  for (const auto& set : built.sets) argument(set);
  const auto found = call::index_cast(T{}, built.index.data(), built.views.data(), built.set_count(), &view, m.vx, m.vy,
                                      m.t_end, items.data(), std::int64_t(items.size()), state.data());
  items.resize(found < 0 ? 0 : static_cast<std::size_t>(found));
  result(found), values(items), end();

  typename Structs<T>::Impact out{};
  begin<T>("index_cast_first"), argument(one), motion_argument(m);
  for (const auto& set : built.sets) argument(set);
  impact<T>(call::index_cast_first(T{}, built.index.data(), built.views.data(), built.set_count(), &view, m.vx, m.vy,
                                   m.t_end, &out),
            out);
}

template <class T>
using Turn = typename Structs<T>::Turn;

template <class T>
void impact_time(const Array<T>& a, const Turn<T>& turn_a, const Array<T>& b, const Turn<T>& turn_b, T tolerance) {
  typename Structs<T>::Impact out{};
  T gap{};
  const auto turn_argument = [](const Turn<T>& turn) {
    numbers_argument(std::vector<T>{turn.vx, turn.vy, turn.angle});
  };
  begin<T>("impact_time"), argument(a), turn_argument(turn_a), argument(b), turn_argument(turn_b);
  numbers_argument(std::vector<T>{tolerance});
  const int code = call::impact_time(T{}, a.kind, a.data(), &turn_a, b.kind, b.data(), &turn_b, tolerance, &out, &gap);
  result(code);
  if (code >= 0) values(std::vector<T>{out.t, out.x, out.y, out.nx, out.ny, gap});
  end();
}

/// Each answer and each error, both shapes turning unlike each other, so that none of the arguments can be left out.
template <class T>
void impact_times() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN(), most = std::numeric_limits<T>::max();
  const Turn<T> still{0, 0, 0}, spin{T(0.5), T(-0.25), 4};
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
    impact_time<T>(sample<T>(kind, 0, 0), spin, sample<T>(5 - kind, -9, -6), {10, T(6.5), -2}, T(0.0009765625));
  }
  const auto rect = sample<T>(VESICA_RECT, 0, 0), box = sample<T>(VESICA_AABB, 4, 0);
  impact_time<T>(rect, spin, sample<T>(VESICA_POINT, 5, 5), {1, 0, 8}, T(0.0009765625));
  impact_time<T>(sample<T>(VESICA_SEGMENT, 0, 0), spin, sample<T>(VESICA_POINT, 0, T(0.5)), still, T(0.0009765625));
  impact_time<T>(rect, still, sample<T>(VESICA_CIRCLE, -6, T(3.5625)), {12, 0, 1}, T(0.25));
  impact_time<T>(rect, spin, sample<T>(VESICA_CIRCLE, 2, 0), {-1, 0, 8}, T(0.0009765625));
  impact_time<T>(rect, {0, 0, 1000}, sample<T>(VESICA_AABB, T(3.5), 2), {0, 0, -999}, T(0.0009765625));

  impact_time<T>(rect, still, box, {-3, 0, 0}, 0);
  impact_time<T>(rect, still, box, {-3, 0, 1048577}, 1);
  impact_time<T>(rect, {0, nan, 0}, box, {-3, 0, 0}, 1);
  impact_time<T>(rect, still, invalid<T>(VESICA_ELLIPSE), {-3, 0, 0}, 1);
  const Array<T> far{VESICA_CIRCLE, {most / 2, 0, most / 32}}, farther{VESICA_CIRCLE, {most / 8 * 7, 0, most / 32}};
  impact_time<T>(far, {most, 0, 1}, farther, {most / 2, 0, 1}, most / 1024);
}

template <class T>
void motion() {
  constexpr T forever = std::numeric_limits<T>::infinity();
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
    cast<T>(sample<T>(kind, 0, 0), sample<T>(5 - kind, -9, -6), {T(1.5), 1, forever});
  }
  cast<T>(sample<T>(VESICA_RECT, 0, 0), sample<T>(VESICA_POINT, 5, 5), {1, 0, 8});
  cast<T>(sample<T>(VESICA_RECT, 0, 0), sample<T>(VESICA_CIRCLE, 2, 0), {-1, 0, 8});
  cast<T>(sample<T>(VESICA_AABB, 0, 0), sample<T>(VESICA_AABB, 4, 0), {-1, 0, -1});
  cast<T>(invalid<T>(VESICA_AABB), sample<T>(VESICA_AABB, 4, 0), {-1, 0, 1});

  const auto rects = series<T>(VESICA_RECT, 3), circles = series<T>(VESICA_CIRCLE, 3);
  cast_many<T>(rects, sample<T>(VESICA_POINT, -6, 0), {1, 1, T(-0.5)}, {0, T(0.125), T(0.25)}, 20);
  cast_many<T>(with_invalid(rects), circles, {T(0.25)}, {-1}, forever);
  cast_many<T>(circles, sample<T>(VESICA_AABB, 9, 0), {-1, forever, -2}, {0, 0, T(0.5)}, 3);

  cast_first<T>(sample<T>(VESICA_CIRCLE, -9, 0), rects, {1, 0, forever});
  cast_first<T>(sample<T>(VESICA_CIRCLE, -9, 0), rects, {-1, 0, forever});
  cast_first<T>(sample<T>(VESICA_CIRCLE, -9, 0), with_invalid(rects), {1, 0, forever});
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
    sweep_bounds<T>(sample<T>(kind, 0, 0), {T(-0.75), 3, 2});
  }
  sweep_bounds<T>(sample<T>(VESICA_RECT, 0, 0), {1, 0, forever});

  const Built<T> built({series<T>(VESICA_RECT, 5), with_invalid(series<T>(VESICA_CIRCLE, 3))});
  index_casts<T>(built, sample<T>(VESICA_ELLIPSE, -9, 0), {1, 0, forever});
  index_casts<T>(built, sample<T>(VESICA_POINT, -9, 0), {T(0.5), T(0.03125), 24});
  index_casts<T>(built, sample<T>(VESICA_POINT, -9, 0), {-1, 0, forever});
  index_casts<T>(built, invalid<T>(VESICA_CIRCLE), {1, 0, 1});
  impact_times<T>();
}
