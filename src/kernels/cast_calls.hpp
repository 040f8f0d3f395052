// SPDX-License-Identifier: Apache-2.0
// Casts of two shapes that miss, without reading the control register. Included once, by src/isa/<set>_calls.cpp, after
// Steady, whose operations do not depend on it.
#pragma once

#include <vesica/cast/early_out.hpp>
#include <vesica/overlap.hpp>

#include "kernels/table.hpp"

namespace vesica {
namespace {

template <class Shape>
struct Read;
template <template <class> class Shape, class T>
struct Read<Shape<T>> {
  VESICA_INLINE static Shape<Steady> from(const void* numbers) noexcept {
    return detail::with_numbers(*static_cast<const Shape<T>*>(numbers),
                                [](const auto&... x) { return Shape<Steady>{Steady::load(x)...}; });
  }
};

template <class A, class B, class T>
VESICA_KERNEL std::int32_t cast_call(const void* a, const void* b, T vx, T vy, T end, void* out,
                                     RestOfCast<T> rest) noexcept {
  using namespace detail::cast;
  EarlyOut early = EarlyOut::open;
  if (keeps_subnormals()) [[likely]] {
    const MotionOf<Steady> motion{Steady::load(vx), Steady::load(vy), Steady::load(end)};
    early = early_out(Read<A>::from(a), Read<B>::from(b), motion);
  }
  if (early != EarlyOut::missed) return rest(a, b, vx, vy, end, out, early);
  *static_cast<Impact<T>*>(out) = no_impact<T>();
  return cast_miss;
}

template <template <class> class A, template <class> class B>
consteval void enter_cast(CallTable& calls) noexcept {
  constexpr int a = static_cast<int>(kind_of<A>), b = static_cast<int>(kind_of<B>);
  calls.casts_f32[a][b] = cast_call<A<float>, B<float>, float>;
  calls.casts_f64[a][b] = cast_call<A<double>, B<double>, double>;
}
consteval CallTable make_calls() noexcept {
  CallTable calls{};
  enter_cast<Segment, Point>(calls);
  enter_cast<Circle, Point>(calls);
  enter_cast<Aabb, Point>(calls);
  enter_cast<Rect, Point>(calls);
  enter_cast<Ellipse, Point>(calls);
  enter_cast<Capsule, Point>(calls);
  enter_cast<RoundRect, Point>(calls);
  enter_cast<Circle, Circle>(calls);
  return calls;
}

}  // namespace
}  // namespace vesica
