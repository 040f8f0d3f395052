// SPDX-License-Identifier: Apache-2.0
// A filter's certain facts about the relation of two shapes are true, and it says nothing about invalid
// shapes: every pair of kinds, in float and in double, inside and outside of the filters' guards, over the whole range
// of the format, about outer and inner contact. And it says enough: of ordinary pairs, hardly any is left to the exact
// stage.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vesica/relation.hpp>

#include "filter/any_numbers.hpp"
#include "filter/inputs.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica;
using inputs::Exponents;
using inputs::Numbers;
using properties::Random;

constexpr const char* kind_names[] = {"point", "segment", "circle", "aabb", "rect", "ellipse"};
constexpr int most_printed = 3;

/// The code compiled for each pair of kinds; everything else is for all of them.
template <class V>
struct PairOfKinds {
  Kind first, second;
  int fields_a, fields_b;
  filter::CertainFacts<bool> (*facts)(const Numbers<V>&);
  Relation (*exact)(const Numbers<V>&);
  bool (*valid)(const Numbers<V>&);

  int count() const { return fields_a + fields_b; }
  std::string name() const {
    const auto kind = [](Kind k) { return std::string(kind_names[static_cast<int>(k)]); };
    return kind(first) + "_" + kind(second) + (sizeof(V) == 4 ? "_f32" : "_f64");
  }
};

template <class A, class B>
struct Compiled {
  using V = typename ShapeTraits<A>::Scalar;
  static constexpr int fields_a = ShapeTraits<A>::fields, fields_b = ShapeTraits<B>::fields;

  static A first(const Numbers<V>& n) { return inputs::shape_at<A>(n.data()); }
  static B second(const Numbers<V>& n) { return inputs::shape_at<B>(n.data() + fields_a); }
  static filter::CertainFacts<bool> facts(const Numbers<V>& n) {
    if constexpr (ShapeTraits<B>::kind == Kind::point) {
      return {};
    } else {
      return detail::relation::certain_facts(first(n), second(n));
    }
  }
  static Relation exact(const Numbers<V>& n) {
    return vesica::exact::relate(vesica::exact::relation_form(widen(first(n))),
                                 vesica::exact::relation_form(widen(second(n))));
  }
  static bool valid(const Numbers<V>& n) { return vesica::check(first(n)) == 0 && vesica::check(second(n)) == 0; }

  static constexpr PairOfKinds<V> pair{
      ShapeTraits<A>::kind, ShapeTraits<B>::kind, fields_a, fields_b, facts, exact, valid};
};

/// True if every fact that is set holds for the relation; at most one of the answers may be set.
bool is_right(const filter::CertainFacts<bool>& s, Relation r) {
  const bool inside = r == Relation::inside || r == Relation::inside_touch;
  const bool contains = r == Relation::contains || r == Relation::contains_touch;
  const bool equal = r == Relation::equal;
  if (s.disjoint && r != Relation::disjoint) return false;
  if (s.crossing && (r == Relation::disjoint || r == Relation::touch)) return false;
  if (s.inside && r != Relation::inside) return false;
  if (s.contains && r != Relation::contains) return false;
  return !(s.neither && (inside || contains || equal));
}

bool says_nothing(const filter::CertainFacts<bool>& s) {
  return !s.disjoint && !s.crossing && !s.inside && !s.contains && !s.neither;
}

bool decides(const filter::CertainFacts<bool>& s) {
  const auto certain = filter::certain_relation(s);
  return certain.disjoint || certain.cross || certain.inside || certain.contains;
}

/// Draws pairs of two kinds and counts what the filter says of them.
template <class V>
class Judge {
 public:
  explicit Judge(const PairOfKinds<V>& pair) : pair_(pair) {}

  void check(const Numbers<V>& n) {
    ++cases_;
    const filter::CertainFacts<bool> facts = pair_.facts(n);
    if (says_nothing(facts)) return;
    decided_ += decides(facts);
    if ((pair_.valid(n) && is_right(facts, pair_.exact(n))) || ++wrong_ > most_printed) return;
    ADD_FAILURE() << pair_.name() << " is wrong" << (pair_.valid(n) ? "" : " on an invalid shape") << ", seed "
                  << properties::seed() << ": " << inputs::describe(n, pair_.fields_a, pair_.count());
  }

  /// Ranges of exponents about every filter's guard.
  inputs::Inputs<V> pairs(int which) {
    constexpr Exponents narrow{-3, 5, -6, 10}, middle{-10, 10, -30, 40}, wide{-25, 25, -90, 75};
    const Exponents& e = which == 0 ? narrow : which == 1 ? middle : wide;
    return {pair_.first, pair_.second, inputs::widened<V>(e), random};
  }

  /// A pair whose first shape often contains the second, or the reverse: the second's sizes shrunk or grown.
  Numbers<V> nested(inputs::Inputs<V>& pairs) {
    Numbers<V> n = pairs.draw();
    const V factor = std::ldexp(V(1), random.integer(-6, 6));
    const std::string_view role = inputs::roles[static_cast<int>(pair_.second)];
    for (int i = 0; i < pair_.fields_b; ++i) {
      if (role[static_cast<std::size_t>(i)] == 's') n[pair_.fields_a + i] *= factor;
    }
    if (pair_.second == Kind::segment || pair_.second == Kind::aabb) {
      n[pair_.fields_a + 2] = n[pair_.fields_a] + (n[pair_.fields_a + 2] - n[pair_.fields_a]) * factor;
      n[pair_.fields_a + 3] = n[pair_.fields_a + 1] + (n[pair_.fields_a + 3] - n[pair_.fields_a + 1]) * factor;
    }
    return n;
  }

  /// A shape of sizes about 1 and any position and direction.
  Numbers<V> ordinary(Kind kind) {
    const auto between = [this](double low, double high) { return static_cast<V>(random.between(low, high)); };
    const V x = between(-1, 1), y = between(-1, 1), angle = between(-3.2, 3.2), p = between(0.1, 1),
            q = between(0.1, 1);
    switch (kind) {
      case Kind::point:
        return {x, y};
      case Kind::circle:
        return {x, y, p};
      case Kind::segment:
        return {x, y, between(-1, 1), between(-1, 1)};
      case Kind::aabb:
        return {x, y, x + p, y + q};
      default:
        return {x, y, std::cos(angle), std::sin(angle), p, q};
    }
  }

  void mend(Numbers<V>& n) {
    inputs::mend(pair_.first, n.data(), random);
    inputs::mend(pair_.second, n.data() + pair_.fields_a, random);
  }

  void report() const {
    std::printf("  %-24s %8d of %8d decided\n", pair_.name().c_str(), decided_, cases_);
    EXPECT_EQ(wrong_, 0) << pair_.name();
  }

  int undecided() const { return cases_ - decided_; }

  Random random{properties::seed()};

 private:
  const PairOfKinds<V>& pair_;
  int cases_ = 0, decided_ = 0, wrong_ = 0;
};

#define VESICA_PAIR(a, A, b, B) Compiled<A<V>, B<V>>::pair,
template <class V>
constexpr PairOfKinds<V> pairs_of_kinds[] = {VESICA_EACH_PAIR_OF_FORMS(VESICA_PAIR)};
#undef VESICA_PAIR

template <class V>
class CertainFactsTest : public testing::Test {
 protected:
  static constexpr bool is_float = sizeof(V) == 4;

  /// Two points have no filter: there is nothing to judge.
  template <class Judgement>
  static void for_each_pair(const Judgement& judgement) {
    for (const PairOfKinds<V>& pair : pairs_of_kinds<V>) {
      if (pair.second != Kind::point) judgement(pair);
    }
  }
};

struct ScalarNames {
  template <class V>
  static std::string GetName(int) {
    return sizeof(V) == 4 ? "Float" : "Double";
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(CertainFactsTest, Scalars, ScalarNames);

// Each number of its own magnitude, sizes and axes too: almost always out of one guard or another. This finds values
// that overflow under a finite bound and products that underflow unnoticed.
TYPED_TEST(CertainFactsTest, OverTheWholeRange) {
  const int cases = (this->is_float ? 25'000 : 10'000) * properties::repeat();
  this->for_each_pair([&](const auto& pair) {
    Judge judge(pair);
    for (int i = 0; i < cases; ++i) {
      Numbers<TypeParam> n{};
      const bool all = judge.random.chance(0.3);
      if (!all) n = judge.pairs(judge.random.below(3)).draw();
      for (int field = 0; field < pair.count(); ++field) {
        if (all || judge.random.chance(0.15)) n[field] = inputs::any_number<TypeParam>(judge.random);
      }
      judge.mend(n);
      judge.check(n);
    }
    judge.report();
  });
}

TYPED_TEST(CertainFactsTest, WithinTheGuards) {
  const int cases = (this->is_float ? 12'000 : 4'000) * properties::repeat();
  this->for_each_pair([&](const auto& pair) {
    Judge judge(pair);
    for (int which = 0; which < 3; ++which) {
      inputs::Inputs pairs = judge.pairs(which);
      for (int i = 0; i < cases; ++i) {
        auto n = i % 2 == 0 ? pairs.draw() : judge.nested(pairs);
        if (pair.valid(n)) judge.check(n);
      }
    }
    judge.report();
  });
}

TYPED_TEST(CertainFactsTest, AboutContact) {
  const int cases = (this->is_float ? 200 : 60) * properties::repeat();
  this->for_each_pair([&](const auto& pair) {
    Judge judge(pair);
    for (int which = 0; which < 2; ++which) {
      inputs::Inputs pairs = judge.pairs(which);
      for (int i = 0; i < cases; ++i) {
        auto n = judge.nested(pairs);
        if (!pair.valid(n)) continue;
        // A place where containment changes, else one where overlap does; and from there by places outwards.
        const Relation here = pair.exact(n);
        n = pairs.near_contact(n, [&](const auto& m) { return pair.exact(m) == here; });
        for (int k = 0; k < 10; ++k) {
          judge.check(n);
          inputs::move_one(n, pair.count(), judge.random);
          if (!pair.valid(n)) break;
        }
      }
    }
    judge.report();
  });
}

TYPED_TEST(CertainFactsTest, NothingOnInvalidShapes) {
  const int cases = (this->is_float ? 8'000 : 6'000) * properties::repeat();
  this->for_each_pair([&](const auto& pair) {
    Judge judge(pair);
    for (int which = 0; which < 3; ++which) {
      inputs::Inputs pairs = judge.pairs(which);
      for (int i = 0; i < cases; ++i) {
        auto n = pairs.draw();
        inputs::spoil(n, pair.fields_a, pair.count(), judge.random);
        judge.check(n);
      }
    }
    judge.report();
  });
}

// Shapes of sizes about 1 in any position. Relations are decided in double; in float, filters leave more open.
TYPED_TEST(CertainFactsTest, OrdinaryPairsAreDecided) {
  const int cases = 20'000 * properties::repeat();
  this->for_each_pair([&](const auto& pair) {
    Judge judge(pair);
    for (int i = 0; i < cases; ++i) {
      auto n = judge.ordinary(pair.first);
      const auto second = judge.ordinary(pair.second);
      for (int k = 0; k < pair.fields_b; ++k) n[pair.fields_a + k] = second[k];
      judge.check(n);
    }
    judge.report();
    EXPECT_LE(judge.undecided(), cases / (this->is_float ? 20 : 10'000)) << pair.name();
  });
}

}  // namespace
