// SPDX-License-Identifier: Apache-2.0
// What a filter says for certain about how two shapes stand to each other is so, and it says nothing about invalid
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

template <template <class> class A, template <class> class B, class V>
struct PairOf {
  using First = A<V>;
  using Second = B<V>;
  using Scalar = V;

  static std::string name() {
    const auto kind = [](Kind k) { return std::string(kind_names[static_cast<int>(k)]); };
    return kind(ShapeTraits<First>::kind) + "_" + kind(ShapeTraits<Second>::kind) + (sizeof(V) == 4 ? "_f32" : "_f64");
  }
};

/// Whether every member that is true is so of the relation; and at most one of the answers may be.
bool is_right(const filter::CertainFacts<bool>& s, Relation r) {
  const bool inside = r == Relation::inside || r == Relation::inside_touch;
  const bool contains = r == Relation::contains || r == Relation::contains_touch;
  const bool equal = r == Relation::equal;
  if (s.disjoint && r != Relation::disjoint) return false;
  if (s.crossing && (r == Relation::disjoint || r == Relation::touch)) return false;
  if (s.inside && r != Relation::inside) return false;
  if (s.contains && r != Relation::contains) return false;
  if (s.neither && (inside || contains || equal)) return false;
  if (s.not_inside && (inside || equal)) return false;
  return !(s.not_contains && (contains || equal));
}

bool says_nothing(const filter::CertainFacts<bool>& s) {
  return !s.disjoint && !s.crossing && !s.inside && !s.contains && !s.neither && !s.not_inside && !s.not_contains;
}

bool decides(const filter::CertainFacts<bool>& s) {
  const auto certain = filter::certain_relation(s);
  return certain.disjoint || certain.cross || certain.inside || certain.contains;
}

template <class Shapes>
class CertainFactsTest : public testing::Test {
 protected:
  using V = typename Shapes::Scalar;
  using First = typename Shapes::First;
  using Second = typename Shapes::Second;
  static constexpr int fields_a = ShapeTraits<First>::fields, fields_b = ShapeTraits<Second>::fields;
  static constexpr int count = fields_a + fields_b;

  static First first(const Numbers<V>& n) { return inputs::shape_at<First>(n.data()); }
  static Second second(const Numbers<V>& n) { return inputs::shape_at<Second>(n.data() + fields_a); }
  static Relation exact(const Numbers<V>& n) {
    return exact::relate(exact::relation_form(widen(first(n))), exact::relation_form(widen(second(n))));
  }
  static bool valid(const Numbers<V>& n) { return vesica::check(first(n)) == 0 && vesica::check(second(n)) == 0; }

  void check(const Numbers<V>& n) {
    ++cases_;
    const filter::CertainFacts<bool> facts = detail::relation::certain_facts(first(n), second(n));
    if (says_nothing(facts)) return;
    decided_ += decides(facts);
    if ((valid(n) && is_right(facts, exact(n))) || ++wrong_ > most_printed) return;
    ADD_FAILURE() << Shapes::name() << " is wrong" << (valid(n) ? "" : " on an invalid shape") << ", seed "
                  << properties::seed() << ": " << inputs::describe(n, fields_a, count);
  }

  /// Ranges of exponents about every filter's guard.
  inputs::Inputs<V> pairs(int which) {
    constexpr int range = ScalarTraits<V>::range;
    constexpr Exponents narrow{-3, 5, -6, 10}, middle{-10, 10, -30, 40}, wide{-25, 25, -90, 75};
    const Exponents& e = which == 0 ? narrow : which == 1 ? middle : wide;
    return {ShapeTraits<First>::kind,
            ShapeTraits<Second>::kind,
            {range * e.axis_low, range * e.axis_high, range * e.size_low, range * e.size_high},
            random_};
  }

  /// A pair of which one shape often contains the other: the second's sizes shrunk or grown.
  Numbers<V> nested(inputs::Inputs<V>& pairs) {
    Numbers<V> n = pairs.draw();
    const V factor = std::ldexp(V(1), random_.integer(-6, 6));
    const std::string_view role = inputs::roles[static_cast<int>(ShapeTraits<Second>::kind)];
    for (int i = 0; i < fields_b; ++i) {
      if (role[static_cast<std::size_t>(i)] == 's') n[fields_a + i] *= factor;
    }
    if (ShapeTraits<Second>::kind == Kind::segment || ShapeTraits<Second>::kind == Kind::aabb) {
      n[fields_a + 2] = n[fields_a] + (n[fields_a + 2] - n[fields_a]) * factor;
      n[fields_a + 3] = n[fields_a + 1] + (n[fields_a + 3] - n[fields_a + 1]) * factor;
    }
    return n;
  }

  /// A shape of sizes about 1 and any position and direction.
  Numbers<V> ordinary(Kind kind) {
    const auto between = [this](double low, double high) { return static_cast<V>(random_.between(low, high)); };
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
    inputs::mend(ShapeTraits<First>::kind, n.data(), random_);
    inputs::mend(ShapeTraits<Second>::kind, n.data() + fields_a, random_);
  }

  void report() const {
    std::printf("  %-24s %8d of %8d decided\n", Shapes::name().c_str(), decided_, cases_);
    EXPECT_EQ(wrong_, 0);
  }

  static constexpr bool is_float = sizeof(V) == 4;
  Random random_{properties::seed()};
  int cases_ = 0, decided_ = 0, wrong_ = 0;
};

template <class V>
using PairsOf =
    testing::Types<PairOf<Point, Segment, V>, PairOf<Point, Circle, V>, PairOf<Point, Aabb, V>, PairOf<Point, Rect, V>,
                   PairOf<Point, Ellipse, V>, PairOf<Segment, Segment, V>, PairOf<Segment, Circle, V>,
                   PairOf<Segment, Aabb, V>, PairOf<Segment, Rect, V>, PairOf<Segment, Ellipse, V>,
                   PairOf<Circle, Circle, V>, PairOf<Circle, Aabb, V>, PairOf<Circle, Rect, V>,
                   PairOf<Circle, Ellipse, V>, PairOf<Aabb, Aabb, V>, PairOf<Aabb, Rect, V>, PairOf<Aabb, Ellipse, V>,
                   PairOf<Rect, Rect, V>, PairOf<Rect, Ellipse, V>, PairOf<Ellipse, Ellipse, V>>;

struct PairNames {
  template <class Shapes>
  static std::string GetName(int) {
    return Shapes::name();
  }
};

TYPED_TEST_SUITE_P(CertainFactsTest);

// Each number of its own magnitude, sizes and axes too: almost always out of one guard or another. This finds values
// that overflow under a finite bound and products that underflow unnoticed.
TYPED_TEST_P(CertainFactsTest, OverTheWholeRange) {
  const int cases = (this->is_float ? 25'000 : 10'000) * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    Numbers<typename TypeParam::Scalar> n{};
    const bool all = this->random_.chance(0.3);
    if (!all) n = this->pairs(this->random_.below(3)).draw();
    for (int field = 0; field < this->count; ++field) {
      if (all || this->random_.chance(0.15)) n[field] = inputs::any_number<typename TypeParam::Scalar>(this->random_);
    }
    this->mend(n);
    this->check(n);
  }
  this->report();
}

TYPED_TEST_P(CertainFactsTest, WithinTheGuards) {
  const int cases = (this->is_float ? 12'000 : 4'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = i % 2 == 0 ? pairs.draw() : this->nested(pairs);
      if (this->valid(n)) this->check(n);
    }
  }
  this->report();
}

TYPED_TEST_P(CertainFactsTest, AboutContact) {
  const int cases = (this->is_float ? 200 : 60) * properties::repeat();
  for (int which = 0; which < 2; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = this->nested(pairs);
      if (!this->valid(n)) continue;
      // Where containment changes, else where overlap does; and from there by places outwards.
      const Relation here = this->exact(n);
      n = pairs.near_contact(n, [&](const auto& m) { return this->exact(m) == here; });
      for (int k = 0; k < 10; ++k) {
        this->check(n);
        inputs::move_one(n, this->count, this->random_);
        if (!this->valid(n)) break;
      }
    }
  }
  this->report();
}

TYPED_TEST_P(CertainFactsTest, NothingOnInvalidShapes) {
  const int cases = (this->is_float ? 8'000 : 6'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = pairs.draw();
      inputs::spoil(n, this->fields_a, this->count, this->random_);
      this->check(n);
    }
  }
  this->report();
}

// Shapes of sizes about 1 in any position. Relations are decided in double; in float, filters leave more open.
TYPED_TEST_P(CertainFactsTest, OrdinaryPairsAreDecided) {
  const int cases = 20'000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    auto n = this->ordinary(ShapeTraits<typename TypeParam::First>::kind);
    const auto second = this->ordinary(ShapeTraits<typename TypeParam::Second>::kind);
    for (int k = 0; k < this->fields_b; ++k) n[this->fields_a + k] = second[k];
    this->check(n);
  }
  this->report();
  EXPECT_LE(this->cases_ - this->decided_, cases / (this->is_float ? 20 : 10'000));
}

REGISTER_TYPED_TEST_SUITE_P(CertainFactsTest, OverTheWholeRange, WithinTheGuards, AboutContact, NothingOnInvalidShapes,
                            OrdinaryPairsAreDecided);
INSTANTIATE_TYPED_TEST_SUITE_P(Float, CertainFactsTest, PairsOf<float>, PairNames);
INSTANTIATE_TYPED_TEST_SUITE_P(Double, CertainFactsTest, PairsOf<double>, PairNames);

}  // namespace
