// SPDX-License-Identifier: Apache-2.0
/// All pairs by the scalar functions: what a join must find. A sweep over exact bounds leaves out what cannot be a
/// pair, by plain comparisons of vesica_bounds' boxes and none of the index's own.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "index/face.hpp"

namespace index_tests {

template <class T>
struct Item {
  std::int32_t kind;
  const T* numbers;
  double min_x, min_y, max_x, max_y;
  std::int64_t number;
};

inline int bounds_of(std::int32_t kind, const double* numbers, vesica_aabb_f64* out) {
  return vesica_bounds_f64(kind, numbers, out);
}

/// Every valid item with its bounds as doubles; infinite where they overflow.
template <class T>
std::vector<Item<T>> items_of(const Laid<T>& laid) {
  constexpr int fields[] = {2, 4, 3, 4, 6, 6};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Item<T>> items;
  std::int64_t number = 0;
  for (const Records<T>& r : laid) {
    for (std::int64_t i = 0; i < r.count(); ++i, ++number) {
      const T* const numbers = r.numbers.data() + i * fields[r.kind];
      double wide[6] = {};
      for (int k = 0; k < fields[r.kind]; ++k) wide[k] = static_cast<double>(numbers[k]);
      vesica_aabb_f64 box;
      const int error = bounds_of(r.kind, wide, &box);
      if (error == VESICA_E_SHAPE) continue;
      if (error != 0) box = {-infinity, -infinity, infinity, infinity};
      items.push_back({r.kind, numbers, box.min_x, box.min_y, box.max_x, box.max_y, number});
    }
  }
  return items;
}

/// Items of like widths, by their left ends: a sweep need not go back further than the widest reaches.
template <class T>
struct Row {
  std::vector<Item<T>> items;
  double widest = 0;
};

/// Rows by width, four times as wide from one to the next; of widths that are infinite or 0, a row each.
template <class T>
std::vector<Row<T>> rows_of(const std::vector<Item<T>>& items) {
  std::map<int, Row<T>> rows;
  for (const Item<T>& item : items) {
    const double width = item.max_x - item.min_x;
    Row<T>& row = rows[std::isfinite(width) && width > 0 ? std::ilogb(width) / 2 : std::isfinite(width) ? -9999 : 9999];
    row.items.push_back(item);
    row.widest = std::max(row.widest, width);
  }
  std::vector<Row<T>> all;
  for (auto& [level, row] : rows) {
    std::sort(row.items.begin(), row.items.end(), [](const Item<T>& a, const Item<T>& b) { return a.min_x < b.min_x; });
    all.push_back(std::move(row));
  }
  return all;
}

/// Sweeps go along the longer side of everything: x and y change places where that is y.
template <class T>
bool taller_than_wide(const std::vector<Item<T>>& items) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const Item<T>& item : items) {
    low[0] = std::min(low[0], item.min_x);
    low[1] = std::min(low[1], item.min_y);
    high[0] = std::max(high[0], item.min_x);
    high[1] = std::max(high[1], item.min_y);
  }
  return high[1] - low[1] > high[0] - low[0];
}

template <class T>
void turn(std::vector<Item<T>>& items) {
  for (Item<T>& item : items) {
    std::swap(item.min_x, item.min_y);
    std::swap(item.max_x, item.max_y);
  }
}

/// Calls `found` for the items of a row whose bounds meet those of x.
template <class T, class Found>
void sweep(const Row<T>& row, const Item<T>& x, Found found) {
  const double from = x.min_x - row.widest - (std::fabs(x.min_x) + row.widest) * 1e-14;
  // With infinite bounds the place to begin is not a number.
  auto y = std::isnan(from) ? row.items.begin()
                            : std::lower_bound(row.items.begin(), row.items.end(), from,
                                               [](const Item<T>& i, double v) { return i.min_x < v; });
  for (; y != row.items.end() && y->min_x <= x.max_x; ++y) {
    if (y->max_x >= x.min_x && y->max_y >= x.min_y && y->min_y <= x.max_y) found(*y);
  }
}

/// Pairs (a, b) for which `holds(a, b)`, in order; of one set, those with a < b.
template <class T, class Holds>
std::vector<Pair> all_pairs(const Laid<T>& laid_a, const Laid<T>& laid_b, bool self, Holds holds) {
  std::vector<Item<T>> a = items_of(laid_a), b = items_of(laid_b);
  if (taller_than_wide(b)) {
    turn(a);
    turn(b);
  }
  const std::vector<Row<T>> rows = rows_of(b);
  std::vector<Pair> pairs;
  for (const Item<T>& x : a) {
    for (const Row<T>& row : rows) {
      sweep(row, x, [&](const Item<T>& y) {
        if (self && x.number >= y.number) return;
        if (holds(x, y)) pairs.emplace_back(x.number, y.number);
      });
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class T>
bool overlaps(const Item<T>& a, const Item<T>& b) {
  return Face<T>::overlap(a.kind, a.numbers, b.kind, b.numbers) == 1;
}
template <class T>
bool contains(const Item<T>& a, const Item<T>& b) {
  return Face<T>::contains(a.kind, a.numbers, b.kind, b.numbers) == 1;
}

template <class T>
bool interiors_overlap(const Item<T>& a, const Item<T>& b) {
  return Face<T>::interiors_overlap(a.kind, a.numbers, b.kind, b.numbers) == 1;
}

/// In order, for comparing as sets.
inline std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace index_tests
