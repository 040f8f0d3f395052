// SPDX-License-Identifier: Apache-2.0
// Polygons that broke other libraries, and those of other libraries' tests, with truth by rationals:
// corpus/polygons.csv. corpus/README.md says where they come from and how the answers were made.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygon_corpus {

using polygons::Path;
using polygons::Random;

struct Row {
  std::string id, query, expected;
  std::array<std::int32_t, 2> kind;
  std::array<Path, 2> path;
  double tolerance;
};

inline Path read_rings(const std::string& text) {
  Path path;
  std::istringstream rings(text);
  for (std::string ring; std::getline(rings, ring, ';');) {
    std::istringstream numbers(ring);
    std::vector<double> vertices;
    for (std::string number; numbers >> number;) vertices.push_back(std::strtod(number.c_str(), nullptr));
    path.add_ring(vertices);
  }
  return path;
}

inline std::int32_t read_kind(const std::string& name) {
  for (std::int32_t kind = VESICA_POINT; kind <= VESICA_POLYLINE; ++kind) {
    if (name == vesica_kind_name(kind)) return kind;
  }
  ADD_FAILURE() << name;
  return -1;
}

inline std::vector<Row> rows() {
  std::ifstream file(VESICA_POLYGONS);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "id,source,kind_a,a,kind_b,b,query,expected,tolerance,note");
  std::vector<Row> all;
  while (std::getline(file, line)) {
    std::vector<std::string> field;
    std::istringstream fields(line);
    for (std::string text; std::getline(fields, text, ',');) field.push_back(text);
    EXPECT_EQ(field.size(), 10u) << line;
    if (field.size() != 10) return {};
    all.push_back({field[0],
                   field[6],
                   field[7],
                   {read_kind(field[2]), read_kind(field[4])},
                   {read_rings(field[3]), read_rings(field[5])},
                   std::strtod(field[8].c_str(), nullptr)});
  }
  return all;
}

/// Two shapes of a row, or the same sets of points written otherwise.
struct Asked {
  std::array<std::int32_t, 2> kind;
  std::array<Path, 2> path;
  std::array<vesica_polygon_f64, 2> view;

  Asked(const Row& row, bool exchanged, Random* random) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t from = exchanged ? 1 - k : k;
      kind[k] = row.kind[from];
      path[k] = row.path[from];
      if (random != nullptr && kind[k] == VESICA_POLYGON) path[k] = rewritten(path[k], *random);
      view[k] = path[k].view();
    }
  }
  const void* shape(std::size_t k) const {
    return kind[k] == VESICA_POINT ? static_cast<const void*>(path[k].xy.data()) : &view[k];
  }
  template <class Function, class... More>
  std::int32_t ask(Function function, More... more) const {
    return function(kind[0], shape(0), kind[1], shape(1), more...);
  }
};

/// The relation that a matrix of areas says.
inline std::int32_t relation_of(const std::string& m) {
  const bool insides = m[0] != 'F', outlines = m[4] != 'F', a_leaves = m[2] != 'F', b_leaves = m[6] != 'F';
  if (!insides) return outlines ? VESICA_TOUCH : VESICA_DISJOINT;
  if (a_leaves && b_leaves) return VESICA_CROSS;
  if (!a_leaves && !b_leaves) return VESICA_EQUAL;
  if (a_leaves) return outlines ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS;
  return outlines ? VESICA_INSIDE_TOUCH : VESICA_INSIDE;
}

inline void expect(const Row& row, const Asked& asked, bool exchanged) {
  const double known = std::strtod(row.expected.c_str(), nullptr);
  double number = -1;
  if (row.query == "overlap") {
    EXPECT_EQ(asked.ask(vesica_overlap_f64), static_cast<std::int32_t>(known));
    return;
  }
  if (row.query == "distance") {
    vesica_closest_points_f64 points{-1, 0, 0, 0, 0};
    EXPECT_EQ(asked.ask(vesica_nearest_f64, &points), 0);
    EXPECT_LE(std::fabs(points.distance - known), row.tolerance) << points.distance;
    EXPECT_EQ(asked.ask(vesica_overlap_f64), known == 0 ? 1 : 0);
    return;
  }
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(vesica_check_f64(asked.kind[k], asked.shape(k)), 0) << k;
  if (row.query == "matrix") {
    std::string m = row.expected;
    if (exchanged) m = {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
    EXPECT_EQ(asked.ask(vesica_relation_f64), relation_of(m));
    EXPECT_EQ(asked.ask(vesica_contains_f64), m[6] == 'F' ? 1 : 0);
    EXPECT_EQ(asked.ask(vesica_interiors_overlap_f64), m[0] == 'F' ? 0 : 1);
    EXPECT_EQ(asked.ask(vesica_overlap_f64), m[0] == 'F' && m[4] == 'F' ? 0 : 1);
  } else {
    ASSERT_TRUE(row.query == "area" || row.query == "iou") << row.query;
    EXPECT_EQ(asked.ask(row.query == "area" ? vesica_area_f64 : vesica_iou_f64, &number), 0);
    EXPECT_LE(std::fabs(number - known), row.tolerance) << number;
  }
}

/// In both orders, and with rings that begin elsewhere, run backward or are closed.
TEST(PolygonCorpus, EveryRow) {
  Random random(598);
  std::map<std::string, int> asked;
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.id);
    ++asked[row.query];
    for (const bool exchanged : {false, true}) {
      expect(row, Asked(row, exchanged, nullptr), exchanged);
      for (int i = 0; i < 3; ++i) expect(row, Asked(row, exchanged, &random), exchanged);
    }
  }
  // Fewer rows mean a damaged file.
  EXPECT_EQ(asked, (std::map<std::string, int>{
                       {"area", 120}, {"distance", 8}, {"iou", 25}, {"matrix", 119}, {"overlap", 26}}));
}

}  // namespace polygon_corpus
