// SPDX-License-Identifier: Apache-2.0
// The boxes of items: from their numbers by a kernel, or from the vertices of polygons and polylines.
#pragma once

#include <vesica/polygon/edges.hpp>

#include "index/kernels.hpp"

namespace vesica::index {

template <class T>
void find_path_boxes(const Set& set, std::int64_t begin, const std::uint32_t* list, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const Polygon<T> path = path_at<T>(set.paths(), list == nullptr ? begin + i : list[i] - set.first);
    detail::polygon::Box box = detail::polygon::no_box;
    out.valid[i] = detail::polygon::Edges<T>(path).check(box) == 0;
    out.min_x[i] = box.min_x;
    out.min_y[i] = box.min_y;
    out.max_x[i] = box.max_x;
    out.max_y[i] = box.max_y;
  }
}

/// The boxes of n shapes of a set, at most `chunk`: from its element `begin` on, or those of the items that are listed.
inline void find_boxes(const Kernels& kernels, const Sets& sets, const Set& set, std::int64_t begin,
                       const std::uint32_t* list, int n, Boxes& out) noexcept {
  if (!is_row(set.kind)) {
    return sets.is_float ? find_path_boxes<float>(set, begin, list, n, out)
                         : find_path_boxes<double>(set, begin, list, n, out);
  }
  Fields fields;
  if (list == nullptr) {
    load(sets, set, begin, n, fields);
  } else {
    gather(sets, set, list, n, fields);
  }
  kernels.bounds(set.kind, fields, n, out);
}

}  // namespace vesica::index
