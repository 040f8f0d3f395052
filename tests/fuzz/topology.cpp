// SPDX-License-Identifier: Apache-2.0
// Calls of within, DE-9IM, intersection and impact time, for single shapes and arrays.
#include <algorithm>
#include <iterator>

#include "fuzz/arrays.hpp"

namespace fuzz {
namespace topology {
namespace {

bool is_error(std::int64_t code) { return code < 0 && code >= VESICA_E_RANGE; }

template <class T>
void call_within(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const T distance = bytes.below(8) == 0 ? T{0} : bytes.number<T>();
  const std::int32_t code = Face<T>::within(a.kind(), a.numbers(), b.kind(), b.numbers(), distance);
  demand(is_error(code) || (code >= VESICA_WITHIN_NO && code <= VESICA_WITHIN_NEARLY));
  if (code >= 0 && distance == 0) demand(code == Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()));
}

template <class T>
void call_signed_distance(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const Output<T> out(memory.out, bytes.below(128) == 127);
  const std::int32_t code = Face<T>::signed_distance(a.kind(), a.numbers(), b.kind(), b.numbers(), out.get());
  demand(code == 0 || (is_error(code) && out.untouched()));
  if (code == 0) demand(*out.get() <= 0 || Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()) == 0);
}

template <class T>
void call_de9im(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  char* matrix = room<char>(memory.out, VESICA_DE9IM_SIZE);
  const std::int32_t code = Face<T>::de9im(a.kind(), a.numbers(), b.kind(), b.numbers(), matrix);
  demand(code == 0 || is_error(code));
  if (code != 0) return;
  const bool apart = vesica_de9im_match(matrix, "FF*FF****") == 1;
  demand(vesica_de9im_match(matrix, "*********") == 1 && vesica_de9im_match(matrix, "12") == VESICA_E_ARGUMENT);
  demand(apart == (Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()) == 0));
}

template <class T>
void call_intersection(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const std::int64_t capacity = bytes.below(10);
  auto* vertices = room<typename Face<T>::Point>(memory.out, static_cast<std::size_t>(capacity));
  const std::int64_t count =
      Face<T>::intersection_in_room(a.kind(), a.numbers(), b.kind(), b.numbers(), vertices, capacity);
  demand(count < 0 ? is_error(static_cast<std::int32_t>(count)) : count <= 8);
  if (count >= 0) demand((count > 0) == (Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()) == 1));
}

template <class T>
void call_impact_time(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  typename Face<T>::Turn turn[2];
  for (auto& t : turn) t = {bytes.number<T>(), bytes.number<T>(), bytes.number<T>()};
  const Output<typename Face<T>::Impact> out(memory.out, bytes.below(128) == 127);
  T gap = -7;
  const std::int32_t code = Face<T>::impact_time(a.kind(), a.numbers(), &turn[0], b.kind(), b.numbers(), &turn[1],
                                                 bytes.number<T>(), out.get(), &gap);
  demand(is_error(code) || (code >= VESICA_CAST_MISS && code <= VESICA_CAST_NEAR));
  if (code < 0) return demand(out.untouched() && gap == -7);
  if (code == VESICA_CAST_START) {
    demand(out.get()->t == 0 && Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()) == 1);
  }
}

template <class T>
void call_manifold(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const Output<typename Face<T>::Contacts> out(memory.out, bytes.below(128) == 127);
  const std::int32_t code = Face<T>::manifold(a.kind(), a.numbers(), b.kind(), b.numbers(), out.get());
  demand(is_error(code) || (code >= 0 && code <= 2));
  if (code < 0) return demand(out.untouched());
  demand((code > 0) == (Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers()) == 1));
  demand(out.get()->count == code && out.get()->depth0 >= 0 && out.get()->depth1 >= 0);
}

template <class T>
void call_arrays(Bytes& bytes, Memory& memory) {
  const std::int64_t count_a = bytes.below(most), count_b = bytes.below(most);
  const auto a = array<T>(bytes, memory.a, count_a);
  const auto b = array<T>(bytes, memory.b, count_b);
  const std::ptrdiff_t row = count_b + bytes.below(5), size = count_a == 0 ? 0 : (count_a - 1) * row + count_b;
  const std::int64_t n = count_a == 0 || count_b == 0 ? 0 : std::max(count_a, count_b);
  const T distance = bytes.number<T>();
  std::int64_t found = 0;
  switch (bytes.below(4)) {
    case 0:
      found = Face<T>::within_many(&a, &b, distance, room<std::uint8_t>(memory.out, n));
      break;
    case 1:
      found = Face<T>::within_matrix(&a, &b, distance, room<std::uint8_t>(memory.out, size), row);
      break;
    case 2:
      found = Face<T>::signed_distance_many(&a, &b, room<T>(memory.out, n));
      break;
    default:
      found = Face<T>::signed_distance_matrix(&a, &b, room<T>(memory.out, size), row);
      break;
  }
  demand(is_error(found) || (found >= 0 && found <= std::max(n, count_a * count_b)));
}

template <class T>
void call_soft_suppression(Bytes& bytes, Memory& memory) {
  static GuardedMemory scratch_memory(1 << 20), decayed_memory;
  const std::int64_t count = bytes.below(most), limit = bytes.below(most), room_kept = limit < count ? limit : count;
  const auto shapes = array<T>(bytes, memory.a, count);
  T* scores = room<T>(memory.b, count);
  for (std::int64_t i = 0; i < count; ++i) scores[i] = bytes.number<T>();
  const std::int64_t scratch_size =
      std::max<std::int64_t>(vesica_suppress_soft_scratch(count) - (bytes.below(16) == 15), 0);
  std::byte* scratch = scratch_memory.place(static_cast<std::size_t>(scratch_size), Edge::after);
  std::int64_t kept = -7;
  auto* keep = room<std::int64_t>(memory.out, room_kept);
  const std::int32_t ratio = static_cast<std::int32_t>(bytes.below(9)) - 1, decay = bytes.below(4) - 1;
  const std::int32_t error =
      Face<T>::suppress_soft(&shapes, scores, nullptr, ratio, decay, bytes.number<T>(), bytes.number<T>(), limit,
                             scratch, scratch_size, keep, room<T>(decayed_memory, room_kept), &kept);
  demand(error == 0 || is_error(error));
  if (error == 0) demand(kept >= 0 && kept <= room_kept);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  constexpr void (*calls[])(Bytes&, Memory&) = {call_within<T>,       call_signed_distance<T>, call_de9im<T>,
                                                call_intersection<T>, call_impact_time<T>,     call_manifold<T>,
                                                call_arrays<T>,       call_soft_suppression<T>};
  calls[bytes.below(static_cast<unsigned>(std::size(calls)))](bytes, memory);
}

}  // namespace
}  // namespace topology

void call_topology(Bytes& bytes, Memory& memory) {
  if (bytes.below(2) == 0) {
    topology::call<double>(bytes, memory);
  } else {
    topology::call<float>(bytes, memory);
  }
}

}  // namespace fuzz
