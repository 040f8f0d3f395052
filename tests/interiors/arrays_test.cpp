// SPDX-License-Identifier: Apache-2.0
// Arrays of all pairs of kinds answer as single calls do: in step, matrix and selection, columns and records, at
// contact and at extreme scales.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interiors/lattice.hpp"

namespace {

using interiors::Shape;
using properties::Random;

template <class T>
struct Api;
template <>
struct Api<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto single = vesica_interiors_overlap_f64;
  static constexpr auto many = vesica_interiors_overlap_many_f64;
  static constexpr auto matrix = vesica_interiors_overlap_matrix_f64;
  static constexpr auto select = vesica_interiors_overlap_select_f64;
  static constexpr std::array exponents{0, -1060, -540, 340, 1000};
};
template <>
struct Api<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto single = vesica_interiors_overlap_f32;
  static constexpr auto many = vesica_interiors_overlap_many_f32;
  static constexpr auto matrix = vesica_interiors_overlap_matrix_f32;
  static constexpr auto select = vesica_interiors_overlap_select_f32;
  static constexpr std::array exponents{0, -140, -60, 60, 120};
};

/// Shapes of one kind, as records without gaps or as columns.
template <class T>
class Array {
 public:
  Array(std::int32_t kind, std::int64_t count, int exponent, bool in_columns, Random& random)
      : fields_(static_cast<std::size_t>(vesica_field_count(kind))), count_(static_cast<std::size_t>(count)) {
    for (std::size_t i = 0; i < count_; ++i) {
      Shape s = interiors::shape(kind, exponent, random);
      for (std::size_t k = 0; k < fields_; ++k) records_.push_back(static_cast<T>(s.number[k]));
    }
    columns_.resize(records_.size());
    for (std::size_t n = 0; n < records_.size(); ++n) columns_[n % fields_ * count_ + n / fields_] = records_[n];
    shapes_.kind = kind;
    shapes_.count = count;
    shapes_.stride = static_cast<std::ptrdiff_t>((in_columns ? 1 : fields_) * sizeof(T));
    for (std::size_t k = 0; k < fields_; ++k) {
      shapes_.field[k] = in_columns ? columns_.data() + k * count_ : records_.data() + k;
    }
  }
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;

  const typename Api<T>::Shapes* shapes() const { return &shapes_; }
  const T* at(std::size_t i) const { return records_.data() + i % count_ * fields_; }
  std::size_t size() const { return count_; }
  std::int32_t kind() const { return shapes_.kind; }

 private:
  std::size_t fields_, count_;
  std::vector<T> records_, columns_;
  typename Api<T>::Shapes shapes_{};
};

template <class T>
std::int32_t single(const Array<T>& a, std::size_t i, const Array<T>& b, std::size_t j) {
  return Api<T>::single(a.kind(), a.at(i), b.kind(), b.at(j));
}

template <class T>
class InteriorsArrays : public testing::Test {
 protected:
  void in_step(const Array<T>& a, const Array<T>& b) {
    const std::size_t n = a.size() > b.size() ? a.size() : b.size();
    std::vector<std::uint8_t> out(n, 9);
    std::int64_t expected = 0;
    const std::int64_t found = Api<T>::many(a.shapes(), b.shapes(), out.data());
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(out[i], single(a, i, b, i)) << a.kind() << ", " << b.kind() << ", " << i;
      expected += out[i];
    }
    EXPECT_EQ(found, expected);
    meeting_ += expected;
  }
  void matrix(const Array<T>& a, const Array<T>& b) {
    std::vector<std::uint8_t> out(a.size() * b.size(), 9);
    ASSERT_GE(Api<T>::matrix(a.shapes(), b.shapes(), out.data(), static_cast<std::ptrdiff_t>(b.size())), 0);
    for (std::size_t n = 0; n < out.size(); ++n) {
      ASSERT_EQ(out[n], single(a, n / b.size(), b, n % b.size())) << a.kind() << ", " << b.kind() << ", " << n;
    }
  }
  void selection(const Array<T>& one, const Array<T>& many) {
    std::vector<std::int64_t> out(many.size() + 1, -9), expected;
    for (std::size_t i = 0; i < many.size(); ++i) {
      if (single(one, 0, many, i) == 1) expected.push_back(static_cast<std::int64_t>(i));
    }
    ASSERT_EQ(Api<T>::select(one.shapes(), many.shapes(), out.data(), static_cast<std::int64_t>(out.size())),
              static_cast<std::int64_t>(expected.size()));
    expected.push_back(-1);
    out.resize(expected.size());
    EXPECT_EQ(out, expected);
  }
  std::int64_t meeting_ = 0;
};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(InteriorsArrays, Scalars);

TYPED_TEST(InteriorsArrays, AnswerAsSingleCalls) {
  using Shapes = Array<TypeParam>;
  Random random(properties::seed());
  for (const int exponent : Api<TypeParam>::exponents) {
    for (std::int32_t kind_a = 0; kind_a < interiors::kind_count; ++kind_a) {
      for (std::int32_t kind_b = 0; kind_b < interiors::kind_count; ++kind_b) {
        const bool columns_a = random.chance(0.5), columns_b = random.chance(0.5);
        const Shapes a(kind_a, 133, exponent, columns_a, random), b(kind_b, 133, exponent, columns_b, random);
        const Shapes few(kind_a, 7, exponent, columns_a, random), one(kind_a, 1, exponent, columns_a, random);
        ASSERT_NO_FATAL_FAILURE(this->in_step(a, b));
        ASSERT_NO_FATAL_FAILURE(this->in_step(one, b));
        ASSERT_NO_FATAL_FAILURE(this->in_step(b, one));
        ASSERT_NO_FATAL_FAILURE(this->matrix(few, b));
        ASSERT_NO_FATAL_FAILURE(this->selection(one, b));
      }
    }
  }
  EXPECT_GT(this->meeting_, 0);
}

/// An invalid element is 0, the others are answered, and the call returns the error.
TEST(InteriorsArrays, InvalidElements) {
  const double boxes[] = {0, 0, 2, 2, 2, 0, 1, 2, 1, 1, 3, 3}, one[] = {0, 0, 2, 2};
  vesica_shapes_f64 a, b;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1, one, 32, &a), 0);
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 3, boxes, 32, &b), 0);
  std::uint8_t out[3] = {9, 9, 9};
  EXPECT_EQ(vesica_interiors_overlap_many_f64(&a, &b, out), VESICA_E_SHAPE);
  EXPECT_EQ(out[0], 1);
  EXPECT_EQ(out[1], 0);
  EXPECT_EQ(out[2], 1);
  EXPECT_EQ(vesica_interiors_overlap_many_f64(&a, nullptr, out), VESICA_E_NULL);
  b.kind = VESICA_POLYLINE + 1;
  EXPECT_EQ(vesica_interiors_overlap_many_f64(&a, &b, out), VESICA_E_KIND);
}

}  // namespace
