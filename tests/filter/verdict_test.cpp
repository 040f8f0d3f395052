// SPDX-License-Identifier: Apache-2.0
// What a filter decides is the exact answer, and it decides nothing about invalid shapes: every pair, in float and in
// double, inside and outside of the filters' guards, over the whole range of the format and about contact.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vesica/overlap.hpp>

#include "filter/any_numbers.hpp"
#include "filter/inputs.hpp"
#include "kernels/filters.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica;
using inputs::Exponents;
using inputs::Numbers;
using properties::Random;

/// The filter that every caller runs, and the one batches run first on shapes with axes of unit length.
struct PairFilter {
  template <class A, class B>
  static auto verdict(const A& a, const B& b) {
    return detail::overlap::filter(a, b);
  }
};
struct UnitAxesFilter {
  template <class A, class B>
  static filter::Verdict<bool> verdict(const A& a, const B& b) {
    const auto answer = UnitAxes::filter(a, b);
    if constexpr (HalfDone<decltype(answer)>) {
      return whole(decide(answer));
    } else {
      return whole(answer);
    }
  }

 private:
  static filter::Verdict<bool> whole(const filter::DecidedVerdict<bool>& v) {
    return {v.overlap, v.decided && !v.overlap};
  }
};

constexpr const char* kind_names[] = {"point", "segment", "circle", "aabb", "rect", "ellipse"};
constexpr int most_printed = 3;

template <template <class> class A, template <class> class B, class V, class Filter = PairFilter>
struct PairOf {
  using First = A<V>;
  using Second = B<V>;
  using Scalar = V;
  using Tested = Filter;

  static std::string name() {
    const auto kind = [](Kind k) { return std::string(kind_names[static_cast<int>(k)]); };
    return kind(ShapeTraits<First>::kind) + "_" + kind(ShapeTraits<Second>::kind) +
           (std::is_same_v<Filter, PairFilter> ? "" : "_unit_axes") + (sizeof(V) == 4 ? "_f32" : "_f64");
  }

  /// Pairs that comparisons decide have no exact stage of their own: as boxes they have one.
  static bool exact(const First& a, const Second& b) {
    constexpr auto compared = [](Kind k) { return k == Kind::point || k == Kind::aabb; };
    if constexpr (compared(ShapeTraits<First>::kind) && compared(ShapeTraits<Second>::kind)) {
      return exact::overlap(exact::form(widen(a)), exact::form(widen(b)));
    } else {
      return detail::overlap::exact(widen(a), widen(b));
    }
  }
};

template <class Shapes>
class Verdicts : public testing::Test {
 protected:
  using V = typename Shapes::Scalar;
  using First = typename Shapes::First;
  using Second = typename Shapes::Second;
  static constexpr int fields_a = ShapeTraits<First>::fields, fields_b = ShapeTraits<Second>::fields;
  static constexpr int count = fields_a + fields_b;

  static First first(const Numbers<V>& n) { return inputs::shape_at<First>(n.data()); }
  static Second second(const Numbers<V>& n) { return inputs::shape_at<Second>(n.data() + fields_a); }
  static bool exact(const Numbers<V>& n) { return Shapes::exact(first(n), second(n)); }

  static bool valid(Kind kind, const V* n, int fields) {
    const std::string_view role = inputs::roles[static_cast<int>(kind)];
    for (int i = 0; i < fields; ++i) {
      if (!std::isfinite(n[i])) return false;
      if (role[static_cast<std::size_t>(i)] == 's' && n[i] < 0) return false;
    }
    if (fields == 6 && n[2] == 0 && n[3] == 0) return false;
    return kind != Kind::aabb || (n[0] <= n[2] && n[1] <= n[3]);
  }
  static bool valid(const Numbers<V>& n) {
    return valid(ShapeTraits<First>::kind, n.data(), fields_a) &&
           valid(ShapeTraits<Second>::kind, n.data() + fields_a, fields_b);
  }

  void check(const Numbers<V>& n) {
    ++cases_;
    const auto verdict = Shapes::Tested::verdict(first(n), second(n));
    if (!verdict.overlap && !verdict.disjoint) return;
    ++decided_;
    const bool right = valid(n) && verdict.overlap != verdict.disjoint && verdict.overlap == exact(n);
    if (right || ++wrong_ > most_printed) return;
    ADD_FAILURE() << Shapes::name() << " decides " << (verdict.overlap ? "overlap" : "disjoint")
                  << (valid(n) ? "" : " on an invalid shape") << ", seed " << properties::seed() << ": "
                  << inputs::describe(n, fields_a, count);
  }

  /// Ranges of exponents about every filter's guard.
  inputs::Inputs<V> pairs(int which) {
    constexpr int range = ScalarTraits<V>::range;
    constexpr Exponents narrow{-3, 5, -6, 10}, middle{-10, 10, -30, 40}, wide{-25, 25, -90, 75};
    constexpr Exponents unit{-1, 0, -30, 40}, unit_ellipse{-1, 0, -9, 12};
    const Exponents& e = unit_axes    ? (has_ellipse ? unit_ellipse : unit)
                         : which == 0 ? narrow
                         : which == 1 ? middle
                                      : wide;
    const int axes = unit_axes ? 1 : range;
    return {ShapeTraits<First>::kind,
            ShapeTraits<Second>::kind,
            {axes * e.axis_low, axes * e.axis_high, range * e.size_low, range * e.size_high},
            random_};
  }

  /// A pair, its axes of unit length but for a few places where the tested filter asks for that.
  Numbers<V> drawn(inputs::Inputs<V>& pairs) {
    Numbers<V> n = pairs.draw();
    if (!unit_axes || !has_ellipse) return n;
    make_unit(ShapeTraits<First>::kind, n.data());
    make_unit(ShapeTraits<Second>::kind, n.data() + fields_a);
    return n;
  }
  void make_unit(Kind kind, V* shape) {
    if (kind != Kind::rect && kind != Kind::ellipse) return;
    const double x = shape[2], y = shape[3], length = std::hypot(x, y);
    shape[2] = inputs::places_from(static_cast<V>(x / length), random_.integer(-5, 5) * random_.below(2));
    shape[3] = inputs::places_from(static_cast<V>(y / length), random_.integer(-5, 5) * random_.below(2));
  }

  void mend(Numbers<V>& n) {
    inputs::mend(ShapeTraits<First>::kind, n.data(), random_);
    inputs::mend(ShapeTraits<Second>::kind, n.data() + fields_a, random_);
  }

  void report() const {
    std::printf("  %-24s %8d of %8d decided\n", Shapes::name().c_str(), decided_, cases_);
    // Else there was little to be wrong about.
    EXPECT_GE(decided_, cases_ / 10);
  }

  static constexpr bool is_float = sizeof(V) == 4;
  static constexpr bool unit_axes = std::is_same_v<typename Shapes::Tested, UnitAxesFilter>;
  static constexpr bool has_ellipse = ShapeTraits<Second>::kind == Kind::ellipse;
  Random random_{properties::seed()};
  int cases_ = 0, decided_ = 0, wrong_ = 0;
};

template <class V>
using PairsOf = testing::Types<
    PairOf<Point, Point, V>, PairOf<Point, Segment, V>, PairOf<Point, Circle, V>, PairOf<Point, Aabb, V>,
    PairOf<Point, Rect, V>, PairOf<Point, Ellipse, V>, PairOf<Segment, Segment, V>, PairOf<Segment, Circle, V>,
    PairOf<Segment, Aabb, V>, PairOf<Segment, Rect, V>, PairOf<Segment, Ellipse, V>, PairOf<Circle, Circle, V>,
    PairOf<Circle, Aabb, V>, PairOf<Circle, Rect, V>, PairOf<Circle, Ellipse, V>, PairOf<Aabb, Aabb, V>,
    PairOf<Aabb, Rect, V>, PairOf<Aabb, Ellipse, V>, PairOf<Rect, Rect, V>, PairOf<Rect, Ellipse, V>,
    PairOf<Ellipse, Ellipse, V>, PairOf<Rect, Rect, V, UnitAxesFilter>, PairOf<Rect, Ellipse, V, UnitAxesFilter>,
    PairOf<Circle, Ellipse, V, UnitAxesFilter>, PairOf<Ellipse, Ellipse, V, UnitAxesFilter>>;

struct PairNames {
  template <class Shapes>
  static std::string GetName(int) {
    return Shapes::name();
  }
};

TYPED_TEST_SUITE_P(Verdicts);

// Each number of its own magnitude, sizes and axes too: almost always out of one guard or another. This finds values
// that overflow under a finite bound and products that underflow unnoticed.
TYPED_TEST_P(Verdicts, OverTheWholeRange) {
  const int cases = (this->is_float ? 60'000 : 20'000) * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    Numbers<typename TypeParam::Scalar> n{};
    // A few numbers anywhere, the rest within the guards; or all anywhere.
    const bool all = this->random_.chance(0.3);
    if (!all) {
      inputs::Inputs pairs = this->pairs(this->random_.below(3));
      n = this->drawn(pairs);
    }
    for (int field = 0; field < this->count; ++field) {
      if (all || this->random_.chance(0.15)) n[field] = inputs::any_number<typename TypeParam::Scalar>(this->random_);
    }
    this->mend(n);
    this->check(n);
  }
  std::printf("  %-24s %8d of %8d decided\n", TypeParam::name().c_str(), this->decided_, this->cases_);
}

TYPED_TEST_P(Verdicts, WithinTheGuards) {
  const int cases = (this->is_float ? 30'000 : 8'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) this->check(this->drawn(pairs));
  }
  this->report();
}

TYPED_TEST_P(Verdicts, AboutContact) {
  const int cases = (this->is_float ? 400 : 100) * properties::repeat();
  for (int which = 0; which < 2; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = pairs.near_contact(this->drawn(pairs), [this](const auto& m) { return this->exact(m); });
      // Contact, and from there by places outwards.
      for (int k = 0; k < 10; ++k) {
        this->check(n);
        inputs::move_one(n, this->count, this->random_);
        if (!this->valid(n)) break;
      }
    }
  }
  std::printf("  %-24s %8d of %8d decided\n", TypeParam::name().c_str(), this->decided_, this->cases_);
}

TYPED_TEST_P(Verdicts, NoneOnInvalidShapes) {
  const int cases = (this->is_float ? 15'000 : 10'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs pairs = this->pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = this->drawn(pairs);
      inputs::spoil(n, this->fields_a, this->count, this->random_);
      this->check(n);
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(Verdicts, OverTheWholeRange, WithinTheGuards, AboutContact, NoneOnInvalidShapes);
INSTANTIATE_TYPED_TEST_SUITE_P(Float, Verdicts, PairsOf<float>, PairNames);
INSTANTIATE_TYPED_TEST_SUITE_P(Double, Verdicts, PairsOf<double>, PairNames);

}  // namespace
