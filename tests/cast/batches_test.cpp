// SPDX-License-Identifier: Apache-2.0
/// Arrays have the bits of single calls, in every layout, and say what is wrong with an element.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "cast/arrays.hpp"
#include "properties/generators.hpp"

namespace {

using namespace cast_test;

template <class T>
class Batches : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(Batches, Scalars);

TYPED_TEST(Batches, HaveTheBitsOfSingleCalls) {
  using T = TypeParam;
  for (int kind_a = 0; kind_a < properties::kinds; ++kind_a) {
    for (int kind_b = 0; kind_b < properties::kinds; ++kind_b) {
      Arrays<T> s(properties::Workload::random, kind_a, kind_b, 40);
      check_many<T>(s, T(3));
      Arrays<T> grid(properties::Workload::grid, kind_a, kind_b, 20);
      check_many<T>(grid, std::numeric_limits<T>::infinity());
    }
  }
}

TYPED_TEST(Batches, OfWhichSomeElementsAreWrong) {
  using T = TypeParam;
  Arrays<T> s(properties::Workload::random, VESICA_CIRCLE, VESICA_AABB, 30);
  s.v[7][1] = std::numeric_limits<T>::infinity();
  check_many<T>(s, T(2));
  s.a[3][2] = -1;
  s.a[7][2] = -1;
  check_many<T>(s, T(2));
}

TYPED_TEST(Batches, FirstIsTheEarliestOfAll) {
  using T = TypeParam;
  int found = 0;
  for (int kind = 0; kind < properties::kinds; ++kind) {
    Arrays<T> s(properties::Workload::random, kind, VESICA_POINT, 60);
    s.shapes_b.count = 1;
    const T vx = s.v[0][0] * 8, vy = s.v[0][1] * 8;
    typename Face<T>::Impact expected{}, first;
    std::int64_t index = s.shapes_a.count;
    for (std::size_t i = 0; i < s.a.size(); ++i) {
      typename Face<T>::Impact one;
      if (Face<T>::cast(kind, s.a[i].data(), VESICA_POINT, s.b[0].data(), vx, vy, T(9), &one) <= 0) continue;
      if (index != s.shapes_a.count && !(one.t < expected.t)) continue;
      expected = one;
      index = static_cast<std::int64_t>(i);
    }
    EXPECT_EQ(Face<T>::cast_first(&s.shapes_b, &s.shapes_a, vx, vy, T(9), &first), index);
    if (index == s.shapes_a.count) continue;
    ++found;
    EXPECT_TRUE(same_bits(&first, &expected, sizeof first));
  }
  EXPECT_GT(found, 2);
}

/// An index of one set of shapes.
class Index {
 public:
  explicit Index(const vesica_shapes_f64& set) : set_(set), bytes_(rounded(vesica_index_size(set.count))) {
    std::vector<Chunk> scratch(rounded(vesica_index_scratch(set.count)));
    EXPECT_GT(vesica_index_build_f64(&set_, 1, bytes_.data(), 64 * static_cast<std::int64_t>(bytes_.size()),
                                     scratch.data(), 64 * static_cast<std::int64_t>(scratch.size())),
              0);
  }
  std::int64_t cast_first(const vesica_shapes_f64& one, double vx, double vy, double end,
                          vesica_impact_f64& out) const {
    return vesica_index_cast_first_f64(bytes_.data(), &set_, 1, &one, vx, vy, end, &out);
  }
  /// All items that are hit, ascending, and how many are undecided.
  std::int64_t cast(const vesica_shapes_f64& one, double vx, double vy, double end,
                    std::vector<std::int64_t>& met) const {
    std::int64_t page[5], state[4] = {}, errors = 0;
    met.clear();
    while (state[0] != -1) {
      const std::int64_t n = vesica_index_cast_f64(bytes_.data(), &set_, 1, &one, vx, vy, end, page, 5, state);
      if (n < 0 && (n != VESICA_E_RANGE || ++errors > set_.count)) return n;
      met.insert(met.end(), page, page + std::max<std::int64_t>(n, 0));
    }
    std::sort(met.begin(), met.end());
    return errors;
  }

 private:
  struct alignas(64) Chunk {
    unsigned char bytes[64];
  };
  static std::size_t rounded(std::int64_t size) { return static_cast<std::size_t>((size + 63) / 64); }

  vesica_shapes_f64 set_;
  std::vector<Chunk> bytes_;
};

/// A shape hit later than any number, one that lies there already, and one that is hit early: whatever their order and
/// number, the far one does not hide the first.
TYPED_TEST(Batches, FirstBesideContactBeyondTheNumbers) {
  using T = TypeParam;
  constexpr T far = std::numeric_limits<T>::max() / 4, speed = T(0x1p-20);
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const T beyond[3] = {far, 0, 1}, early[3] = {3, 0, 1}, here[3] = {T(0.5), 0, 1}, origin[2] = {0, 0};
  typename Face<T>::Shapes point;
  Face<T>::from_records(VESICA_POINT, 1, origin, 0, &point);
  for (const T* const nearer : {early, here}) {
    for (const int count : {2, 3, 40, 700}) {
      for (const int place : {0, 1, count - 1}) {
        std::vector<T> circles;
        for (int i = 0; i < count; ++i) {
          const T* const circle = i == place ? nearer : beyond;
          circles.insert(circles.end(), circle, circle + 3);
        }
        typename Face<T>::Shapes many;
        Face<T>::from_records(VESICA_CIRCLE, count, circles.data(), 3 * sizeof(T), &many);
        typename Face<T>::Impact first{}, expected{};
        ASSERT_GT(Face<T>::cast(VESICA_CIRCLE, nearer, VESICA_POINT, origin, speed, 0, infinity, &expected), 0);
        ASSERT_EQ(Face<T>::cast(VESICA_CIRCLE, beyond, VESICA_POINT, origin, speed, 0, infinity, &first),
                  VESICA_E_RANGE);
        EXPECT_EQ(Face<T>::cast_first(&point, &many, speed, 0, infinity, &first), place);
        EXPECT_TRUE(same_bits(&first, &expected, sizeof first));
      }
    }
  }
}

/// Exponents that are wildly unlike: a first hit is out of range only where the cast of an item is that may be the
/// first, and else it is the earliest of all casts.
TEST(FirstHits, AgreeWithSingleCastsAboutTheRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  int out_of_range = 0, beside_out_of_range = 0, found = 0, told_faster = 0;
  for (const properties::Workload workload :
       {properties::Workload::mixed_scale, properties::Workload::axis_length, properties::Workload::near_contact}) {
    for (int kind_a = 0; kind_a < properties::kinds; ++kind_a) {
      for (int kind_b = 0; kind_b < properties::kinds; ++kind_b) {
        Arrays<double> s(workload, kind_a, kind_b, 24);
        const Index index(s.shapes_a);
        for (std::size_t k = 0; k < 4; ++k) {
          vesica_shapes_f64 moving;
          vesica_shapes_from_records_f64(kind_b, 1, s.b[k].data(), 0, &moving);
          const double vx = s.v[k][0], vy = s.v[k][1], end = k % 2 == 0 ? infinity : 2;
          std::vector<std::size_t> range;
          std::int64_t earliest = s.shapes_a.count;
          vesica_impact_f64 expected{};
          for (std::size_t i = 0; i < s.a.size(); ++i) {
            vesica_impact_f64 one;
            const std::int32_t code = vesica_cast_f64(kind_a, s.a[i].data(), kind_b, s.b[k].data(), vx, vy, end, &one);
            if (code == VESICA_E_RANGE) range.push_back(i);
            if (code <= 0 || (earliest != s.shapes_a.count && !(one.t < expected.t))) continue;
            earliest = static_cast<std::int64_t>(i);
            expected = one;
          }
          const auto may_be_first = [&](std::size_t i) {
            vesica_impact_f64 one;
            const double until = earliest == s.shapes_a.count ? end : std::nextafter(expected.t, infinity);
            return vesica_cast_f64(kind_a, s.a[i].data(), kind_b, s.b[k].data(), vx, vy, std::fmin(until, end), &one) !=
                   VESICA_CAST_MISS;
          };
          const bool some_range = !range.empty();
          const bool may_be_range = std::any_of(range.begin(), range.end(), may_be_first);
          // Without an end it does not matter how fast it goes.
          std::vector<std::int64_t> met, expected_met;
          const std::int64_t unknown = index.cast(moving, vx, vy, end, met);
          for (std::size_t i = 0; i < s.a.size(); ++i) {
            vesica_impact_f64 one;
            std::int32_t code = vesica_cast_f64(kind_a, s.a[i].data(), kind_b, s.b[k].data(), vx, vy, end, &one);
            for (const double faster : {0x1p200, 0x1p600, 0x1p900}) {
              if (code != VESICA_E_RANGE || end != infinity) break;
              code = vesica_cast_f64(kind_a, s.a[i].data(), kind_b, s.b[k].data(), vx * faster, vy * faster, end, &one);
              told_faster += code != VESICA_E_RANGE;
            }
            if (code > 0) expected_met.push_back(static_cast<std::int64_t>(i));
            if (code < 0) met.erase(std::remove(met.begin(), met.end(), static_cast<std::int64_t>(i)), met.end());
          }
          EXPECT_EQ(met, expected_met);
          EXPECT_TRUE(unknown == 0 || end != infinity) << unknown;
          vesica_impact_f64 of_all{}, of_index{};
          const std::int64_t all = vesica_cast_first_f64(&moving, &s.shapes_a, vx, vy, end, &of_all),
                             through = index.cast_first(moving, vx, vy, end, of_index);
          for (const auto& [answer, impact] : {std::pair(all, of_all), std::pair(through, of_index)}) {
            if (answer == VESICA_E_RANGE) {
              EXPECT_TRUE(may_be_range);
              ++out_of_range;
              continue;
            }
            EXPECT_EQ(answer, earliest);
            beside_out_of_range += some_range;
            found += answer != s.shapes_a.count;
            if (answer != s.shapes_a.count) {
              EXPECT_TRUE(same_bits(&impact, &expected, sizeof impact));
            }
          }
        }
      }
    }
  }
  EXPECT_GT(out_of_range, 10);
  EXPECT_GT(found, 100);
  EXPECT_GT(told_faster, 10);
  std::printf("%d found, %d out of range, %d answered beside casts that are, %d told by faster casts\n", found,
              out_of_range, beside_out_of_range, told_faster);
}

TEST(BatchArguments, Refused) {
  Arrays<double> s(properties::Workload::random, VESICA_CIRCLE, VESICA_AABB, 5);
  double t[5], *none = nullptr;
  const double *vx = &s.v[0][0], *vy = &s.v[0][1];
  const auto many = [&](const double* x, const double* y, double end, double* out) {
    return vesica_cast_many_f64(&s.shapes_a, &s.shapes_b, x, y, sizeof s.v[0], end, out, none, none, none, none);
  };
  EXPECT_GE(many(vx, vy, 1, t), 0);
  EXPECT_EQ(many(vx, vy, 1, nullptr), VESICA_E_NULL);
  EXPECT_EQ(many(nullptr, vy, 1, t), VESICA_E_NULL);
  EXPECT_EQ(many(vx, nullptr, 1, t), VESICA_E_NULL);
  EXPECT_EQ(many(vx, vy, -1, t), VESICA_E_ARGUMENT);
  EXPECT_EQ(many(vx, vy, std::nan(""), t), VESICA_E_ARGUMENT);
  vesica_impact_f64 impact{7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_cast_first_f64(&s.shapes_b, &s.shapes_a, 1, 1, 1, &impact), VESICA_E_ARGUMENT);
  s.shapes_b.count = 1;
  EXPECT_EQ(vesica_cast_first_f64(&s.shapes_b, &s.shapes_a, std::nan(""), 1, 1, &impact), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_cast_first_f64(&s.shapes_b, &s.shapes_a, 1, 1, 1, nullptr), VESICA_E_NULL);
  s.a[4][2] = -1;
  EXPECT_EQ(vesica_cast_first_f64(&s.shapes_b, &s.shapes_a, 1, 1, 1, &impact), VESICA_E_SHAPE);
  EXPECT_EQ(impact.t, 7);
}

}  // namespace
