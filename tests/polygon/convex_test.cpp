// SPDX-License-Identifier: Apache-2.0
// Triangles and quadrilaterals: the filter by separating axes and the lanes decide as the edges do.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>
#include <vesica/polygon/overlap.hpp>
#include <vesica/polygon/relation.hpp>

#include "polygon/questions.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_convex {

using namespace polygons;
namespace path = vesica::detail::polygon;

template <class T>
std::int32_t overlap(const PolygonOf<T>& a, const PolygonOf<T>& b) {
  return Face<T>::overlap(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
}
template <class T>
std::int32_t insides_overlap(const PolygonOf<T>& a, const PolygonOf<T>& b) {
  return Face<T>::interiors_overlap(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
}

/// n vertices, x y x y ...
template <class T>
using Numbers = std::vector<T>;

template <class T>
PolygonOf<T> view(const T* xy, std::int64_t n) {
  return {xy, xy + 1, 2 * sizeof(T), nullptr, n};
}
template <class T>
vesica::Polygon<T> core(const PolygonOf<T>& p) {
  return {p.x, p.y, p.stride, p.rings, p.count};
}

/// Answers by the edges, without the filter.
template <class T>
std::int32_t by_edges(const PolygonOf<T>& a, const PolygonOf<T>& b) {
  return path::overlap_or_error(path::Edges<T>(core<T>(a)), path::Edges<T>(core<T>(b)));
}
template <class T>
std::int32_t insides_by_edges(const PolygonOf<T>& a, const PolygonOf<T>& b) {
  return path::interiors_overlap_or_error(path::Edges<T>(core<T>(a)), path::Edges<T>(core<T>(b)));
}

/// Arrays of as many vertices each.
template <class T>
typename Face<T>::Shapes array(const Numbers<T>& xy, std::int64_t each) {
  typename Face<T>::Shapes s{};
  s.kind = VESICA_POLYGON;
  s.count = static_cast<std::int64_t>(xy.size()) / (2 * each);
  s.stride = 2 * sizeof(T);
  s.field[0] = xy.data();
  s.field[1] = xy.data() + 1;
  s.each = each;
  return s;
}

/// Calls and arrays in step agree with the edges, for overlap and for insides. Returns how many overlap.
template <class T>
int check(const Numbers<T>& a, const Numbers<T>& b, int n) {
  const auto first = array(a, n), second = array(b, n);
  const auto count = static_cast<std::size_t>(first.count);
  std::vector<std::uint8_t> many(count), insides(count);
  EXPECT_GE(Face<T>::overlap_many(&first, &second, many.data()), 0);
  EXPECT_GE(Face<T>::interiors_overlap_many(&first, &second, insides.data()), 0);
  int met = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 2 * i * static_cast<std::size_t>(n);
    const auto p = view(&a[at], n), q = view(&b[at], n);
    const std::int32_t expected = by_edges<T>(p, q), inner = insides_by_edges<T>(p, q);
    met += expected;
    EXPECT_EQ(overlap<T>(p, q), expected) << i;
    EXPECT_EQ(overlap<T>(q, p), expected) << i;
    EXPECT_EQ(many[i], expected) << i;
    if (expected >= inner) {  // of rings that cross themselves the edges may find insides that meet where rings do not
      EXPECT_EQ(insides_overlap<T>(p, q), inner) << i;
      EXPECT_EQ(insides[i], inner) << i;
    }
    if (testing::Test::HasFailure()) return met;
  }
  return met;
}

/// Random vertices are seldom convex, coincide and lie on edges; at any scale, far from the origin too.
template <class T>
void check_lattices() {
  Random random(71);
  const int most = std::is_same_v<T, float> ? 120 : 1000, least = std::is_same_v<T, float> ? -140 : -1060;
  for (int round = 0; round < 400 * properties::repeat(); ++round) {
    const int n = random.integer(3, 4), size = random.integer(2, 12);
    const bool scaled = random.chance(0.5);
    const T scale = static_cast<T>(std::ldexp(1.0, scaled ? random.integer(least, most) : 0));
    const T far = scaled ? T{0} : static_cast<T>(random.chance(0.5) ? 1e6 : 1e15);
    Numbers<T> a, b;
    for (int i = 0; i < 1000; ++i) {
      const int shift = random.below(size);
      for (int k = 0; k < 2 * n; ++k) {
        a.push_back((static_cast<T>(random.below(size)) + far) * scale);
        b.push_back((static_cast<T>(random.below(size) + (k % 2) * shift) + far) * scale);
      }
    }
    check(a, b, n);
    ASSERT_FALSE(testing::Test::HasFailure()) << n << " vertices, scale " << scale << ", far " << far;
  }
}
TEST(PolygonConvex, LatticesInDouble) { check_lattices<double>(); }
TEST(PolygonConvex, LatticesInFloat) { check_lattices<float>(); }

/// A convex ring in an ellipse of half sizes 1 and `thin`.
template <class T>
void add_ring(Numbers<T>& xy, int n, double x, double y, double thin, Random& random) {
  const double start = random.between(0, 6.3), turn = random.between(0, 6.3);
  const double direction = random.chance(0.5) ? 1 : -1;
  for (int i = 0; i < n; ++i) {
    const double t = start + direction * 6.283185307179586 * (i + random.between(0, 0.6)) / n;
    const double along = std::cos(t), across = thin * std::sin(t);
    xy.push_back(static_cast<T>(x + along * std::cos(turn) - across * std::sin(turn)));
    xy.push_back(static_cast<T>(y + along * std::sin(turn) + across * std::cos(turn)));
  }
}

/// Ordinary pairs never reach the edges; if the filter is not asked, this fails.
template <class T>
void check_ordinary() {
  Random random(72);
  for (const int n : {3, 4}) {
    Numbers<T> a, b;
    int open = 0, met = 0;
    for (int i = 0; i < 2000; ++i) {
      add_ring(a, n, 0, 0, random.between(0.3, 1), random);
      add_ring(b, n, random.between(-2, 2), random.between(-2, 2), random.between(0.3, 1), random);
      const std::size_t at = a.size() - static_cast<std::size_t>(2 * n);
      open += path::convex_overlap(core<T>(view(&a[at], n)), core<T>(view(&b[at], n))) == vesica::filter::undecided;
    }
    EXPECT_LE(open, 2);
    met = check(a, b, n);
    EXPECT_GT(met, 400);
    EXPECT_LT(met, 1600);
  }
}
TEST(PolygonConvex, OrdinaryInDouble) { check_ordinary<double>(); }
TEST(PolygonConvex, OrdinaryInFloat) { check_ordinary<float>(); }

/// One coordinate of b is moved until the two just touch, and some units in the last place to either side.
template <class T>
void check_contacts() {
  Random random(73);
  int met = 0, all = 0;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const int n = random.integer(3, 4);
    const double thin = random.chance(0.3) ? 1e-6 : random.between(0.05, 1);
    const double far = random.chance(0.3) ? 1e4 : 0;
    Numbers<T> a, b;
    add_ring(a, n, far, far, thin, random);
    add_ring(b, n, far, far, random.between(0.05, 1), random);
    const auto moved = [&](T by) {
      Numbers<T> c = b;
      for (std::size_t k = 0; k < c.size(); k += 2) c[k] += by;
      return c;
    };
    const auto overlap = [&](T by) { return by_edges<T>(view(a.data(), n), view(moved(by).data(), n)) == 1; };
    if (!overlap(0) || overlap(4)) continue;
    T low = 0, high = 4;
    while (true) {
      const T middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      (overlap(middle) ? low : high) = middle;
    }
    Numbers<T> first, second;
    T by = low;
    for (int k = 0; k < 20; ++k) by = std::nextafter(by, T{0});
    for (int k = 0; k < 40; ++k, by = std::nextafter(by, T{8})) {
      const Numbers<T> c = moved(by);
      first.insert(first.end(), a.begin(), a.end());
      second.insert(second.end(), c.begin(), c.end());
    }
    met += check(first, second, n);
    all += 40;
    ASSERT_FALSE(testing::Test::HasFailure()) << i;
  }
  EXPECT_GT(met, all / 4);
  EXPECT_LT(met, all * 3 / 4);
}
TEST(PolygonConvex, ContactsInDouble) { check_contacts<double>(); }
TEST(PolygonConvex, ContactsInFloat) { check_contacts<float>(); }

/// Closed rings, offsets, structs, one against many, columns, and every length of an array.
TEST(PolygonConvex, EveryLayout) {
  Random random(74);
  Numbers<double> a, b, closed_b, x, y;
  constexpr int count = 300;
  std::vector<std::int32_t> rings;
  std::vector<vesica_polygon_f64> structs;
  for (int i = 0; i < count; ++i) {
    add_ring(a, 4, 0, 0, random.between(0.3, 1), random);
    add_ring(b, 4, random.between(-2, 2), random.between(-2, 2), random.between(0.3, 1), random);
    rings.push_back(5 * i);
    for (std::size_t k = 0; k < 5; ++k) {
      closed_b.push_back(b[static_cast<std::size_t>(8 * i) + 2 * (k % 4)]);
      closed_b.push_back(b[static_cast<std::size_t>(8 * i) + 2 * (k % 4) + 1]);
    }
  }
  rings.push_back(5 * count);
  for (std::size_t k = 0; k < b.size(); k += 2) {
    x.push_back(b[k]);
    y.push_back(b[k + 1]);
  }
  for (std::size_t i = 0; i < count; ++i) structs.push_back(view(&closed_b[10 * i], i % 3 == 0 ? 5 : 4));
  vesica_shapes_f64 columns = array(b, 4), offsets{}, of_structs{}, closed = array(closed_b, 5);
  columns.field[0] = x.data();
  columns.field[1] = y.data();
  columns.stride = sizeof(double);
  offsets = closed;
  offsets.each = 0;
  offsets.rings = rings.data();
  offsets.count = count;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, count, structs.data(), sizeof structs[0], &of_structs), 0);
  const auto first = array(a, 4), second = array(b, 4);
  for (const vesica_shapes_f64& other : {second, columns, closed, offsets, of_structs}) {
    for (std::int64_t n = 1; n <= count; n += n < 40 ? 1 : 13) {
      vesica_shapes_f64 p = first, q = other;
      p.count = q.count = n;
      std::vector<std::uint8_t> out(static_cast<std::size_t>(n), 9);
      std::int64_t met = 0;
      ASSERT_GE(met = vesica_overlap_many_f64(&p, &q, out.data()), 0);
      std::int64_t expected_met = 0;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int32_t expected = by_edges<double>(view(&a[8 * i], 4), view(&b[8 * i], 4));
        ASSERT_EQ(out[i], expected) << i << " of " << n;
        expected_met += expected;
      }
      ASSERT_EQ(met, expected_met);
      // One against many, on either side, and the indices.
      p.count = 1;
      std::vector<std::int64_t> found(static_cast<std::size_t>(n) + 1, -2);
      std::vector<std::uint8_t> exchanged(static_cast<std::size_t>(n), 9);
      ASSERT_GE(vesica_overlap_many_f64(&p, &q, out.data()), 0);
      ASSERT_GE(vesica_overlap_many_f64(&q, &p, exchanged.data()), 0);
      ASSERT_GE(met = vesica_overlap_select_f64(&p, &q, found.data(), n), 0);
      std::size_t next = 0;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int32_t expected = by_edges<double>(view(a.data(), 4), view(&b[8 * i], 4));
        ASSERT_EQ(out[i], expected) << i << " of " << n;
        ASSERT_EQ(exchanged[i], expected) << i << " of " << n;
        if (expected == 1) {
          ASSERT_EQ(found[next++], static_cast<std::int64_t>(i));
        }
      }
      ASSERT_EQ(met, static_cast<std::int64_t>(next));
    }
  }
  vesica_shapes_f64 rows = first;
  rows.count = 37;
  std::vector<std::uint8_t> matrix(37 * count, 9);
  const std::int64_t met = vesica_overlap_matrix_f64(&rows, &second, matrix.data(), count);
  std::int64_t expected_met = 0;
  for (std::size_t i = 0; i < 37; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const std::int32_t expected = by_edges<double>(view(&a[8 * i], 4), view(&b[8 * j], 4));
      ASSERT_EQ(matrix[i * count + j], expected) << i << " " << j;
      expected_met += expected;
    }
  }
  EXPECT_EQ(met, expected_met);
}

/// A number that is not finite is an error of its pair alone, wherever it is and however far apart the boxes are.
template <class T>
void check_invalid() {
  Random random(75);
  for (const T wrong :
       {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity()}) {
    for (const int n : {3, 4}) {
      for (int k = 0; k < 2 * n; ++k) {
        for (const double away : {0.0, 1.0, 50.0}) {
          Numbers<T> a, b;
          for (int i = 0; i < 20; ++i) {
            add_ring(a, n, 0, 0, 0.5, random);
            add_ring(b, n, away, 0, 0.5, random);
          }
          const std::size_t at = static_cast<std::size_t>(2 * n) * 11;
          b[at + static_cast<std::size_t>(k)] = wrong;
          const auto first = array(a, n), second = array(b, n);
          std::vector<std::uint8_t> out(20, 9), matrix(400, 9);
          EXPECT_EQ(Face<T>::overlap_many(&first, &second, out.data()), VESICA_E_SHAPE);
          EXPECT_EQ(Face<T>::overlap_many(&second, &first, out.data()), VESICA_E_SHAPE);
          EXPECT_EQ(Face<T>::overlap_matrix(&first, &second, matrix.data(), 20), VESICA_E_SHAPE);
          EXPECT_EQ(Face<T>::overlap_matrix(&second, &first, matrix.data(), 20), VESICA_E_SHAPE);
          EXPECT_EQ(overlap<T>(view(&a[at], n), view(&b[at], n)), VESICA_E_SHAPE);
          EXPECT_EQ(overlap<T>(view(&b[at], n), view(&a[at], n)), VESICA_E_SHAPE);
          EXPECT_EQ(out[11], 0);
          EXPECT_EQ(out[10], by_edges<T>(view(&a[at] - 2 * n, n), view(&b[at] - 2 * n, n)));
          ASSERT_FALSE(testing::Test::HasFailure()) << wrong << " at " << k << " of " << n << ", away " << away;
        }
      }
    }
  }
}
TEST(PolygonConvex, InvalidInDouble) { check_invalid<double>(); }
TEST(PolygonConvex, InvalidInFloat) { check_invalid<float>(); }

/// The greatest numbers: widths and products overflow.
TEST(PolygonConvex, GreatestNumbers) {
  constexpr double m = std::numeric_limits<double>::max();
  for (const double t : {m, m / 2, 1e300, 1e200, 1e160}) {
    const Numbers<double> a{-t, -t, t, -t, t, t, -t, t}, b{t, t, t, -t, -t, -t, -t, t},
        c{t / 2, t / 2, t, t / 2, t, t, t / 2, t}, d{-t, -t, -t / 4, -t, -t / 4, -t / 4, -t, -t / 4};
    for (const auto* p : {&a, &b, &c, &d}) {
      for (const auto* q : {&a, &b, &c, &d}) {
        const auto s = view(p->data(), 4), u = view(q->data(), 4);
        Numbers<double> first, second;
        for (int i = 0; i < 20; ++i) {
          first.insert(first.end(), p->begin(), p->end());
          second.insert(second.end(), q->begin(), q->end());
        }
        EXPECT_EQ(overlap<double>(s, u), by_edges<double>(s, u));
        check(first, second, 4);
      }
    }
  }
}

__extension__ using Wide = __int128;

/// Integers that T holds, whose products 128 bits hold.
template <class T, int n>
using Exact = std::array<std::array<Wide, 2>, n>;

template <class T, int n>
vesica::filter::Ring<T, n> stored(const Exact<T, n>& v) {
  vesica::filter::Ring<T, n> ring;
  for (std::size_t i = 0; i < n; ++i) {
    ring.x.number[i] = static_cast<T>(v[i][0]);
    ring.y.number[i] = static_cast<T>(v[i][1]);
  }
  return ring;
}

/// Twice the area of a triangle.
inline Wide cross(const std::array<Wide, 2>& p, const std::array<Wide, 2>& q, const std::array<Wide, 2>& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// The filter's numbers for one pair, in the rounding mode of the caller.
template <class T, int n>
[[gnu::noinline]] std::array<T, 3> sides_of(const vesica::filter::Ring<T, n>& a, const vesica::filter::Ring<T, n>& b) {
  using namespace vesica::filter;
  const RingBoxes<T> boxes(a, b);
  const Sides<T> s = sides(a, seen_from(a, b.x[0], b.y[0]), seen_from(b, b.x[0], b.y[0]));
  return {s.reach, s.turn, boxes.error_a};
}

/// The greatest error of a reach or a turn over its bound.
template <class T, int n>
double error_over_bound(int mode, Random& random) {
  constexpr std::int64_t most = std::int64_t{1} << (std::is_same_v<T, float> ? 23 : 50);
  auto* volatile ask = sides_of<T, n>;
  double worst = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    Exact<T, n> a, b;
    // Rings of any height, so that one product is far greater than the other, or not.
    const int lower = random.integer(0, 20);
    const auto draw = [&](int shift) {
      return static_cast<Wide>(random.bits() % static_cast<std::uint64_t>(2 * most)) / (std::int64_t{1} << shift) -
             most / (std::int64_t{1} << shift);
    };
    for (auto* ring : {&a, &b}) {
      for (auto& v : *ring) v = {draw(0), draw(lower)};
    }
    const int before = std::fegetround();
    std::fesetround(mode);
    const std::array<T, 3> found = ask(stored<T, n>(a), stored<T, n>(b));
    std::fesetround(before);
    const Wide first = cross(a[0], a[1], a[2]), sense = first < 0 ? -1 : 1;
    if (static_cast<double>(sense * first) <= static_cast<double>(found[2])) continue;  // its sign may be wrong
    Wide reach = 0, turn = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const auto &from = a[k], &to = a[(k + 1) % n];
      Wide farthest = sense * cross(from, to, b[0]);
      for (const auto& q : b) farthest = std::max(farthest, sense * cross(from, to, q));
      const Wide next = sense * cross(from, to, a[(k + 2) % n]);
      reach = k == 0 ? farthest : std::min(reach, farthest);
      turn = k == 0 ? next : std::min(turn, next);
    }
    const double off = std::max(std::fabs(static_cast<double>(static_cast<Wide>(found[0]) - reach)),
                                std::fabs(static_cast<double>(static_cast<Wide>(found[1]) - turn)));
    worst = std::max(worst, off / static_cast<double>(found[2]));
  }
  return worst;
}

/// A float's bound is for rounding to nearest, a double's for any mode.
TEST(PolygonConvex, ErrorsWithinTheirBound) {
  Random random(76);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const double most = std::max(error_over_bound<double, 3>(mode, random), error_over_bound<double, 4>(mode, random));
    EXPECT_LT(most, 0.75) << mode;
    EXPECT_GT(most, 0.02) << mode;
  }
  const double most =
      std::max(error_over_bound<float, 3>(FE_TONEAREST, random), error_over_bound<float, 4>(FE_TONEAREST, random));
  EXPECT_LT(most, 0.75);
  EXPECT_GT(most, 0.04);
}

}  // namespace polygon_convex
