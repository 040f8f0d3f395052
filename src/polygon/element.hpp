// SPDX-License-Identifier: Apache-2.0
// An element of an array of polygons or polylines, as the struct of a single one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vesica/polygon.hpp>

namespace vesica {

/// The places of an array's vertices, as vesica_shapes_<T> says them.
struct PathArray {
  const std::byte *x, *y;
  std::ptrdiff_t stride;
  const std::int32_t *rings, *polygons;
  std::int64_t each;

  /// The array is of structs, stride bytes apart from x on.
  bool holds_structs() const noexcept { return rings == nullptr && each == 0; }
};

/// Element i. Its pointers need no alignment. Offsets that exceed the columns, if their length is known, make a polygon
/// without rings, which is invalid. A polyline's struct is the same.
template <class T>
Polygon<T> path_at(const PathArray& paths, std::int64_t i) noexcept {
  Polygon<T> path;
  if (paths.holds_structs()) {
    std::memcpy(&path, paths.x + i * paths.stride, sizeof path);
    return path;
  }
  const std::int64_t first_vertex = paths.rings == nullptr ? i * paths.each : 0;
  path.x = reinterpret_cast<const T*>(paths.x + first_vertex * paths.stride);
  path.y = reinterpret_cast<const T*>(paths.y + first_vertex * paths.stride);
  path.stride = paths.stride;
  path.rings = nullptr;
  path.count = paths.each;
  if (paths.rings == nullptr) return path;
  const std::int64_t first = paths.polygons == nullptr ? i : paths.polygons[i];
  const std::int64_t count = paths.polygons == nullptr ? 1 : paths.polygons[i + 1] - first;
  bool sound = first >= 0 && count > 0;
  for (std::int64_t j = first; sound && paths.each > 0 && j <= first + count; ++j) {
    sound = paths.rings[j] <= paths.each;
  }
  path.rings = sound ? paths.rings + first : paths.rings;
  path.count = sound ? count : 0;
  return path;
}

}  // namespace vesica
