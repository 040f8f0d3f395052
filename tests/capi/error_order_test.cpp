// SPDX-License-Identifier: Apache-2.0
// Several errors at once: vesica.h says in which order they are checked, so a call returns the first of them. Every set
// of faults, each fault in every argument that can have it.
#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "capi/face.hpp"

namespace {

using namespace capi_tests;

/// In the order of the header.
enum Fault : unsigned { null_pointer = 1, unknown_kind = 2, bad_argument = 4, invalid_shape = 8 };

std::int32_t first_of(unsigned faults) {
  if (faults & null_pointer) return VESICA_E_NULL;
  if (faults & unknown_kind) return VESICA_E_KIND;
  if (faults & bad_argument) return VESICA_E_ARGUMENT;
  return VESICA_E_SHAPE;
}

template <class T>
constexpr T valid[6] = {1, 2, 3, 4, 5, 6};
template <class T>
constexpr T negative[6] = {1, 2, 3, 4, -5, 6};

/// A call of two shapes and an output, with some of the faults: each in the argument of its place.
template <class T>
struct Call {
  struct Operand {
    std::int32_t kind;
    const T* numbers;
    typename Face<T>::Shapes shapes;
    bool absent;
    const auto* array() const { return absent ? nullptr : &shapes; }
  };
  Operand a, b;
  bool no_output, wrong;  // wrong: to be made of another argument

  template <class Out>
  Out* out(Out& to) const {
    return no_output ? nullptr : &to;
  }
};

constexpr std::int32_t operands = 2;

template <class T>
typename Call<T>::Operand operand(bool null, bool unknown, bool invalid) {
  const std::int32_t kind = unknown ? VESICA_POLYLINE + 1 : VESICA_RECT;
  const T* const numbers = invalid ? negative<T> : valid<T>;
  typename Face<T>::Shapes shapes{kind, 0, 1, sizeof(T), {}, nullptr, nullptr, 0};
  for (std::size_t k = 0; k < 6; ++k) shapes.field[k] = numbers + k;
  return {kind, null ? nullptr : numbers, shapes, null};
}

template <class T>
class ErrorOrder : public testing::Test {
 protected:
  using Result = std::int64_t (*)(const Call<T>&);

  /// `faults`, those that the function knows; `null_places`, 2 if it has no output beside its operands, else 3.
  static void expect_order(const char* name, unsigned faults, int null_places, Result ask) {
    for (unsigned chosen = 0; chosen <= faults; ++chosen) {
      if ((chosen & ~faults) != 0) continue;
      for (int place = 0; place < null_places * operands * operands; ++place) {
        const int null = place % null_places, kind = place / null_places % operands,
                  shape = place / null_places / operands;
        const auto has = [chosen](Fault fault) { return (chosen & fault) != 0; };
        const auto make = [&](int i) {
          return operand<T>(has(null_pointer) && null == i, has(unknown_kind) && kind == i,
                            has(invalid_shape) && shape == i);
        };
        const std::int64_t answer = ask({make(0), make(1), has(null_pointer) && null == 2, has(bad_argument)});
        if (chosen == 0) {
          EXPECT_GE(answer, 0) << name;
        } else {
          EXPECT_EQ(answer, first_of(chosen)) << name << ", faults " << chosen << ", places " << place;
        }
      }
    }
  }
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(ErrorOrder, Scalars);

constexpr unsigned of_shapes = null_pointer | unknown_kind | invalid_shape, all = of_shapes | bad_argument;

TYPED_TEST(ErrorOrder, OfTwoShapes) {
  using T = TypeParam;
  using F = Face<T>;
  this->expect_order("overlap", of_shapes, 2, [](const Call<T>& c) -> std::int64_t {
    return F::overlap(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers);
  });
  this->expect_order("interiors_overlap", of_shapes, 2, [](const Call<T>& c) -> std::int64_t {
    return F::interiors_overlap(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers);
  });
  this->expect_order("relation", of_shapes, 2, [](const Call<T>& c) -> std::int64_t {
    return F::relation(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers);
  });
  this->expect_order("nearest", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Points points;
    return F::nearest(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(points));
  });
  this->expect_order("depth", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Penetration penetration;
    return F::depth(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(penetration));
  });
  this->expect_order("area", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    T area;
    return F::area(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(area));
  });
  this->expect_order("crossings", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Crossings crossings;
    return F::crossings(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(crossings));
  });
  this->expect_order("signed_distance", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    T distance;
    return F::signed_distance(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(distance));
  });
  this->expect_order("manifold", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Contacts contacts;
    return F::manifold(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(contacts));
  });
  this->expect_order("de9im", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    char matrix[VESICA_DE9IM_SIZE];
    return F::de9im(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(matrix[0]));
  });
  this->expect_order("intersection", of_shapes, 3, [](const Call<T>& c) -> std::int64_t {
    T vertices[16];
    return F::intersection(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(vertices[0]));
  });
}

TYPED_TEST(ErrorOrder, OfTwoShapesAndANumber) {
  using T = TypeParam;
  using F = Face<T>;
  this->expect_order("ratio", all, 3, [](const Call<T>& c) -> std::int64_t {
    T ratio;
    return F::ratio(c.wrong ? 99 : VESICA_RATIO_OVER_UNION, c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, c.out(ratio));
  });
  this->expect_order("within", all, 2, [](const Call<T>& c) -> std::int64_t {
    return F::within(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers,
                     c.wrong ? std::numeric_limits<T>::quiet_NaN() : T(1));
  });
  this->expect_order("cast", all, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Impact impact;
    return F::cast(c.a.kind, c.a.numbers, c.b.kind, c.b.numbers, 1, 0, static_cast<T>(c.wrong ? -1 : 1), c.out(impact));
  });
  this->expect_order("impact_time", all, 3, [](const Call<T>& c) -> std::int64_t {
    const typename F::Turn turn{1, 0, 1};
    typename F::Impact impact;
    T gap;
    return F::impact_time(c.a.kind, c.a.numbers, &turn, c.b.kind, c.b.numbers, &turn, static_cast<T>(c.wrong ? 0 : 0.5),
                          c.out(impact), &gap);
  });
}

/// An argument is wrong here as an array, and others as a number beside the arrays.
TYPED_TEST(ErrorOrder, OfTwoArrays) {
  using T = TypeParam;
  using F = Face<T>;
  this->expect_order("overlap_many", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.a.shapes.reserved = c.wrong;
    std::uint8_t byte;
    return F::overlap_many(d.a.array(), d.b.array(), c.out(byte));
  });
  this->expect_order("interiors_overlap_many", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.a.shapes.reserved = c.wrong;
    std::uint8_t byte;
    return F::interiors_overlap_many(d.a.array(), d.b.array(), c.out(byte));
  });
  this->expect_order("overlap_many, counts", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    if (c.wrong) d.b.shapes.count = -1;
    std::uint8_t byte;
    return F::overlap_many(d.a.array(), d.b.array(), c.out(byte));
  });
  this->expect_order("area_many", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.b.shapes.reserved = c.wrong;
    T area;
    return F::area_many(d.a.array(), d.b.array(), c.out(area));
  });
  this->expect_order("overlap_matrix", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.a.shapes.reserved = c.wrong;
    std::uint8_t byte;
    return F::overlap_matrix(d.a.array(), d.b.array(), c.out(byte), 1);
  });
  this->expect_order("interiors_overlap_matrix", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.a.shapes.reserved = c.wrong;
    std::uint8_t byte;
    return F::interiors_overlap_matrix(d.a.array(), d.b.array(), c.out(byte), 1);
  });
  this->expect_order("overlap_select", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.b.shapes.reserved = c.wrong;
    std::int64_t index;
    return F::overlap_select(d.a.array(), d.b.array(), c.out(index), 1);
  });
  this->expect_order("interiors_overlap_select", all, 3, [](const Call<T>& c) -> std::int64_t {
    Call<T> d = c;
    d.b.shapes.reserved = c.wrong;
    std::int64_t index;
    return F::interiors_overlap_select(d.a.array(), d.b.array(), c.out(index), 1);
  });
  this->expect_order("ratio_many", all, 3, [](const Call<T>& c) -> std::int64_t {
    T ratio;
    return F::ratio_many(c.wrong ? 99 : VESICA_RATIO_OVER_UNION, c.a.array(), c.b.array(), c.out(ratio));
  });
  this->expect_order("ratio_matrix", all, 3, [](const Call<T>& c) -> std::int64_t {
    T ratio;
    return F::ratio_matrix(c.wrong ? 99 : VESICA_RATIO_OVER_UNION, c.a.array(), c.b.array(), c.out(ratio), 1);
  });
  this->expect_order("within_many", all, 3, [](const Call<T>& c) -> std::int64_t {
    std::uint8_t byte;
    return F::within_many(c.a.array(), c.b.array(), c.wrong ? std::numeric_limits<T>::quiet_NaN() : T(1), c.out(byte));
  });
  this->expect_order("cast_many", all, 2, [](const Call<T>& c) -> std::int64_t {
    const T velocity = 1;
    T t;
    return F::cast_many(c.a.array(), c.b.array(), &velocity, &velocity, 0, static_cast<T>(c.wrong ? -1 : 1), &t,
                        nullptr, nullptr, nullptr, nullptr);
  });
  this->expect_order("cast_many, velocities", all, 3, [](const Call<T>& c) -> std::int64_t {
    const T velocity = 1;
    T t;
    return F::cast_many(c.a.array(), c.b.array(), &velocity, c.out(velocity), 0, static_cast<T>(c.wrong ? -1 : 1), &t,
                        nullptr, nullptr, nullptr, nullptr);
  });
  this->expect_order("cast_first", all, 3, [](const Call<T>& c) -> std::int64_t {
    typename F::Impact impact;
    return F::cast_first(c.a.array(), c.b.array(), 1, 0, static_cast<T>(c.wrong ? -1 : 1), c.out(impact));
  });
}

/// With one shape or array there is no second operand: its faults are those of the first.
TYPED_TEST(ErrorOrder, OfOneShapeOrArray) {
  using T = TypeParam;
  using F = Face<T>;
  for (unsigned chosen = 1; chosen <= all; ++chosen) {
    const auto has = [chosen](Fault fault) { return (chosen & fault) != 0; };
    for (const bool no_output : {false, true}) {
      const bool null = has(null_pointer);
      const auto one = operand<T>(null && !no_output, has(unknown_kind), has(invalid_shape));
      const Call<T> c{one, one, null && no_output, has(bad_argument)};
      const T end = c.wrong ? std::numeric_limits<T>::quiet_NaN() : T{1}, score = 1;
      typename F::Aabb box;
      EXPECT_EQ(F::sweep_bounds(one.kind, one.numbers, 1, 0, end, c.out(box)), first_of(chosen)) << chosen;
      std::vector<char> scratch(static_cast<std::size_t>(vesica_nms_scratch(1)));
      std::int64_t keep, kept;
      EXPECT_EQ(
          F::nms(one.array(), &score, T{0.5}, scratch.data(), c.wrong ? 1 : vesica_nms_scratch(1), &keep, c.out(kept)),
          first_of(chosen))
          << chosen;
      T corners[5];
      EXPECT_EQ(F::boxes_from_shapes(one.array(), c.wrong ? 99 : VESICA_ANGLE_RADIANS, c.out(corners[0])),
                first_of(chosen))
          << chosen;
      if (c.wrong) continue;
      EXPECT_EQ(F::bounds(one.kind, one.numbers, c.out(box)), first_of(chosen)) << chosen;
      EXPECT_EQ(F::shape_area(one.kind, one.numbers, c.out(corners[0])), first_of(chosen)) << chosen;
    }
  }
}

/// A kind that a function does not support is reported before faults of the array.
TYPED_TEST(ErrorOrder, OfKindsThatAFunctionDoesNotTake) {
  using T = TypeParam;
  using F = Face<T>;
  const T score = 1;
  T numbers[8];
  alignas(8) unsigned char scratch[1 << 12];
  std::int64_t keep, kept;
  for (const int wrong : {0, 1, 2}) {
    for (const bool no_output : {false, true}) {
      auto point = operand<T>(false, false, false).shapes;
      point.kind = VESICA_POINT;
      if (wrong == 1) point.count = -1;
      if (wrong == 2) point.reserved = 1;
      const std::int64_t error = no_output ? VESICA_E_NULL : VESICA_E_KIND;
      auto without_field = operand<T>(false, false, false).shapes;
      without_field.field[5] = nullptr;
      EXPECT_EQ(F::corners_of_shapes(&without_field, numbers), VESICA_E_NULL);
      T* const to = no_output ? nullptr : numbers;
      std::int64_t* const to_kept = no_output ? nullptr : &kept;
      EXPECT_EQ(F::boxes_from_shapes(&point, VESICA_ANGLE_RADIANS, to), error) << wrong;
      EXPECT_EQ(F::corners_of_shapes(&point, to), error) << wrong;
      EXPECT_EQ(F::nms(&point, &score, T{0.5}, scratch, sizeof scratch, &keep, to_kept), error) << wrong;
      EXPECT_EQ(F::suppress(&point, &score, nullptr, VESICA_RATIO_OVER_UNION, T{0.5}, 0, 1, scratch, sizeof scratch,
                            &keep, to_kept),
                error)
          << wrong;
      EXPECT_EQ(F::suppress_soft(&point, &score, nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, T{0.5}, 0, 1,
                                 scratch, sizeof scratch, &keep, numbers, to_kept),
                error)
          << wrong;
    }
  }
}

/// An index, and a shape to look for in it without its sets.
TYPED_TEST(ErrorOrder, OfAnIndex) {
  using T = TypeParam;
  using F = Face<T>;
  alignas(64) static unsigned char index[1 << 17], built[1 << 17], scratch[1 << 19];
  ASSERT_LE(vesica_index_size(1), std::int64_t{sizeof index});
  ASSERT_LE(vesica_index_scratch(1), std::int64_t{sizeof scratch});
  const auto set = operand<T>(false, false, false);
  ASSERT_GT(F::index_build(set.array(), 1, built, sizeof built, scratch, sizeof scratch), 0);
  for (unsigned chosen = 1; chosen <= all; ++chosen) {
    const auto has = [chosen](Fault fault) { return (chosen & fault) != 0; };
    for (const bool no_output : {false, true}) {
      const bool null = has(null_pointer), wrong = has(bad_argument);
      const auto one = operand<T>(null && !no_output, has(unknown_kind), has(invalid_shape));
      void* const to = null && no_output ? nullptr : index;
      EXPECT_EQ(F::index_build(one.array(), 1, to, wrong ? 1 : sizeof index, scratch, sizeof scratch), first_of(chosen))
          << chosen;
      std::int64_t item, state[4] = {};
      EXPECT_EQ(
          F::index_select(built, nullptr, wrong ? 1 : 0, one.array(), null && no_output ? nullptr : &item, 1, state),
          first_of(chosen))
          << chosen;
      const auto* const sets = null && !no_output ? nullptr : set.array();
      EXPECT_EQ(F::index_cast(built, sets, 1, one.array(), 1, 0, 1, null && no_output ? nullptr : &item, wrong ? -1 : 1,
                              state),
                null && no_output && wrong ? first_of(chosen & ~null_pointer) : first_of(chosen))
          << chosen;
      std::int64_t wrong_state[4] = {wrong ? -7 : 0};
      EXPECT_EQ(
          F::index_cast(built, sets, 1, one.array(), 1, 0, 1, null && no_output ? nullptr : &item, 1, wrong_state),
          first_of(chosen))
          << chosen;
      T distance;
      std::int64_t* const item_or_null = null && no_output ? nullptr : &item;
      EXPECT_EQ(F::index_nearest(built, sets, 1, one.array(), 1, T(wrong ? -1 : 1), item_or_null, &distance),
                first_of(chosen))
          << chosen;
      EXPECT_EQ(F::join_nearest(one.array(), 1, built, sets, 1, 1, T(wrong ? -1 : 1), 0, 1, item_or_null, &distance),
                first_of(chosen))
          << chosen;
      if (has(invalid_shape)) continue;  // of the other side
      EXPECT_EQ(F::join_within(built, sets, 1, built, one.array(), 1,
                               wrong ? std::numeric_limits<T>::quiet_NaN() : T(1), 0, 1, item_or_null, &item, 1, state),
                first_of(chosen))
          << chosen;
      EXPECT_EQ(F::join(wrong ? 99 : VESICA_JOIN_OVERLAP, built, sets, 1, built, one.array(), 1, 0, 1,
                        null && no_output ? nullptr : scratch, sizeof scratch, &item, &item, 1, state),
                first_of(chosen))
          << chosen;
    }
  }
}

}  // namespace
