// SPDX-License-Identifier: Apache-2.0
#include "stress/exact_stage.hpp"

#include <vesica.h>

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
#define VESICA_CASE(name, Name) \
  case vesica::Kind::name:      \
    return action(load<vesica::Name<double>>(numbers));
    VESICA_EACH_SHAPE_WITH_FORM(VESICA_CASE)
    VESICA_EACH_SHAPE_INFLATED(VESICA_CASE)
#undef VESICA_CASE
    default:
      return VESICA_E_KIND;
  }
}

template <class Action>
std::int32_t with_pair(const Pair& p, Action action) {
  return with_shape(p.kind_a, p.a, [&](const auto& a) {
    return with_shape(p.kind_b, p.b, [&](const auto& b) { return static_cast<std::int32_t>(action(a, b)); });
  });
}

/// For kinds in order.
template <class A, class B>
std::int32_t relate(const A& a, const B& b) {
  if constexpr (!vesica::detail::form::Inflated<B>) {
    return static_cast<std::int32_t>(
        vesica::exact::relate(vesica::exact::relation_form(a), vesica::exact::relation_form(b)));
  } else if constexpr (!vesica::detail::overlap::is_ellipse<A>) {
    return static_cast<std::int32_t>(
        vesica::exact::relate(vesica::exact::inflated_box(a), vesica::exact::inflated_box(b)));
  } else {
    return static_cast<std::int32_t>(vesica::exact::relate(vesica::exact::form(a), vesica::exact::inflated_box(b)));
  }
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
  return with_pair(p, []<class A, class B>(const A& a, const B& b) {
    if constexpr (!vesica::detail::in_order<A, B>) {
      const auto reversed = static_cast<vesica::Relation>(relate(b, a));
      return static_cast<std::int32_t>(vesica::converse(reversed));
    } else {
      return relate(a, b);
    }
  });
}

}  // namespace stress
