// SPDX-License-Identifier: Apache-2.0
// No byte outside an array is read or written by any function of arrays, at every length from 0 to 40, on the
// instruction set that VESICA_ISA names: every array lies against a page that may not be touched, before or behind it.
// A fault is the failure. What is written is written throughout; a call that refuses the kinds writes nothing.
#include "batch/guard_pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "batch/data.hpp"
#include "batch/guarded_shapes.hpp"

namespace {

using namespace batch_tests;
using capi_tests::Face;

constexpr std::size_t longest = 40;
constexpr int pattern = 0xA5;

/// Arrays of numbers that a call reads or writes, all against the same edge; new ones are full of a pattern.
class Rooms {
 public:
  explicit Rooms(Edge edge) : edge_(edge) {}

  template <class X>
  X* room(std::size_t count) {
    static std::array<GuardedMemory, 8> memory;
    auto* const bytes = memory.at(used_++).place(count * sizeof(X), edge_);
    std::memset(bytes, pattern, count * sizeof(X));
    return reinterpret_cast<X*>(bytes);
  }
  template <class X>
  X* copy(const std::vector<X>& from) {
    X* const to = room<X>(from.size());
    std::copy(from.begin(), from.end(), to);
    return to;
  }
  std::byte* scratch(std::int64_t size) {
    static GuardedMemory memory(1 << 19);
    return memory.place(static_cast<std::size_t>(size), edge_);
  }

 private:
  Edge edge_;
  std::size_t used_ = 0;
};

/// Is an element no longer the pattern?
template <class X>
bool is_written(const X& element) {
  std::array<unsigned char, sizeof(X)> bytes;
  std::memcpy(bytes.data(), &element, sizeof(X));
  return std::any_of(bytes.begin(), bytes.end(), [](unsigned char byte) { return byte != pattern; });
}
template <class X>
std::size_t written(const X* out, std::size_t n) {
  return static_cast<std::size_t>(std::count_if(out, out + n, is_written<X>));
}

/// How two arrays lie. There are five, so that in 40 lengths each meets every remainder of lanes.
struct Lie {
  Layout a, b;
};
constexpr std::array<Lie, 5> lies{{{Layout::columns, Layout::columns},
                                   {Layout::packed, Layout::packed},
                                   {Layout::odd_records, Layout::backward_columns},
                                   {Layout::single, Layout::backward_records},
                                   {Layout::packed, Layout::repeated}}};
constexpr std::array ratios{VESICA_RATIO_OVER_FIRST, VESICA_RATIO_GENERALIZED, VESICA_RATIO_COMPLETE};

template <class T>
class GuardPagesOfArrays : public testing::Test {
 protected:
  using Shapes = typename Face<T>::Shapes;

  /// Calls body for all kinds at every length and edge, with a number that differs from length to length and kind to
  /// kind.
  template <class Body>
  void at_every_length(const Body& body) {
    for (int kind_a = 0; kind_a < properties::kinds; ++kind_a) {
      for (int kind_b = 0; kind_b < properties::kinds; ++kind_b) {
        const Pairs<T>& pairs = mixed_pairs<T>(kind_a, kind_b);
        std::size_t begin = 0;
        for (std::size_t n = 0; n <= longest; ++n) {
          const std::span<const Numbers<T>> a(&pairs.a[begin], n), b(&pairs.b[begin], n);
          const std::size_t turn = n + static_cast<std::size_t>(kind_a + 2 * kind_b);
          for (const Edge edge : {Edge::before, Edge::after}) body(turn, kind_a, a, kind_b, b, edge);
          begin = (begin + n) % (pairs.size() - longest);
        }
      }
    }
  }

  Shapes write_a(int kind, std::span<const Numbers<T>> shapes, Layout layout, Edge edge) {
    static GuardedShapes memory;
    return c_shapes(memory.write<T>(kind, shapes, layout, edge));
  }
  Shapes write_b(int kind, std::span<const Numbers<T>> shapes, Layout layout, Edge edge) {
    static GuardedShapes memory;
    return c_shapes(memory.write<T>(kind, shapes, layout, edge));
  }

  /// A call that fills `columns` columns of n elements.
  template <class Out, std::size_t columns, class Call>
  static void fill(const char* name, std::size_t n, Edge edge, const Call& call) {
    Rooms rooms(edge);
    std::array<Out*, columns> out;
    for (Out*& column : out) column = rooms.room<Out>(n);
    const std::int64_t code = call(out);
    const std::size_t expected = code == VESICA_E_KIND ? 0 : n;
    for (const Out* column : out) EXPECT_EQ(written(column, n), expected) << name << " returned " << code;
  }

  void many(const Shapes& a, const Shapes& b, std::size_t n, Edge edge) {
    using F = Face<T>;
    using Byte = std::uint8_t;
    fill<Byte, 1>("overlap", n, edge, [&](auto out) { return F::overlap_many(&a, &b, out[0]); });
    fill<Byte, 1>("relation", n, edge, [&](auto out) { return F::relation_many(&a, &b, out[0]); });
    fill<Byte, 1>("contains", n, edge, [&](auto out) { return F::contains_many(&a, &b, out[0]); });
    fill<Byte, 1>("within", n, edge, [&](auto out) { return F::within_many(&a, &b, T(0.5), out[0]); });
    fill<T, 5>("nearest", n, edge,
               [&](auto out) { return F::nearest_many(&a, &b, out[0], out[1], out[2], out[3], out[4]); });
    fill<T, 2>("nearest, some", n, edge,
               [&](auto out) { return F::nearest_many(&a, &b, nullptr, out[0], nullptr, nullptr, out[1]); });
    fill<T, 5>("boundary_distance", n, edge,
               [&](auto out) { return F::boundary_distance_many(&a, &b, out[0], out[1], out[2], out[3], out[4]); });
    fill<T, 3>("depth", n, edge, [&](auto out) { return F::depth_many(&a, &b, out[0], out[1], out[2]); });
    fill<T, 1>("depth, one", n, edge, [&](auto out) { return F::depth_many(&a, &b, nullptr, nullptr, out[0]); });
    fill<T, 1>("signed_distance", n, edge, [&](auto out) { return F::signed_distance_many(&a, &b, out[0]); });
    fill<T, 1>("area", n, edge, [&](auto out) { return F::area_many(&a, &b, out[0]); });
    fill<T, 1>("iou", n, edge, [&](auto out) { return F::iou_many(&a, &b, out[0]); });
    fill<T, 1>("ratio", n, edge, [&](auto out) { return F::ratio_many(ratios[n % 3], &a, &b, out[0]); });
    fill<T, 1>("gaussian_distance", n, edge,
               [&](auto out) { return F::gaussian_distance_many(static_cast<int>(n % 4), &a, &b, out[0]); });
    fill<T, 1>("volume_ratio", n, edge, [&](auto out) {
      Rooms rooms(edge);
      const auto* const spans = rooms.template room<typename F::Span>(n);
      return F::volume_ratio_many(static_cast<int>(n % 4), &a, spans, &b, spans, out[0]);
    });
  }

  /// A call that fills a matrix and leaves two elements between its rows.
  template <class Out, class Call>
  static void fill_matrix(const char* name, std::size_t rows, std::size_t columns, Edge edge, const Call& call) {
    Rooms rooms(edge);
    const std::size_t step = columns + 2, size = rows == 0 || columns == 0 ? 0 : (rows - 1) * step + columns;
    Out* const out = rooms.room<Out>(size);
    const bool backward = columns % 2 == 1 && size > 0;
    const auto row_stride = static_cast<std::ptrdiff_t>(step) * (backward ? -1 : 1);
    const std::int64_t code = call(out + (backward ? (rows - 1) * step : 0), row_stride);
    EXPECT_EQ(written(out, size), code == VESICA_E_KIND ? 0 : rows * columns) << name << " returned " << code;
  }

  void matrix(const Shapes& a, const Shapes& b, Edge edge) {
    using F = Face<T>;
    using Byte = std::uint8_t;
    const auto rows = static_cast<std::size_t>(a.count), columns = static_cast<std::size_t>(b.count);
    const auto of = [&]<class Out>(Out, const char* name, auto function, auto... more) {
      fill_matrix<Out>(name, rows, columns, edge,
                       [&](Out* out, std::ptrdiff_t step) { return function(&a, &b, more..., out, step); });
    };
    of(Byte{}, "overlap", F::overlap_matrix);
    of(Byte{}, "relation", F::relation_matrix);
    of(Byte{}, "contains", F::contains_matrix);
    of(Byte{}, "within", F::within_matrix, T(0.5));
    of(T{}, "area", F::area_matrix);
    of(T{}, "iou", F::iou_matrix);
    of(T{}, "nearest", F::nearest_matrix);
    of(T{}, "boundary_distance", F::boundary_distance_matrix);
    of(T{}, "depth", F::depth_matrix);
    of(T{}, "signed_distance", F::signed_distance_matrix);
    const std::int32_t ratio = ratios[(rows + columns) % 3];
    fill_matrix<T>("ratio", rows, columns, edge,
                   [&](T* out, std::ptrdiff_t step) { return F::ratio_matrix(ratio, &a, &b, out, step); });
    const auto which = static_cast<std::int32_t>((rows + columns) % 4);
    fill_matrix<T>("gaussian_distance", rows, columns, edge,
                   [&](T* out, std::ptrdiff_t step) { return F::gaussian_distance_matrix(which, &a, &b, out, step); });
    fill_matrix<T>("volume_ratio", rows, columns, edge, [&](T* out, std::ptrdiff_t step) {
      Rooms spans(edge);
      const auto* const first = spans.template room<typename F::Span>(rows);
      const auto* const second = spans.template room<typename F::Span>(columns);
      return F::volume_ratio_matrix(which, &a, first, &b, second, out, step);
    });
  }
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(GuardPagesOfArrays, Scalars);

TYPED_TEST(GuardPagesOfArrays, AreNotTouchedInStep) {
  this->at_every_length([&](std::size_t turn, int kind_a, auto a, int kind_b, auto b, Edge edge) {
    const Lie lie = lies[turn % lies.size()];
    this->many(this->write_a(kind_a, a, lie.a, edge), this->write_b(kind_b, b, lie.b, edge), a.size(), edge);
  });
}

TYPED_TEST(GuardPagesOfArrays, AreNotTouchedByMatrices) {
  this->at_every_length([&](std::size_t turn, int kind_a, auto a, int kind_b, auto b, Edge edge) {
    const Lie lie = lies[turn % 3];
    const bool wide = (turn / 3) % 2 == 0;
    const auto rows = wide ? a.first(std::min<std::size_t>(2, a.size())) : a;
    const auto columns = wide ? b : b.first(std::min<std::size_t>(2, b.size()));
    this->matrix(this->write_a(kind_a, rows, lie.a, edge), this->write_b(kind_b, columns, lie.b, edge), edge);
  });
}

TYPED_TEST(GuardPagesOfArrays, AreNotTouchedBySelect) {
  using T = TypeParam;
  this->at_every_length([&](std::size_t turn, int kind_a, auto a, int kind_b, auto b, Edge edge) {
    if (a.empty()) return;
    const auto one = this->write_a(kind_a, a.first(1), Layout::single, edge);
    const auto all = this->write_b(kind_b, b, lies[turn % 3].b, edge);
    const std::int64_t found = Face<T>::overlap_select(&one, &all, nullptr, 0);
    for (std::int64_t room = std::max<std::int64_t>(0, found - 1); room <= found + 1; ++room) {
      Rooms rooms(edge);
      auto* const out = rooms.room<std::int64_t>(static_cast<std::size_t>(room));
      EXPECT_EQ(Face<T>::overlap_select(&one, &all, out, room), found);
      // An entry after the last is -1.
      EXPECT_EQ(std::count(out, out + room, -1), room > found ? 1 : 0);
    }
  });
}

TYPED_TEST(GuardPagesOfArrays, AreNotTouchedByCasts) {
  using T = TypeParam;
  using F = Face<T>;
  this->at_every_length([&](std::size_t turn, int kind_a, auto a, int kind_b, auto b, Edge edge) {
    const Lie lie = lies[turn % lies.size()];
    const std::size_t n = a.size(), velocities = turn % 3 == 0 ? std::min<std::size_t>(1, n) : n;
    const auto at_rest = this->write_a(kind_a, a, lie.a, edge), moving = this->write_b(kind_b, b, lie.b, edge);
    const std::ptrdiff_t strides[] = {0, sizeof(T), -static_cast<std::ptrdiff_t>(sizeof(T))};
    Rooms rooms(edge);
    const T* const vx = rooms.copy(std::vector<T>(velocities, T(0.5)));
    const T* const vy = rooms.copy(std::vector<T>(velocities, T(-0.25)));
    const std::size_t first = turn % 3 == 2 && n > 0 ? n - 1 : 0;
    std::array<T*, 5> out;
    for (T*& column : out) column = rooms.room<T>(n);
    const std::int64_t code = F::cast_many(&at_rest, &moving, vx + first, vy + first, strides[turn % 3], 8, out[0],
                                           out[1], out[2], out[3], out[4]);
    for (const T* column : out) EXPECT_EQ(written(column, n), n) << "cast returned " << code;
    if (n == 0) return;
    const auto one = this->write_b(kind_b, b.first(1), Layout::single, edge);
    typename F::Impact impact{};
    for (const Layout layout : {lie.a, Layout::columns}) {
      const auto many = this->write_a(kind_a, a, layout, edge);
      EXPECT_LE(F::cast_first(&one, &many, T(0.5), T(-0.25), 8, &impact), static_cast<std::int64_t>(n));
    }
  });
}

TYPED_TEST(GuardPagesOfArrays, AreNotTouchedByBoxes) {
  using T = TypeParam;
  using F = Face<T>;
  for (std::size_t n = 0; n <= longest; ++n) {
    for (const Edge edge : {Edge::before, Edge::after}) {
      for (const std::size_t gap : {std::size_t{0}, std::size_t{1}}) {
        const std::size_t row = 5 + gap;
        const std::vector<T> numbers(n == 0 ? 0 : (n - 1) * row + 5, T(3));
        const auto count = static_cast<std::int64_t>(n);
        const auto stride = static_cast<std::ptrdiff_t>(row * sizeof(T));
        Rooms rooms(edge);
        const T* const boxes = rooms.copy(numbers);
        auto* const rects = rooms.room<typename F::Rect>(n);
        auto* const ellipses = rooms.room<typename F::Ellipse>(n);
        EXPECT_EQ(F::rects_from_boxes(boxes, count, stride, VESICA_ANGLE_DEGREES, rects), 0);
        EXPECT_EQ(F::ellipses_from_boxes(boxes, count, stride, VESICA_ANGLE_DEGREES, ellipses), 0);
        EXPECT_EQ(written(rects, n), n);
        EXPECT_EQ(written(ellipses, n), n);
        const std::size_t eight = 8 + gap;
        const std::vector<T> equal(n == 0 ? 0 : (n - 1) * eight + 8, T(3));
        const auto apart = static_cast<std::ptrdiff_t>(eight * sizeof(T));
        const T* const corners = rooms.copy(equal);
        auto* const made = rooms.room<typename F::Rect>(n);
        T* const misfit = rooms.room<T>(n);
        EXPECT_EQ(F::rects_from_corners(corners, count, apart, made), 0);
        EXPECT_EQ(written(made, n), n);
        typename F::Shapes shapes;
        EXPECT_EQ(F::from_records(VESICA_RECT, count, made, sizeof(typename F::Rect), &shapes), 0);
        EXPECT_EQ(F::rect_corners_misfit_many(corners, apart, &shapes, misfit), 0);
        EXPECT_EQ(written(misfit, n), n);
      }
      for (int kind = 0; kind < properties::kinds; ++kind) {
        const std::span<const Numbers<T>> shapes(mixed_pairs<T>(kind, kind).a.data(), n);
        const auto all = this->write_a(kind, shapes, lies[n % 3].a, edge);
        Rooms rooms(edge);
        auto* const bounds = rooms.room<typename F::Aabb>(n);
        const std::int64_t code = F::bounds_many(&all, bounds);
        EXPECT_EQ(written(bounds, n), n) << code;
        T* const areas = rooms.room<T>(n);
        F::shape_area_many(&all, areas);
        EXPECT_EQ(written(areas, n), n);
        if (kind != VESICA_RECT && kind != VESICA_ELLIPSE) continue;
        T* const corners = rooms.room<T>(8 * n);
        T* const boxes = rooms.room<T>(5 * n);
        F::corners_of_shapes(&all, corners);
        F::boxes_from_shapes(&all, VESICA_ANGLE_RADIANS, boxes);
        EXPECT_EQ(written(corners, 8 * n), 8 * n);
        EXPECT_EQ(written(boxes, 5 * n), 5 * n);
      }
    }
  }
}

/// Unit squares in a row, each over half of the next: with thresholds below 1/3 every second one is kept.
TYPED_TEST(GuardPagesOfArrays, AreNotTouchedBySuppression) {
  using T = TypeParam;
  using F = Face<T>;
  for (std::size_t n = 0; n <= longest; ++n) {
    std::vector<Numbers<T>> squares;
    std::vector<T> falling;
    for (std::size_t i = 0; i < n; ++i) {
      const T left = T(i) / 2;
      squares.push_back({left, 0, left + 1, 1});
      falling.push_back(T(2 * n - i));
    }
    const auto count = static_cast<std::int64_t>(n), half = (count + 1) / 2;
    for (const Edge edge : {Edge::before, Edge::after}) {
      const auto shapes = this->write_a(VESICA_AABB, squares, lies[n % 3].a, edge);
      Rooms rooms(edge);
      const T* const scores = rooms.copy(falling);
      const std::int32_t* const labels = rooms.copy(std::vector<std::int32_t>(n, 7));
      const std::int64_t size = vesica_nms_scratch(count), soft_size = vesica_suppress_soft_scratch(count);
      auto* const keep = rooms.room<std::int64_t>(n);
      std::int64_t kept = -1;
      EXPECT_EQ(F::nms(&shapes, scores, T(0.25), rooms.scratch(size), size, keep, &kept), 0);
      EXPECT_EQ(kept, half);
      auto* const few = rooms.room<std::int64_t>(n / 3);
      EXPECT_EQ(F::suppress(&shapes, scores, labels, VESICA_RATIO_OVER_UNION, T(0.25), 0, count / 3,
                            rooms.scratch(size), size, few, &kept),
                0);
      EXPECT_EQ(kept, count / 3);
      auto* const soft = rooms.room<std::int64_t>(n);
      T* const decayed = rooms.room<T>(n);
      EXPECT_EQ(F::suppress_soft(&shapes, scores, labels, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, T(0.25), 0,
                                 count, rooms.scratch(soft_size), soft_size, soft, decayed, &kept),
                0);
      EXPECT_EQ(kept, count);
      EXPECT_EQ(written(keep, n), static_cast<std::size_t>(half));
      EXPECT_EQ(written(few, n / 3), n / 3);
      EXPECT_EQ(written(soft, n), n);
      EXPECT_EQ(written(decayed, n), n);
    }
  }
}

}  // namespace
