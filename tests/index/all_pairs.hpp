// SPDX-License-Identifier: Apache-2.0
/// All pairs by the scalar functions: what a join must find. A sweep over exact bounds leaves out what cannot be a pair,
/// by plain comparisons of vesica_bounds' boxes and none of the index's own.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
  std::sort(items.begin(), items.end(), [](const Item<T>& a, const Item<T>& b) { return a.min_x < b.min_x; });
  return items;
}

/// Pairs (a, b) for which `holds(a, b)`, in order; of one set, those with a < b.
template <class T, class Holds>
std::vector<Pair> all_pairs(const Laid<T>& laid_a, const Laid<T>& laid_b, bool self, Holds holds) {
  const std::vector<Item<T>> a = items_of(laid_a), b = items_of(laid_b);
  double widest = 0;
  for (const Item<T>& y : b) widest = std::max(widest, y.max_x - y.min_x);
  std::vector<Pair> pairs;
  for (const Item<T>& x : a) {
    const double from = x.min_x - widest - (std::fabs(x.min_x) + widest) * 1e-14;
    auto y = std::lower_bound(b.begin(), b.end(), from, [](const Item<T>& i, double v) { return i.min_x < v; });
    for (; y != b.end() && y->min_x <= x.max_x; ++y) {
      if (y->max_x < x.min_x || y->max_y < x.min_y || y->min_y > x.max_y) continue;
      if (self && x.number >= y->number) continue;
      if (holds(x, *y)) pairs.emplace_back(x.number, y->number);
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

/// In order, for comparing as sets.
inline std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace index_tests
