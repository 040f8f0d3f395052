// SPDX-License-Identifier: Apache-2.0
/// Greedy non-maximum suppression: of shapes with scores, in the order of their scores, each is kept unless its iou()
/// with one kept before exceeds a threshold.
///
/// What a kept shape suppresses is marked at once. Only shapes whose bounds meet its own are compared with it. All
/// shapes are sorted by the left side of their bounds, so a binary search finds them.
#pragma once

#include <cstdint>
#include <vesica/iou.hpp>

namespace vesica {

namespace suppression {

/// Sides of a box that surely contains a shape; infinite where they overflow.
struct Bounds {
  double min_x, max_x, min_y, max_y;
};

/// A shape with its place in the order of scores, or -1 when it is kept, suppressed or left out.
struct Entry {
  Bounds bounds;
  std::int64_t index, rank;
};

/// c - extent and c + extent with room for what is rounded.
inline void interval(double c, double extent, double& low, double& high) noexcept {
  const double room = extent * (1 + 0x1p-49) + (std::fabs(c) * 0x1p-51 + 0x1p-1070);
  low = c - room;
  high = c + room;
}

inline Bounds bounds_about(double cx, double cy, double ux, double uy, double size_0, double size_1) noexcept {
  const double x = std::fabs(ux), y = std::fabs(uy);
  Bounds b;
  interval(cx, x * size_0 + y * size_1, b.min_x, b.max_x);
  interval(cy, y * size_0 + x * size_1, b.min_y, b.max_y);
  return b;
}
inline Bounds bounds(const Aabb<double>& s) noexcept { return {s.min_x, s.max_x, s.min_y, s.max_y}; }
inline Bounds bounds(const Circle<double>& s) noexcept { return bounds_about(s.cx, s.cy, 1, 0, s.r, s.r); }
inline Bounds bounds(const Rect<double>& s) noexcept { return bounds_about(s.cx, s.cy, s.ux, s.uy, s.hx, s.hy); }
inline Bounds bounds(const Ellipse<double>& s) noexcept { return bounds_about(s.cx, s.cy, s.ux, s.uy, s.a, s.b); }

/// Heap sort: in place, and n log n whatever the order; `before` must be a strict order without equals.
template <class T, class Before>
void sort(T* item, std::int64_t count, const Before& before) noexcept {
  const auto sink = [&](std::int64_t hole, std::int64_t end, T moving) {
    for (std::int64_t child = 2 * hole + 1; child < end; child = 2 * hole + 1) {
      if (child + 1 < end && before(item[child], item[child + 1])) ++child;
      if (!before(moving, item[child])) break;
      item[hole] = item[child];
      hole = child;
    }
    item[hole] = moving;
  };
  for (std::int64_t i = count / 2; i-- > 0;) sink(i, count, item[i]);
  for (std::int64_t end = count; end-- > 1;) {
    const T last = item[end];
    item[end] = item[0];
    sink(0, end, last);
  }
}

/// The first of the entries, sorted by min_x, whose min_x is at least x.
inline std::int64_t first_from(const Entry* entry, std::int64_t count, double x) noexcept {
  std::int64_t low = 0, high = count;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (entry[middle].bounds.min_x < x) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

inline bool meet(const Bounds& a, const Bounds& b) noexcept {
  return a.min_x <= b.max_x && b.min_x <= a.max_x && a.min_y <= b.max_y && b.min_y <= a.max_y;
}

inline constexpr std::int64_t bytes_each = sizeof(Entry) + sizeof(std::int64_t);
inline constexpr std::int64_t alignment = alignof(Entry);

}  // namespace suppression

/// Bytes of scratch nms() needs, wherever it is aligned; error_argument for a negative count or one too great.
constexpr std::int64_t nms_scratch(std::int64_t count) noexcept {
  constexpr std::int64_t most = (INT64_MAX - suppression::alignment) / suppression::bytes_each;
  if (count < 0 || count > most) return error_argument;
  return count * suppression::bytes_each + suppression::alignment;
}

/// Writes the indices of what is kept, in the order of scores, to keep, which needs room for `count`, and how many to
/// kept. shape_at(i): the shape i; score_at(i): its score. Equal scores go by index. Invalid
/// shapes and those whose score is NaN are left out; if there are any, error_shape is returned, else 0.
/// scratch: nms_scratch(count) bytes.
template <class Real, class ShapeAt, class ScoreAt>
std::int32_t nms(std::int64_t count, const ShapeAt& shape_at, const ScoreAt& score_at, Real threshold, void* scratch,
                 std::int64_t* keep, std::int64_t& kept) noexcept {
  using suppression::Entry;
  const auto address = reinterpret_cast<std::uintptr_t>(scratch);
  const auto misplaced = static_cast<std::int64_t>(address % suppression::alignment);
  char* const aligned = static_cast<char*>(scratch) + (misplaced == 0 ? 0 : suppression::alignment - misplaced);
  Entry* const entry = reinterpret_cast<Entry*>(aligned);
  std::int64_t* const order = reinterpret_cast<std::int64_t*>(entry + count);

  std::int64_t valid = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    if (check(shape_at(i)) == 0 && score_at(i) == score_at(i)) order[valid++] = i;
  }
  suppression::sort(order, valid, [&](std::int64_t i, std::int64_t j) {
    return score_at(i) > score_at(j) || (score_at(i) == score_at(j) && i < j);
  });
  double widest = 0;
  for (std::int64_t rank = 0; rank < valid; ++rank) {
    const std::int64_t i = order[rank];
    entry[rank] = {suppression::bounds(widen(shape_at(i))), i, rank};
    widest = std::fmax(widest, entry[rank].bounds.max_x - entry[rank].bounds.min_x);
  }
  suppression::sort(entry, valid, [](const Entry& a, const Entry& b) {
    return a.bounds.min_x < b.bounds.min_x || (a.bounds.min_x == b.bounds.min_x && a.rank < b.rank);
  });
  for (std::int64_t place = 0; place < valid; ++place) order[entry[place].rank] = place;

  std::int64_t found = 0;
  for (std::int64_t rank = 0; rank < valid; ++rank) {
    Entry& best = entry[order[rank]];
    if (best.rank < 0) continue;
    best.rank = -1;
    keep[found++] = best.index;
    const auto shape = shape_at(best.index);
    // Rounded down, so that the widest itself is not missed.
    const double from = (best.bounds.min_x - widest) - std::fabs(best.bounds.min_x) * 0x1p-50 - widest * 0x1p-50;
    for (std::int64_t k = suppression::first_from(entry, valid, from); k < valid; ++k) {
      Entry& other = entry[k];
      if (other.bounds.min_x > best.bounds.max_x) break;
      if (other.rank < 0 || !suppression::meet(best.bounds, other.bounds)) continue;
      Real ratio = 0;
      iou_or_error(shape, shape_at(other.index), ratio);
      if (ratio > threshold) other.rank = -1;
    }
  }
  kept = found;
  return valid == count ? 0 : error_shape;
}

}  // namespace vesica
