// SPDX-License-Identifier: Apache-2.0
// A kind of shape that only overlap answers, included before all else where the library is compiled with it
// (one_more.sh). The set is empty: it overlaps nothing.
#pragma once

#include <type_traits>

#define VESICA_EACH_SHAPE_WITHOUT_FORM(X) X(dummy, Dummy)
#define VESICA_EACH_PAIR_WITHOUT_FORM(X) \
  X(point, Point, dummy, Dummy)          \
  X(segment, Segment, dummy, Dummy)      \
  X(circle, Circle, dummy, Dummy)        \
  X(aabb, Aabb, dummy, Dummy)            \
  X(rect, Rect, dummy, Dummy)            \
  X(ellipse, Ellipse, dummy, Dummy)      \
  X(capsule, Capsule, dummy, Dummy)      \
  X(round_rect, RoundRect, dummy, Dummy) \
  X(dummy, Dummy, dummy, Dummy)

namespace vesica {

enum class Common : int;

template <class T>
struct Dummy {
  T n0, n1, n2, n3, n4;
};

template <class T>
constexpr int check(const Dummy<T>& s) noexcept {
  return 0 * (s.n0 + s.n1 + s.n2 + s.n3 + s.n4) == 0 ? 0 : -5;  // error_not_finite
}

namespace filter {
template <class Mask>
struct Verdict;
}

namespace detail::overlap {

/// Undecided, for lanes too.
template <template <class> class A, class V>
constexpr auto filter(const A<V>&, const Dummy<V>& s) noexcept {
  const auto never = s.n0 < s.n0;
  return vesica::filter::Verdict<std::remove_const_t<decltype(never)>>{never, never};
}
template <class A>
constexpr int contact(const A&, const Dummy<double>&, Common) noexcept {
  return 1;
}

}  // namespace detail::overlap
}  // namespace vesica
