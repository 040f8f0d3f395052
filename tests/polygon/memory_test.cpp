// SPDX-License-Identifier: Apache-2.0
// Every question of polygons and polylines: no byte outside their arrays is read, whatever the offsets are; the same
// bits in every floating-point environment; at most 64 KiB of stack, of arrays 176.
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "batch/guard_pages.hpp"
#include "environment/environments.hpp"
#include "inflated/shapes.hpp"
#include "polygon/questions.hpp"
#include "polygon/shapes.hpp"

namespace polygon_memory {

using namespace polygons;
using batch_tests::Edge;
using batch_tests::GuardedMemory;
/// Vertices and offsets of a path, each against a guard page: x and y in turn, or a column each.
template <class T>
class Guarded {
 public:
  void write(const Path& path, Edge edge, bool columns) {
    const std::size_t n = path.xy.size() / 2, size = sizeof(T);
    std::byte* const x = x_.place((columns ? 1 : 2) * n * size, edge);
    std::byte* const y = columns ? y_.place(n * size, edge) : x + size;
    const std::size_t stride = (columns ? 1 : 2) * size;
    for (std::size_t i = 0; i < n; ++i) {
      const T p[] = {static_cast<T>(path.xy[2 * i]), static_cast<T>(path.xy[2 * i + 1])};
      std::memcpy(x + i * stride, &p[0], size);
      std::memcpy(y + i * stride, &p[1], size);
    }
    std::byte* const rings = rings_.place(path.rings.size() * sizeof(std::int32_t), edge);
    std::memcpy(rings, path.rings.data(), path.rings.size() * sizeof(std::int32_t));
    view = {reinterpret_cast<const T*>(x), reinterpret_cast<const T*>(y), static_cast<std::ptrdiff_t>(stride),
            reinterpret_cast<const std::int32_t*>(rings), static_cast<std::int64_t>(path.ring_count())};
  }
  PolygonOf<T> view{};

 private:
  GuardedMemory x_, y_, rings_;
};

inline Path some_path(Random& random, int most) {
  Path path;
  const int style = random.below(4);
  if (style == 0) return lattice_path(random.integer(2, 6), random);
  path.add_ring(star(random.integer(1, most), random.between(-2, 2), random.between(-2, 2), 1.5, 0.3, random));
  for (int holes = style == 1 ? random.integer(1, 3) : 0; holes > 0; --holes)
    path.add_ring(star(random.integer(1, 9), 0, 0, 0.2 * holes, 0.5, random));
  return path;
}
inline std::int32_t some_kind(Random& random) { return random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE; }

template <class T>
void guard_pages(int pairs) {
  Random random(801);
  Guarded<T> guarded_a, guarded_b;
  GuardedMemory row_memory;
  for (int i = 0; i < pairs; ++i) {
    const Edge edge = random.chance(0.5) ? Edge::before : Edge::after;
    const Path a = some_path(random, i % 16 == 0 ? 300 : 12), b = some_path(random, 40);
    guarded_a.write(a, edge, random.chance(0.5));
    guarded_b.write(b, edge, random.chance(0.5));
    const inflated::Shape other = inflated::any_shape(random);
    const auto fields = static_cast<std::size_t>(vesica_field_count(other.kind));
    T* const row = reinterpret_cast<T*>(row_memory.place(fields * sizeof(T), edge));
    std::transform(other.number.begin(), other.number.begin() + static_cast<std::ptrdiff_t>(fields), row,
                   [](double v) { return static_cast<T>(v); });
    const Given first{some_kind(random), &guarded_a.view}, second{some_kind(random), &guarded_b.view},
        third{other.kind, row};
    for (const Question& q : questions<T>()) {
      const Bytes answer = q.ask(first, second);
      ASSERT_EQ(q.ask(first, second), answer) << q.name;
      q.ask(first, third);
      q.ask(third, second);
    }
  }
}
TEST(PolygonMemory, GuardPages) {
  guard_pages<double>(400 * properties::repeat());
  guard_pages<float>(400 * properties::repeat());
}

/// Columns of polygons with any offsets: an element with bad ones is invalid, others answer as the struct does.
TEST(PolygonMemory, AnyOffsets) {
  Random random(802);
  GuardedMemory xs, ys, rings_memory, polygons_memory;
  int sound = 0, refused = 0;
  const int arrays = 6000 * properties::repeat();
  for (int i = 0; i < arrays; ++i) {
    const Edge edge = random.chance(0.5) ? Edge::before : Edge::after;
    const auto n = static_cast<std::size_t>(random.integer(1, 20)),
               ring_count = static_cast<std::size_t>(random.integer(1, 8)),
               count = static_cast<std::size_t>(random.integer(1, 5));
    auto* const x = reinterpret_cast<double*>(xs.place(n * sizeof(double), edge));
    auto* const y = reinterpret_cast<double*>(ys.place(n * sizeof(double), edge));
    for (std::size_t k = 0; k < n; ++k)
      x[k] = random.integer(-3, 3), y[k] = random.chance(0.02) ? HUGE_VAL : random.integer(-3, 3);
    const auto offsets = [&](GuardedMemory& memory, std::size_t size, int most, bool any) {
      auto* const at = reinterpret_cast<std::int32_t*>(memory.place(size * sizeof(std::int32_t), edge));
      for (std::size_t k = 0; k < size; ++k) at[k] = random.integer(0, most);
      std::sort(at, at + size);
      if (any && random.chance(0.5))
        at[static_cast<std::size_t>(random.below(static_cast<int>(size)))] = random.integer(-3, most);
      return at;
    };
    std::int32_t* const rings = offsets(rings_memory, ring_count + 1, static_cast<int>(n), true);
    const bool known = random.chance(0.7);  // the length of the columns is
    if (known && random.chance(0.3)) {
      const std::array<std::int32_t, 4> wild{INT32_MAX, INT32_MIN, static_cast<std::int32_t>(n) + 1, -1};
      rings[static_cast<std::size_t>(random.below(static_cast<int>(ring_count) + 1))] =
          wild[static_cast<std::size_t>(random.below(4))];
    }
    vesica_shapes_f64 shapes{};
    shapes.kind = some_kind(random);
    shapes.stride = sizeof(double);
    shapes.field[0] = x;
    shapes.field[1] = y;
    shapes.rings = rings;
    shapes.each = known ? static_cast<std::int64_t>(n) : 0;
    shapes.count = static_cast<std::int64_t>(ring_count);
    if (random.chance(0.5)) {
      shapes.polygons = offsets(polygons_memory, count + 1, static_cast<int>(ring_count), true);
      shapes.count = static_cast<std::int64_t>(count);
    }
    const vesica_circle_f64 disc{0.5, 0.5, 1};
    vesica_shapes_f64 one;
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, &disc, sizeof disc, &one), 0);
    std::array<std::uint8_t, 8> out{}, relation{};
    std::array<double, 8> number{};
    const std::int64_t code = vesica_overlap_many_f64(&shapes, &one, out.data());
    ASSERT_TRUE(code >= 0 || code == VESICA_E_SHAPE) << code;
    (code >= 0 ? sound : refused) += 1;
    vesica_relation_many_f64(&one, &shapes, relation.data());
    vesica_area_many_f64(&shapes, &one, number.data());
    vesica_nearest_many_f64(&shapes, &one, number.data(), nullptr, nullptr, nullptr, nullptr);
    vesica_depth_many_f64(&shapes, &one, number.data(), nullptr, nullptr);
    std::array<std::int64_t, 8> found{};
    const std::int64_t selected = vesica_overlap_select_f64(&one, &shapes, found.data(), 8);
    ASSERT_TRUE(selected >= 0 || selected == VESICA_E_SHAPE);
    for (std::int64_t k = 0; k < shapes.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const std::int64_t first = shapes.polygons == nullptr ? k : shapes.polygons[k],
                         last = shapes.polygons == nullptr ? k + 1 : shapes.polygons[k + 1];
      bool fine = first >= 0 && first < last;
      for (std::int64_t j = first; fine && j <= last; ++j)
        fine = rings[j] >= 0 && rings[j] <= static_cast<std::int32_t>(n) && (j == first || rings[j] >= rings[j - 1]);
      const vesica_polygon_f64 polygon{x, y, sizeof(double), rings + (fine ? first : 0), fine ? last - first : 0};
      const std::int32_t single = vesica_overlap_f64(shapes.kind, &polygon, VESICA_CIRCLE, &disc);
      ASSERT_EQ(out[at], single == 1 ? 1 : 0) << i << ' ' << k;
      ASSERT_TRUE(fine || code == VESICA_E_SHAPE);
    }
  }
  EXPECT_GT(sound, arrays / 10);
  EXPECT_GT(refused, arrays / 10);
}

/// Some pairs of paths, and of a path with another shape, at any magnitude.
template <class Action>
void for_pairs(int pairs, int seed, const Action& action) {
  Random random(static_cast<unsigned>(seed));
  for (int i = 0; i < pairs; ++i) {
    Path a = some_path(random, 12), b = some_path(random, 12);
    inflated::Shape other = inflated::any_shape(random);
    const double k = std::ldexp(1.0, random.chance(0.5) ? 0 : random.integer(-1070, 1000));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c *= k;
    }
    if (random.chance(0.7)) other = inflated::times(other, k);
    const auto view_a = a.view(), view_b = b.view();
    const Given first{some_kind(random), &view_a};
    action(first, Given{some_kind(random), &view_b});
    action(first, Given{other.kind, other.number.data()});
  }
}

TEST(PolygonMemory, EveryEnvironment) {
  for_pairs(150 * properties::repeat(), 803, [](const Given& a, const Given& b) {
    for (const Question& q : questions<double>()) {
      const Bytes expected = q.ask(a, b);
      for (const auto& e : environment::all_environments) {
        if (e.traps && std::string(q.name).ends_with("overlap")) continue;
        Bytes found;
        found.reserve(expected.size());
        ASSERT_TRUE(environment::ask_in(e, [&] { found = q.ask(a, b); })) << q.name << " in " << e.name;
        ASSERT_EQ(found, expected) << q.name << " in " << e.name;
      }
    }
  });
}

/// A thread's stack, painted first: where the paint is gone, it was used.
class Stack {
 public:
  std::size_t used_by(std::function<void()> call) {
    std::fill(memory_.begin(), memory_.end(), paint);
    call_ = std::move(call);
    auto* const begin = memory_.data() + (page - reinterpret_cast<std::uintptr_t>(memory_.data()) % page);
    pthread_attr_t attributes;
    pthread_t thread;
    EXPECT_EQ(pthread_attr_init(&attributes), 0);
    EXPECT_EQ(pthread_attr_setstack(&attributes, begin, size), 0);
    EXPECT_EQ(pthread_create(&thread, &attributes, run, this), 0);
    EXPECT_EQ(pthread_join(thread, nullptr), 0);
    pthread_attr_destroy(&attributes);
    return static_cast<std::size_t>(top_ - std::find_if(begin, top_, [](unsigned char c) { return c != paint; }));
  }

 private:
  static constexpr std::size_t size = 512 * 1024, page = 64 * 1024;
  static constexpr unsigned char paint = 0xa5;
  [[gnu::noinline]] static void* run(void* self) {
    auto& stack = *static_cast<Stack*>(self);
    stack.top_ = static_cast<unsigned char*>(__builtin_frame_address(0));
    stack.call_();
    return nullptr;
  }
  std::vector<unsigned char> memory_ = std::vector<unsigned char>(size + page);
  unsigned char* top_ = nullptr;
  std::function<void()> call_;
};

TEST(PolygonMemory, StackOfACall) {
  constexpr std::size_t promised = 64 * 1024, promised_of_arrays = 176 * 1024;
  Stack stack;
  std::size_t deepest = 0, deepest_of_arrays = 0;
  const auto measure = [&](const Given& a, const Given& b) {
    for (const Question& q : questions<double>()) {
      Bytes answer = q.ask(a, b);
      const std::size_t used = stack.used_by([&] { answer = q.ask(a, b); });
      EXPECT_LE(used, promised) << q.name;
      deepest = std::max(deepest, used);
    }
  };
  for_pairs(30, 804, measure);
  // Many vertices: blocks of blocks. Many rings: what is known of each.
  std::vector<double> ring;
  constexpr int n = 40000;
  for (int i = 0; i < n; ++i) {
    const double t = i * (6.283185307179586 / n), r = 1 + 0.01 * (i % 2);
    ring.insert(ring.end(), {r * std::cos(t), r * std::sin(t)});
  }
  Path one, other, squares;
  one.add_ring(ring);
  for (double& c : ring) c *= 0.98;
  other.add_ring(ring);
  for (int i = 0; i < 400; ++i) {
    const double x = i % 20, y = i / 20;
    squares.add_ring({x, y, x + 0.5, y, x + 0.5, y + 0.5, x, y + 0.5});
  }
  const auto a = one.view(), b = other.view(), c = squares.view();
  const vesica_ellipse_f64 ellipse{0.25, 0.25, 1, 1e-3, 1, 0.5};
  for (const Given& second : {Given{VESICA_POLYGON, &b}, Given{VESICA_POLYGON, &c}, Given{VESICA_ELLIPSE, &ellipse}})
    measure({VESICA_POLYGON, &a}, second);
  measure({VESICA_POLYGON, &c}, {VESICA_POLYGON, &c});
  // Arrays of polygons; each pair is asked alone.
  const vesica_polygon_f64 structs[] = {a, b, c};
  vesica_shapes_f64 array{};
  array.kind = VESICA_POLYGON;
  array.field[0] = reinterpret_cast<const double*>(structs);
  array.stride = sizeof(vesica_polygon_f64);
  array.count = 3;
  double out[9];
  std::uint8_t bytes[9];
  for (const auto& call : std::vector<std::function<std::int64_t()>>{
           [&] { return vesica_iou_matrix_f64(&array, &array, out, 3); },
           [&] { return vesica_ratio_many_f64(VESICA_RATIO_COMPLETE, &array, &array, out); },
           [&] { return vesica_nearest_matrix_f64(&array, &array, out, 3); },
           [&] { return vesica_boundary_distance_matrix_f64(&array, &array, out, 3); },
           [&] { return vesica_relation_matrix_f64(&array, &array, bytes, 3); },
           [&] { return vesica_overlap_matrix_f64(&array, &array, bytes, 3); }}) {
    const std::size_t used = stack.used_by(call);
    EXPECT_LE(used, promised_of_arrays);
    deepest_of_arrays = std::max(deepest_of_arrays, used);
  }
  std::printf("  at most %zu bytes, with arrays %zu\n", deepest, deepest_of_arrays);
}

/// Equal vertices, which are one point: not every edge against every other.
TEST(PolygonMemory, AMillionEqualVertices) {
  constexpr int n = 1000000;
  std::vector<double> ring, far;
  for (int i = 0; i < n; ++i) ring.insert(ring.end(), {1, 2}), far.insert(far.end(), {3, 2});
  Path one, other;
  one.add_ring(ring);
  other.add_ring(far);
  const auto a = one.view(), b = other.view();
  for (const Question& q : questions<double>()) {
    q.ask({VESICA_POLYGON, &a}, {VESICA_POLYGON, &a});
    q.ask({VESICA_POLYGON, &a}, {VESICA_POLYLINE, &b});
  }
  EXPECT_EQ(vesica_relation_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &a), VESICA_EQUAL);
  vesica_closest_points_f64 points;
  EXPECT_EQ(vesica_nearest_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &points), 0);
  EXPECT_EQ(points.distance, 2);
}

}  // namespace polygon_memory
