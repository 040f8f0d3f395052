// SPDX-License-Identifier: Apache-2.0
// Invalid shapes: the same error of every function, nothing written, and vesica_check names the first rule broken.
#include <vesica.h>

#include <cmath>

#include "stress/laws.hpp"

namespace stress {
namespace {

std::int32_t first_rule_broken(int kind, const Numbers& n) {
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (!std::isfinite(n[static_cast<std::size_t>(i)])) return VESICA_E_NOT_FINITE;
  }
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (properties::is_size(properties::role(kind, i)) && n[static_cast<std::size_t>(i)] < 0) {
      return VESICA_E_NEGATIVE_SIZE;
    }
  }
  if (properties::role(kind, 2) == properties::Role::axis && n[2] == 0 && n[3] == 0) return VESICA_E_ZERO_AXIS;
  return kind == VESICA_AABB && (n[0] > n[2] || n[1] > n[3]) ? VESICA_E_INVERTED : 0;
}

}  // namespace

void judge_invalid(Judge& j, const Case& c, bool in_environments) {
  const Pair& p = c.pair;
  // Towards the place of the second shape or away, where a cast may be content with less than it should look at.
  const double sign = p.kind_a % 2 == 0 ? 1 : -1;
  const Motion motion{sign * (std::isfinite(p.b[0]) ? p.b[0] : 1), std::isfinite(p.b[1]) ? sign * p.b[1] : 1, 64};
  for (const auto& [kind, n] : {std::pair(p.kind_a, &p.a), std::pair(p.kind_b, &p.b)}) {
    const std::int32_t rule = first_rule_broken(kind, *n), said = check(c.scalar, kind, *n);
    j.demand(said == rule, "check", std::to_string(rule), std::to_string(said));
  }
  for (const Query query : all_queries) {
    if (query == Query::invalid || query == Query::batch) continue;
    if (is_refused(query, p.kind_a, p.kind_b)) continue;
    if (of_one_shape(query) && properties::valid(p.kind_a, p.a)) continue;
    const Answer answer = ask({query, c.scalar, p, motion, 1});
    j.demand(answer.code == VESICA_E_SHAPE, name(query), std::to_string(VESICA_E_SHAPE), text(answer));
    j.demand(!answer.wrote, "untouched", "nothing written", name(query));
    if (in_environments) judge_environments(j, {query, c.scalar, p, motion, 1});
  }
}

}  // namespace stress
