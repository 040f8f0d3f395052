// SPDX-License-Identifier: Apache-2.0
// Bounds, areas and corners of arrays have the bits of single calls: of every kind, layout and length, among invalid
// shapes and extremes of magnitude. Arrays and results lie against pages that may not be touched.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "batch/guard_pages.hpp"
#include "capi/face.hpp"
#include "properties/random.hpp"

namespace {

using batch_tests::Edge;
using batch_tests::GuardedMemory;
using capi_tests::Face;
using properties::Random;

template <class T>
using Numbers = std::array<T, 6>;

std::size_t fields_of(std::int32_t kind) {
  constexpr std::array<std::size_t, 6> fields{2, 4, 3, 4, 6, 6};
  return fields.at(static_cast<std::size_t>(kind));
}

/// A number at which something may end: a range, exactness, validity.
template <class T>
T extreme(Random& draw) {
  using Limits = std::numeric_limits<T>;
  const T numbers[] = {0,
                       T(-0.0),
                       1,
                       -1,
                       T(1e12),
                       Limits::denorm_min(),
                       Limits::min(),
                       std::ldexp(Limits::denorm_min(), 14),
                       Limits::max(),
                       -Limits::max(),
                       std::ldexp(T(1), Limits::max_exponent - 1),
                       T(std::ldexp(1.0, sizeof(T) == 8 ? 400 : 100)),
                       T(std::ldexp(1.0, sizeof(T) == 8 ? -400 : -100)),
                       T(std::ldexp(1.0, sizeof(T) == 8 ? -200 : -50)),
                       Limits::infinity(),
                       Limits::quiet_NaN()};
  return numbers[draw.below(std::size(numbers))];
}

template <class T>
Numbers<T> shape(int way, Random& draw) {
  Numbers<T> s;
  for (T& x : s) x = static_cast<T>(draw.between(-4, 4));
  s[4] = std::fabs(s[4]);
  s[5] = std::fabs(s[5]);
  if (way == 1) {  // few digits: extents are numbers, and bounds exact
    for (T& x : s) x = std::round(x * 8) / 8;
  } else if (way == 2) {
    s[static_cast<std::size_t>(draw.below(6))] = extreme<T>(draw);
  } else if (way == 3) {
    for (T& x : s) x = extreme<T>(draw);
  } else if (way == 4) {
    const int range = sizeof(T) == 8 ? 420 : 60;
    for (T& x : s) x = std::ldexp(x, draw.integer(-range, range));
  } else if (way == 5) {  // along an axis, and flat
    s[2] = draw.chance(0.5) ? T(0) : T(-0.0);
    if (draw.chance(0.5)) s[4] = draw.chance(0.5) ? T(0) : T(-0.0);
  }
  return s;
}

enum class Layout { columns, packed, padded, backward };

/// An array of shapes as a caller has it.
template <class T>
class Stored {
 public:
  typename Face<T>::Shapes view(std::int32_t kind, std::span<const Numbers<T>> shapes, Layout layout, Edge edge) {
    const std::size_t fields = fields_of(kind), n = shapes.size();
    const std::size_t element = layout == Layout::columns ? 1 : fields + (layout == Layout::packed ? 0 : 1);
    const std::size_t used = layout == Layout::columns ? n * fields : (n - 1) * element + fields;
    auto* const low = reinterpret_cast<T*>(memory_.place(used * sizeof(T), edge));
    const bool backward = layout == Layout::backward;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < fields; ++k) {
        low[(backward ? n - 1 - i : i) * element + (layout == Layout::columns ? k * n : k)] = shapes[i][k];
      }
    }
    const auto stride = static_cast<std::ptrdiff_t>(element * sizeof(T));
    typename Face<T>::Shapes view{kind,    0, static_cast<std::int64_t>(n), backward ? -stride : stride, {}, nullptr,
                                  nullptr, 0};
    for (std::size_t k = 0; k < fields; ++k) {
      view.field[k] = low + (backward ? (n - 1) * element : 0) + (layout == Layout::columns ? k * n : k);
    }
    return view;
  }

 private:
  GuardedMemory memory_;
};

std::int64_t first_error(std::int64_t a, std::int64_t b) {
  return a == VESICA_E_SHAPE || b == 0 ? a : b == VESICA_E_RANGE ? b : VESICA_E_SHAPE;
}

/// The answers of single calls, `width` numbers an element, and the error of the array.
template <std::size_t width, class T, class One>
std::int64_t by_single_calls(std::span<const Numbers<T>> shapes, const One& one, std::vector<T>& out) {
  std::int64_t error = 0;
  for (const Numbers<T>& s : shapes) {
    std::array<T, width> numbers;
    numbers.fill(std::numeric_limits<T>::quiet_NaN());
    error = first_error(error, one(s, numbers.data()));
    out.insert(out.end(), numbers.begin(), numbers.end());
  }
  return error;
}

/// NaN has any bits.
template <class T>
bool same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}

template <class T>
class BoxArrays {
 public:
  void check(std::int32_t kind, std::span<const Numbers<T>> shapes, Layout layout, Edge edge) {
    using F = Face<T>;
    const auto view = stored_.view(kind, shapes, layout, edge);
    const auto bounds = [&](const Numbers<T>& s, T* out) {
      return F::bounds(kind, s.data(), reinterpret_cast<typename F::Aabb*>(out));
    };
    const auto corners = [&](const Numbers<T>& s, T* out) {
      const auto one = alone_.view(kind, std::span(&s, 1), Layout::packed, Edge::after);
      return F::corners_of_shapes(&one, out);
    };
    compare<4>(shapes, bounds, edge,
               [&](T* out) { return F::bounds_many(&view, reinterpret_cast<typename F::Aabb*>(out)); });
    const auto area = [&](const Numbers<T>& s, T* out) { return F::shape_area(kind, s.data(), out); };
    compare<1>(shapes, area, edge, [&](T* out) { return F::shape_area_many(&view, out); });
    if (kind < VESICA_RECT) return;
    compare<8>(shapes, corners, edge, [&](T* out) { return F::corners_of_shapes(&view, out); });
  }

 private:
  template <std::size_t width, class One, class Many>
  void compare(std::span<const Numbers<T>> shapes, const One& one, Edge edge, const Many& many) {
    std::vector<T> expected;
    const std::int64_t error = by_single_calls<width>(shapes, one, expected);
    auto* const out = reinterpret_cast<T*>(out_.place(expected.size() * sizeof(T), edge));
    EXPECT_EQ(many(out), error);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_TRUE(same(out[i], expected[i]))
          << "number " << i % width << " of " << width << " of shape " << i / width << " of " << shapes.size() << ": "
          << out[i] << " instead of " << expected[i] << ", seed " << properties::seed();
    }
  }

  Stored<T> stored_, alone_;
  GuardedMemory out_;
};

template <class T>
std::vector<Numbers<T>> drawn(std::size_t n, int most_way, Random& draw) {
  std::vector<Numbers<T>> shapes;
  // Half of them plain: a kernel has something to answer beside those that it leaves.
  for (std::size_t i = 0; i < n; ++i) shapes.push_back(shape<T>(i % 2 == 0 ? 0 : draw.below(most_way + 1), draw));
  return shapes;
}

template <class T>
void check_all_lengths() {
  Random draw(properties::seed());
  BoxArrays<T> arrays;
  for (const std::int32_t kind :
       {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE, VESICA_AABB, VESICA_RECT, VESICA_ELLIPSE}) {
    for (std::size_t n = 2; n <= 40; ++n) {
      for (const Layout layout : {Layout::columns, Layout::packed, Layout::padded, Layout::backward}) {
        for (const Edge edge : {Edge::before, Edge::after}) {
          auto shapes = drawn<T>(n, 5, draw);
          // A circle's radius is its third number, which would be invalid in half of the cases.
          if (kind == VESICA_CIRCLE) {
            for (auto& s : shapes) s[2] = std::fabs(s[2]);
          }
          arrays.check(kind, shapes, layout, edge);
        }
      }
    }
  }
}

TEST(BoxArrays, HaveTheBitsOfSingleCallsAtEveryLength) {
  check_all_lengths<double>();
  check_all_lengths<float>();
}

/// One way of drawing at a time, in arrays of several blocks.
template <class T>
void check_all_ways() {
  Random draw(properties::seed());
  BoxArrays<T> arrays;
  for (int round = 0; round < 8 * properties::repeat(); ++round) {
    for (const std::int32_t kind : {VESICA_CIRCLE, VESICA_RECT, VESICA_ELLIPSE}) {
      for (int way = 0; way <= 5; ++way) {
        std::vector<Numbers<T>> shapes;
        for (int i = 0; i < 300; ++i) shapes.push_back(shape<T>(way, draw));
        if (kind == VESICA_CIRCLE) {
          for (auto& s : shapes) s[2] = std::fabs(s[2]);
        }
        arrays.check(kind, shapes, Layout::packed, Edge::after);
      }
    }
  }
}

TEST(BoxArrays, HaveTheBitsOfSingleCallsAtExtremes) {
  check_all_ways<double>();
  check_all_ways<float>();
}

}  // namespace
