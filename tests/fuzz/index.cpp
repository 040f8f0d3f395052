// SPDX-License-Identifier: Apache-2.0
// An index of two sets, built at once or in steps, perhaps damaged, and what is asked of it. What vesica_index_check
// passes is safe to read: nothing outside of it, and no item that is not there.
#include "fuzz/arrays.hpp"

namespace fuzz {
namespace index {
namespace {

constexpr std::size_t index_room = 1 << 20, unit = 64;

bool is_error(std::int64_t code) { return code < 0 && code >= VESICA_E_INDEX; }

/// Aligned memory that ends at the guard page, except for the padding of the last unit.
std::byte* aligned(GuardedMemory& memory, std::int64_t size) {
  return memory.place((static_cast<std::size_t>(size) + unit - 1) / unit * unit, Edge::after);
}

template <class T>
struct Sets {
  using Shapes = typename Face<T>::Shapes;
  Shapes set[2];
  std::int64_t items;

  Sets(Bytes& bytes, Memory& memory)
      : set{array<T>(bytes, memory.a, bytes.below(most)), array<T>(bytes, memory.b, bytes.below(most))},
        items(set[0].count + set[1].count) {}
};

/// The bytes of an index, or null where the sets make none.
template <class T>
std::byte* build(Bytes& bytes, const Sets<T>& sets, GuardedMemory& room_of_index, GuardedMemory& room_of_scratch) {
  const std::int64_t size = vesica_index_size(sets.items), scratch_size = vesica_index_scratch(sets.items);
  demand(size > 0 && scratch_size > 0);
  std::byte* index = aligned(room_of_index, size);
  std::byte* scratch = aligned(room_of_scratch, scratch_size);
  std::int64_t code = 0;
  if (bytes.below(2) == 0) {
    code = Face<T>::index_build(sets.set, 2, index, size, scratch, scratch_size);
  } else {
    for (std::int32_t step = 0; step < 5 && code >= 0; ++step) {
      const std::int64_t parts = step == 0 || step == 4 ? 1 : 1 + bytes.below(4);
      for (std::int64_t part = 0; part < parts && code >= 0; ++part) {
        code = Face<T>::index_step(step, part, parts, sets.set, 2, index, size, scratch, scratch_size);
        demand(step == 4 || code <= 0);
      }
    }
  }
  demand(code >= 0 || is_error(code));
  if (code < 0 && code != VESICA_E_SHAPE) return nullptr;
  const std::int64_t used = vesica_index_bytes(index);
  demand(used > 0 && used <= size && vesica_index_count(index) == sets.items);
  demand(vesica_index_check(index, used) == 0);
  return index;
}

/// A copy that ends at a guard page, with some bytes changed; null where it is found out.
std::byte* damaged(Bytes& bytes, const std::byte* index, GuardedMemory& memory) {
  std::int64_t size = vesica_index_bytes(index);
  std::byte* copy = aligned(memory, size);
  std::memcpy(copy, index, static_cast<std::size_t>(size));
  for (unsigned i = bytes.below(4); i > 0; --i) {
    const std::size_t place = bytes.below(2) == 0 ? bytes.below(192) : bytes.take<std::uint16_t>();
    if (place < static_cast<std::size_t>(size)) copy[place] ^= static_cast<std::byte>(bytes.take<std::uint8_t>());
  }
  const std::int32_t said = vesica_index_check(copy, size);
  demand(said == 0 || said == VESICA_E_INDEX);
  return said == 0 ? copy : nullptr;
}

/// Without room, the result is a number alone.
void demand_items(const std::int64_t* out, std::int64_t found, std::int64_t capacity, std::int64_t items) {
  demand(is_error(found) || (found >= 0 && found <= (capacity == 0 ? items : capacity)));
  for (std::int64_t i = 0; capacity > 0 && i < found; ++i) demand(out[i] >= 0 && out[i] < items);
}

template <class T>
void ask(Bytes& bytes, Memory& memory, const Sets<T>& sets, const std::byte* index) {
  using F = Face<T>;
  static GuardedMemory room_of_one, room_of_distance;
  const auto one = array<T>(bytes, room_of_one, 1);
  const std::int64_t capacity = bytes.below(most);
  auto* out = room<std::int64_t>(memory.out, capacity);
  std::int64_t state[4] = {};
  switch (bytes.below(6)) {
    case 0:
      do {
        const std::int64_t found = F::index_select(index, sets.set, 2, &one, out, capacity, state);
        demand_items(out, found, capacity, sets.items);
        if (found <= 0) break;
      } while (capacity > 0 && state[0] >= 0);
      return;
    case 1: {
      T* distance = room<T>(room_of_distance, capacity);
      const std::int64_t found = F::index_nearest(index, sets.set, 2, &one, capacity, bytes.number<T>(), out, distance);
      demand_items(out, found, capacity, sets.items);
      return;
    }
    case 2: {
      const T vx = bytes.number<T>(), vy = bytes.number<T>(), end = bytes.number<T>();
      const std::int64_t found = F::index_cast(index, sets.set, 2, &one, vx, vy, end, out, capacity, state);
      demand_items(out, found, capacity, sets.items);
      return;
    }
    case 3: {
      typename F::Impact impact;
      const T vx = bytes.number<T>(), vy = bytes.number<T>(), end = bytes.number<T>();
      const std::int64_t found = F::index_cast_first(index, sets.set, 2, &one, vx, vy, end, &impact);
      return demand(is_error(found) || (found >= 0 && found <= sets.items));
    }
    case 4: {
      vesica_aabb_f64 bounds;
      demand(vesica_index_bounds(index, &bounds) <= 0);
      const std::int64_t all = vesica_index_order(index, out, capacity);
      demand(all <= sets.items);
      return demand_items(out, all < capacity ? all : capacity, capacity, sets.items);
    }
    default: {
      const std::int64_t k = 1 + bytes.below(3), rows = one.count * k;
      auto* row = room<std::int64_t>(memory.out, rows);
      T* distance = room<T>(room_of_distance, rows);
      demand(F::join_nearest(&one, 1, index, sets.set, 2, k, bytes.number<T>(), 0, 1, row, distance) <= rows);
    }
  }
}

/// An index with itself: overlaps and the like, or at most so far apart.
template <class T>
void join(Bytes& bytes, Memory& memory, const Sets<T>& sets, const std::byte* index) {
  static GuardedMemory room_of_scratch(1 << 20), room_of_b;
  const std::int64_t capacity = 1 + bytes.below(most), scratch_size = vesica_join_scratch();
  auto *a = room<std::int64_t>(memory.out, capacity), *b = room<std::int64_t>(room_of_b, capacity);
  const std::int64_t parts = 1 + bytes.below(4), part = bytes.below(static_cast<unsigned>(parts));
  const std::int32_t query = static_cast<std::int32_t>(bytes.below(7)) - 1;
  const T distance = query == 5 ? bytes.number<T>() : T{0};
  std::int64_t state[4] = {}, found;
  do {
    found = query == 5 ? Face<T>::join_within(index, sets.set, 2, index, sets.set, 2, distance, part, parts, a, b,
                                              capacity, state)
                       : Face<T>::join(query, index, sets.set, 2, index, sets.set, 2, part, parts,
                                       aligned(room_of_scratch, scratch_size), scratch_size, a, b, capacity, state);
    demand_items(a, found, capacity, sets.items);
    demand_items(b, found, capacity, sets.items);
  } while (found > 0 && state[0] >= 0);
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  static GuardedMemory room_of_index(index_room), room_of_copy(index_room), room_of_scratch(index_room);
  const Sets<T> sets(bytes, memory);
  const std::byte* index = build(bytes, sets, room_of_index, room_of_scratch);
  if (index != nullptr && bytes.below(2) == 1) index = damaged(bytes, index, room_of_copy);
  if (index == nullptr || vesica_index_count(index) != sets.items) return;
  if (bytes.below(4) == 0) {
    join(bytes, memory, sets, index);
  } else {
    ask(bytes, memory, sets, index);
  }
}

}  // namespace
}  // namespace index

void call_index(Bytes& bytes, Memory& memory) {
  if (bytes.below(2) == 0) {
    index::call<double>(bytes, memory);
  } else {
    index::call<float>(bytes, memory);
  }
}

}  // namespace fuzz
