// SPDX-License-Identifier: Apache-2.0
// Every invalid input, in every field of every kind, in both scalars, through every function that takes shapes.
#include <gtest/gtest.h>

#include <bit>
#include <cerrno>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "capi/typed_pairs.hpp"

namespace {

template <class T>
using Numbers = std::array<T, 6>;

template <class T>
struct Limits : std::numeric_limits<T> {
  static constexpr T largest = std::numeric_limits<T>::max();
  static constexpr T smallest = std::numeric_limits<T>::denorm_min();
  static constexpr T normal = std::numeric_limits<T>::min();
  static constexpr T inf = std::numeric_limits<T>::infinity();
};

constexpr std::int32_t all_kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,
                                      VESICA_AABB,  VESICA_RECT,    VESICA_ELLIPSE};
// Neighbours of the range, its extremes, and numbers that fit once cut to 8 or 16 bits.
constexpr std::int32_t unknown_kinds[] = {-1, VESICA_POLYLINE + 1, INT32_MIN, INT32_MAX, 256, 65537, -252};

bool has_axis(std::int32_t kind) { return kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

/// Positions of radius, half extents and half lengths.
std::vector<std::size_t> size_fields(std::int32_t kind) {
  if (kind == VESICA_CIRCLE) return {2};
  return has_axis(kind) ? std::vector<std::size_t>{4, 5} : std::vector<std::size_t>{};
}

/// Valid shapes of a kind: around (3, 4), and without size at (1e30, 1e30), far from the first one.
template <class T>
std::array<Numbers<T>, 2> valid_shapes(std::int32_t kind) {
  constexpr T far = static_cast<T>(1e30);
  switch (kind) {
    case VESICA_CIRCLE:
      return {{{3, 4, 2}, {far, far, 0}}};
    case VESICA_RECT:
    case VESICA_ELLIPSE:
      return {{{3, 4, 3, 4, 2, 1}, {far, far, 3, 4, 0, 0}}};
    default:
      return {{{3, 4, 5, 6}, {far, far, far, far}}};
  }
}

template <class T>
std::vector<T> not_finite() {
  using Bits = std::conditional_t<std::is_same_v<T, double>, std::uint64_t, std::uint32_t>;
  const Bits infinity = std::bit_cast<Bits>(Limits<T>::inf);
  const Bits sign = std::bit_cast<Bits>(T{-0.0});
  const Bits signalling = infinity | 1;
  const Bits quiet = std::bit_cast<Bits>(Limits<T>::quiet_NaN());
  std::vector<T> result;
  for (Bits bits : {infinity, signalling, quiet, quiet | 1}) {
    result.push_back(std::bit_cast<T>(bits));
    result.push_back(std::bit_cast<T>(static_cast<Bits>(bits | sign)));
  }
  return result;
}

template <class T>
struct Invalid {
  Numbers<T> numbers;
  std::int32_t rule;
};

template <class T>
void add_not_finite(std::int32_t kind, const Numbers<T>& base, std::vector<Invalid<T>>& out) {
  const auto count = static_cast<std::size_t>(vesica_field_count(kind));
  for (std::size_t field = 0; field < count; ++field) {
    for (const T& bad : not_finite<T>()) {
      Numbers<T> shape = base;
      shape[field] = bad;
      out.push_back({shape, VESICA_E_NOT_FINITE});
      // Another rule broken as well does not change the report.
      if (has_axis(kind)) shape[field == 4 ? 5 : 4] = -1;
      if (kind == VESICA_CIRCLE && field != 2) shape[2] = -1;
      out.push_back({shape, VESICA_E_NOT_FINITE});
    }
  }
  // No sum and no product of them is NaN.
  Numbers<T> shape = base;
  for (std::size_t field = 0; field < count; ++field) shape[field] = Limits<T>::inf;
  out.push_back({shape, VESICA_E_NOT_FINITE});
}

template <class T>
void add_negative_sizes(std::int32_t kind, const Numbers<T>& base, std::vector<Invalid<T>>& out) {
  for (std::size_t field : size_fields(kind)) {
    for (T bad : {T{-1}, -Limits<T>::smallest, -Limits<T>::normal, -Limits<T>::largest}) {
      Numbers<T> shape = base;
      shape[field] = bad;
      out.push_back({shape, VESICA_E_NEGATIVE_SIZE});
      if (has_axis(kind)) shape[2] = shape[3] = 0;
      out.push_back({shape, VESICA_E_NEGATIVE_SIZE});
    }
  }
}

template <class T>
void add_zero_axes(std::int32_t kind, const Numbers<T>& base, std::vector<Invalid<T>>& out) {
  if (!has_axis(kind)) return;
  for (T ux : {T{0}, -T{0}}) {
    for (T uy : {T{0}, -T{0}}) {
      Numbers<T> shape = base;
      shape[2] = ux;
      shape[3] = uy;
      out.push_back({shape, VESICA_E_ZERO_AXIS});
    }
  }
}

/// min one representable number above max, at ordinary, subnormal and extreme values, in x and in y.
template <class T>
void add_inverted(std::int32_t kind, const Numbers<T>& base, std::vector<Invalid<T>>& out) {
  if (kind != VESICA_AABB) return;
  constexpr T tiny = Limits<T>::smallest, normal = Limits<T>::normal, big = Limits<T>::largest;
  constexpr T below_big = big * (1 - Limits<T>::epsilon() / 2);
  static_assert(below_big < big && below_big + (big - below_big) / 2 == below_big, "nothing lies between them");
  const std::array<T, 2> neighbours[] = {{1, 1 + Limits<T>::epsilon()},
                                         {0, tiny},
                                         {-T{0}, tiny},
                                         {-tiny, 0},
                                         {-tiny, -T{0}},
                                         {tiny, 2 * tiny},
                                         {-2 * tiny, -tiny},
                                         {normal - tiny, normal},
                                         {normal, normal + tiny},
                                         {below_big, big},
                                         {-big, -below_big}};
  for (const auto& [max, min] : neighbours) {
    for (std::size_t axis : {0u, 1u}) {
      Numbers<T> shape = base;
      shape[axis] = min;
      shape[axis + 2] = max;
      out.push_back({shape, VESICA_E_INVERTED});
    }
  }
  out.push_back({{1, 1, -1, -1}, VESICA_E_INVERTED});
}

template <class T>
std::vector<Invalid<T>> invalid_shapes(std::int32_t kind) {
  std::vector<Invalid<T>> result;
  for (const Numbers<T>& base : valid_shapes<T>(kind)) {
    add_not_finite(kind, base, result);
    add_negative_sizes(kind, base, result);
    add_zero_axes(kind, base, result);
    add_inverted(kind, base, result);
  }
  return result;
}

/// Numbers at the edge of what is valid.
template <class T>
std::vector<Numbers<T>> barely_valid(std::int32_t kind) {
  constexpr T big = Limits<T>::largest, tiny = Limits<T>::smallest;
  switch (kind) {
    case VESICA_POINT:
      return {{-0.0, -0.0}, {big, -big}, {tiny, -tiny}};
    case VESICA_SEGMENT:
      return {{-0.0, 0, 0, -0.0}, {big, -big, -big, big}, {tiny, 0, 0, tiny}};
    case VESICA_CIRCLE:
      return {{3, 4, -0.0}, {big, -big, big}, {0, 0, tiny}};
    case VESICA_AABB:
      return {{0, 0, -0.0, -0.0}, {-big, -big, big, big}, {0, 0, tiny, tiny}, {-tiny, 0, 0, tiny}};
    default:
      return {{3, 4, 3, 4, -0.0, -0.0},
              {0, 0, tiny, 0, 1, 1},
              {0, 0, -0.0, -tiny, 1, 1},
              {0, 0, 0, 1, tiny, -0.0},
              {big, big, big, big, big, big}};
  }
}

template <class T>
std::string text(std::int32_t kind, const Numbers<T>& numbers) {
  std::string result = vesica_kind_name(kind);
  for (int i = 0; i < vesica_field_count(kind); ++i) {
    result += ' ' + ::testing::PrintToString(numbers[static_cast<std::size_t>(i)]);
  }
  return result;
}

/// The library never prints and never sets errno, whatever it is given.
template <class T>
class CapiErrors : public ::testing::Test {
 protected:
  void SetUp() override {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    errno = EXDEV;
  }
  void TearDown() override {
    const int error_number = errno;
    const std::string out = ::testing::internal::GetCapturedStdout();
    const std::string err = ::testing::internal::GetCapturedStderr();
    if (HasFailure()) {
      std::cout << out << err;  // The report of the failure itself.
      return;
    }
    EXPECT_EQ(out, "");
    EXPECT_EQ(err, "");
    EXPECT_EQ(error_number, EXDEV);
  }
};

using Scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(CapiErrors, Scalars);

/// Overlap by kind in both orders and typed, where the two are in the order of shapes.
template <class T>
void expect_overlap_error(std::int32_t kind_a, const T* a, std::int32_t kind_b, const T* b, std::int32_t error) {
  ASSERT_EQ(capi::Api<T>::overlap(kind_a, a, kind_b, b), error);
  ASSERT_EQ(capi::Api<T>::overlap(kind_b, b, kind_a, a), error);
  for (const capi::TypedPair<T>& pair : capi::Api<T>::typed_pairs) {
    if (pair.kind_a == kind_a && pair.kind_b == kind_b) {
      ASSERT_EQ(pair.overlap(a, b), error);
    }
    if (pair.kind_a == kind_b && pair.kind_b == kind_a) {
      ASSERT_EQ(pair.overlap(b, a), error);
    }
  }
}

TYPED_TEST(CapiErrors, CheckNamesTheFirstRuleBroken) {
  for (std::int32_t kind : all_kinds) {
    for (const auto& bad : invalid_shapes<TypeParam>(kind)) {
      ASSERT_EQ(capi::Api<TypeParam>::check(kind, bad.numbers.data()), bad.rule) << text(kind, bad.numbers);
    }
  }
}

TYPED_TEST(CapiErrors, CheckAcceptsValidShapes) {
  for (std::int32_t kind : all_kinds) {
    for (const auto& good : valid_shapes<TypeParam>(kind)) {
      EXPECT_EQ(capi::Api<TypeParam>::check(kind, good.data()), 0) << text(kind, good);
    }
    for (const auto& good : barely_valid<TypeParam>(kind)) {
      EXPECT_EQ(capi::Api<TypeParam>::check(kind, good.data()), 0) << text(kind, good);
    }
  }
}

TYPED_TEST(CapiErrors, ValidShapesOverlapThemselves) {
  for (std::int32_t kind : all_kinds) {
    for (const auto& good : barely_valid<TypeParam>(kind)) {
      SCOPED_TRACE(text(kind, good));
      expect_overlap_error<TypeParam>(kind, good.data(), kind, good.data(), 1);
    }
  }
}

// Near a partner and far from it: an answer that is plain whatever the bad number means is still an error.
TYPED_TEST(CapiErrors, InvalidNextToValid) {
  for (std::int32_t kind : all_kinds) {
    for (const auto& bad : invalid_shapes<TypeParam>(kind)) {
      for (std::int32_t partner : all_kinds) {
        for (const auto& good : valid_shapes<TypeParam>(partner)) {
          expect_overlap_error<TypeParam>(kind, bad.numbers.data(), partner, good.data(), VESICA_E_SHAPE);
          if (this->HasFatalFailure()) FAIL() << text(kind, bad.numbers) << " and " << text(partner, good);
        }
      }
    }
  }
}

TYPED_TEST(CapiErrors, BothInvalid) {
  for (std::int32_t kind_a : all_kinds) {
    for (std::int32_t kind_b : all_kinds) {
      const auto bad_b = invalid_shapes<TypeParam>(kind_b);
      std::size_t i = 0;
      for (const auto& a : invalid_shapes<TypeParam>(kind_a)) {
        const auto& b = bad_b[i++ % bad_b.size()];
        expect_overlap_error<TypeParam>(kind_a, a.numbers.data(), kind_b, b.numbers.data(), VESICA_E_SHAPE);
        if (this->HasFatalFailure()) FAIL() << text(kind_a, a.numbers) << " and " << text(kind_b, b.numbers);
      }
    }
  }
}

TYPED_TEST(CapiErrors, NullComesFirst) {
  using T = TypeParam;
  for (std::int32_t kind : all_kinds) {
    const Numbers<T> bad = invalid_shapes<T>(kind)[0].numbers;
    const Numbers<T> good = valid_shapes<T>(kind)[0];
    EXPECT_EQ(capi::Api<T>::check(kind, nullptr), VESICA_E_NULL);
    for (std::int32_t partner : all_kinds) {
      expect_overlap_error<T>(kind, nullptr, partner, nullptr, VESICA_E_NULL);
      expect_overlap_error<T>(kind, good.data(), partner, nullptr, VESICA_E_NULL);
      expect_overlap_error<T>(kind, bad.data(), partner, nullptr, VESICA_E_NULL);
    }
    for (std::int32_t unknown : unknown_kinds) {
      EXPECT_EQ(capi::Api<T>::check(unknown, nullptr), VESICA_E_NULL);
      expect_overlap_error<T>(kind, bad.data(), unknown, nullptr, VESICA_E_NULL);
      expect_overlap_error<T>(kind, nullptr, unknown, good.data(), VESICA_E_NULL);
    }
  }
}

// A kind is looked at before the numbers, of either argument.
TYPED_TEST(CapiErrors, KindComesBeforeShape) {
  using T = TypeParam;
  const Numbers<T> nan = invalid_shapes<T>(VESICA_RECT)[0].numbers;
  for (std::int32_t unknown : unknown_kinds) {
    EXPECT_EQ(capi::Api<T>::check(unknown, nan.data()), VESICA_E_KIND);
    expect_overlap_error<T>(unknown, nan.data(), unknown, nan.data(), VESICA_E_KIND);
    for (std::int32_t kind : all_kinds) {
      expect_overlap_error<T>(kind, invalid_shapes<T>(kind)[0].numbers.data(), unknown, nan.data(), VESICA_E_KIND);
      expect_overlap_error<T>(kind, valid_shapes<T>(kind)[0].data(), unknown, nan.data(), VESICA_E_KIND);
    }
  }
}

/// Bounds must report the error and leave the box as it was.
template <class T>
void expect_bounds_error(std::int32_t kind, const T* numbers, std::int32_t error) {
  using Box = typename capi::Api<T>::Box;
  const Box before{1, -2, 3, static_cast<T>(-4.5)};
  Box box = before;
  ASSERT_EQ(capi::Api<T>::bounds(kind, numbers, &box), error);
  ASSERT_EQ(std::memcmp(&box, &before, sizeof box), 0) << "output written on error";
}

TYPED_TEST(CapiErrors, BoundsOfInvalidShapes) {
  for (std::int32_t kind : all_kinds) {
    for (const auto& bad : invalid_shapes<TypeParam>(kind)) {
      expect_bounds_error<TypeParam>(kind, bad.numbers.data(), VESICA_E_SHAPE);
      if (this->HasFatalFailure()) FAIL() << text(kind, bad.numbers);
    }
  }
}

TYPED_TEST(CapiErrors, BoundsArgumentsInOrder) {
  using T = TypeParam;
  for (std::int32_t kind : all_kinds) {
    const Numbers<T> bad = invalid_shapes<T>(kind)[0].numbers;
    const Numbers<T> good = valid_shapes<T>(kind)[0];
    expect_bounds_error<T>(kind, nullptr, VESICA_E_NULL);
    EXPECT_EQ(capi::Api<T>::bounds(kind, nullptr, nullptr), VESICA_E_NULL);
    EXPECT_EQ(capi::Api<T>::bounds(kind, good.data(), nullptr), VESICA_E_NULL);
    EXPECT_EQ(capi::Api<T>::bounds(kind, bad.data(), nullptr), VESICA_E_NULL);
    for (std::int32_t unknown : unknown_kinds) {
      expect_bounds_error<T>(unknown, bad.data(), VESICA_E_KIND);
      expect_bounds_error<T>(unknown, nullptr, VESICA_E_NULL);
      EXPECT_EQ(capi::Api<T>::bounds(unknown, good.data(), nullptr), VESICA_E_NULL);
    }
  }
}

// Valid shapes that reach beyond the finite range.
TYPED_TEST(CapiErrors, BoundsOutOfRange) {
  using T = TypeParam;
  constexpr T big = Limits<T>::largest;
  const Numbers<T> circle = {0, -big, big};
  const Numbers<T> wide = {0, 0, 2, 0, big, 1};
  const Numbers<T> high = {0, big, 1, 0, 1, big};
  expect_bounds_error<T>(VESICA_CIRCLE, circle.data(), VESICA_E_RANGE);
  expect_bounds_error<T>(VESICA_RECT, wide.data(), VESICA_E_RANGE);
  expect_bounds_error<T>(VESICA_RECT, high.data(), VESICA_E_RANGE);
  expect_bounds_error<T>(VESICA_ELLIPSE, wide.data(), VESICA_E_RANGE);
  expect_bounds_error<T>(VESICA_ELLIPSE, high.data(), VESICA_E_RANGE);
}

}  // namespace
