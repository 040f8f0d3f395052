// SPDX-License-Identifier: Apache-2.0
// Shapes that move: two of them, arrays, one against many.
#include <cstring>
#include <iterator>
#include <limits>

#include "capi/typed_casts.hpp"
#include "fuzz/arrays.hpp"

namespace fuzz {
namespace motion {
namespace {

/// Outside of an index: the codes of a cast.
bool is_error(std::int64_t code) { return code < 0 && code >= VESICA_E_RANGE; }

template <class T>
struct Motion {
  T vx, vy, end;
  explicit Motion(Bytes& bytes) : vx(bytes.number<T>()), vy(bytes.number<T>()), end(bytes.number<T>()) {
    if (bytes.below(4) == 0) end = std::numeric_limits<T>::infinity();
  }
};

template <class T>
void demand_impact(std::int64_t code, T end, const typename Face<T>::Impact& impact) {
  demand(code == VESICA_CAST_MISS ? std::isinf(impact.t) : impact.t >= 0 && impact.t <= end);
  demand(code != VESICA_CAST_START || impact.t == 0);
}

template <class T>
void call_cast(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a), b(bytes, memory.b);
  const Motion<T> m(bytes);
  const Output<typename Face<T>::Impact> out(memory.out, bytes.below(128) == 127);
  const std::int32_t code = Face<T>::cast(a.kind(), a.numbers(), b.kind(), b.numbers(), m.vx, m.vy, m.end, out.get());
  demand(is_error(code) || (code >= VESICA_CAST_MISS && code <= VESICA_CAST_START));
  if (code < 0) return demand(out.untouched());
  demand_impact<T>(code, m.end, *out.get());
  const std::int32_t overlap = Face<T>::overlap(a.kind(), a.numbers(), b.kind(), b.numbers());
  demand((code == VESICA_CAST_START) == (overlap == 1));
}

/// Typed structs that end at a guard page, as in the calls by kind.
template <class T>
void call_typed_cast(Bytes& bytes, Memory& memory) {
  const auto& all = capi::typed_casts(T{});
  const auto& typed = all[bytes.below(static_cast<unsigned>(std::size(all)))];
  const auto numbers = [&](std::int32_t kind, GuardedMemory& at) -> const T* {
    if (bytes.below(128) == 127) return nullptr;
    const auto fields = static_cast<std::size_t>(vesica_field_count(kind));
    auto* n = reinterpret_cast<T*>(at.place(fields * sizeof(T), Edge::after));
    for (std::size_t k = 0; k < fields; ++k) n[k] = bytes.number<T>();
    return n;
  };
  const T* a = numbers(typed.kind_a, memory.a);
  const T* b = numbers(typed.kind_b, memory.b);
  const Motion<T> m(bytes);
  const Output<typename Face<T>::Impact> out(memory.out, bytes.below(128) == 127);
  const std::int32_t code = typed.cast(a, b, m.vx, m.vy, m.end, out.get());
  demand(is_error(code) || (code >= VESICA_CAST_MISS && code <= VESICA_CAST_START));
  if (code < 0) demand(out.untouched());
  if (code >= 0) demand_impact<T>(code, m.end, *out.get());
  typename Face<T>::Impact by_kind;
  if (a == nullptr || b == nullptr || out.get() == nullptr) return demand(code == VESICA_E_NULL);
  demand(Face<T>::cast(typed.kind_a, a, typed.kind_b, b, m.vx, m.vy, m.end, &by_kind) == code);
  if (code >= 0) demand(std::memcmp(&by_kind, out.get(), sizeof by_kind) == 0);
}

template <class T>
void call_sweep_bounds(Bytes& bytes, Memory& memory) {
  const Shape<T> a(bytes, memory.a);
  const Motion<T> m(bytes);
  const Output<typename Face<T>::Aabb> out(memory.out, bytes.below(128) == 127);
  const std::int32_t error = Face<T>::sweep_bounds(a.kind(), a.numbers(), m.vx, m.vy, m.end, out.get());
  demand(error == 0 || (is_error(error) && out.untouched()));
  if (error != 0) return;
  typename Face<T>::Aabb rest;
  demand(Face<T>::bounds(a.kind(), a.numbers(), &rest) == 0);
  const auto& box = *out.get();
  demand(box.min_x <= rest.min_x && box.min_y <= rest.min_y && box.max_x >= rest.max_x && box.max_y >= rest.max_y);
}

template <class T>
void call_cast_many(Bytes& bytes, Memory& memory) {
  static GuardedMemory velocities;
  const std::int64_t count_a = bytes.below(most), count_b = bytes.below(4) == 3 ? 1 : count_a;
  const auto a = array<T>(bytes, memory.a, count_a);
  const auto b = array<T>(bytes, memory.b, count_b);
  const std::int64_t n = count_a == 0 || count_b == 0 ? 0 : count_a, apart = bytes.below(3);
  T* v = room<T>(velocities, n == 0 ? 0 : (n - 1) * apart + 2);
  for (std::int64_t i = 0; n > 0 && i < (n - 1) * apart + 2; ++i) v[i] = bytes.number<T>();
  T* out = room<T>(memory.out, 5 * n);
  const unsigned left_out = bytes.below(8);
  const auto column = [&](unsigned k) { return k == left_out ? nullptr : out + k * n; };
  const std::int64_t hits =
      Face<T>::cast_many(&a, &b, v, v + 1, static_cast<std::ptrdiff_t>(apart) * static_cast<std::ptrdiff_t>(sizeof(T)),
                         Motion<T>(bytes).end, column(0), column(1), column(2), column(3), column(4));
  demand(is_error(hits) || (hits >= 0 && hits <= n));
}

template <class T>
void call_cast_first(Bytes& bytes, Memory& memory) {
  const std::int64_t count = bytes.below(most);
  const auto one = array<T>(bytes, memory.a, 1);
  const auto many = array<T>(bytes, memory.b, count);
  const Motion<T> m(bytes);
  const Output<typename Face<T>::Impact> out(memory.out, bytes.below(128) == 127);
  const std::int64_t found = Face<T>::cast_first(&one, &many, m.vx, m.vy, m.end, out.get());
  if (found < 0) return demand(is_error(found) && out.untouched());
  demand(found <= count);
  demand_impact<T>(found == count ? VESICA_CAST_MISS : VESICA_CAST_HIT, m.end, *out.get());
}

template <class T>
void call(Bytes& bytes, Memory& memory) {
  constexpr void (*calls[])(Bytes&, Memory&) = {call_cast<T>, call_typed_cast<T>, call_sweep_bounds<T>,
                                                call_cast_many<T>, call_cast_first<T>};
  calls[bytes.below(static_cast<unsigned>(std::size(calls)))](bytes, memory);
}

}  // namespace
}  // namespace motion

void call_motion(Bytes& bytes, Memory& memory) {
  if (bytes.below(2) == 0) {
    motion::call<double>(bytes, memory);
  } else {
    motion::call<float>(bytes, memory);
  }
}

}  // namespace fuzz
