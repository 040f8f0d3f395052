// SPDX-License-Identifier: Apache-2.0
// Two vectors as one, for code whose time is the latency of divisions and roots in a row. Each operation is done on
// both vectors, so the processor always has two independent chains to work on.
#pragma once

namespace vesica {
namespace {

template <class Mask>
struct TwoMasks {
  Mask a, b;
};
template <class M>
TwoMasks<M> both(TwoMasks<M> x, TwoMasks<M> y) {
  return {both(x.a, y.a), both(x.b, y.b)};
}
template <class M>
TwoMasks<M> either(TwoMasks<M> x, TwoMasks<M> y) {
  return {either(x.a, y.a), either(x.b, y.b)};
}
template <class M>
TwoMasks<M> and_not(TwoMasks<M> x, TwoMasks<M> y) {
  return {and_not(x.a, y.a), and_not(x.b, y.b)};
}
template <class M>
bool all(TwoMasks<M> m) {
  return all(both(m.a, m.b));
}

template <class V>
struct TwoVectors {
  using Element = typename V::Element;
  static constexpr int width = 2 * V::width;
  V a, b;
  TwoVectors() = default;
  TwoVectors(V x, V y) : a(x), b(y) {}
  explicit TwoVectors(Element x) : a(x), b(x) {}
  static TwoVectors load(const Element* p) { return {V::load(p), V::load(p + V::width)}; }
  void store(Element* p) const {
    a.store(p);
    b.store(p + V::width);
  }
};
template <class V>
TwoVectors<V> operator+(TwoVectors<V> x, TwoVectors<V> y) {
  return {x.a + y.a, x.b + y.b};
}
template <class V>
TwoVectors<V> operator-(TwoVectors<V> x, TwoVectors<V> y) {
  return {x.a - y.a, x.b - y.b};
}
template <class V>
TwoVectors<V> operator*(TwoVectors<V> x, TwoVectors<V> y) {
  return {x.a * y.a, x.b * y.b};
}
template <class V>
TwoVectors<V> operator/(TwoVectors<V> x, TwoVectors<V> y) {
  return {x.a / y.a, x.b / y.b};
}
template <class V>
TwoVectors<V> operator-(TwoVectors<V> x) {
  return {-x.a, -x.b};
}
template <class V>
auto operator<(TwoVectors<V> x, TwoVectors<V> y) {
  return TwoMasks<decltype(x.a < y.a)>{x.a < y.a, x.b < y.b};
}
template <class V>
auto operator<=(TwoVectors<V> x, TwoVectors<V> y) {
  return TwoMasks<decltype(x.a <= y.a)>{x.a <= y.a, x.b <= y.b};
}
template <class V>
auto operator>(TwoVectors<V> x, TwoVectors<V> y) {
  return y < x;
}
template <class V>
auto operator>=(TwoVectors<V> x, TwoVectors<V> y) {
  return y <= x;
}
template <class V>
auto operator==(TwoVectors<V> x, TwoVectors<V> y) {
  return TwoMasks<decltype(x.a == y.a)>{x.a == y.a, x.b == y.b};
}
template <class V>
TwoVectors<V> abs(TwoVectors<V> x) {
  return {abs(x.a), abs(x.b)};
}
template <class V>
TwoVectors<V> sqrt(TwoVectors<V> x) {
  return {sqrt(x.a), sqrt(x.b)};
}
template <class V>
TwoVectors<V> positive_part(TwoVectors<V> x) {
  return {positive_part(x.a), positive_part(x.b)};
}
template <class V>
TwoVectors<V> max(TwoVectors<V> x, TwoVectors<V> y) {
  return {max(x.a, y.a), max(x.b, y.b)};
}
template <class V>
TwoVectors<V> min(TwoVectors<V> x, TwoVectors<V> y) {
  return {min(x.a, y.a), min(x.b, y.b)};
}
template <class V>
TwoVectors<V> flip_sign(TwoVectors<V> x, TwoVectors<V> y) {
  return {flip_sign(x.a, y.a), flip_sign(x.b, y.b)};
}
template <class M, class V>
TwoVectors<V> select(TwoMasks<M> m, TwoVectors<V> yes, TwoVectors<V> no) {
  return {select(m.a, yes.a, no.a), select(m.b, yes.b, no.b)};
}

}  // namespace
}  // namespace vesica
