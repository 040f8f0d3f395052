// SPDX-License-Identifier: Apache-2.0
// Boxes about a path's edges that the caller keeps, and the questions that read them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vesica/polygon/boxes.hpp>
#include <vesica/polygon/edges.hpp>

#include "by_kind.hpp"
#include "environment.hpp"
#include "polygon/answers.hpp"
#include "polygon/operand.hpp"
#include "vesica_index.h"

namespace {

using vesica::Operand;
using vesica::detail::polygon::Box, vesica::detail::polygon::Edges, vesica::detail::polygon::KeptBox;
using vesica::detail::polygon::KeptBoxes, vesica::detail::polygon::Range, vesica::detail::polygon::no_box;

constexpr std::int64_t edges_in_run = 16;

/// The first bytes. Boxes follow.
struct Header {
  char magic[8];
  std::int32_t kind, scalar_bytes;
  std::int64_t first, vertices;
  Box whole;
};
static_assert(sizeof(Header) == 64);

constexpr Header header_of(std::int32_t kind, std::int32_t scalar_bytes, const Range& all) noexcept {
  return {{'V', 'E', 'S', 'B', 'O', 'X', 'E', '1'}, kind, scalar_bytes, all.first, all.length(), no_box};
}

std::int64_t size_for(std::int64_t vertices) noexcept {
  return static_cast<std::int64_t>(sizeof(Header)) +
         KeptBoxes(0, vertices, edges_in_run).boxes() * static_cast<std::int64_t>(sizeof(KeptBox));
}

bool is_aligned(const void* p) noexcept { return reinterpret_cast<std::uintptr_t>(p) % alignof(Header) == 0; }

template <class T>
std::int32_t make_boxes(std::int32_t kind, const void* path, void* boxes, std::int64_t size) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(make_boxes<T>, kind, path, boxes, size);
  if (path == nullptr || boxes == nullptr) return VESICA_E_NULL;
  if (!vesica::has_vertices(kind)) return VESICA_E_KIND;
  const Edges<T> edges = vesica::polygon::edges<T>({kind, std::is_same_v<T, float>, path});
  Box whole;
  const int error = edges.check(whole);
  if (error != 0) return error == vesica::error_null ? VESICA_E_NULL : VESICA_E_SHAPE;
  const Range all = edges.all();
  if (!is_aligned(boxes) || size < size_for(all.length())) return VESICA_E_ARGUMENT;
  Header header = header_of(kind, sizeof(T), all);
  header.whole = whole;
  std::memcpy(boxes, &header, sizeof header);
  KeptBoxes(all.first, all.length(), edges_in_run)
      .make(edges, whole, reinterpret_cast<KeptBox*>(static_cast<std::byte*>(boxes) + sizeof header));
  return 0;
}

/// action(operand of the path with its boxes, operand of the other shape), or an error.
template <class T, class Action>
std::int32_t with_boxes(std::int32_t kind, const void* path, const void* boxes, std::int64_t size, std::int32_t kind_b,
                        const void* b, const Action& action) noexcept {
  if (path == nullptr || boxes == nullptr || b == nullptr) return VESICA_E_NULL;
  if (!vesica::has_vertices(kind) || !vesica::has_core_or_path(kind_b)) return VESICA_E_KIND;
  constexpr bool is_float = std::is_same_v<T, float>;
  const Edges<T> edges = vesica::polygon::edges<T>({kind, is_float, path});
  if (edges.has_null()) return VESICA_E_NULL;
  if (edges.rings() < 1 || !is_aligned(boxes) || size < static_cast<std::int64_t>(sizeof(Header)))
    return VESICA_E_INDEX;
  Header header;
  std::memcpy(&header, boxes, sizeof header);
  const Range all = edges.all();
  const Header wanted = header_of(kind, sizeof(T), all);
  if (std::memcmp(&header, &wanted, offsetof(Header, whole)) != 0 || header.vertices < 1 ||
      size < size_for(header.vertices)) {
    return VESICA_E_INDEX;
  }
  KeptBoxes kept(all.first, all.length(), edges_in_run);
  kept.use(reinterpret_cast<const KeptBox*>(static_cast<const std::byte*>(boxes) + sizeof header), header.whole);
  return action(Operand{kind, is_float, path, &kept}, Operand{kind_b, is_float, b});
}

template <class T>
std::int32_t overlap_by_boxes(std::int32_t kind, const void* path, const void* boxes, std::int64_t size,
                              std::int32_t kind_b, const void* b) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(overlap_by_boxes<T>, kind, path, boxes, size, kind_b, b);
  return with_boxes<T>(kind, path, boxes, size, kind_b, b, [](const Operand& whole, const Operand& other) {
    return vesica::polygon::overlap(whole, other, nullptr);
  });
}

template <class T, class Points>
std::int32_t nearest_by_boxes(std::int32_t kind, const void* path, const void* boxes, std::int64_t size,
                              std::int32_t kind_b, const void* b, Points* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((nearest_by_boxes<T, Points>), kind, path, boxes, size, kind_b, b, out);
  if (out == nullptr) return VESICA_E_NULL;
  return with_boxes<T>(kind, path, boxes, size, kind_b, b, [out](const Operand& whole, const Operand& other) {
    return vesica::polygon::nearest(whole, other, out);
  });
}

template <class T>
std::int32_t within_by_boxes(std::int32_t kind, const void* path, const void* boxes, std::int64_t size,
                             std::int32_t kind_b, const void* b, T distance) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(within_by_boxes<T>, kind, path, boxes, size, kind_b, b, distance);
  return with_boxes<T>(kind, path, boxes, size, kind_b, b, [distance](const Operand& whole, const Operand& other) {
    return vesica::polygon::within(whole, other, static_cast<double>(distance));
  });
}

}  // namespace

int64_t vesica_polygon_boxes_size(int64_t vertices) {
  // Larger ones have no room in memory, and would overflow here.
  return vertices < 1 || vertices > (int64_t{1} << 58) ? VESICA_E_ARGUMENT : size_for(vertices);
}

int32_t vesica_polygon_boxes_f64(int32_t kind, const void* path, void* boxes, int64_t size) {
  return make_boxes<double>(kind, path, boxes, size);
}
int32_t vesica_polygon_boxes_f32(int32_t kind, const void* path, void* boxes, int64_t size) {
  return make_boxes<float>(kind, path, boxes, size);
}
int32_t vesica_polygon_boxes_overlap_f64(int32_t kind, const void* path, const void* boxes, int64_t size,
                                         int32_t kind_b, const void* b) {
  return overlap_by_boxes<double>(kind, path, boxes, size, kind_b, b);
}
int32_t vesica_polygon_boxes_overlap_f32(int32_t kind, const void* path, const void* boxes, int64_t size,
                                         int32_t kind_b, const void* b) {
  return overlap_by_boxes<float>(kind, path, boxes, size, kind_b, b);
}
int32_t vesica_polygon_boxes_nearest_f64(int32_t kind, const void* path, const void* boxes, int64_t size,
                                         int32_t kind_b, const void* b, vesica_closest_points_f64* out) {
  return nearest_by_boxes<double>(kind, path, boxes, size, kind_b, b, out);
}
int32_t vesica_polygon_boxes_nearest_f32(int32_t kind, const void* path, const void* boxes, int64_t size,
                                         int32_t kind_b, const void* b, vesica_closest_points_f32* out) {
  return nearest_by_boxes<float>(kind, path, boxes, size, kind_b, b, out);
}
int32_t vesica_polygon_boxes_within_f64(int32_t kind, const void* path, const void* boxes, int64_t size, int32_t kind_b,
                                        const void* b, double distance) {
  return within_by_boxes<double>(kind, path, boxes, size, kind_b, b, distance);
}
int32_t vesica_polygon_boxes_within_f32(int32_t kind, const void* path, const void* boxes, int64_t size, int32_t kind_b,
                                        const void* b, float distance) {
  return within_by_boxes<float>(kind, path, boxes, size, kind_b, b, distance);
}
