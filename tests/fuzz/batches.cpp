// SPDX-License-Identifier: Apache-2.0
#include "capi/face.hpp"
#include "fuzz/bytes.hpp"

namespace fuzz {
namespace {

constexpr std::int64_t most = 40;

using capi_tests::Face;

/// Records of a kind, packed or not, at any byte, forwards or backwards; or one shape repeated.
template <class T>
typename Face<T>::Shapes array(Bytes& bytes, GuardedMemory& memory, std::int64_t count) {
  typename Face<T>::Shapes shapes{};
  shapes.kind = bytes.kind();
  shapes.count = count;
  shapes.reserved = bytes.below(128) == 127;
  const std::int32_t known = vesica_field_count(shapes.kind);
  const std::size_t fields = known < 0 ? 0 : static_cast<std::size_t>(known);
  const bool repeated = bytes.below(8) == 7, backward = bytes.below(4) == 3;
  const std::size_t element = fields * sizeof(T) + bytes.below(9),
                    stored = repeated ? 1 : static_cast<std::size_t>(count);
  const std::size_t size = stored * element;
  std::byte* begin = memory.place(size, bytes.below(2) == 0 ? Edge::before : Edge::after);
  for (std::size_t i = 0; i < stored; ++i) {
    for (std::size_t k = 0; k < fields; ++k) {
      const T number = bytes.number<T>();
      std::memcpy(begin + i * element + k * sizeof(T), &number, sizeof number);
    }
  }
  const std::size_t first = backward && stored > 0 ? (stored - 1) * element : 0;
  shapes.stride = repeated ? 0 : static_cast<std::ptrdiff_t>(element) * (backward ? -1 : 1);
  for (std::size_t k = 0; k < fields; ++k) shapes.field[k] = reinterpret_cast<const T*>(begin + first + k * sizeof(T));
  return shapes;
}

/// As many numbers as fit, in pieces for columns.
template <class Out>
Out* room(GuardedMemory& memory, std::int64_t count) {
  return reinterpret_cast<Out*>(memory.place(static_cast<std::size_t>(count) * sizeof(Out), Edge::after));
}

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
    default:
      return F::ratio_many(static_cast<std::int32_t>(which) - 8, &a, &b, room<T>(memory, n));
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
    default:
      return F::ratio_matrix(static_cast<std::int32_t>(which) - 8, &a, &b, room<T>(memory, size), row);
  }
}

template <class T>
void call_nms(Bytes& bytes, Memory& memory) {
  const std::int64_t count = bytes.below(most);
  const auto shapes = array<T>(bytes, memory.a, count);
  T* scores = room<T>(memory.b, count);
  for (std::int64_t i = 0; i < count; ++i) scores[i] = bytes.number<T>();
  const std::int64_t scratch_size = vesica_nms_scratch(count) - (bytes.below(16) == 15);
  std::byte scratch[64 * (most + 1)];
  demand(scratch_size <= static_cast<std::int64_t>(sizeof scratch));
  std::int64_t kept = -7;
  auto* keep = room<std::int64_t>(memory.out, count);
  const std::int32_t error = Face<T>::nms(&shapes, scores, bytes.number<T>(), scratch, scratch_size, keep, &kept);
  demand(error <= 0 && (error != 0 || (kept >= 0 && kept <= count)));
  for (std::int64_t i = 0; i < kept; ++i) demand(keep[i] >= 0 && keep[i] < count);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  constexpr unsigned first_matrix = 16, from_records = 29, select = 30, nms = 31;
  const unsigned which = bytes.below(32);
  if (which == nms) return call_nms<T>(bytes, memory);
  const std::int64_t count_a = bytes.below(most);
  std::int64_t count_b = bytes.below(4) == 3 ? 1 : count_a;
  if (which >= first_matrix) count_b = bytes.below(most);
  const auto a = array<T>(bytes, memory.a, which == select ? 1 : count_a);
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
    demand(Face<T>::overlap_select(&a, &b, room<std::int64_t>(memory.out, capacity), capacity) <= count_b);
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
