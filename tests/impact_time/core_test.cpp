// SPDX-License-Identifier: Apache-2.0
// The header's own impact_time(), which the library does not call: it has the bits of the C function.
#include <gtest/gtest.h>

#include <cmath>
#include <vesica/impact_time.hpp>

#include "impact_time/face.hpp"
#include "properties/core_shape.hpp"

namespace core_test {
namespace {

using impact_time_test::Answer;
using impact_time_test::Style;
using impact_time_test::Turning;
using properties::shape_of;
using namespace vesica;

/// Equal, or both NaN, as after a miss.
void expect_same(double found, double wanted) {
  if (std::isnan(wanted)) {
    EXPECT_TRUE(std::isnan(found));
  } else {
    EXPECT_EQ(found, wanted);
  }
}

template <class T>
vesica::Turn<T> turn(const impact_time_test::Turn& t) {
  return {static_cast<T>(t.vx), static_cast<T>(t.vy), static_cast<T>(t.angle)};
}

template <class T>
constexpr properties::Scalar scalar = sizeof(T) == 8 ? properties::Scalar::f64 : properties::Scalar::f32;

/// Returns the code.
template <template <class> class A, template <class> class B, class T>
int expect_same_answer(const Turning& s) {
  SCOPED_TRACE(describe(s));
  const Answer wanted = impact_time_test::impact_time(scalar<T>, s);
  Impact<T> found{7, 7, 7, 7, 7};
  T gap = 7;
  const int code = impact_time_or_error(shape_of<A<T>, T>(s.pair.a), turn<T>(s.a), shape_of<B<T>, T>(s.pair.b),
                                        turn<T>(s.b), static_cast<T>(s.tolerance), found, gap);
  EXPECT_EQ(code, wanted.code);
  if (code < 0 || code != wanted.code) return code;
  expect_same(static_cast<double>(found.t), wanted.t);
  expect_same(static_cast<double>(found.x), wanted.x);
  expect_same(static_cast<double>(found.y), wanted.y);
  expect_same(static_cast<double>(found.nx), wanted.nx);
  expect_same(static_cast<double>(found.ny), wanted.ny);
  expect_same(static_cast<double>(gap), wanted.gap);
  return code;
}

template <template <class> class A, template <class> class B, class T>
void expect_same_answers() {
  constexpr int kind_a = static_cast<int>(ShapeTraits<A<T>>::kind), kind_b = static_cast<int>(ShapeTraits<B<T>>::kind);
  int count[4] = {};
  properties::Random random(properties::seed() + 43);
  for (const Style style : {Style::plain, Style::needles, Style::close, Style::still}) {
    for (int i = 0; i < 40 * properties::repeat(); ++i) {
      Turning s = draw(kind_a, kind_b, style, 6.3, random);
      s.pair.a = properties::nearest_shape(scalar<T>, kind_a, s.pair.a);
      s.pair.b = properties::nearest_shape(scalar<T>, kind_b, s.pair.b);
      const int code = expect_same_answer<A, B, T>(s);
      if (testing::Test::HasFailure()) return;
      if (code >= 0) ++count[code];
    }
  }
  EXPECT_GT(count[cast_miss], 0);
  EXPECT_GT(count[cast_hit], 0);
  EXPECT_GT(count[cast_start], 0);
}

TEST(ImpactTimeOfTheHeader, HasTheBitsOfTheLibrary) {
  expect_same_answers<Rect, Ellipse, double>();
  expect_same_answers<Ellipse, Circle, float>();
}

}  // namespace
}  // namespace core_test
