// SPDX-License-Identifier: Apache-2.0
/// Calls of vesica_measures.h and vesica_boxes.h: ratios, matrices of distances, suppression, boxes, corners, bounds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lines.hpp"

// ---- Ratios ----

template <class T>
void ratio(int which, const Array<T>& a, const Array<T>& b) {
  T out{};
  begin<T>("ratio"), numbers_argument(std::vector<int>{which}), argument(a), argument(b);
  const int code = call::ratio(T{}, which, a.kind, a.data(), b.kind, b.data(), &out);
  result(code);
  if (code >= 0) values(std::vector<T>{out});
  end();
}

template <class T>
void ratio_many(int which, const Array<T>& a, const Array<T>& b) {
  std::vector<T> out(std::max(a.count(), b.count()));
  const auto view_a = a.view(), view_b = b.view();
  begin<T>("ratio_many"), numbers_argument(std::vector<int>{which}), argument(a), argument(b);
  result(call::ratio_many(T{}, which, &view_a, &view_b, out.data()));
  values(out), end();
}

template <class T>
void ratio_matrix(int which, const Array<T>& a, const Array<T>& b) {
  std::vector<T> out(a.count() * b.count());
  const auto view_a = a.view(), view_b = b.view();
  begin<T>("ratio_matrix"), numbers_argument(std::vector<int>{which}), argument(a), argument(b);
  result(call::ratio_matrix(T{}, which, &view_a, &view_b, out.data(), static_cast<std::ptrdiff_t>(b.count())));
  values(out), end();
}

template <class T>
void ratios() {
  const auto rect = sample<T>(VESICA_RECT, 0, 0), circle = sample<T>(VESICA_CIRCLE, 0.75, 0.25);
  for (int which = VESICA_RATIO_OVER_UNION; which <= VESICA_RATIO_COMPLETE; ++which) ratio(which, rect, circle);
  ratio(VESICA_RATIO_OVER_FIRST, sample<T>(VESICA_SEGMENT, 0, 0), circle);
  ratio(VESICA_RATIO_OVER_SECOND, invalid<T>(VESICA_ELLIPSE), circle);
  const auto rects = series<T>(VESICA_RECT, 4), boxes = series<T>(VESICA_AABB, 4);
  ratio_many(VESICA_RATIO_GENERALIZED, rects, boxes);
  ratio_many(VESICA_RATIO_COMPLETE, with_invalid(rects), sample<T>(VESICA_ELLIPSE, 0.5, 0));
  ratio_many(VESICA_RATIO_OVER_SECOND, rects, series<T>(VESICA_POINT, 4));
  ratio_matrix(VESICA_RATIO_OVER_SMALLER, rects, series<T>(VESICA_CIRCLE, 2));
  ratio_matrix(VESICA_RATIO_DISTANCE, boxes, with_invalid(series<T>(VESICA_RECT, 3)));
}

// ---- Every a with every b ----

template <class T, class Call>
void distances(const char* name, Call call, const Array<T>& a, const Array<T>& b) {
  std::vector<T> out(a.count() * b.count());
  const auto view_a = a.view(), view_b = b.view();
  begin<T>(name), argument(a), argument(b);
  result(call(T{}, &view_a, &view_b, out.data(), static_cast<std::ptrdiff_t>(b.count())));
  values(out), end();
}

template <class T>
void all_distances(const Array<T>& a, const Array<T>& b) {
  distances("nearest_matrix", call::nearest_matrix, a, b);
  distances("boundary_distance_matrix", call::boundary_distance_matrix, a, b);
  distances("depth_matrix", call::depth_matrix, a, b);
}

// ---- Suppression ----

struct Suppression {
  int ratio;
  double threshold, least_score;
  int most;
};

template <class T>
void suppress(const Array<T>& boxes, const std::vector<T>& scores, const std::vector<std::int32_t>& labels,
              const Suppression& how) {
  std::vector<std::int64_t> keep(boxes.count());
  std::vector<unsigned char> scratch(static_cast<std::size_t>(vesica_nms_scratch(std::int64_t(boxes.count()))));
  const auto view = boxes.view();
  std::int64_t kept = 0;
  begin<T>("suppress"), argument(boxes), numbers_argument(scores);
  numbers_argument(std::vector<double>{double(how.ratio), how.threshold, how.least_score, double(how.most)});
  if (!labels.empty()) numbers_argument(labels);
  result(call::suppress(T{}, &view, scores.data(), labels.empty() ? nullptr : labels.data(), how.ratio,
                        T(how.threshold), T(how.least_score), std::int64_t{how.most}, scratch.data(),
                        std::int64_t(scratch.size()), keep.data(), &kept));
  keep.resize(static_cast<std::size_t>(kept));
  values(keep), end();
}

template <class T>
void suppressions() {
  constexpr double any = -std::numeric_limits<double>::infinity();
  const auto rects = series<T>(VESICA_RECT, 7);
  const std::vector<T> scores{0.5, 0.25, 0.75, 0.875, 0.125, 0.375, 0.625};
  const std::vector<std::int32_t> labels{1, 1, 2, 1, -3, 1, 2};
  suppress(rects, scores, {}, {VESICA_RATIO_OVER_UNION, 0.25, any, 7});
  suppress(rects, scores, labels, {VESICA_RATIO_OVER_SMALLER, 0.125, any, 7});
  suppress(rects, scores, labels, {VESICA_RATIO_GENERALIZED, 0.0625, 0.25, 3});
  suppress(with_invalid(rects), scores, labels, {VESICA_RATIO_DISTANCE, 0.25, any, 7});
  suppress(rects, scores, {}, {VESICA_RATIO_OVER_FIRST, 0.25, any, 7});
}

// ---- Boxes, corners and bounds ----

template <class T, class Call>
void shapes_from_boxes(const char* name, Call call, const std::vector<T>& boxes, int angle) {
  using Rect = typename Structs<T>::Rect;
  const auto count = static_cast<std::int64_t>(boxes.size() / 5);
  std::vector<T> out(boxes.size() / 5 * 6);
  static_assert(sizeof(Rect) == 6 * sizeof(T));
  begin<T>(name), numbers_argument(boxes), numbers_argument(std::vector<int>{angle});
  result(call(boxes.data(), count, static_cast<std::ptrdiff_t>(5 * sizeof(T)), angle, out.data()));
  values(out), end();
}

template <class T>
void rects_and_ellipses_from_boxes(const std::vector<T>& boxes, int angle) {
  const auto rects = [](const T* from, std::int64_t count, std::ptrdiff_t stride, int unit, T* out) {
    return call::rects_from_boxes(T{}, from, count, stride, unit, reinterpret_cast<typename Structs<T>::Rect*>(out));
  };
  const auto ellipses = [](const T* from, std::int64_t count, std::ptrdiff_t stride, int unit, T* out) {
    return call::ellipses_from_boxes(T{}, from, count, stride, unit,
                                     reinterpret_cast<typename Structs<T>::Ellipse*>(out));
  };
  shapes_from_boxes("rects_from_boxes", rects, boxes, angle);
  shapes_from_boxes("ellipses_from_boxes", ellipses, boxes, angle);
}

/// width: how many numbers each shape gives.
template <class T, class Call>
void rows(const char* name, Call call, const Array<T>& shapes, std::size_t width) {
  std::vector<T> out(width * shapes.count());
  const auto view = shapes.view();
  begin<T>(name), argument(shapes);
  result(call(&view, out.data()));
  values(out), end();
}

template <class T>
void boxes_from_shapes(const Array<T>& shapes, int angle) {
  std::vector<T> out(5 * shapes.count());
  const auto view = shapes.view();
  begin<T>("boxes_from_shapes"), argument(shapes), numbers_argument(std::vector<int>{angle});
  result(call::boxes_from_shapes(T{}, &view, angle, out.data()));
  values(out), end();
}

template <class T>
void of_shapes(const Array<T>& shapes) {
  using View = typename Structs<T>::Shapes;
  rows(
      "corners_of_shapes", [](const View* v, T* out) { return call::corners_of_shapes(T{}, v, out); }, shapes, 8);
}

template <class T>
void bounds_of(const Array<T>& shapes) {
  using View = typename Structs<T>::Shapes;
  const auto bounds = [](const View* v, T* out) {
    return call::bounds_many(T{}, v, reinterpret_cast<typename Structs<T>::Aabb*>(out));
  };
  rows("bounds_many", bounds, shapes, 4);
}

template <class T>
void boxes() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  rects_and_ellipses_from_boxes<T>({1, 2, 4, 2, T(0.5), 0, 0, 3, 5, T(-2.25)}, VESICA_ANGLE_RADIANS);
  rects_and_ellipses_from_boxes<T>({1, 2, 4, 2, 90, 0, 0, 3, 5, T(-33.5), 7, 0, 1, 1, 540}, VESICA_ANGLE_DEGREES);
  rects_and_ellipses_from_boxes<T>({1, 2, 4, 2, 3, 0, 0, 3, 5, T(0.25)}, VESICA_ANGLE_QUARTERS + VESICA_ANGLE_REVERSED);
  rects_and_ellipses_from_boxes<T>({1, 2, -4, 2, 30, 0, 0, 3, 5, 30, 0, nan, 3, 5, 30},
                                   VESICA_ANGLE_DEGREES + VESICA_ANGLE_REVERSED);
  const auto rects = series<T>(VESICA_RECT, 3), ellipses = series<T>(VESICA_ELLIPSE, 2);
  // Every mathematical library gives the same angles for these axes. For others the last place may differ.
  const Array<T> turned{VESICA_RECT, {1, 2, 0, -3, 2, 1, -4, 0, 2, 2, T(0.5), 3, 0, 5, -1, 0, 1, T(0.25)}};
  boxes_from_shapes(turned, VESICA_ANGLE_RADIANS);
  boxes_from_shapes(with_invalid(turned), VESICA_ANGLE_DEGREES);
  boxes_from_shapes(Array<T>{VESICA_ELLIPSE, turned.numbers}, VESICA_ANGLE_QUARTERS + VESICA_ANGLE_REVERSED);
  of_shapes(rects);
  of_shapes(with_invalid(ellipses));
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) bounds_of(series<T>(kind, 2));
  bounds_of(with_invalid(rects));
}

template <class T>
void measures() {
  ratios<T>();
  all_distances(series<T>(VESICA_RECT, 3), series<T>(VESICA_ELLIPSE, 2));
  all_distances(with_invalid(series<T>(VESICA_CIRCLE, 2)), series<T>(VESICA_AABB, 3));
  suppressions<T>();
  boxes<T>();
}
