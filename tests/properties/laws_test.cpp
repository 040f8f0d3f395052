// SPDX-License-Identifier: Apache-2.0
// The laws of overlap, asked of the library alone. Every change below is exact on the stored numbers, so answers must
// be equal, not close:
//   symmetry       overlap(a, b) = overlap(b, a)
//   motion         mirrored, turned by a quarter, or scaled by a power of two, both together
//   notation       one shape written with other numbers, or as another kind, that mean the same points
//   monotonicity   an overlap stays one when a size grows
//   reflexivity    a shape overlaps itself and its own points
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "properties/answers.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace properties;

constexpr int cases_per_workload = 400;
constexpr int most_printed = 3;

class Laws : public testing::TestWithParam<Kinds> {
 protected:
  /// Counts the law as applied, and reports when the changed pair's answer is not the one it demands.
  void demand(const char* law, const Pair& original, const std::optional<Pair>& changed, std::int32_t answer) {
    if (!changed) return;
    ++applied_[law];
    const std::int32_t got = overlap_by_kind(GetParam().scalar, *changed);
    if (got == answer || ++broken_ > most_printed) return;
    ADD_FAILURE() << law << ": " << got << " where the law demands " << answer << ", seed " << seed() << "\n  "
                  << describe(original) << "\n  " << describe(*changed);
  }

  void expect_applied(const char* law) const { EXPECT_TRUE(applied_.contains(law)) << law << " was never applied"; }

  void symmetry_and_motion(const Pair& p, std::int32_t answer, Random& random);
  void notation(const Pair& p, const Shape& written, bool is_second, std::int32_t answer, Random& random);
  void monotonicity(const Pair& p, Random& random);
  void reflexivity(const Shape& shape);

  std::map<std::string, int> applied_;
  int broken_ = 0;
};

void Laws::symmetry_and_motion(const Pair& p, std::int32_t answer, Random& random) {
  const Scalar scalar = GetParam().scalar;
  demand("symmetry", p, swapped(p), answer);
  demand("mirrored", p, pair_of(mirrored(first(p)), mirrored(second(p))), answer);
  demand("turned", p, pair_of(turned(first(p)), turned(second(p))), answer);
  const int exponent = random_exponent(scalar, random);
  const auto a = scaled_exactly(first(p), scalar, exponent, random.chance(0.5));
  const auto b = scaled_exactly(second(p), scalar, exponent, random.chance(0.5));
  if (a && b) demand("scaled", p, pair_of(*a, *b), answer);
}

void Laws::notation(const Pair& p, const Shape& written, bool is_second, std::int32_t answer, Random& random) {
  const Scalar scalar = GetParam().scalar;
  const auto demand_same = [&](const char* law, const std::optional<Shape>& other) {
    if (other) demand(law, p, is_second ? pair_of(first(p), *other) : pair_of(*other, second(p)), answer);
  };
  demand_same("negated axis", with_negated_axis(written));
  demand_same("turned axis", with_turned_axis(written));
  demand_same("scaled axis", with_scaled_axis(written, scalar, random_exponent(scalar, random)));
  demand_same("ends exchanged", with_ends_exchanged(written));
  for (const Shape& other : as_other_kinds(written, scalar)) demand_same("other kind", other);
}

void Laws::monotonicity(const Pair& p, Random& random) {
  const Scalar scalar = GetParam().scalar;
  if (const auto a = grown(first(p), scalar, random)) demand("grown", p, pair_of(*a, second(p)), 1);
  if (const auto b = grown(second(p), scalar, random)) demand("grown", p, pair_of(first(p), *b), 1);
}

void Laws::reflexivity(const Shape& shape) {
  const Pair twice = pair_of(shape, shape);
  demand("itself", twice, twice, 1);
  for (const Shape& point : own_points(shape, GetParam().scalar)) demand("own point", twice, pair_of(point, shape), 1);
}

bool has_size(int kind) { return kind >= 2; }

TEST_P(Laws, Hold) {
  const Kinds& kinds = GetParam();
  Random random(seed());
  for (const Workload workload : all_workloads) {
    Stream stream(workload, kinds.a, kinds.b, kinds.scalar, seed());
    for (int i = 0; i < cases_per_workload * repeat(); ++i) {
      const Pair p = stream.next();
      const std::int32_t answer = overlap_by_kind(kinds.scalar, p);
      symmetry_and_motion(p, answer, random);
      notation(p, first(p), false, answer, random);
      notation(p, second(p), true, answer, random);
      if (answer == 1) monotonicity(p, random);
      reflexivity(first(p));
      reflexivity(second(p));
    }
  }
  EXPECT_EQ(broken_, 0) << "laws broken; replay with VESICA_SEED=" << seed();
  for (const char* law : {"symmetry", "mirrored", "turned", "scaled", "other kind", "itself", "own point"}) {
    expect_applied(law);
  }
  if (has_axis(kinds.b)) {
    for (const char* law : {"negated axis", "turned axis", "scaled axis"}) expect_applied(law);
  }
  if (has_size(kinds.b)) expect_applied("grown");
}

INSTANTIATE_TEST_SUITE_P(Pairs, Laws, testing::ValuesIn(all_pairs_of_kinds()), test_name);

}  // namespace
