// SPDX-License-Identifier: Apache-2.0
/// The eight ways two shapes can relate.
#pragma once

#include <cstdint>

namespace vesica {

/// RCC-8's eight relations of a to b. relation.hpp defines them for shapes without area too.
enum class Relation : std::int32_t {
  disjoint = 0,        ///< no common point
  touch = 1,           ///< common points, none of them inside both
  cross = 2,           ///< the insides meet, and neither shape contains the other
  inside = 3,          ///< b contains a, and a stays clear of b's outline
  inside_touch = 4,    ///< b contains a, and a reaches b's outline
  contains = 5,        ///< a contains b, and b stays clear of a's outline
  contains_touch = 6,  ///< a contains b, and b reaches a's outline
  equal = 7,           ///< the same set of points
};

/// The relation of b to a.
constexpr Relation converse(Relation r) noexcept {
  switch (r) {
    case Relation::inside:
      return Relation::contains;
    case Relation::inside_touch:
      return Relation::contains_touch;
    case Relation::contains:
      return Relation::inside;
    case Relation::contains_touch:
      return Relation::inside_touch;
    case Relation::disjoint:
    case Relation::touch:
    case Relation::cross:
    case Relation::equal:
      break;
  }
  return r;
}

}  // namespace vesica
