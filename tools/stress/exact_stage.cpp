// SPDX-License-Identifier: Apache-2.0
#include "stress/exact_stage.hpp"

#include <cstring>
#include <vesica/relation.hpp>

namespace stress {
namespace {

template <class Shape>
Shape load(const Numbers& numbers) {
  Shape shape;
  std::memcpy(&shape, numbers.data(), sizeof shape);
  return shape;
}

template <class Action>
std::int32_t with_shape(int kind, const Numbers& numbers, Action action) {
  switch (static_cast<vesica::Kind>(kind)) {
    case vesica::Kind::point:
      return action(load<vesica::Point<double>>(numbers));
    case vesica::Kind::segment:
      return action(load<vesica::Segment<double>>(numbers));
    case vesica::Kind::circle:
      return action(load<vesica::Circle<double>>(numbers));
    case vesica::Kind::aabb:
      return action(load<vesica::Aabb<double>>(numbers));
    case vesica::Kind::rect:
      return action(load<vesica::Rect<double>>(numbers));
    default:
      return action(load<vesica::Ellipse<double>>(numbers));
  }
}

template <class Action>
std::int32_t with_pair(const Pair& p, Action action) {
  return with_shape(p.kind_a, p.a, [&](const auto& a) {
    return with_shape(p.kind_b, p.b, [&](const auto& b) { return static_cast<std::int32_t>(action(a, b)); });
  });
}

}  // namespace

std::int32_t exact_overlap(const Pair& p) {
  return with_pair(p, []<class A, class B>(const A& a, const B& b) {
    if constexpr (vesica::detail::in_order<A, B>) {
      return vesica::detail::overlap::exact(a, b);
    } else {
      return vesica::detail::overlap::exact(b, a);
    }
  });
}

std::int32_t exact_relation(const Pair& p) {
  return with_pair(p, [](const auto& a, const auto& b) {
    return vesica::exact::relate(vesica::exact::relation_form(a), vesica::exact::relation_form(b));
  });
}

}  // namespace stress
