// SPDX-License-Identifier: Apache-2.0
// Overlap, relation, contains: against the exact stage, the other order of shapes, and the oracle.
#include <vesica.h>

#include "capi/typed_pairs.hpp"
#include "oracle/oracle.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr std::int32_t converses[] = {VESICA_DISJOINT,       VESICA_TOUCH,  VESICA_CROSS,        VESICA_CONTAINS,
                                      VESICA_CONTAINS_TOUCH, VESICA_INSIDE, VESICA_INSIDE_TOUCH, VESICA_EQUAL};

bool contains_by(std::int32_t relation) { return relation >= VESICA_CONTAINS; }

std::int32_t by_exact_stage(Query query, const Pair& p) {
  if (query == Query::overlap) return exact_overlap(p);
  const std::int32_t relation = exact_relation(p);
  return query == Query::relation ? relation : contains_by(relation);
}

std::int32_t by_oracle(Query query, const Pair& p) {
  if (query == Query::overlap) return oracle::overlap(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  const std::int32_t relation = oracle::relation(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return query == Query::relation ? relation : contains_by(relation);
}

/// The oracle knows no relation of an ellipse with a shape that has a core and a radius.
bool has_oracle(const Case& c) {
  const bool has_ellipse = c.pair.kind_a == VESICA_ELLIPSE || c.pair.kind_b == VESICA_ELLIPSE;
  return c.query == Query::overlap || !has_ellipse || !(is_inflated(c.pair.kind_a) || is_inflated(c.pair.kind_b));
}

void demand_code(Judge& j, const char* law, std::int32_t expected, std::int32_t got) {
  if (expected != got) j.demand(false, law, std::to_string(expected), std::to_string(got));
}

/// The function of the two kinds, in the order that it has.
template <class T>
void demand_typed(Judge& j, const Case& c, const properties::NumbersOf<T>& a, const properties::NumbersOf<T>& b,
                  std::int32_t code) {
  for (const auto& pair : capi::Api<T>::typed_pairs) {
    if (pair.kind_a == c.pair.kind_a && pair.kind_b == c.pair.kind_b) {
      demand_code(j, "typed", code, pair.overlap(a.data(), b.data()));
    } else if (pair.kind_a == c.pair.kind_b && pair.kind_b == c.pair.kind_a) {
      demand_code(j, "typed", code, pair.overlap(b.data(), a.data()));
    }
  }
}
void demand_typed(Judge& j, const Case& c, std::int32_t code) {
  if (c.scalar == Scalar::f64) return demand_typed(j, c, c.pair.a, c.pair.b, code);
  demand_typed(j, c, as_floats(c.pair.a), as_floats(c.pair.b), code);
}

}  // namespace

void judge_code(Judge& j, const Case& c, Effort effort) {
  const std::int32_t code = ask(c.query, c.scalar, c.pair).code;
  demand_code(j, "exact_stage", by_exact_stage(c.query, c.pair), code);
  if (effort == Effort::quick) return;
  if (has_oracle(c)) demand_code(j, "oracle", by_oracle(c.query, c.pair), code);
  if (c.query == Query::overlap) demand_typed(j, c, code);
  const std::int32_t back = ask(c.query, c.scalar, swapped(c.pair)).code;
  if (c.query == Query::overlap) demand_code(j, "exchanged", code, back);
  if (c.query != Query::relation) return;
  demand_code(j, "exchanged", code < 0 || code > 7 ? code : converses[code], back);
  demand_code(j, "and_overlap", code > 0, ask(Query::overlap, c.scalar, c.pair).code);
  demand_code(j, "and_contains", contains_by(code), ask(Query::contains, c.scalar, c.pair).code);
}

}  // namespace stress
