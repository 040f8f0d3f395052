// SPDX-License-Identifier: Apache-2.0
// The laws of relation and containment, asked of the library alone. Every change below is exact on the stored numbers,
// so answers must be equal, not close:
//   converse       relation(b, a) is the converse of relation(a, b)
//   containment    contains(a, b) iff relation(a, b) is contains, contains_touch or equal; then they overlap
//   overlap        overlap(a, b) iff relation(a, b) is not disjoint
//   motion         mirrored, turned by a quarter, or scaled by a power of two, both together
//   notation       one shape written with other numbers, or as another kind, that mean the same points
//   reflexivity    a shape is equal to itself however written, and contains its own points
//   transitivity   of containment, over triples from a chain of shapes
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "properties/answers.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "relation/answers.hpp"
#include "relation/nesting.hpp"

namespace {

using namespace properties;

constexpr int cases_per_workload = 400;
constexpr int most_printed = 3;

class RelationLaws : public testing::TestWithParam<Kinds> {
 protected:
  /// Counts the law as applied, and reports when the answer about the changed pair is not the one it demands.
  void demand(const char* law, const Pair& original, const Pair& changed, std::int32_t got, std::int32_t answer) {
    ++applied_[law];
    if (got == answer || ++broken_ > most_printed) return;
    ADD_FAILURE() << law << ": " << got << " where the law demands " << answer << ", seed " << seed() << "\n  "
                  << describe(original) << "\n  " << describe(changed);
  }
  void demand_relation(const char* law, const Pair& original, const Pair& changed, std::int32_t answer) {
    demand(law, original, changed, relations::relation(GetParam().scalar, changed), answer);
  }

  void one_pair(const Pair& p, std::int32_t answer);
  void motion(const Pair& p, std::int32_t answer, Random& random);
  void notation(const Pair& p, const Shape& written, bool is_second, std::int32_t answer, Random& random);
  void reflexivity(const Shape& shape, Random& random);

  template <class Stream>
  void hold_for(Stream stream, Random& random) {
    for (int i = 0; i < cases_per_workload * repeat(); ++i) {
      const Pair p = stream.next();
      const std::int32_t answer = relations::relation(GetParam().scalar, p);
      one_pair(p, answer);
      motion(p, answer, random);
      notation(p, first(p), false, answer, random);
      notation(p, second(p), true, answer, random);
      reflexivity(first(p), random);
      reflexivity(second(p), random);
    }
  }

  std::map<std::string, int> applied_;
  int broken_ = 0;
};

void RelationLaws::one_pair(const Pair& p, std::int32_t answer) {
  const Scalar scalar = GetParam().scalar;
  demand_relation("converse", p, swapped(p), relations::converse(answer));
  demand("containment", p, p, relations::contains(scalar, p), relations::says_contains(answer));
  demand("overlap", p, p, overlap_by_kind(scalar, p), answer != VESICA_DISJOINT);
}

void RelationLaws::motion(const Pair& p, std::int32_t answer, Random& random) {
  const Scalar scalar = GetParam().scalar;
  demand_relation("mirrored", p, pair_of(mirrored(first(p)), mirrored(second(p))), answer);
  demand_relation("turned", p, pair_of(turned(first(p)), turned(second(p))), answer);
  const int exponent = random_exponent(scalar, random);
  const auto a = scaled_exactly(first(p), scalar, exponent, random.chance(0.5));
  const auto b = scaled_exactly(second(p), scalar, exponent, random.chance(0.5));
  if (a && b) demand_relation("scaled", p, pair_of(*a, *b), answer);
}

void RelationLaws::notation(const Pair& p, const Shape& written, bool is_second, std::int32_t answer, Random& random) {
  const Scalar scalar = GetParam().scalar;
  const auto demand_same = [&](const char* law, const std::optional<Shape>& other) {
    if (!other) return;
    demand_relation(law, p, is_second ? pair_of(first(p), *other) : pair_of(*other, second(p)), answer);
    demand_relation("equal", p, pair_of(written, *other), VESICA_EQUAL);
  };
  demand_same("negated axis", with_negated_axis(written));
  demand_same("turned axis", with_turned_axis(written));
  demand_same("scaled axis", with_scaled_axis(written, scalar, random_exponent(scalar, random)));
  demand_same("ends exchanged", with_ends_exchanged(written));
  for (const Shape& other : as_other_kinds(written, scalar)) demand_same("other kind", other);
}

void RelationLaws::reflexivity(const Shape& shape, Random& random) {
  const Scalar scalar = GetParam().scalar;
  const Pair twice = pair_of(shape, shape);
  demand_relation("equal", twice, twice, VESICA_EQUAL);
  for (const Shape& point : own_points(shape, scalar)) {
    const Pair p = pair_of(shape, point);
    demand("own point", p, p, relations::contains(scalar, p), 1);
  }
  if (const auto larger = grown(shape, scalar, random)) {
    const Pair p = pair_of(*larger, shape);
    demand("grown", p, p, relations::contains(scalar, p), 1);
  }
}

TEST_P(RelationLaws, Hold) {
  const Kinds& kinds = GetParam();
  Random random(seed());
  for (const Workload workload : all_workloads) {
    hold_for(Stream(workload, kinds.a, kinds.b, kinds.scalar, seed()), random);
  }
  for (const relations::Nesting nesting : relations::all_nestings) {
    if (exists(nesting, kinds.a, kinds.b)) {
      hold_for(relations::NestingStream(nesting, kinds.a, kinds.b, kinds.scalar, seed()), random);
    }
  }
  EXPECT_EQ(broken_, 0) << "laws broken; replay with VESICA_SEED=" << seed();
  for (const char* law :
       {"converse", "containment", "overlap", "mirrored", "turned", "scaled", "other kind", "equal"}) {
    EXPECT_TRUE(applied_.contains(law)) << law << " was never applied";
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, RelationLaws, testing::ValuesIn(all_pairs_of_kinds()), test_name);

// Shapes each made from the one before by a change of one number, so that many contain each other; of every three, the
// law is asked where it says something.
class Chain : public testing::TestWithParam<Kinds> {};

TEST_P(Chain, ContainmentIsTransitive) {
  const Kinds& kinds = GetParam();
  Random random(seed());
  relations::NestingStream stream(relations::Nesting::nested, kinds.a, kinds.b, kinds.scalar, seed());
  int applied = 0;
  for (int i = 0; i < 60 * repeat(); ++i) {
    const Pair p = stream.next();
    std::vector<Shape> shapes{first(p), second(p)};
    for (std::size_t k = 0; k < 5; ++k) {
      if (const auto larger = grown(shapes[k], kinds.scalar, random)) shapes.push_back(*larger);
      if (k >= shapes.size() - 1) break;
    }
    for (const Shape& point : own_points(second(p), kinds.scalar)) shapes.push_back(point);
    const auto contains = [&](std::size_t x, std::size_t y) {
      return relations::contains(kinds.scalar, pair_of(shapes[x], shapes[y])) == 1;
    };
    for (std::size_t x = 0; x < shapes.size(); ++x) {
      for (std::size_t y = 0; y < shapes.size(); ++y) {
        if (!contains(x, y)) continue;
        for (std::size_t z = 0; z < shapes.size(); ++z) {
          if (!contains(y, z)) continue;
          applied += x != y && y != z && x != z;
          ASSERT_TRUE(contains(x, z)) << "seed " << seed() << "\n  " << describe(pair_of(shapes[x], shapes[y]))
                                      << "\n  " << describe(pair_of(shapes[y], shapes[z]));
        }
      }
    }
  }
  if (kinds.b != VESICA_POINT && kinds.b != VESICA_SEGMENT) {
    EXPECT_GT(applied, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, Chain, testing::ValuesIn(all_pairs_of_kinds()), test_name);

}  // namespace
