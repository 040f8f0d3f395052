// SPDX-License-Identifier: Apache-2.0
/// Calls of vesica_topology.h; and of vesica_measures.h, within a distance, signed distance and soft suppression.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lines.hpp"

// ---- Within a distance, signed distances ----

template <class T>
void within(const Array<T>& a, const Array<T>& b, T distance) {
  begin<T>("within"), argument(a), argument(b), numbers_argument(std::vector<T>{distance});
  result(call::within(T{}, a.kind, a.data(), b.kind, b.data(), distance));
  end();
}

template <class T>
void within_many(const Array<T>& a, const Array<T>& b, T distance) {
  std::vector<std::uint8_t> out(std::max(a.count(), b.count()));
  const auto view_a = a.view(), view_b = b.view();
  begin<T>("within_many"), argument(a), argument(b), numbers_argument(std::vector<T>{distance});
  result(call::within_many(T{}, &view_a, &view_b, distance, out.data()));
  values(out), end();
}

template <class T>
void within_matrix(const Array<T>& a, const Array<T>& b, T distance) {
  std::vector<std::uint8_t> out(a.count() * b.count());
  const auto view_a = a.view(), view_b = b.view();
  const auto row = static_cast<std::ptrdiff_t>(b.count());
  begin<T>("within_matrix"), argument(a), argument(b), numbers_argument(std::vector<T>{distance});
  result(call::within_matrix(T{}, &view_a, &view_b, distance, out.data(), row));
  values(out), end();
}

template <class T>
void join_within(const Built<T>& a, const Built<T>& b, T distance) {
  std::vector<std::int64_t> first(1000), second(1000), found, state(4);
  begin<T>("join_within"), numbers_argument(std::vector<T>{distance});
  for (const auto& set : a.sets) argument(set);
  std::printf(" | /");
  if (&a != &b) {
    for (const auto& set : b.sets) argument(set);
  }
  const auto count = call::join_within(T{}, a.index.data(), a.views.data(), a.set_count(), b.index.data(),
                                       b.views.data(), b.set_count(), distance, std::int64_t{0}, std::int64_t{1},
                                       first.data(), second.data(), std::int64_t{1000}, state.data());
  must(state[0] == -1, "join_within");
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) found.insert(found.end(), {first[i], second[i]});
  result(count), values(found), end();
}

template <class T>
void all_within() {
  const auto rect = sample<T>(VESICA_RECT, 0, 0), disc = sample<T>(VESICA_CIRCLE, 5, 0);
  for (const T distance :
       {T(0), T(0.5), T(2), T(-1), std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()})
    within(rect, disc, distance);
  within(Array<T>{VESICA_POINT, {0, 0}}, Array<T>{VESICA_CIRCLE, {5, 0, 2}}, T(3));
  within(Array<T>{VESICA_POINT, {4, 0}}, Array<T>{VESICA_CIRCLE, {5, 0, 2}}, T(-1));
  const Array<T> ellipse{VESICA_ELLIPSE, {5, 0, 1, 0, 2, 1}};
  within(Array<T>{VESICA_POINT, {0, 0}}, ellipse, T(3));
  within(Array<T>{VESICA_ELLIPSE, {-2, 0, 1, 0, 2, 1}}, ellipse, T(3));
  within(invalid<T>(VESICA_AABB), disc, T(1));
  const auto rects = series<T>(VESICA_RECT, 4), boxes = series<T>(VESICA_AABB, 3);
  within_many(rects, disc, T(1));
  within_many(with_invalid(boxes), series<T>(VESICA_POINT, 3), T(0.25));
  within_matrix(rects, Array<T>{VESICA_AABB, {4, 0, 5, 1, 6, 0, 7, 1, 9, 0, 10, 1}}, T(1.5));
  const Built<T> a({rects, with_invalid(boxes)}), b({series<T>(VESICA_CIRCLE, 4)});
  join_within(a, b, T(0.75));
  join_within(a, a, T(0));
}

template <class T>
void signed_distances() {
  const auto signed_one = [](const Array<T>& a, const Array<T>& b) {
    T out{};
    begin<T>("signed_distance"), argument(a), argument(b);
    const int code = call::signed_distance(T{}, a.kind, a.data(), b.kind, b.data(), &out);
    result(code);
    if (code >= 0) values(std::vector<T>{out});
    end();
  };
  const auto rect = sample<T>(VESICA_RECT, 0, 0);
  signed_one(rect, sample<T>(VESICA_CIRCLE, 9, 0));
  signed_one(rect, sample<T>(VESICA_CIRCLE, 1, 0));
  signed_one(invalid<T>(VESICA_POINT), rect);
  const auto rects = series<T>(VESICA_RECT, 4), ellipses = with_invalid(series<T>(VESICA_ELLIPSE, 4));
  std::vector<T> out(4);
  const auto view_a = rects.view(), view_b = ellipses.view();
  begin<T>("signed_distance_many"), argument(rects), argument(ellipses);
  result(call::signed_distance_many(T{}, &view_a, &view_b, out.data()));
  values(out), end();
  out.resize(16);
  begin<T>("signed_distance_matrix"), argument(rects), argument(ellipses);
  result(call::signed_distance_matrix(T{}, &view_a, &view_b, out.data(), std::ptrdiff_t{4}));
  values(out), end();
}

// ---- Topology ----

/// F is -1.
template <class T>
void de9im(const Array<T>& a, const Array<T>& b) {
  std::array<char, 10> matrix{};
  begin<T>("de9im"), argument(a), argument(b);
  const int code = call::de9im(T{}, a.kind, a.data(), b.kind, b.data(), matrix.data());
  result(code);
  for (std::size_t i = 0; i < 9 && code >= 0; ++i) print_number(matrix[i] == 'F' ? -1 : matrix[i] - '0');
  end();
}

inline void de9im_match(const char* matrix, const char* pattern) {
  std::printf("de9im_match f64 | %s | %s", matrix, pattern);
  result(vesica_de9im_match(matrix, pattern));
  end();
}

template <class T>
void intersection(const Array<T>& a, const Array<T>& b) {
  typename Structs<T>::Point vertices[8];
  begin<T>("intersection"), argument(a), argument(b);
  const auto code = static_cast<int>(call::intersection(T{}, a.kind, a.data(), b.kind, b.data(), vertices, 8));
  result(code);
  for (int i = 0; i < code; ++i) values(std::vector<T>{vertices[i].x, vertices[i].y});
  end();
}

template <class T>
void soft(const Array<T>& boxes, const std::vector<T>& scores, int decay, T parameter, T least, int most,
          const std::vector<std::int32_t>& labels) {
  std::vector<std::int64_t> keep(boxes.count());
  std::vector<T> decayed(boxes.count());
  Lines scratch(vesica_suppress_soft_scratch(std::int64_t(boxes.count())));
  const auto view = boxes.view();
  std::int64_t kept = 0;
  begin<T>("suppress_soft"), argument(boxes), numbers_argument(scores);
  numbers_argument(std::vector<double>{double(VESICA_RATIO_OVER_UNION), double(decay), double(parameter), double(least),
                                       double(most)});
  if (!labels.empty()) numbers_argument(labels);
  result(call::suppress_soft(T{}, &view, scores.data(), labels.empty() ? nullptr : labels.data(),
                             VESICA_RATIO_OVER_UNION, decay, parameter, least, std::int64_t{most}, scratch.data(),
                             scratch.size(), keep.data(), decayed.data(), &kept));
  keep.resize(static_cast<std::size_t>(kept)), decayed.resize(keep.size());
  values(keep), values(decayed), end();
}

template <class T>
void topology() {
  all_within<T>();
  signed_distances<T>();
  const auto rect = sample<T>(VESICA_RECT, 0, 0), box = sample<T>(VESICA_AABB, 1, 0.25);
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) de9im(rect, sample<T>(kind, 0.5, 0));
  de9im(box, box);
  de9im(rect, invalid<T>(VESICA_CIRCLE));
  intersection(rect, box);
  intersection(box, box);
  intersection(rect, sample<T>(VESICA_AABB, 40, 0));
  intersection(sample<T>(VESICA_SEGMENT, 0, 0), sample<T>(VESICA_ELLIPSE, 0.25, 0));
  intersection(rect, sample<T>(VESICA_CIRCLE, 0, 0));
  const auto rects = series<T>(VESICA_RECT, 5);
  const std::vector<T> scores{T(0.5), T(0.25), T(0.75), T(0.875), T(0.625)};
  soft(rects, scores, VESICA_DECAY_LINEAR, T(0.25), T(0.125), 5, {});
  soft(rects, scores, VESICA_DECAY_GAUSSIAN, T(0.5), T(0), 3, {1, 2, 1, 2, 1});
  soft(with_invalid(rects), scores, VESICA_DECAY_LINEAR, T(0.25), T(0), 5, {});
  soft(rects, scores, VESICA_DECAY_LINEAR, T(2), T(0), 5, {});
}

inline void matches() {
  de9im_match("FF2F11212", "FF*FT****");
  de9im_match("212101212", "T*F**F***");
  de9im_match("2FF1FF212", "T*F**F***");
  de9im_match("FF2F11212", "T*F**F**");
}
