// SPDX-License-Identifier: Apache-2.0
// Queries of whole arrays, through the library on the instruction set that VESICA_ISA names: whatever the layout and
// the length, every number has the bits of the scalar function's.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "batch/data.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "batch/queries/faces.hpp"
#include "properties/random.hpp"

namespace {

using namespace batch_tests;

template <class T>
auto bits(T x) {
  return std::bit_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(x);
}

/// The values that a batch must write and return.
template <class T>
class Expected {
 public:
  explicit Expected(const QueryFace<T>& face) : face_(face) {}

  Result<T> ask(int kind_a, const Numbers<T>& a, int kind_b, const Numbers<T>& b) {
    Result<T> result{};
    const std::int32_t error = face_.scalar(kind_a, a.data(), kind_b, b.data(), result);
    if (error < 0) {
      if (error_ != VESICA_E_SHAPE) error_ = error;
      result.fill(face_.is_code ? T{0} : std::numeric_limits<T>::quiet_NaN());
      return result;
    }
    count_ += face_.counts_zero ? result[0] == 0 : result[0] > 0;
    return result;
  }

  std::int64_t returned() const { return error_ != 0 ? error_ : count_; }

 private:
  const QueryFace<T>& face_;
  std::int64_t count_ = 0;
  std::int32_t error_ = 0;
};

template <class T>
bool same(T got, T wanted) {
  return std::isnan(wanted) ? std::isnan(got) : bits(got) == bits(wanted);
}

/// n of the pairs from `begin` on, in step.
template <class T>
void check_many(const QueryFace<T>& face, const Pairs<T>& pairs, std::size_t begin, std::size_t n, Layout layout_a,
                Layout layout_b) {
  std::vector<Numbers<T>> a, b;
  for (std::size_t i = 0; i < n; ++i) {
    a.push_back(pairs.a[(begin + i) % pairs.size()]);
    b.push_back(pairs.b[(begin + i) % pairs.size()]);
  }
  const Stored<T> stored_a(pairs.kind_a, a, layout_a), stored_b(pairs.kind_b, b, layout_b);
  const auto c_a = c_shapes(stored_a), c_b = c_shapes(stored_b);
  std::vector<std::vector<T>> columns(face.results, std::vector<T>(n));
  const std::int64_t returned = face.many(&c_a, &c_b, columns);
  Expected<T> expected(face);
  for (std::size_t i = 0; i < n; ++i) {
    const Numbers<T>&of_a = a[one_shape(layout_a) ? 0 : i], &of_b = b[one_shape(layout_b) ? 0 : i];
    const Result<T> wanted = expected.ask(pairs.kind_a, of_a, pairs.kind_b, of_b);
    for (std::size_t k = 0; k < face.results; ++k) {
      ASSERT_TRUE(same(columns[k][i], wanted[k]))
          << face.name << " number " << k << ": " << columns[k][i] << ", not " << wanted[k] << ", for "
          << describe(pairs.kind_a, of_a, pairs.kind_b, of_b);
    }
  }
  EXPECT_EQ(returned, expected.returned()) << face.name;
}

template <class T>
void check_matrix(const QueryFace<T>& face, const Pairs<T>& pairs, std::size_t begin, std::size_t rows,
                  std::size_t width) {
  std::vector<Numbers<T>> a, b;
  for (std::size_t i = 0; i < rows; ++i) a.push_back(pairs.a[(begin + i) % pairs.size()]);
  for (std::size_t i = 0; i < width; ++i) b.push_back(pairs.b[(begin + i) % pairs.size()]);
  const Stored<T> stored_a(pairs.kind_a, a, Layout::packed), stored_b(pairs.kind_b, b, Layout::columns);
  const auto c_a = c_shapes(stored_a), c_b = c_shapes(stored_b);
  const std::size_t stride = width + 3;
  std::vector<T> out(rows * stride, T{77});
  const std::int64_t returned = face.matrix(&c_a, &c_b, out, static_cast<std::ptrdiff_t>(stride));
  Expected<T> expected(face);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      const Result<T> wanted = expected.ask(pairs.kind_a, a[i], pairs.kind_b, b[j]);
      ASSERT_TRUE(same(out[i * stride + j], wanted[0])) << face.name << ' ' << i << ' ' << j;
    }
    for (std::size_t j = width; j < stride; ++j) EXPECT_EQ(out[i * stride + j], T{77});
  }
  EXPECT_EQ(returned, expected.returned()) << face.name;
}

template <class T>
void check_all(int kind_a, int kind_b) {
  const Pairs<T>& pairs = mixed_pairs<T>(kind_a, kind_b);
  for (const QueryFace<T>& face : query_faces<T>()) {
    Result<T> unused{};
    if (face.scalar(kind_a, pairs.a[0].data(), kind_b, pairs.b[0].data(), unused) == VESICA_E_KIND) continue;
    std::size_t begin = 0;
    for (const std::size_t n : {0, 1, 7, 9, 300}) {
      check_many(face, pairs, begin, n, Layout::columns, Layout::columns);
      check_many(face, pairs, begin + n, n, Layout::odd_records, Layout::backward_columns);
      check_many(face, pairs, begin + 2 * n, n, Layout::repeated, Layout::padded);
      begin += 3 * n;
    }
    if (face.matrix != nullptr) check_matrix(face, pairs, begin, 5, 141);
  }
}

class Queries : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Queries, HaveTheBitsOfScalarCalls) {
  const auto [kind_a, kind_b] = GetParam();
  check_all<float>(kind_a, kind_b);
  check_all<double>(kind_a, kind_b);
}

/// A rectangle about 2 wide somewhere in a square; some without area, invalid, or of odd magnitude.
template <class T>
Numbers<T> scattered(double width, properties::Random& random) {
  const double angle = random.between(0, 6.283185307179586);
  properties::Numbers n{random.between(0, width), random.between(0, width), std::cos(angle),
                        std::sin(angle),          random.between(0.5, 1.5), random.between(0.5, 1.5)};
  if (random.chance(0.0625)) {
    const auto any_field = static_cast<std::size_t>(random.below(6));
    const double odd[] = {0, -1, 1e-36, 1e36, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL};
    n[any_field] = odd[random.below(6)];
    if (random.chance(0.2)) n[4] = n[5] = 0;
  }
  if (random.chance(0.05)) n[4] = 0;
  return to_scalar<T>(n);
}

// Kernels of areas are asked only of pairs that circles about them do not show to be apart, put side by side, where
// those are at most half: from hardly any to all.
template <class T>
void check_scattered() {
  properties::Random random(properties::seed());
  for (const QueryFace<T>& face : query_faces<T>()) {
    for (const double width : {40.0, 12.0, 6.0, 4.0, 2.0}) {
      Pairs<T> pairs{VESICA_RECT, VESICA_RECT, {}, {}, {}};
      for (int i = 0; i < 300; ++i) pairs.add(scattered<T>(width, random), scattered<T>(width, random));
      check_many(face, pairs, 0, 300, Layout::columns, Layout::odd_records);
      check_many(face, pairs, 0, 300, Layout::repeated, Layout::columns);
      check_many(face, pairs, 0, 300, Layout::columns, Layout::repeated);
      if (face.matrix != nullptr) check_matrix(face, pairs, 0, 20, 270);
    }
  }
}
TEST(QueriesOfScatteredRectangles, HaveTheBitsOfScalarCalls) {
  check_scattered<float>();
  check_scattered<double>();
}

// Corners that meet on the line between the centres, where circles about both touch as well, and a few places about.
template <class T>
void check_corner_to_corner() {
  for (const QueryFace<T>& face : query_faces<T>()) {
    Pairs<T> pairs{VESICA_RECT, VESICA_RECT, {}, {}, {}};
    for (int i = 0; i < 81; ++i) {
      const T place = std::numeric_limits<T>::epsilon();
      pairs.add({0, 0, 1, 0, 3, 4}, {T{6} + T(4 * (i % 9 - 4)) * place, T{8} + T(4 * (i / 9 - 4)) * place, 1, 0, 3, 4});
    }
    check_many(face, pairs, 0, 81, Layout::columns, Layout::columns);
  }
}
TEST(QueriesOfRectanglesCornerToCorner, HaveTheBitsOfScalarCalls) {
  check_corner_to_corner<float>();
  check_corner_to_corner<double>();
}

std::vector<std::pair<int, int>> ordered_pairs() {
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < properties::kinds; ++a) {
    for (int b = 0; b < properties::kinds; ++b) pairs.emplace_back(a, b);
  }
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Queries, testing::ValuesIn(ordered_pairs()), [](const auto& kinds) {
  return std::string(properties::kind_name(kinds.param.first)) + '_' + properties::kind_name(kinds.param.second);
});

}  // namespace
