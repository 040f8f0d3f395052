// SPDX-License-Identifier: Apache-2.0
// Arrays of polygons in each layout, and bad input.
#include <gtest/gtest.h>
#include <vesica_boxes.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygon_invalid {

using namespace polygons;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> corners{0, 0, 1, 0, 1, 1, 0, 1, 2, 0, 3, 0, 3, 1, 2, 1, 4, 0, 5, 0, 5, 1, 4, 1};
const vesica_circle_f64 disc{2.5, 0.5, 0.25};

inline vesica_shapes_f64 one_disc() {
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, &disc, sizeof disc, &shapes);
  return shapes;
}

inline vesica_shapes_f64 quads(const std::vector<double>& xy) {
  vesica_shapes_f64 shapes{};
  shapes.kind = VESICA_POLYGON;
  shapes.count = static_cast<std::int64_t>(xy.size() / 8);
  shapes.stride = 16;
  shapes.field[0] = xy.data();
  shapes.field[1] = xy.data() + 1;
  shapes.each = 4;
  return shapes;
}

using Answers = std::array<std::uint8_t, 3>;

TEST(PolygonArrays, OfEachLayout) {
  const vesica_shapes_f64 other = one_disc();
  const Answers expected{0, 1, 0};
  Answers out{};
  vesica_shapes_f64 shapes = quads(corners);
  EXPECT_EQ(vesica_overlap_many_f64(&shapes, &other, out.data()), 1);
  EXPECT_EQ(out, expected);
  // Two columns.
  std::vector<double> x, y;
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    x.push_back(corners[i]);
    y.push_back(corners[i + 1]);
  }
  shapes.field[0] = x.data();
  shapes.field[1] = y.data();
  shapes.stride = 8;
  EXPECT_EQ(vesica_overlap_many_f64(&other, &shapes, out.data()), 1);
  EXPECT_EQ(out, expected);
  // One ring each.
  const std::vector<std::int32_t> rings{0, 4, 8, 12};
  shapes.rings = rings.data();
  shapes.each = 12;
  out = {};
  EXPECT_EQ(vesica_overlap_matrix_f64(&other, &shapes, out.data(), 3), 1);
  EXPECT_EQ(out, expected);
  // The last two are one polygon.
  const std::vector<std::int32_t> polygons{0, 1, 3};
  shapes.polygons = polygons.data();
  shapes.count = 2;
  std::array<std::int64_t, 3> found{};
  EXPECT_EQ(vesica_overlap_select_f64(&other, &shapes, found.data(), 3), 1);
  EXPECT_EQ(found[0], 1);
  EXPECT_EQ(found[1], -1);
  // Structs that lie in records.
  struct Record {
    vesica_polygon_f64 polygon;
    int owner;
  };
  std::vector<Record> records;
  for (std::size_t i = 0; i < 3; ++i) records.push_back({{x.data() + 4 * i, y.data() + 4 * i, 8, nullptr, 4}, 7});
  EXPECT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, 3, records.data(), sizeof(Record), &shapes), 0);
  out = {};
  EXPECT_EQ(vesica_overlap_many_f64(&shapes, &other, out.data()), 1);
  EXPECT_EQ(out, expected);
  std::array<vesica_aabb_f64, 3> boxes;
  EXPECT_EQ(vesica_bounds_many_f64(&shapes, boxes.data()), 0);
  EXPECT_EQ(boxes[2].min_x, 4);
  EXPECT_EQ(boxes[2].max_y, 1);
  // Floats, at an odd address.
  std::vector<unsigned char> bytes(1 + 24 * sizeof(float));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto number = static_cast<float>(corners[i]);
    std::memcpy(bytes.data() + 1 + i * sizeof number, &number, sizeof number);
  }
  vesica_shapes_f32 narrow{}, narrow_other;
  const vesica_circle_f32 narrow_disc{2.5f, 0.5f, 0.25f};
  vesica_shapes_from_records_f32(VESICA_CIRCLE, 1, &narrow_disc, sizeof narrow_disc, &narrow_other);
  narrow.kind = VESICA_POLYGON;
  narrow.count = 3;
  narrow.stride = 8;
  narrow.each = 4;
  narrow.field[0] = reinterpret_cast<const float*>(bytes.data() + 1);
  narrow.field[1] = reinterpret_cast<const float*>(bytes.data() + 1 + sizeof(float));
  out = {};
  EXPECT_EQ(vesica_overlap_many_f32(&narrow, &narrow_other, out.data()), 1);
  EXPECT_EQ(out, expected);
}

TEST(PolygonArrays, ABadElementIsAlone) {
  const vesica_shapes_f64 other = one_disc();
  std::vector<double> xy = corners;
  xy[20] = nan;  // of the last
  const vesica_shapes_f64 shapes = quads(xy);
  Answers out{9, 9, 9};
  EXPECT_EQ(vesica_overlap_many_f64(&shapes, &other, out.data()), VESICA_E_SHAPE);
  EXPECT_EQ(out, (Answers{0, 1, 0}));
  // Offsets that decrease, exceed the columns, or are negative.
  vesica_shapes_f64 columns = quads(corners);
  columns.each = 12;
  for (const std::vector<std::int32_t>& rings :
       {std::vector<std::int32_t>{0, 4, 8, 13}, {5, 4, 8, 12}, {-1, 4, 8, 12}, {0, 4, 8, 8}}) {
    columns.rings = rings.data();
    out = {9, 9, 9};
    EXPECT_EQ(vesica_overlap_many_f64(&columns, &other, out.data()), VESICA_E_SHAPE) << rings[0] << ' ' << rings[3];
    EXPECT_EQ(out, (Answers{0, 1, 0}));
  }
  const std::vector<std::int32_t> rings{0, 4, 8, 12}, polygons{0, 0, 2, -3};
  columns.rings = rings.data();
  columns.polygons = polygons.data();
  out = {9, 9, 9};
  EXPECT_EQ(vesica_overlap_many_f64(&columns, &other, out.data()), VESICA_E_SHAPE);
  EXPECT_EQ(out, (Answers{0, 1, 0}));
}

TEST(PolygonArrays, BadArguments) {
  const vesica_shapes_f64 other = one_disc();
  Answers out{9, 9, 9};
  const auto answer = [&](const vesica_shapes_f64& shapes) {
    return vesica_overlap_many_f64(&shapes, &other, out.data());
  };
  vesica_shapes_f64 shapes = quads(corners);
  shapes.each = -1;
  EXPECT_EQ(answer(shapes), VESICA_E_ARGUMENT);
  shapes.each = std::int64_t{1} << 62;
  EXPECT_EQ(answer(shapes), VESICA_E_ARGUMENT);
  shapes = quads(corners);
  const std::vector<std::int32_t> offsets{0, 4, 8, 12};
  shapes.polygons = offsets.data();  // without rings
  EXPECT_EQ(answer(shapes), VESICA_E_ARGUMENT);
  shapes.polygons = nullptr;
  shapes.rings = reinterpret_cast<const std::int32_t*>(reinterpret_cast<const char*>(offsets.data()) + 1);
  EXPECT_EQ(answer(shapes), VESICA_E_ARGUMENT);
  shapes = quads(corners);
  shapes.field[1] = nullptr;
  EXPECT_EQ(answer(shapes), VESICA_E_NULL);
  shapes = quads(corners);
  shapes.reserved = 1;
  EXPECT_EQ(answer(shapes), VESICA_E_ARGUMENT);
  vesica_shapes_f64 rows = one_disc();
  rows.each = 4;
  EXPECT_EQ(answer(rows), VESICA_E_ARGUMENT);
  EXPECT_EQ(out, (Answers{9, 9, 9}));
}

TEST(PolygonInvalid, Check) {
  std::vector<double> xy{0, 0, 1, 0, 1, 1, 0, 1};
  const std::vector<std::int32_t> rings{0, 2, 2, 4}, empty{3, 3, 3};
  vesica_polygon_f64 polygon{xy.data(), xy.data() + 1, 16, nullptr, 4};
  const auto check = [&] { return vesica_check_f64(VESICA_POLYGON, &polygon); };
  EXPECT_EQ(check(), 0);
  polygon.count = 1;
  EXPECT_EQ(check(), 0);
  polygon.count = 0;
  EXPECT_EQ(check(), VESICA_E_RINGS);
  polygon.count = -1;
  EXPECT_EQ(check(), VESICA_E_RINGS);
  polygon.rings = rings.data();
  polygon.count = 3;
  EXPECT_EQ(check(), 0);  // an empty ring among others
  polygon.rings = empty.data();
  polygon.count = 2;
  EXPECT_EQ(check(), VESICA_E_RINGS);
  polygon = {nullptr, xy.data(), 16, nullptr, 4};
  EXPECT_EQ(check(), VESICA_E_NULL);
  polygon = {xy.data(), xy.data() + 1, 16, nullptr, 4};
  xy[7] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(), VESICA_E_NOT_FINITE);
  vesica_aabb_f64 box{9, 9, 9, 9};
  EXPECT_EQ(vesica_bounds_f64(VESICA_POLYGON, &polygon, &box), VESICA_E_SHAPE);
  EXPECT_EQ(box.min_x, 9);
  xy[7] = 1;
  const vesica_circle_f64 negative{0, 0, -1};
  EXPECT_EQ(vesica_overlap_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, &negative), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_overlap_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_overlap_f64(VESICA_POLYGON, &polygon, 10, &negative), VESICA_E_KIND);
  EXPECT_EQ(vesica_relation_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, &negative), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_relation_f64(VESICA_CIRCLE, nullptr, VESICA_POLYGON, &polygon), VESICA_E_NULL);
  EXPECT_EQ(vesica_relation_f64(VESICA_POLYGON, &polygon, 10, &negative), VESICA_E_KIND);
  EXPECT_EQ(vesica_interiors_overlap_f64(VESICA_POLYGON, &polygon, 10, &negative), VESICA_E_KIND);
  EXPECT_EQ(vesica_interiors_overlap_f64(VESICA_CIRCLE, &negative, VESICA_POLYGON, &polygon), VESICA_E_SHAPE);
}

}  // namespace polygon_invalid
