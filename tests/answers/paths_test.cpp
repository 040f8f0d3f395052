// SPDX-License-Identifier: Apache-2.0
// The same hashes of what is asked of polygons and polylines, by the other kind. They are those of paths.txt; see
// answers_test.cpp. All numbers are made of integers, so that they are the same with every C library.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "answers/table.hpp"
#include "polygon/questions.hpp"
#include "polygon/shapes.hpp"

namespace paths_test {
namespace {

using answers::Hash;
using answers::Table;
using polygons::Path;
using properties::Random;

struct Direction {
  int x, y;
};
/// By the angle from the positive x axis.
bool comes_before(const Direction& a, const Direction& b) {
  const auto lower_half = [](const Direction& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  if (lower_half(a) != lower_half(b)) return lower_half(b);
  return a.x * b.y - a.y * b.x > 0;
}

/// A ring around a place: vertices in all directions, so that edges seldom cross.
std::vector<double> ring_around(double x, double y, int n, Random& random) {
  std::vector<Direction> directions;
  while (static_cast<int>(directions.size()) < n) {
    const Direction d{random.integer(-64, 64), random.integer(-64, 64)};
    if (d.x != 0 || d.y != 0) directions.push_back(d);
  }
  std::sort(directions.begin(), directions.end(), comes_before);
  std::vector<double> ring;
  for (const Direction& d : directions) ring.insert(ring.end(), {x + d.x / 64.0, y + d.y / 64.0});
  return ring;
}

/// On a lattice, or around a place, sometimes with a hole; numbers of a float.
Path some_path(Random& random) {
  if (random.chance(0.3)) return polygons::lattice_path(4, random);
  Path path;
  const double x = random.integer(-40, 40) / 32.0, y = random.integer(-40, 40) / 32.0;
  path.add_ring(ring_around(x, y, random.chance(0.1) ? random.integer(1, 2) : random.integer(3, 9), random));
  if (random.chance(0.2)) {
    const double s = 1 / 64.0;
    path.add_ring({x - s, y - s, x + s, y - s, x, y + s});
  }
  return path;
}

/// A row's numbers: places and axes as they come, sizes not negative.
std::vector<double> some_row(std::int32_t kind, Random& random) {
  const auto any = [&] { return random.integer(-64, 64) / 32.0; };
  const auto size = [&] { return random.integer(0, 40) / 32.0; };
  switch (kind) {
    case VESICA_POINT:
      return {any(), any()};
    case VESICA_SEGMENT:
      return {any(), any(), any(), any()};
    case VESICA_CIRCLE:
      return {any(), any(), size()};
    case VESICA_AABB: {
      const double x = any(), y = any();
      return {x, y, x + size(), y + size()};
    }
    case VESICA_CAPSULE:
      return {any(), any(), any(), any(), size()};
    case VESICA_ROUND_RECT:
      return {any(), any(), 1 + size(), any(), size(), size(), size()};
    default:
      return {any(), any(), 1 + size(), any(), size(), size()};
  }
}

/// A shape's numbers and their struct, in one scalar.
template <class T>
struct Shape {
  std::int32_t kind;
  std::vector<T> numbers;
  std::vector<std::int32_t> rings;
  polygons::PolygonOf<T> path{};

  Shape(std::int32_t of, Random& random) : kind(of) {
    const bool is_path = kind == VESICA_POLYGON || kind == VESICA_POLYLINE;
    const Path drawn = is_path ? some_path(random) : Path{some_row(kind, random), {0, 1}};
    for (const double z : drawn.xy) numbers.push_back(static_cast<T>(z));
    rings = drawn.rings;
    path = {numbers.data(), numbers.data() + 1, 2 * sizeof(T), rings.data(),
            static_cast<std::int64_t>(drawn.ring_count())};
    given = {kind, is_path ? static_cast<const void*>(&path) : numbers.data()};
  }
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  polygons::Given given{};
};

class PathAnswers : public testing::TestWithParam<std::int32_t> {
 protected:
  template <class T>
  void compare(const char* scalar) {
    if (std::endian::native != std::endian::little) GTEST_SKIP() << "hashes are of bytes in the other order";
    static Table pinned = answers::read_table("paths.txt");
    for (const std::int32_t kind : {VESICA_POLYGON, VESICA_POLYLINE}) {
      std::map<std::string, Hash> hashes;
      Random random(static_cast<std::uint64_t>(900 + 16 * kind + GetParam()));
      for (int i = 0; i < 60; ++i) {
        const Shape<T> a(kind, random), b(GetParam(), random);
        for (const polygons::Question& q : polygons::questions<T>()) {
          if (std::string(q.name) == "turns") continue;  // by the C library
          hashes[q.name].add(q.ask(a.given, b.given));
          hashes[q.name].add(q.ask(b.given, a.given));
        }
      }
      const std::string of = kind == VESICA_POLYGON ? "polygon" : "polyline";
      for (const auto& [name, hash] : hashes) {
        auto& line = pinned[name + ' ' + scalar][of];
        line.resize(VESICA_POLYLINE + 1);
        answers::judge(line[static_cast<std::size_t>(GetParam())], hash.value(), name + ' ' + scalar + " of " + of);
      }
    }
    answers::write_table("paths.txt", pinned);
  }
};

TEST_P(PathAnswers, Double) { compare<double>("f64"); }
TEST_P(PathAnswers, Float) { compare<float>("f32"); }

INSTANTIATE_TEST_SUITE_P(All, PathAnswers, testing::Range(0, VESICA_POLYLINE + 1),
                         [](const testing::TestParamInfo<std::int32_t>& kind) {
                           return std::string(vesica_kind_name(kind.param));
                         });

}  // namespace
}  // namespace paths_test
