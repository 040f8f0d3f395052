// SPDX-License-Identifier: Apache-2.0
#include <vesica/relation.hpp>

#include "pair_table.hpp"
#include "vesica.h"

namespace {

struct RelationQuery {
  template <class A, class B>
  static int32_t answer(const A& a, const B& b) noexcept {
    return vesica::relation_or_error(a, b);
  }
};

struct ContainsQuery {
  template <class A, class B>
  static int32_t answer(const A& a, const B& b) noexcept {
    return vesica::contains_or_error(a, b);
  }
};

constexpr bool is_code(vesica::Relation relation, int32_t code) { return static_cast<int32_t>(relation) == code; }

// The core's codes are the C face's.
static_assert(is_code(vesica::Relation::disjoint, VESICA_DISJOINT) && is_code(vesica::Relation::touch, VESICA_TOUCH));
static_assert(is_code(vesica::Relation::cross, VESICA_CROSS) && is_code(vesica::Relation::inside, VESICA_INSIDE));
static_assert(is_code(vesica::Relation::inside_touch, VESICA_INSIDE_TOUCH));
static_assert(is_code(vesica::Relation::contains, VESICA_CONTAINS));
static_assert(is_code(vesica::Relation::contains_touch, VESICA_CONTAINS_TOUCH));
static_assert(is_code(vesica::Relation::equal, VESICA_EQUAL));

}  // namespace

int32_t vesica_relation_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b) {
  return vesica::capi::answer_by_kind<RelationQuery>(kind_a, numbers_a, kind_b, numbers_b);
}
int32_t vesica_relation_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b) {
  return vesica::capi::answer_by_kind<RelationQuery>(kind_a, numbers_a, kind_b, numbers_b);
}

int32_t vesica_contains_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b) {
  return vesica::capi::answer_by_kind<ContainsQuery>(kind_a, numbers_a, kind_b, numbers_b);
}
int32_t vesica_contains_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b) {
  return vesica::capi::answer_by_kind<ContainsQuery>(kind_a, numbers_a, kind_b, numbers_b);
}
