// SPDX-License-Identifier: Apache-2.0
// Batches with wrong arguments, or arguments that ask for nothing: the documented result, and an output that
// was not touched. The scene is small enough for literal answers: a disc of radius 2 about the origin, and points.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vesica/shapes.hpp>

#include "capi/face.hpp"

namespace {

constexpr std::uint8_t untouched = 0xA5;
constexpr std::int64_t unwritten = -77;
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
constexpr std::ptrdiff_t farthest = std::numeric_limits<std::ptrdiff_t>::max();
constexpr std::ptrdiff_t farthest_back = std::numeric_limits<std::ptrdiff_t>::min();

template <class T>
class BatchArguments : public testing::Test {
 protected:
  using Face = capi_tests::Face<T>;
  using Shapes = typename Face::Shapes;

  static Shapes columns(std::int32_t kind, std::int64_t count, std::initializer_list<const T*> fields) {
    Shapes shapes{kind, 0, count, sizeof(T), {}, nullptr, nullptr, 0};
    std::size_t k = 0;
    for (const T* field : fields) shapes.field[k++] = field;
    return shapes;
  }

  std::int64_t many(const Shapes* a, const Shapes* b) { return Face::overlap_many(a, b, out_.data()); }
  std::int64_t matrix(const Shapes& a, const Shapes& b, std::ptrdiff_t row_stride) {
    return Face::overlap_matrix(&a, &b, out_.data(), row_stride);
  }
  std::int64_t select(const Shapes& one, const Shapes& shapes, std::int64_t capacity) {
    return Face::overlap_select(&one, &shapes, indices_.data(), capacity);
  }

  /// All three functions refuse the array `wrong`, whichever argument it is, and write nothing.
  void expect_refused(const Shapes& wrong, std::int32_t error) {
    EXPECT_EQ(many(&wrong, &disc_), error);
    EXPECT_EQ(many(&disc_, &wrong), error);
    EXPECT_EQ(matrix(wrong, disc_, 8), error);
    EXPECT_EQ(matrix(disc_, wrong, 8), error);
    EXPECT_EQ(select(disc_, wrong, 4), error);
    EXPECT_EQ(select(wrong, points_, 4), error);
    expect_untouched();
  }

  void expect_untouched() const {
    for (const std::uint8_t byte : out_) ASSERT_EQ(byte, untouched);
    for (const std::int64_t index : indices_) ASSERT_EQ(index, unwritten);
  }

  /// The first bytes, then the first indices, that a call wrote; the rest is as it was.
  void expect_bytes(std::initializer_list<int> bytes) {
    std::size_t i = 0;
    for (const int byte : bytes) EXPECT_EQ(out_[i++], byte);
    for (; i < out_.size(); ++i) EXPECT_EQ(out_[i], untouched);
    out_.fill(untouched);
  }
  void expect_indices(std::initializer_list<std::int64_t> indices) {
    std::size_t i = 0;
    for (const std::int64_t index : indices) EXPECT_EQ(indices_[i++], index);
    for (; i < indices_.size(); ++i) EXPECT_EQ(indices_[i], unwritten);
    indices_.fill(unwritten);
  }

  static constexpr T not_a_number = std::numeric_limits<T>::quiet_NaN();
  std::array<T, 1> zero_{0}, two_{2};
  std::array<T, 4> x_{0, 2, 3, -1}, y_{0, 0, 0, 1};  // in, on, outside, in
  std::array<T, 4> spoilt_{0, not_a_number, 3, -1};
  Shapes disc_ = columns(VESICA_CIRCLE, 1, {zero_.data(), zero_.data(), two_.data()});
  Shapes points_ = columns(VESICA_POINT, 4, {x_.data(), y_.data()});
  Shapes spoilt_points_ = columns(VESICA_POINT, 4, {spoilt_.data(), y_.data()});
  Shapes nothing_{VESICA_RECT, 0, 0, 0, {}, nullptr, nullptr, 0};
  std::array<std::uint8_t, 32> out_ = filled<std::uint8_t, 32>(untouched);
  std::array<std::int64_t, 8> indices_ = filled<std::int64_t, 8>(unwritten);

 private:
  template <class Element, std::size_t n>
  static std::array<Element, n> filled(Element value) {
    std::array<Element, n> result;
    result.fill(value);
    return result;
  }
};

using Scalars = testing::Types<float, double>;
class ScalarNames {
 public:
  template <class T>
  static std::string GetName(int) {
    return sizeof(T) == sizeof(float) ? "f32" : "f64";
  }
};
TYPED_TEST_SUITE(BatchArguments, Scalars, ScalarNames);

TYPED_TEST(BatchArguments, AreRightInTheScene) {
  EXPECT_EQ(this->many(&this->disc_, &this->points_), 3);
  this->expect_bytes({1, 1, 0, 1});
  EXPECT_EQ(this->many(&this->points_, &this->disc_), 3);
  this->expect_bytes({1, 1, 0, 1});
  EXPECT_EQ(this->many(&this->points_, &this->points_), 4);
  this->expect_bytes({1, 1, 1, 1});
  EXPECT_EQ(this->matrix(this->points_, this->disc_, 2), 3);
  this->expect_bytes({1, untouched, 1, untouched, 0, untouched, 1});
  EXPECT_EQ(this->select(this->disc_, this->points_, 5), 3);
  this->expect_indices({0, 1, 3, -1});
}

// reserved, rings, polygons and each are for kinds that this version does not have.
TYPED_TEST(BatchArguments, UnusedMembersMustBeZero) {
  const std::int32_t offset = 0;
  auto wrong = this->points_;
  wrong.reserved = 1;
  this->expect_refused(wrong, VESICA_E_ARGUMENT);
  wrong = this->points_;
  wrong.rings = &offset;
  this->expect_refused(wrong, VESICA_E_ARGUMENT);
  wrong = this->points_;
  wrong.polygons = &offset;
  this->expect_refused(wrong, VESICA_E_ARGUMENT);
  wrong = this->points_;
  wrong.each = 4;
  this->expect_refused(wrong, VESICA_E_ARGUMENT);
  wrong = this->points_;
  wrong.field[6] = wrong.field[7] = this->x_.data();  // columns beyond those of the kind are ignored
  EXPECT_EQ(this->many(&this->disc_, &wrong), 3);
}

TYPED_TEST(BatchArguments, NullIsReportedFirst) {
  auto wrong_kind = this->points_;
  wrong_kind.kind = VESICA_POLYLINE + 1;
  EXPECT_EQ(TestFixture::Face::overlap_many(nullptr, &this->points_, this->out_.data()), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_many(&this->points_, nullptr, this->out_.data()), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_many(&this->points_, &this->points_, nullptr), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_many(&wrong_kind, nullptr, this->out_.data()), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_many(&wrong_kind, &this->points_, nullptr), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(nullptr, &this->points_, this->out_.data(), 4), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&this->points_, nullptr, this->out_.data(), 4), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&this->points_, &this->points_, nullptr, 4), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_select(nullptr, &this->points_, this->indices_.data(), 8), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_select(&this->disc_, nullptr, this->indices_.data(), 8), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::overlap_select(&this->disc_, &this->points_, nullptr, 8), VESICA_E_NULL);
  this->expect_untouched();
}

TYPED_TEST(BatchArguments, NullFieldsOfTheKindAreReported) {
  for (std::size_t k = 0; k < 2; ++k) {
    auto wrong = this->points_;
    wrong.field[k] = nullptr;
    wrong.count = 1;
    this->expect_refused(wrong, VESICA_E_NULL);
  }
  auto wrong = this->disc_;
  wrong.field[2] = nullptr;
  this->expect_refused(wrong, VESICA_E_NULL);
}

/// The other four fields of a point are NULL throughout this file.
TYPED_TEST(BatchArguments, FieldsBeyondTheKindAreNotLookedAt) {
  for (std::size_t k = 2; k < 6; ++k) ASSERT_EQ(this->points_.field[k], nullptr);
  EXPECT_EQ(this->many(&this->points_, &this->disc_), 3);
}

TYPED_TEST(BatchArguments, UnknownKindsAreReported) {
  for (const std::int32_t kind : {-1, VESICA_POLYLINE + 1, std::numeric_limits<std::int32_t>::max()}) {
    auto wrong = this->disc_;
    wrong.kind = kind;
    this->expect_refused(wrong, VESICA_E_KIND);
    wrong.reserved = 1;  // the kind comes first
    this->expect_refused(wrong, VESICA_E_KIND);
  }
}

TYPED_TEST(BatchArguments, ReservedMustBeZero) {
  for (const std::int32_t reserved : {1, -1}) {
    auto wrong = this->disc_;
    wrong.reserved = reserved;
    this->expect_refused(wrong, VESICA_E_ARGUMENT);
  }
}

TYPED_TEST(BatchArguments, NegativeCountsAreRefused) {
  for (const std::int64_t count : {std::int64_t{-1}, -most, -most - 1}) {
    auto wrong = this->points_;
    wrong.count = count;
    this->expect_refused(wrong, VESICA_E_ARGUMENT);
  }
}

TYPED_TEST(BatchArguments, CountsMustAgree) {
  auto three = this->points_, none = this->points_;
  three.count = 3;
  none.count = 0;
  EXPECT_EQ(this->many(&three, &this->points_), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->many(&this->points_, &three), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->many(&none, &this->points_), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->many(&this->points_, &none), VESICA_E_ARGUMENT);
  auto repeated = three;
  repeated.stride = 0;  // a count of its own all the same
  EXPECT_EQ(this->many(&repeated, &this->points_), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->select(three, this->points_, 4), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->select(none, this->points_, 4), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->select(none, none, 4), VESICA_E_ARGUMENT);
  this->expect_untouched();
}

TYPED_TEST(BatchArguments, ArraysBeyondTheAddressSpaceAreRefused) {
  struct Extent {
    std::int64_t count;
    std::ptrdiff_t stride;
  };
  const std::array extents{Extent{most, sizeof(TypeParam)}, Extent{most / 2, 3},         Extent{most / 8, 9},
                           Extent{2, farthest / 2 + 1},     Extent{2, farthest},         Extent{2, farthest_back},
                           Extent{3, farthest_back / 2},    Extent{most, farthest_back}, Extent{most, -2}};
  for (const Extent& extent : extents) {
    auto wrong = this->points_;
    wrong.count = extent.count;
    wrong.stride = extent.stride;
    EXPECT_EQ(this->many(&wrong, &this->disc_), VESICA_E_ARGUMENT) << extent.count << ' ' << extent.stride;
    this->expect_refused(wrong, VESICA_E_ARGUMENT);
  }
}

/// With one element there is no next one.
TYPED_TEST(BatchArguments, TheStrideOfOneElementIsNotLookedAt) {
  for (const std::ptrdiff_t stride : {std::ptrdiff_t{0}, std::ptrdiff_t{-1}, farthest, farthest_back}) {
    auto one = this->disc_;
    one.stride = stride;
    EXPECT_EQ(this->many(&one, &this->points_), 3);
    EXPECT_EQ(this->many(&this->points_, &one), 3);
    this->expect_bytes({1, 1, 0, 1});
    EXPECT_EQ(this->many(&one, &one), 1);
    this->expect_bytes({1});
    EXPECT_EQ(this->matrix(one, one, 1), 1);
    this->expect_bytes({1});
    EXPECT_EQ(this->select(one, one, 1), 1);
    this->expect_indices({0});
  }
}

TYPED_TEST(BatchArguments, NothingToAnswerNeedsNoMemory) {
  auto& nothing = this->nothing_;
  EXPECT_EQ(TestFixture::Face::overlap_many(&nothing, &nothing, nullptr), 0);
  EXPECT_EQ(TestFixture::Face::overlap_many(&nothing, &this->disc_, nullptr), 0);
  EXPECT_EQ(TestFixture::Face::overlap_many(&this->disc_, &nothing, nullptr), 0);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&nothing, &this->points_, nullptr, 0), 0);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&this->points_, &nothing, nullptr, 0), 0);
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&nothing, &nothing, nullptr, -1), 0);
  EXPECT_EQ(TestFixture::Face::overlap_select(&this->disc_, &nothing, nullptr, 0), 0);
  EXPECT_EQ(TestFixture::Face::overlap_select(&this->disc_, &nothing, nullptr, 8), 0);
  EXPECT_EQ(this->many(&nothing, &this->disc_), 0);
  EXPECT_EQ(this->matrix(this->points_, nothing, 0), 0);
  this->expect_untouched();
  EXPECT_EQ(this->select(this->disc_, nothing, 0), 0);
  this->expect_untouched();
  EXPECT_EQ(this->select(this->disc_, nothing, 3), 0);
  this->expect_indices({-1});
}

/// Checks the other arguments even if the arrays are empty.
TYPED_TEST(BatchArguments, NothingToAnswerIsStillChecked) {
  auto wrong_kind = this->nothing_, wrong_reserved = this->nothing_;
  wrong_kind.kind = VESICA_POLYLINE + 1;
  wrong_reserved.reserved = 7;
  this->expect_refused(wrong_kind, VESICA_E_KIND);
  this->expect_refused(wrong_reserved, VESICA_E_ARGUMENT);
}

TYPED_TEST(BatchArguments, RowsMayNotOverlap) {
  for (const std::ptrdiff_t row_stride : {0, 1, 3, -1, -3}) {
    EXPECT_EQ(this->matrix(this->points_, this->points_, row_stride), VESICA_E_ARGUMENT) << row_stride;
  }
  this->expect_untouched();
  EXPECT_EQ(this->matrix(this->points_, this->points_, 4), 4);
  this->expect_bytes({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  auto two = this->points_;
  two.count = 2;
  EXPECT_EQ(TestFixture::Face::overlap_matrix(&two, &this->points_, this->out_.data() + 4, -4), 2);
  this->expect_bytes({0, 1, 0, 0, 1, 0, 0, 0});
}

TYPED_TEST(BatchArguments, RowsBeyondTheAddressSpaceAreRefused) {
  for (const std::ptrdiff_t row_stride : {farthest, farthest / 2, farthest_back, farthest_back / 2, farthest / 3 + 9}) {
    EXPECT_EQ(this->matrix(this->points_, this->points_, row_stride), VESICA_E_ARGUMENT) << row_stride;
  }
  auto two = this->points_;
  two.count = 2;
  for (const std::ptrdiff_t row_stride : {farthest, farthest_back}) {
    EXPECT_EQ(this->matrix(two, this->points_, row_stride), VESICA_E_ARGUMENT) << row_stride;
  }
  this->expect_untouched();
}

TYPED_TEST(BatchArguments, ASingleRowLiesAnywhere) {
  for (const std::ptrdiff_t row_stride :
       {std::ptrdiff_t{0}, std::ptrdiff_t{3}, std::ptrdiff_t{-1}, farthest, farthest_back}) {
    EXPECT_EQ(this->matrix(this->disc_, this->points_, row_stride), 3);
    this->expect_bytes({1, 1, 0, 1});
  }
}

TYPED_TEST(BatchArguments, SelectionFillsItsRoomAndSaysHowManyThereAre) {
  EXPECT_EQ(TestFixture::Face::overlap_select(&this->disc_, &this->points_, nullptr, 0), 3);
  EXPECT_EQ(this->select(this->disc_, this->points_, 0), 3);
  this->expect_untouched();
  EXPECT_EQ(this->select(this->disc_, this->points_, 1), 3);
  this->expect_indices({0});
  EXPECT_EQ(this->select(this->disc_, this->points_, 2), 3);
  this->expect_indices({0, 1});
  EXPECT_EQ(this->select(this->disc_, this->points_, 3), 3);
  this->expect_indices({0, 1, 3});
  EXPECT_EQ(this->select(this->disc_, this->points_, 4), 3);
  this->expect_indices({0, 1, 3, -1});
  EXPECT_EQ(this->select(this->disc_, this->points_, 8), 3);
  this->expect_indices({0, 1, 3, -1});
  for (const std::int64_t capacity : {std::int64_t{-1}, -most - 1}) {
    EXPECT_EQ(this->select(this->disc_, this->points_, capacity), VESICA_E_ARGUMENT);
  }
  this->expect_untouched();
}

TYPED_TEST(BatchArguments, InvalidElementsLeaveTheOthersAnswered) {
  EXPECT_EQ(this->many(&this->disc_, &this->spoilt_points_), VESICA_E_SHAPE);
  this->expect_bytes({1, 0, 0, 1});
  EXPECT_EQ(this->matrix(this->spoilt_points_, this->disc_, 1), VESICA_E_SHAPE);
  this->expect_bytes({1, 0, 0, 1});
  EXPECT_EQ(this->select(this->disc_, this->spoilt_points_, 1), VESICA_E_SHAPE);
  this->expect_indices({0});
  EXPECT_EQ(this->select(this->disc_, this->spoilt_points_, 8), VESICA_E_SHAPE);
  this->expect_indices({0, 3, -1});
}

TYPED_TEST(BatchArguments, AnInvalidOneOverlapsNothing) {
  auto wrong = this->disc_;
  wrong.field[2] = this->x_.data() + 3;  // radius -1
  EXPECT_EQ(this->many(&this->points_, &wrong), VESICA_E_SHAPE);
  this->expect_bytes({0, 0, 0, 0});
  EXPECT_EQ(this->matrix(wrong, this->points_, 4), VESICA_E_SHAPE);
  this->expect_bytes({0, 0, 0, 0});
  EXPECT_EQ(this->select(wrong, this->points_, 2), VESICA_E_SHAPE);
  this->expect_indices({-1});
}

TYPED_TEST(BatchArguments, RecordsAreDescribed) {
  constexpr std::array<int, 6> fields{2, 4, 3, 4, 6, 6};
  std::array<TypeParam, 8> record{};
  for (std::int32_t kind = 0; kind < 6; ++kind) {
    typename TestFixture::Shapes shapes;
    std::memset(&shapes, 0xA5, sizeof shapes);
    ASSERT_EQ(TestFixture::Face::from_records(kind, 7, record.data(), -48, &shapes), 0);
    EXPECT_EQ(shapes.kind, kind);
    EXPECT_EQ(shapes.reserved, 0);
    EXPECT_EQ(shapes.count, 7);
    EXPECT_EQ(shapes.stride, -48);
    for (std::size_t k = 0; k < static_cast<std::size_t>(fields[static_cast<std::size_t>(kind)]); ++k) {
      EXPECT_EQ(shapes.field[k], record.data() + k);
    }
  }
}

TYPED_TEST(BatchArguments, RecordsThatCannotBeAreRefused) {
  std::array<TypeParam, 8> record{};
  typename TestFixture::Shapes shapes, before;
  std::memset(&shapes, 0xA5, sizeof shapes);
  std::memcpy(&before, &shapes, sizeof shapes);
  EXPECT_EQ(TestFixture::Face::from_records(VESICA_RECT, 1, record.data(), 48, nullptr), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::from_records(VESICA_RECT, 1, nullptr, 48, &shapes), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::from_records(9, 1, nullptr, 48, &shapes), VESICA_E_NULL);
  EXPECT_EQ(TestFixture::Face::from_records(-1, 1, record.data(), 48, &shapes), VESICA_E_KIND);
  EXPECT_EQ(TestFixture::Face::from_records(VESICA_POLYLINE + 1, 1, record.data(), 48, &shapes), VESICA_E_KIND);
  EXPECT_EQ(TestFixture::Face::from_records(VESICA_RECT, -1, record.data(), 48, &shapes), VESICA_E_ARGUMENT);
  EXPECT_EQ(std::memcmp(&shapes, &before, sizeof shapes), 0);
  EXPECT_EQ(TestFixture::Face::from_records(VESICA_RECT, 0, nullptr, 48, &shapes), 0);
  EXPECT_EQ(shapes.count, 0);
  EXPECT_EQ(TestFixture::Face::overlap_many(&shapes, &shapes, nullptr), 0);
}

}  // namespace
