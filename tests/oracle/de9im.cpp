// SPDX-License-Identifier: Apache-2.0
#include "oracle/de9im.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "oracle/region.hpp"

// The library takes most of a matrix from the relation of the shapes. Here every edge is cut wherever it may enter or
// leave a part of the other shape, and each piece is looked up there; areas follow from these pieces and from corners.

namespace oracle {
namespace {

enum Part { inside, outline, outside };

/// (x, y) / w with w > 0.
struct Place {
  mpz_class x, y, w;
};

Place at(const Vector& v) { return {v.x, v.y, 1}; }
/// Between two places.
Place middle(const Place& p, const Place& q) { return {p.x * q.w + q.x * p.w, p.y * q.w + q.y * p.w, 2 * p.w * q.w}; }
bool same(const Place& p, const Vector& v) { return p.x == v.x * p.w && p.y == v.y * p.w; }
int side(const Vector& a, const Vector& b, const Place& p) {
  return sgn((b.x - a.x) * (p.y - a.y * p.w) - (b.y - a.y) * (p.x - a.x * p.w));
}

Part part_of_segment(const Corners& c, const Place& p) {
  if (same(p, c[0]) || same(p, c[1])) return outline;
  const mpz_class along = (p.x - c[0].x * p.w) * (p.x - c[1].x * p.w) + (p.y - c[0].y * p.w) * (p.y - c[1].y * p.w);
  return side(c[0], c[1], p) == 0 && sgn(along) < 0 ? inside : outside;
}

/// Which part of a shape a place is in.
Part part_of(const Corners& c, const Place& p) {
  if (c.size() == 1) return same(p, c[0]) ? inside : outside;
  if (c.size() == 2) return part_of_segment(c, p);
  int least = 1;
  for (std::size_t i = 0; i < 4; ++i) least = std::min(least, side(c[i], edge_end(c, i), p));
  return least > 0 ? inside : least == 0 ? outline : outside;
}

/// The intersection of the line through f, g with the line through c, d, which is not parallel to it.
Place cut(const Vector& c, const Vector& d, const Vector& f, const Vector& g) {
  mpz_class whole = cross(d - c, g - f), part = cross(f - c, g - f);
  if (sgn(whole) < 0) {
    whole = -whole;
    part = -part;
  }
  return {c.x * whole + part * (d.x - c.x), c.y * whole + part * (d.y - c.y), whole};
}

mpz_class along(const Vector& c, const Vector& d, const Place& p) {
  return (p.x - c.x * p.w) * (d.x - c.x) + (p.y - c.y * p.w) * (d.y - c.y);
}
bool before(const Vector& c, const Vector& d, const Place& p, const Place& q) {
  return along(c, d, p) * q.w < along(c, d, q) * p.w;
}

/// The places on the edge from c to d, both ends among them and in their order, between which no part of b ends.
std::vector<Place> cuts(const Vector& c, const Vector& d, const Corners& b) {
  std::vector<Place> places{at(c), at(d)};
  for (const Vector& v : b) {
    if (orientation(c, d, v) == 0) places.push_back(at(v));
  }
  for (std::size_t j = 0; j < edge_count(b); ++j) {
    if (sgn(cross(d - c, edge_end(b, j) - b[j])) != 0) places.push_back(cut(c, d, b[j], edge_end(b, j)));
  }
  std::erase_if(places, [&](const Place& p) { return before(c, d, p, at(c)) || before(c, d, at(d), p); });
  std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return before(c, d, p, q); });
  return places;
}

using Dimensions = std::array<std::array<int, 3>, 3>;  // -1: nothing

void raise(int& dimension, int to) { dimension = std::max(dimension, to); }

/// The parts of b that the points and edges of a share, row by row.
Dimensions of_edges(const Corners& a, const Corners& b) {
  Dimensions m;
  for (auto& row : m) row.fill(-1);
  if (a.size() == 1) {
    raise(m[inside][part_of(b, at(a[0]))], 0);
    return m;
  }
  const Part of_edge = a.size() == 2 ? inside : outline;
  for (const Vector& corner : a) raise(m[outline][part_of(b, at(corner))], 0);
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    const std::vector<Place> places = cuts(a[i], edge_end(a, i), b);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool is_end = same(places[k], a[i]) || same(places[k], edge_end(a, i));
      if (!is_end) raise(m[of_edge][part_of(b, places[k])], 0);
      if (k > 0 && before(a[i], edge_end(a, i), places[k - 1], places[k])) {
        raise(m[of_edge][part_of(b, middle(places[k - 1], places[k]))], 1);
      }
    }
  }
  return m;
}

bool all_corners_in(const Corners& a, const Corners& b) {
  return std::all_of(a.begin(), a.end(), [&](const Vector& v) { return part_of(b, at(v)) != outside; });
}

}  // namespace

std::string de9im(int kind_a, const double* a, int kind_b, const double* b) {
  const RegionPair pair = regions(kind_a, a, kind_b, b);
  const Corners &first = pair.a.corners, &second = pair.b.corners;
  const bool first_is_area = first.size() == 4, second_is_area = second.size() == 4;
  const Dimensions of_a = of_edges(first, second), of_b = of_edges(second, first);
  Dimensions m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = std::max(of_a[i][j], of_b[j][i]);
  }
  m[outside][outside] = 2;
  if (first_is_area && !all_corners_in(first, second)) m[inside][outside] = 2;
  if (second_is_area && !all_corners_in(second, first)) m[outside][inside] = 2;
  if (first_is_area && !second_is_area) m[inside][outside] = 2;
  if (second_is_area && !first_is_area) m[outside][inside] = 2;
  if (first_is_area && second_is_area) {
    const bool equal = all_corners_in(first, second) && all_corners_in(second, first);
    m[inside][inside] = equal || of_a[outline][inside] >= 0 || of_b[outline][inside] >= 0 ? 2 : -1;
  }
  std::string text;
  for (const auto& row : m) {
    for (const int dimension : row) text += dimension < 0 ? 'F' : static_cast<char>('0' + dimension);
  }
  return text;
}

}  // namespace oracle
