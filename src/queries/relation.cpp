// SPDX-License-Identifier: Apache-2.0
#include <vesica/relation.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct RelationOfPair {
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return relation_or_error(a, b);
  }
};

struct ContainsPair {
  template <class A, class B>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b) noexcept {
    return contains_or_error(a, b);
  }
};

double contains_from_relation(double code) noexcept {
  return code >= static_cast<double>(Relation::contains) ? 1 : 0 * code;
}

}  // namespace

constinit const Query relation{
    .pairs = pairs_in_order<RelationOfPair>(),
    .reversal = Reversal::converse,
    .kernels = &QueryTable::relation,
};

// Containment has no converse. Batches take it from the relation, whose kernels know as much.
constinit const Query contains{
    .pairs = pairs_in_both_orders<ContainsPair>(),
    .asked_instead = &relation,
    .from_code = contains_from_relation,
};

}  // namespace vesica::queries
