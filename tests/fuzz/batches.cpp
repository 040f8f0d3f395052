// SPDX-License-Identifier: Apache-2.0
#include "fuzz/arrays.hpp"

namespace fuzz {
namespace {

template <class T, class Shapes>
std::int64_t many(unsigned which, const Shapes& a, const Shapes& b, std::int64_t n, GuardedMemory& memory) {
  using F = Face<T>;
  T* column = room<T>(memory, 5 * n);
  switch (which) {
    case 0:
      return F::overlap_many(&a, &b, room<std::uint8_t>(memory, n));
    case 1:
      return F::relation_many(&a, &b, room<std::uint8_t>(memory, n));
    case 2:
      return F::contains_many(&a, &b, room<std::uint8_t>(memory, n));
    case 3:
      return F::nearest_many(&a, &b, column, column + n, column + 2 * n, column + 3 * n, column + 4 * n);
    case 4:
      return F::boundary_distance_many(&a, &b, nullptr, column + n, nullptr, column + 3 * n, column + 4 * n);
    case 5:
      return F::depth_many(&a, &b, column, nullptr, column + 2 * n);
    case 6:
      return F::area_many(&a, &b, room<T>(memory, n));
    case 7:
      return F::iou_many(&a, &b, room<T>(memory, n));
    case 8:
      return F::interiors_overlap_many(&a, &b, room<std::uint8_t>(memory, n));
    default:
      return F::ratio_many(static_cast<std::int32_t>(which) - 9, &a, &b, room<T>(memory, n));
  }
}

template <class T, class Shapes>
std::int64_t matrix(unsigned which, const Shapes& a, const Shapes& b, std::ptrdiff_t gap, GuardedMemory& memory) {
  using F = Face<T>;
  const std::ptrdiff_t row = b.count + gap;
  const std::int64_t size = a.count == 0 || b.count == 0 ? 0 : (a.count - 1) * row + b.count;
  switch (which) {
    case 0:
      return F::overlap_matrix(&a, &b, room<std::uint8_t>(memory, size), row);
    case 1:
      return F::relation_matrix(&a, &b, room<std::uint8_t>(memory, size), row);
    case 2:
      return F::contains_matrix(&a, &b, room<std::uint8_t>(memory, size), row);
    case 3:
      return F::area_matrix(&a, &b, room<T>(memory, size), row);
    case 4:
      return F::iou_matrix(&a, &b, room<T>(memory, size), row);
    case 5:
      return F::nearest_matrix(&a, &b, room<T>(memory, size), row);
    case 6:
      return F::boundary_distance_matrix(&a, &b, room<T>(memory, size), row);
    case 7:
      return F::depth_matrix(&a, &b, room<T>(memory, size), row);
    case 8:
      return F::interiors_overlap_matrix(&a, &b, room<std::uint8_t>(memory, size), row);
    default:
      return F::ratio_matrix(static_cast<std::int32_t>(which) - 9, &a, &b, room<T>(memory, size), row);
  }
}

/// nms, or suppress with all that it takes besides.
template <class T>
void call_suppression(Bytes& bytes, Memory& memory) {
  const std::int64_t count = bytes.below(most);
  const auto shapes = array<T>(bytes, memory.a, count);
  auto* labels = bytes.below(2) == 0 ? nullptr : reinterpret_cast<std::int32_t*>(memory.b.place(0, Edge::before));
  for (std::int64_t i = 0; labels != nullptr && i < count; ++i) labels[i] = bytes.below(3);
  T* scores = room<T>(memory.b, count);
  for (std::int64_t i = 0; i < count; ++i) scores[i] = bytes.number<T>();
  const std::int64_t scratch_size = vesica_nms_scratch(count) - (bytes.below(16) == 15);
  static GuardedMemory room_of_scratch(1 << 20);
  std::byte* scratch = room_of_scratch.place(static_cast<std::size_t>(scratch_size), Edge::after);
  std::int64_t kept = -7;
  const bool any_ratio = bytes.below(2) == 1;
  const std::int64_t limit = any_ratio ? bytes.below(most) : count;
  auto* keep = room<std::int64_t>(memory.out, limit < count ? limit : count);
  const T threshold = bytes.number<T>();
  const std::int32_t ratio = static_cast<std::int32_t>(bytes.below(9)) - 1;
  const std::int32_t error = any_ratio ? Face<T>::suppress(&shapes, scores, labels, ratio, threshold, bytes.number<T>(),
                                                           limit, scratch, scratch_size, keep, &kept)
                                       : Face<T>::nms(&shapes, scores, threshold, scratch, scratch_size, keep, &kept);
  demand(error <= 0 && ((error != 0 && error != VESICA_E_SHAPE) || (kept >= 0 && kept <= limit && kept <= count)));
  for (std::int64_t i = 0; i < kept; ++i) demand(keep[i] >= 0 && keep[i] < count);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  constexpr unsigned first_matrix = 17, from_records = 31, select = 32, select_insides = 33, suppression = 34;
  const unsigned which = bytes.below(35);
  if (which == suppression) return call_suppression<T>(bytes, memory);
  const std::int64_t count_a = bytes.below(most);
  std::int64_t count_b = bytes.below(4) == 3 ? 1 : count_a;
  if (which >= first_matrix) count_b = bytes.below(most);
  const auto a = array<T>(bytes, memory.a, which == select || which == select_insides ? 1 : count_a);
  const auto b = array<T>(bytes, memory.b, count_b);
  if (which < first_matrix) {
    const std::int64_t n = count_a == 0 || count_b == 0 ? 0 : count_a;
    demand(many<T>(which, a, b, n, memory.out) <= n);
  } else if (which < from_records) {
    demand(matrix<T>(which - first_matrix, a, b, bytes.below(5), memory.out) <= count_a * count_b);
  } else if (which == from_records) {
    typename Face<T>::Shapes made{};
    demand(Face<T>::from_records(a.kind, a.count, a.field[0], a.stride, &made) <= 0);
  } else {
    const std::int64_t capacity = bytes.below(most);
    const auto select_some = which == select ? Face<T>::overlap_select : Face<T>::interiors_overlap_select;
    demand(select_some(&a, &b, room<std::int64_t>(memory.out, capacity), capacity) <= count_b);
  }
}

}  // namespace

void call_batch(Bytes& bytes, Memory& memory) {
  if (bytes.below(2) == 0) {
    call<double>(bytes, memory);
  } else {
    call<float>(bytes, memory);
  }
}

}  // namespace fuzz
