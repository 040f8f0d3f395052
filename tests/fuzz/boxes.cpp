// SPDX-License-Identifier: Apache-2.0
// Arrays of boxes: rectangles and ellipses from their rows and back, corners and bounds.
#include "fuzz/arrays.hpp"

namespace fuzz {
namespace boxes {
namespace {

constexpr int angles = 9;  // more than there are units

bool is_answer(std::int64_t code) { return code <= 0 && code >= VESICA_E_RANGE; }

/// Each element is either a valid shape or NaN throughout, and there is an error if one is NaN.
template <class T, class Made>
void demand_made(std::int64_t code, std::int32_t kind, const Made* made, std::int64_t count) {
  demand(is_answer(code));
  if (code != 0 && code != VESICA_E_SHAPE && code != VESICA_E_RANGE) return;
  bool all = true;
  for (std::int64_t i = 0; i < count; ++i) {
    const T* numbers = &made[i].cx;
    if (Face<T>::check(kind, numbers) == 0) continue;
    all = false;
    for (std::size_t k = 0; k < sizeof(Made) / sizeof(T); ++k) demand(std::isnan(numbers[k]));
  }
  demand(all == (code == 0));
}

/// Some rows of numbers at an edge of memory, `apart` bytes from one to the next.
template <class T>
const T* numbers_in_rows(Bytes& bytes, GuardedMemory& memory, std::int64_t count, std::size_t width,
                         std::size_t apart) {
  const std::size_t size = count == 0 ? 0 : static_cast<std::size_t>(count - 1) * apart + width * sizeof(T);
  std::byte* const rows = memory.place(size, bytes.below(2) == 0 ? Edge::before : Edge::after);
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < width; ++k) {
      const T number = bytes.number<T>();
      std::memcpy(rows + static_cast<std::size_t>(i) * apart + k * sizeof(T), &number, sizeof number);
    }
  }
  return reinterpret_cast<const T*>(rows);
}

template <class T>
void call_from_corners(Bytes& bytes, Memory& memory) {
  using F = Face<T>;
  const std::int64_t count = bytes.below(most);
  const std::size_t apart = 8 * sizeof(T) + bytes.below(9);
  const T* const corners = numbers_in_rows<T>(bytes, memory.b, count, 8, apart);
  const auto stride = static_cast<std::ptrdiff_t>(apart);
  auto* const out = room<typename F::Rect>(memory.out, count);
  demand_made<T>(F::rects_from_corners(corners, count, stride, out), VESICA_RECT, out, count);
  const auto shapes = array<T>(bytes, memory.a, count);
  demand(is_answer(F::rect_corners_misfit_many(corners, stride, &shapes, room<T>(memory.out, count))));
}

template <class T, class Made>
void call_from_boxes(Bytes& bytes, Memory& memory, std::int32_t kind,
                     std::int64_t (*function)(const T*, std::int64_t, std::ptrdiff_t, std::int32_t, Made*)) {
  const std::int64_t count = bytes.below(most);
  const std::size_t apart = 5 * sizeof(T) + bytes.below(9);
  const T* const boxes = numbers_in_rows<T>(bytes, memory.a, count, 5, apart);
  Made* out = room<Made>(memory.out, count);
  const auto angle = static_cast<std::int32_t>(bytes.below(angles)) - 1;
  const std::int64_t code = function(boxes, count, static_cast<std::ptrdiff_t>(apart), angle, out);
  demand_made<T>(code, kind, out, count);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  using F = Face<T>;
  const unsigned which = bytes.below(6);
  if (which == 5) return call_from_corners<T>(bytes, memory);
  if (which == 0) return call_from_boxes<T>(bytes, memory, VESICA_RECT, F::rects_from_boxes);
  if (which == 1) return call_from_boxes<T>(bytes, memory, VESICA_ELLIPSE, F::ellipses_from_boxes);
  const std::int64_t count = bytes.below(most);
  const auto shapes = array<T>(bytes, memory.a, count);
  const auto angle = static_cast<std::int32_t>(bytes.below(angles)) - 1;
  switch (which) {
    case 2:
      return demand(is_answer(F::boxes_from_shapes(&shapes, angle, room<T>(memory.out, 5 * count))));
    case 3:
      return demand(is_answer(F::corners_of_shapes(&shapes, room<T>(memory.out, 8 * count))));
    default:
      demand(is_answer(F::shape_area_many(&shapes, room<T>(memory.out, count))));
      return demand(is_answer(F::bounds_many(&shapes, room<typename F::Aabb>(memory.out, count))));
  }
}

}  // namespace
}  // namespace boxes

void call_boxes(Bytes& bytes, Memory& memory) {
  if (bytes.below(2) == 0) {
    boxes::call<double>(bytes, memory);
  } else {
    boxes::call<float>(bytes, memory);
  }
}

}  // namespace fuzz
