// SPDX-License-Identifier: Apache-2.0
#include <vesica/relation.hpp>

#include "compiled_once.hpp"
#include "polygon/topology.hpp"
#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_RELATION(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica

namespace vesica::queries {

namespace {

struct RelationOfPair {
  static constexpr Reversal reversal = Reversal::converse;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return detail::called_relation(widen(a), widen(b));
  }
};

struct ContainsPair {
  static constexpr Reversal reversal = Reversal::unknown;
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    const std::int32_t relation = detail::called_relation(widen(a), widen(b));
    return relation < 0 ? relation : relation >= static_cast<std::int32_t>(Relation::contains);
  }
};

double contains_from_relation(double code) noexcept {
  return code >= static_cast<double>(Relation::contains) ? 1 : 0 * code;
}

}  // namespace

constinit const Query relation{
    .doubles = pair_table<RelationOfPair, double>(),
    .floats = pair_table<RelationOfPair, float>(),
    .reversal = RelationOfPair::reversal,
    .paths = polygon::relation,
    .kernels = &QueryTable::relation,
};

// Containment of (b, a) says nothing about containment of (a, b). Batches derive it from the relation, whose kernels
// decide it too.
constinit const Query contains{
    .doubles = pair_table<ContainsPair, double>(),
    .floats = pair_table<ContainsPair, float>(),
    .reversal = ContainsPair::reversal,
    .paths = polygon::contains,
    .asked_instead = &relation,
    .from_code = contains_from_relation,
};

}  // namespace vesica::queries
