// SPDX-License-Identifier: Apache-2.0
// A filter decides only the exact answer, and nothing about invalid shapes: every pair, in float and in
// double, inside and outside of the filters' guards, over the whole range of the format and about contact.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>
#include <vesica/each_shape.hpp>
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

struct Said {
  bool overlap, disjoint;
};

/// A pair with the filter that is tested on it, as functions of its numbers: the tests are compiled once a scalar.
template <class V>
struct Tested {
  std::string name;
  Kind kind_a, kind_b;
  bool unit_axes;
  Said (*verdict)(const Numbers<V>& n);
  bool (*exact)(const Numbers<V>& n);
};

template <class A, class B>
struct Shapes {
  using V = typename ShapeTraits<A>::Scalar;
  static A first(const Numbers<V>& n) { return inputs::shape_at<A>(n.data()); }
  static B second(const Numbers<V>& n) { return inputs::shape_at<B>(n.data() + ShapeTraits<A>::fields); }

  template <class Filter>
  static Said verdict(const Numbers<V>& n) {
    const filter::Verdict<bool> said = Filter::verdict(first(n), second(n));
    return {said.overlap, said.disjoint};
  }

  /// Pairs that comparisons decide have no exact stage of their own: as boxes they have one.
  static bool exact(const Numbers<V>& n) {
    constexpr auto compared = [](Kind k) { return k == Kind::point || k == Kind::aabb; };
    if constexpr (compared(ShapeTraits<A>::kind) && compared(ShapeTraits<B>::kind)) {
      return exact::overlap(exact::form(widen(first(n))), exact::form(widen(second(n))));
    } else {
      return detail::overlap::exact(widen(first(n)), widen(second(n)));
    }
  }
};

template <class A, class B, class Filter = PairFilter>
Tested<typename ShapeTraits<A>::Scalar> tested() {
  constexpr bool unit_axes = std::is_same_v<Filter, UnitAxesFilter>;
  constexpr Kind a = ShapeTraits<A>::kind, b = ShapeTraits<B>::kind;
  return {std::string(kind_names[static_cast<int>(a)]) + "_" + kind_names[static_cast<int>(b)] +
              (unit_axes ? "_unit_axes" : "") + (sizeof(typename ShapeTraits<A>::Scalar) == 4 ? "_f32" : "_f64"),
          a,
          b,
          unit_axes,
          Shapes<A, B>::template verdict<Filter>,
          Shapes<A, B>::exact};
}

template <class V>
class Verdicts : public testing::TestWithParam<Tested<V>> {
 protected:
  static bool valid(Kind kind, const V* n, int fields) {
    const std::string_view role = inputs::roles[static_cast<int>(kind)];
    for (int i = 0; i < fields; ++i) {
      if (!std::isfinite(n[i])) return false;
      if (role[static_cast<std::size_t>(i)] == 's' && n[i] < 0) return false;
    }
    if (fields == 6 && n[2] == 0 && n[3] == 0) return false;
    return kind != Kind::aabb || (n[0] <= n[2] && n[1] <= n[3]);
  }
  bool valid(const Numbers<V>& n) const {
    return valid(pair_.kind_a, n.data(), fields_a_) && valid(pair_.kind_b, n.data() + fields_a_, fields_b_);
  }

  void check(const Numbers<V>& n) {
    ++cases_;
    const Said verdict = pair_.verdict(n);
    if (!verdict.overlap && !verdict.disjoint) return;
    ++decided_;
    const bool right = valid(n) && verdict.overlap != verdict.disjoint && verdict.overlap == pair_.exact(n);
    if (right || ++wrong_ > most_printed) return;
    ADD_FAILURE() << pair_.name << " decides " << (verdict.overlap ? "overlap" : "disjoint")
                  << (valid(n) ? "" : " on an invalid shape") << ", seed " << properties::seed() << ": "
                  << inputs::describe(n, fields_a_, count_);
  }

  /// Ranges of exponents about every filter's guard.
  inputs::Inputs<V> pairs(int which) {
    constexpr Exponents narrow{-3, 5, -6, 10}, middle{-10, 10, -30, 40}, wide{-25, 25, -90, 75};
    constexpr Exponents unit{-1, 0, -30, 40}, unit_ellipse{-1, 0, -9, 12};
    const Exponents& e = pair_.unit_axes ? (has_ellipse_ ? unit_ellipse : unit)
                         : which == 0    ? narrow
                         : which == 1    ? middle
                                         : wide;
    Exponents widened = inputs::widened<V>(e);
    if (pair_.unit_axes) widened.axis_low = e.axis_low, widened.axis_high = e.axis_high;
    return {pair_.kind_a, pair_.kind_b, widened, random_};
  }

  /// A pair, its axes of unit length up to a few places if the tested filter asks for that.
  Numbers<V> drawn(inputs::Inputs<V>& pairs) {
    Numbers<V> n = pairs.draw();
    if (!pair_.unit_axes || !has_ellipse_) return n;
    make_unit(pair_.kind_a, n.data());
    make_unit(pair_.kind_b, n.data() + fields_a_);
    return n;
  }
  void make_unit(Kind kind, V* shape) {
    if (kind != Kind::rect && kind != Kind::ellipse) return;
    const double x = shape[2], y = shape[3], length = std::hypot(x, y);
    shape[2] = inputs::places_from(static_cast<V>(x / length), random_.integer(-5, 5) * random_.below(2));
    shape[3] = inputs::places_from(static_cast<V>(y / length), random_.integer(-5, 5) * random_.below(2));
  }

  void mend(Numbers<V>& n) {
    inputs::mend(pair_.kind_a, n.data(), random_);
    inputs::mend(pair_.kind_b, n.data() + fields_a_, random_);
  }

  void report() const {
    std::printf("  %-24s %8d of %8d decided\n", pair_.name.c_str(), decided_, cases_);
    // Else there was little to be wrong about.
    EXPECT_GE(decided_, cases_ / 10);
  }

  static int fields(Kind kind) { return static_cast<int>(inputs::roles[static_cast<int>(kind)].size()); }

  static constexpr bool is_float = sizeof(V) == 4;
  const Tested<V>& pair_ = this->GetParam();
  const int fields_a_ = fields(pair_.kind_a), fields_b_ = fields(pair_.kind_b), count_ = fields_a_ + fields_b_;
  const bool has_ellipse_ = pair_.kind_b == Kind::ellipse;
  Random random_{properties::seed()};
  int cases_ = 0, decided_ = 0, wrong_ = 0;

  void over_the_whole_range();
  void within_the_guards();
  void about_contact();
  void none_on_invalid_shapes();
};

// Each number of its own magnitude, sizes and axes too: almost always out of one guard or another. This finds values
// that overflow under a finite bound and products that underflow unnoticed.
template <class V>
void Verdicts<V>::over_the_whole_range() {
  const int cases = (is_float ? 60'000 : 20'000) * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    Numbers<V> n{};
    // A few numbers anywhere, the rest within the guards; or all anywhere.
    const bool all = random_.chance(0.3);
    if (!all) {
      inputs::Inputs<V> drawn_from = pairs(random_.below(3));
      n = drawn(drawn_from);
    }
    for (int field = 0; field < count_; ++field) {
      if (all || random_.chance(0.15)) n[field] = inputs::any_number<V>(random_);
    }
    mend(n);
    check(n);
  }
  std::printf("  %-24s %8d of %8d decided\n", pair_.name.c_str(), decided_, cases_);
}

template <class V>
void Verdicts<V>::within_the_guards() {
  const int cases = (is_float ? 30'000 : 8'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs<V> drawn_from = pairs(which);
    for (int i = 0; i < cases; ++i) check(drawn(drawn_from));
  }
  report();
}

template <class V>
void Verdicts<V>::about_contact() {
  const int cases = (is_float ? 400 : 100) * properties::repeat();
  for (int which = 0; which < 2; ++which) {
    inputs::Inputs<V> drawn_from = pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = drawn_from.near_contact(drawn(drawn_from), pair_.exact);
      // Contact, and from there by places outwards.
      for (int k = 0; k < 10; ++k) {
        check(n);
        inputs::move_one(n, count_, random_);
        if (!valid(n)) break;
      }
    }
  }
  std::printf("  %-24s %8d of %8d decided\n", pair_.name.c_str(), decided_, cases_);
}

template <class V>
void Verdicts<V>::none_on_invalid_shapes() {
  const int cases = (is_float ? 15'000 : 10'000) * properties::repeat();
  for (int which = 0; which < 3; ++which) {
    inputs::Inputs<V> drawn_from = pairs(which);
    for (int i = 0; i < cases; ++i) {
      auto n = drawn(drawn_from);
      inputs::spoil(n, fields_a_, count_, random_);
      check(n);
    }
  }
}

template <class V>
std::vector<Tested<V>> all_tested() {
  return {
#define VESICA_TESTED(a, A, b, B) tested<A<V>, B<V>>(),
      VESICA_EACH_PAIR_OF_FORMS(VESICA_TESTED)
#undef VESICA_TESTED
          tested<Rect<V>, Rect<V>, UnitAxesFilter>(),
      tested<Circle<V>, Ellipse<V>, UnitAxesFilter>(),
      tested<Ellipse<V>, Ellipse<V>, UnitAxesFilter>(),
  };
}

template <class V>
std::string test_name(const testing::TestParamInfo<Tested<V>>& info) {
  return info.param.name;
}

using FloatVerdicts = Verdicts<float>;
TEST_P(FloatVerdicts, OverTheWholeRange) { over_the_whole_range(); }
TEST_P(FloatVerdicts, WithinTheGuards) { within_the_guards(); }
TEST_P(FloatVerdicts, AboutContact) { about_contact(); }
TEST_P(FloatVerdicts, NoneOnInvalidShapes) { none_on_invalid_shapes(); }
INSTANTIATE_TEST_SUITE_P(Pairs, FloatVerdicts, testing::ValuesIn(all_tested<float>()), test_name<float>);

using DoubleVerdicts = Verdicts<double>;
TEST_P(DoubleVerdicts, OverTheWholeRange) { over_the_whole_range(); }
TEST_P(DoubleVerdicts, WithinTheGuards) { within_the_guards(); }
TEST_P(DoubleVerdicts, AboutContact) { about_contact(); }
TEST_P(DoubleVerdicts, NoneOnInvalidShapes) { none_on_invalid_shapes(); }
INSTANTIATE_TEST_SUITE_P(Pairs, DoubleVerdicts, testing::ValuesIn(all_tested<double>()), test_name<double>);

}  // namespace
