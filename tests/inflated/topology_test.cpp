// SPDX-License-Identifier: Apache-2.0
// Nine-intersection matrices and parts of segments: known ones, and against 190 digits.
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <cmath>
#include <string>
#include <vesica/de9im.hpp>

#include "inflated/outlines.hpp"
#include "inflated/shapes.hpp"

namespace inflated_topology {
namespace {

using namespace inflated;
using properties::Random;

std::string de9im(const Shape& a, const Shape& b) {
  char matrix[VESICA_DE9IM_SIZE] = "?????????";
  EXPECT_EQ(vesica_de9im_f64(a.kind, a.number.data(), b.kind, b.number.data(), matrix), 0);
  return matrix;
}
int relation(const Shape& a, const Shape& b) {
  return vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
}
std::string transposed(const std::string& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }

const Shape capsule{VESICA_CAPSULE, {0, 0, 10, 0, 1}};

TEST(InflatedDe9im, Known) {
  EXPECT_EQ(de9im(capsule, capsule), "2FFF1FFF2");
  EXPECT_EQ(de9im(capsule, {VESICA_CIRCLE, {0, 0, 1}}), "212F11FF2");
  EXPECT_EQ(de9im(capsule, {VESICA_CIRCLE, {5, 0, 1}}), "212F01FF2");
  EXPECT_EQ(de9im(capsule, {VESICA_CIRCLE, {5, 2, 1}}), "FF2F01212");
  EXPECT_EQ(de9im(capsule, {VESICA_CAPSULE, {0, 2, 10, 2, 1}}), "FF2F11212");
  EXPECT_EQ(de9im(capsule, {VESICA_CAPSULE, {10, 2, 20, 2, 1}}), "FF2F01212");
  EXPECT_EQ(de9im(capsule, {VESICA_AABB, {2, -1, 20, 5}}), "212111212");
  EXPECT_EQ(de9im(capsule, {VESICA_ROUND_RECT, {5, 0, 1, 0, 5, 0, 1}}), "2FFF1FFF2");
  EXPECT_EQ(de9im(capsule, {VESICA_ROUND_RECT, {5, 0, 0, 1, 1, 2, 0.5}}), "212101212");
  EXPECT_EQ(de9im({VESICA_SEGMENT, {3, 1, 4, 1}}, capsule), "F1FF0F212");
  EXPECT_EQ(de9im({VESICA_SEGMENT, {3, 1, 14, 1}}, capsule), "F11F00212");
  EXPECT_EQ(de9im({VESICA_SEGMENT, {3, 1, 4, 0}}, capsule), "1FF00F212");
  EXPECT_EQ(de9im({VESICA_SEGMENT, {-1, -5, -1, 5}}, capsule), "F01FF0212");
  EXPECT_EQ(de9im({VESICA_POINT, {-1, 0}}, capsule), "F0FFFF212");
  EXPECT_EQ(de9im({VESICA_POINT, {0, 0}}, capsule), "0FFFFF212");
  EXPECT_EQ(de9im({VESICA_CAPSULE, {0, 0, 1, 0, 0}}, {VESICA_SEGMENT, {0, 0, 1, 0}}), "1FFF0FFF2");
}

/// An ellipse that is a circle holds the arc of a shape about its centre with its radius.
TEST(InflatedDe9im, SharesOfEllipses) {
  const auto shares = [](const vesica::Ellipse<double>& e) {
    return vesica::detail::de9im::outlines_share_stretch(e, vesica::Capsule<double>{0, 0, 10, 0, 5});
  };
  EXPECT_TRUE(shares({0, 0, 1, 0, 5, 5}) && shares({10, 0, 3, 4, 1, 1}));
  EXPECT_FALSE(shares({5, 0, 1, 0, 5, 5}) || shares({0, 0, 3, 4, 5, 5}) || shares({0, 0, 1, 0, 5, 4}));
}

/// The relation by its definition, from the matrix.
int relation_of(const std::string& m) {
  const auto fits = [&m](const char* pattern) { return vesica_de9im_match(m.c_str(), pattern) == 1; };
  const bool within = fits("**F**F***"), contains = fits("******FF*");
  if (fits("FF*FF****")) return VESICA_DISJOINT;
  if (within && contains) return VESICA_EQUAL;
  if (within) return m[1] != 'F' || m[4] != 'F' ? VESICA_INSIDE_TOUCH : VESICA_INSIDE;
  if (contains) return m[3] != 'F' || m[4] != 'F' ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS;
  return m[0] == 'F' ? VESICA_TOUCH : VESICA_CROSS;
}

bool has_area(const Shape& s) {
  double area = 0;
  EXPECT_EQ(vesica_shape_area_f64(s.kind, s.number.data(), &area), 0);
  return area > 0;
}
bool is_segment(const Shape& s) {
  return s.kind == VESICA_SEGMENT && (s.number[0] != s.number[2] || s.number[1] != s.number[3]);
}

/// A segment's matrix with a shape with area.
std::string expected_matrix(const Shape& segment, const Outline& o) {
  const PartOfSegment part = part_of_segment(segment, o);
  std::string m = "FFFFFF212";
  bool inner = false;
  for (const auto& p : part.places) {
    const auto is_end = [&](std::size_t k) {
      return abs(mpf_class(p.x - segment.number[k])) + abs(mpf_class(p.y - segment.number[k + 1])) < 1e-40;
    };
    inner = inner || (side_of_outline(o, p.x, p.y) == 0 && !is_end(0) && !is_end(2));
  }
  for (const std::size_t k : {0U, 2U}) {
    const int side = side_of_outline(o, mpf_class(segment.number[k], 640), mpf_class(segment.number[k + 1], 640));
    m[side > 0 ? 3 : side == 0 ? 4 : 5] = '0';
  }
  if (part.meets_inside) m[0] = '1';
  m[1] = part.shared ? '1' : inner ? '0' : 'F';
  m[2] = m[5] == '0' ? '1' : 'F';
  return m;
}

void compare(const Shape& a, const Shape& b) {
  SCOPED_TRACE(described(a) + "   " + described(b));
  const std::string m = de9im(a, b);
  ASSERT_EQ(de9im(b, a), transposed(m));
  ASSERT_EQ(relation_of(m), relation(a, b)) << m;
  if (has_area(a) && has_area(b)) {
    const OutlinePlaces met = outline_places(Outline(a), Outline(b));
    ASSERT_EQ(m[4], met.shared ? '1' : met.places.empty() ? 'F' : '0') << m;
    for (const std::size_t k : {1U, 3U, 5U, 7U}) ASSERT_TRUE(m[k] == 'F' || m[k] == '1') << m;
    for (const std::size_t k : {0U, 2U, 6U}) ASSERT_TRUE(m[k] == 'F' || m[k] == '2') << m;
  }
  ASSERT_TRUE(!is_segment(a) || !has_area(b) || m == expected_matrix(a, Outline(b))) << m;
}

TEST(InflatedDe9im, OfShapesOnALattice) {
  Random random(properties::seed());
  for (int i = 0; i < 4000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape a = lattice_shape(random);
    Shape b = lattice_shape(random);
    while (!is_inflated(a) && !is_inflated(b)) b = lattice_shape(random);
    compare(a, b);
  }
}

TEST(InflatedDe9im, OfSimplerKinds) {
  Random random(properties::seed());
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const Shape a = lattice_shape(random);
    Shape b = lattice_shape(random);
    while (!is_inflated(b)) b = lattice_shape(random);
    b.number[b.kind == VESICA_CAPSULE ? 4 : 6] = 0;
    ASSERT_EQ(de9im(a, b), de9im(a, core(b))) << described(a) << "   " << described(b);
    ASSERT_EQ(de9im(b, a), de9im(core(b), a)) << described(a) << "   " << described(b);
  }
}

std::vector<std::array<double, 2>> intersection(const Shape& a, const Shape& b) {
  std::array<vesica_point_f64, 8> at{};
  const std::int64_t n = vesica_intersection_f64(a.kind, a.number.data(), b.kind, b.number.data(), at.data(), 8);
  EXPECT_GE(n, 0);
  std::vector<std::array<double, 2>> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) all.push_back({at[i].x, at[i].y});
  return all;
}

using Vertices = std::vector<std::array<double, 2>>;

TEST(InflatedIntersection, Known) {
  EXPECT_EQ(intersection(capsule, {VESICA_SEGMENT, {3, 5, 3, -5}}), (Vertices{{3, -1}, {3, 1}}));
  EXPECT_EQ(intersection({VESICA_SEGMENT, {14, 1, 3, 1}}, capsule), (Vertices{{3, 1}, {10, 1}}));
  EXPECT_EQ(intersection({VESICA_SEGMENT, {-5, 0, 3, 0}}, capsule), (Vertices{{-1, 0}, {3, 0}}));
  EXPECT_EQ(intersection({VESICA_SEGMENT, {-1, -5, -1, 5}}, capsule), (Vertices{{-1, 0}}));
  EXPECT_EQ(intersection({VESICA_SEGMENT, {-2, -5, -2, 5}}, capsule), Vertices{});
  EXPECT_EQ(intersection({VESICA_POINT, {5, 1}}, capsule), (Vertices{{5, 1}}));
  EXPECT_EQ(intersection({VESICA_SEGMENT, {-5, 0, 3, 0}}, {VESICA_CAPSULE, {0, 0, 9, 0, 0}}),
            (Vertices{{0, 0}, {3, 0}}));
}

/// The part of a segment: its ends where they are inside or on the outline, to the bit, else the first and last place.
void compare_part(const Shape& segment, const Shape& b) {
  SCOPED_TRACE(described(segment) + "   " + described(b));
  const Vertices found = intersection(segment, b);
  ASSERT_EQ(intersection(b, segment), found);
  const PartOfSegment part = part_of_segment(segment, Outline(b));
  ASSERT_EQ(found.size(), std::min<std::size_t>(part.places.size(), 2));
  if (found.empty()) return;
  const auto off = [](const PlaceOfOutlines& p, const std::array<double, 2>& q) {
    return std::hypot(mpf_class(p.x - q[0]).get_d(), mpf_class(p.y - q[1]).get_d());
  };
  const auto &first = part.places.front(), &last = part.places.back();
  const double bound = 4 * 0x1p-53 * scale(segment, b);
  const double forward = std::max(off(first, found.front()), off(last, found.back()));
  const double backward = std::max(off(first, found.back()), off(last, found.front()));
  ASSERT_LE(std::min(forward, backward), bound);
  for (const std::size_t k : {0U, 2U}) {
    const std::array<double, 2> end{segment.number[k], segment.number[k + 1]};
    const bool is_in = side_of_outline(Outline(b), mpf_class(end[0], 640), mpf_class(end[1], 640)) >= 0;
    ASSERT_TRUE(!is_in || found.front() == end || found.back() == end);
  }
}

TEST(InflatedIntersection, PartsOfSegments) {
  Random random(properties::seed());
  for (int i = 0; i < 3000 * properties::repeat() && !HasFatalFailure(); ++i) {
    Shape a = lattice_shape(random), b = lattice_shape(random);
    while (!is_segment(a)) a = lattice_shape(random);
    while (!is_inflated(b) || !has_area(b)) b = lattice_shape(random);
    compare_part(a, b);
    a = shape(VESICA_SEGMENT, random);
    if (is_segment(a)) compare_part(a, inflated_shape(random));
  }
}

}  // namespace
}  // namespace inflated_topology
