// SPDX-License-Identifier: Apache-2.0
// The guards of the kernels for unit axes, at the ends of their ranges, for the lanes included before this. An answer
// hardly shows a guard that is wrong by a little: a filter's bound has room to spare.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernels/guard.hpp"

namespace guard_cases {

template <class T>
using Limits = std::numeric_limits<T>;

/// True if `check(guard)` holds in every lane, or in none.
template <class V, class Check>
bool holds(Check check) {
  vesica::Guard<V> guard;
  check(guard);
  const auto mask = guard.holds();
  EXPECT_TRUE(all(mask) || vesica::bits(mask) == 0);
  return all(mask);
}

template <class V>
void expect_within() {
  using T = typename V::Element;
  const auto within = [](T low, T high, T x) {
    // In the last of three places too.
    EXPECT_EQ(holds<V>([&](auto& g) { g.within(low, high, V(x)); }),
              holds<V>([&](auto& g) { g.within(low, high, V(low), V(low), V(x)); }));
    return holds<V>([&](auto& g) { g.within(low, high, V(x)); });
  };
  for (const auto& [low, high] : {std::pair<T, T>{T(0.5), T(2)}, {T(0x1p-6), T(0x1p10)}, {T(0x1p-16), T(0x1p16)}}) {
    EXPECT_TRUE(within(low, high, low));
    EXPECT_TRUE(within(low, high, std::nextafter(high, T(0))));
    EXPECT_TRUE(within(low, high, T(1)));
    EXPECT_FALSE(within(low, high, std::nextafter(low, T(0))));
    EXPECT_FALSE(within(low, high, high));
    for (const T x : {T(0), T(-0.0), -low, T(-1), -Limits<T>::max(), Limits<T>::max(), Limits<T>::denorm_min(),
                      Limits<T>::quiet_NaN(), -Limits<T>::quiet_NaN(), Limits<T>::infinity(), -Limits<T>::infinity()}) {
      EXPECT_FALSE(within(low, high, x)) << x;
    }
  }
}

template <class V>
void expect_near_in_size() {
  using T = typename V::Element;
  const auto near = [](T a, T b) { return holds<V>([&](auto& g) { g.near_in_size(V(a), V(b)); }); };
  for (const T a : {T(0x1p-6), T(0.7), T(1), T(1.9), T(1023)}) {
    const T next = std::nextafter(a, T(0));
    EXPECT_TRUE(near(a, a)) << a;
    EXPECT_TRUE(near(a, 16 * a)) << a;
    EXPECT_FALSE(near(next, 16 * a)) << a;
    EXPECT_FALSE(near(16 * a, a)) << a;
    EXPECT_TRUE(near(16 * next, a)) << a;
    for (const T b : {-a, T(0), Limits<T>::quiet_NaN(), Limits<T>::infinity()})
      EXPECT_FALSE(near(a, b)) << a << ' ' << b;
  }
}

template <class V>
void expect_not_negative() {
  using T = typename V::Element;
  const auto not_negative = [](auto... x) { return holds<V>([&](auto& g) { g.not_negative(V(x)...); }); };
  for (const T x : {T(0), Limits<T>::denorm_min(), T(1), Limits<T>::max()}) EXPECT_TRUE(not_negative(x, x, x, x)) << x;
  for (const T x : {-Limits<T>::denorm_min(), T(-1), -Limits<T>::max(), -Limits<T>::infinity()}) {
    EXPECT_FALSE(not_negative(x, T(1), T(1), T(1))) << x;
    EXPECT_FALSE(not_negative(T(1), T(1), x, T(1))) << x;
    EXPECT_FALSE(not_negative(T(1), T(1), T(1), x)) << x;
  }
}

/// A check that failed stays failed.
template <class V>
void expect_together() {
  using T = typename V::Element;
  const auto both = [](T size, T sign) {
    return holds<V>([&](auto& g) { g.within(T(0.5), T(2), V(size)).not_negative(V(sign)); });
  };
  EXPECT_TRUE(both(1, 1));
  EXPECT_FALSE(both(4, 1));
  EXPECT_FALSE(both(1, -1));
}

template <class V>
void expect_all() {
  expect_within<V>();
  expect_near_in_size<V>();
  expect_not_negative<V>();
  expect_together<V>();
}

}  // namespace guard_cases
