// SPDX-License-Identifier: Apache-2.0
/// Paths along the edges of a triangulation, where what two of them share is found by looking at every triangle, edge
/// and vertex of it. Nothing is computed: each is inside, on the outline or outside by construction.
///
/// A grid of squares, each cut into four triangles by its diagonals. Corners are at even coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygons {

class Grid {
 public:
  explicit Grid(int size) : size_(size) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const int c = vertex(2 * i + 1, 2 * j + 1);
        const std::array<int, 4> corner{vertex(2 * i, 2 * j), vertex(2 * i + 2, 2 * j), vertex(2 * i + 2, 2 * j + 2),
                                        vertex(2 * i, 2 * j + 2)};
        for (std::size_t k = 0; k < 4; ++k) add_triangle(corner[k], corner[(k + 1) % 4], c);
      }
    }
  }

  int size() const { return size_; }
  int vertex(int x, int y) const { return y * (2 * size_ + 1) + x; }
  double x(int vertex) const { return vertex % (2 * size_ + 1); }
  double y(int vertex) const { return vertex / (2 * size_ + 1); }
  std::size_t vertices() const { return static_cast<std::size_t>((2 * size_ + 1) * (2 * size_ + 1)); }

  std::vector<std::array<int, 3>> triangles;  // vertices, counter-clockwise
  std::map<std::pair<int, int>, int> left;    // the triangle on the left of an edge from one vertex to another
  std::vector<std::vector<int>> neighbours;

 private:
  void add_triangle(int a, int b, int c) {
    const std::array<int, 3> corners{a, b, c};
    neighbours.resize(vertices());
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = corners[k], to = corners[(k + 1) % 3];
      left[{from, to}] = static_cast<int>(triangles.size());
      if (left.count({to, from}) == 0) {
        neighbours[static_cast<std::size_t>(from)].push_back(to);
        neighbours[static_cast<std::size_t>(to)].push_back(from);
      }
    }
    triangles.push_back(corners);
  }
  int size_;
};

enum CellPart : std::uint8_t { in, on, out };

/// A path, and the part of it that each triangle, edge and vertex of the grid is.
struct Figure {
  bool closed = true;
  Path path;
  std::vector<CellPart> triangle, vertex;
  std::map<std::pair<int, int>, CellPart> edge;  // from the lesser vertex; those not listed are outside
  std::map<int, std::vector<int>> paths;         // from each vertex of the path along its edges, as often as it goes

  Figure(const Grid& grid) : triangle(grid.triangles.size(), out), vertex(grid.vertices(), out) {}
};

/// Does nothing else cross a straight line at a vertex? It may touch the line there.
inline bool is_free(const Figure& figure, const Grid& grid, int before, int at, int next) {
  const std::vector<int>& ways = figure.paths.at(at);
  if (ways.size() == 2) return true;
  if (!figure.closed || ways.size() > 4) return false;
  int sides = 0;
  for (const int way : ways) {
    if (way == before || way == next) continue;
    const double side = (grid.x(next) - grid.x(at)) * (grid.y(way) - grid.y(at)) -
                        (grid.y(next) - grid.y(at)) * (grid.x(way) - grid.x(at));
    sides += side > 0 ? 1 : -1;
  }
  return sides == 2 || sides == -2;
}

/// The ring's vertices, without some or all of those in the middle of a straight line.
inline void add_ring(Figure& figure, const Grid& grid, const std::vector<int>& ring, double keeps, Random& random) {
  std::vector<double> xy;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_end = !figure.closed && (i == 0 || i + 1 == n);
    const int before = ring[(i + n - 1) % n], at = ring[i], next = ring[(i + 1) % n];
    const double ux = grid.x(at) - grid.x(before), uy = grid.y(at) - grid.y(before), vx = grid.x(next) - grid.x(at),
                 vy = grid.y(next) - grid.y(at);
    const bool straight = ux * vy == uy * vx && ux * vx + uy * vy > 0;
    if (straight && !is_end && is_free(figure, grid, before, at, next) && !random.chance(keeps)) continue;
    xy.insert(xy.end(), {grid.x(at), grid.y(at)});
  }
  figure.path.add_ring(xy);
}

/// Adds rings without area: points, and edges there and back.
inline void add_flat_rings(Figure& figure, const Grid& grid, Random& random) {
  for (int count = random.below(4); count > 0; --count) {
    const int at = random.below(static_cast<int>(grid.vertices()));
    const auto& ways = grid.neighbours[static_cast<std::size_t>(at)];
    if (ways.empty()) continue;
    figure.vertex[static_cast<std::size_t>(at)] = on;
    const int to = ways[static_cast<std::size_t>(random.below(static_cast<int>(ways.size())))];
    CellPart& edge = figure.edge.try_emplace({std::min(at, to), std::max(at, to)}, out).first->second;
    if (random.chance(0.5) || edge == on) {
      figure.path.add_ring({grid.x(at), grid.y(at)});
      continue;
    }
    edge = on;
    figure.vertex[static_cast<std::size_t>(to)] = on;
    figure.path.add_ring({grid.x(at), grid.y(at), grid.x(to), grid.y(to)});
  }
}

/// The union of the triangles that are `in`; there must be one.
inline void trace(Figure& figure, const Grid& grid, double keeps, Random& random, double flat_rings = 0) {
  std::map<int, std::vector<int>> next;
  std::vector<int> count(grid.vertices()), inner(grid.vertices());
  for (std::size_t t = 0; t < grid.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = grid.triangles[t][k], b = grid.triangles[t][(k + 1) % 3];
      const auto twin = grid.left.find({b, a});
      const bool mine = figure.triangle[t] == in,
                 other = twin != grid.left.end() && figure.triangle[static_cast<std::size_t>(twin->second)] == in;
      if (mine && !other) {
        next[a].push_back(b);
        figure.paths[a].push_back(b);
        figure.paths[b].push_back(a);
      }
      if (mine) figure.edge[{std::min(a, b), std::max(a, b)}] = other ? in : on;
    }
  }
  for (const auto& [at, part] : figure.edge) {
    for (const int v : {at.first, at.second}) {
      CellPart& known = figure.vertex[static_cast<std::size_t>(v)];
      if (known != on) known = part;
    }
  }
  while (!next.empty()) {
    std::vector<int> ring;
    int at = next.begin()->first;
    while (next.count(at) != 0) {
      ring.push_back(at);
      std::vector<int>& ways = next[at];
      const std::size_t k = static_cast<std::size_t>(random.below(static_cast<int>(ways.size())));
      const int to = ways[k];
      ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(k));
      if (ways.empty()) next.erase(at);
      at = to;
    }
    add_ring(figure, grid, ring, keeps, random);
  }
  if (random.chance(flat_rings)) add_flat_rings(figure, grid, random);
  figure.path = rewritten(figure.path, random);
}

/// Each triangle with some probability; whole squares, or each by itself.
inline Figure region(const Grid& grid, double density, Random& random) {
  Figure figure(grid);
  const bool squares = random.chance(0.4);
  for (std::size_t t = 0; t < grid.triangles.size(); t += 4) {
    const bool square = random.chance(density);
    for (std::size_t k = 0; k < 4; ++k) {
      if (squares ? square : random.chance(density)) figure.triangle[t + k] = in;
    }
  }
  figure.triangle[static_cast<std::size_t>(random.below(static_cast<int>(grid.triangles.size())))] = in;
  trace(figure, grid, random.chance(0.3) ? 1 : random.chance(0.5) ? 0 : 0.5, random, 0.2);
  return figure;
}

/// A region that differs from another one in a few triangles, or none.
inline Figure neighbour(const Figure& other, const Grid& grid, Random& random) {
  Figure figure(grid);
  figure.triangle = other.triangle;
  const int changes = random.below(4);
  const bool complement = random.chance(0.2), subset = random.chance(0.5);
  for (CellPart& part : figure.triangle) {
    if (complement) part = part == in ? out : in;
  }
  for (int i = 0; i < changes; ++i) {
    CellPart& part = figure.triangle[static_cast<std::size_t>(random.below(static_cast<int>(grid.triangles.size())))];
    part = part == in ? out : subset ? part : in;
  }
  figure.triangle[static_cast<std::size_t>(random.below(static_cast<int>(grid.triangles.size())))] = in;
  trace(figure, grid, random.chance(0.3) ? 1 : random.chance(0.5) ? 0 : 0.5, random, 0.2);
  return figure;
}

/// Chains along the edges.
inline Figure lines(const Grid& grid, int most, Random& random) {
  Figure figure(grid);
  figure.closed = false;
  const int chains = random.chance(0.6) ? 1 : 2;
  std::vector<int> ends;
  std::vector<std::vector<int>> walks;
  for (int j = 0; j < chains; ++j) {
    std::vector<int> chain;
    const auto t = static_cast<std::size_t>(random.below(static_cast<int>(grid.triangles.size())));
    int at = grid.triangles[t][static_cast<std::size_t>(random.below(3))];
    chain.push_back(at);
    ends.push_back(at);
    figure.vertex[static_cast<std::size_t>(at)] = in;
    const int steps = random.chance(0.1) ? 0 : random.integer(1, most);
    int dx = 0, dy = 0;
    for (int i = 0; i < steps; ++i) {
      const auto& ways = grid.neighbours[static_cast<std::size_t>(at)];
      int to = ways[static_cast<std::size_t>(random.below(static_cast<int>(ways.size())))];
      // Often straight on.
      for (const int way : ways) {
        const int wx = way % (2 * grid.size() + 1) - at % (2 * grid.size() + 1),
                  wy = way / (2 * grid.size() + 1) - at / (2 * grid.size() + 1);
        if (wx * dy == wy * dx && wx * dx + wy * dy > 0 && random.chance(0.6)) to = way;
      }
      dx = to % (2 * grid.size() + 1) - at % (2 * grid.size() + 1);
      dy = to / (2 * grid.size() + 1) - at / (2 * grid.size() + 1);
      figure.edge[{std::min(at, to), std::max(at, to)}] = in;
      figure.vertex[static_cast<std::size_t>(at)] = figure.vertex[static_cast<std::size_t>(to)] = in;
      chain.push_back(to);
      at = to;
    }
    ends.push_back(at);
    walks.push_back(chain);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      figure.paths[chain[i - 1]].push_back(chain[i]);
      figure.paths[chain[i]].push_back(chain[i - 1]);
    }
  }
  for (const std::vector<int>& chain : walks) add_ring(figure, grid, chain, random.chance(0.5) ? 0 : 1, random);
  for (const int end : ends) {
    if (std::count(ends.begin(), ends.end(), end) % 2 == 1) figure.vertex[static_cast<std::size_t>(end)] = on;
  }
  return figure;
}

/// The nine characters, row by row: the greatest dimension of a cell that is this part of a and that part of b.
inline std::string matrix_of(const Figure& a, const Figure& b) {
  std::string m = "FFFFFFFF2";
  const auto note = [&](CellPart p, CellPart q, char dimension) {
    char& c = m[static_cast<std::size_t>(3 * p + q)];
    if (c == 'F' || c < dimension) c = dimension;
  };
  for (std::size_t t = 0; t < a.triangle.size(); ++t) note(a.triangle[t], b.triangle[t], '2');
  const auto edge_part = [](const Figure& f, const std::pair<int, int>& at) {
    const auto found = f.edge.find(at);
    return found == f.edge.end() ? out : found->second;
  };
  for (const auto& [at, part] : a.edge) note(part, edge_part(b, at), '1');
  for (const auto& [at, part] : b.edge) note(edge_part(a, at), part, '1');
  for (std::size_t v = 0; v < a.vertex.size(); ++v) note(a.vertex[v], b.vertex[v], '0');
  return m;
}

/// The relation, by its definition.
inline std::int32_t relation_of(const std::string& m) {
  const auto any = [&](int k) { return m[static_cast<std::size_t>(k)] != 'F'; };
  const bool a_in_b = !any(2) && !any(5), b_in_a = !any(6) && !any(7);
  if (a_in_b && b_in_a) return VESICA_EQUAL;
  if (a_in_b) return any(1) || any(4) ? VESICA_INSIDE_TOUCH : VESICA_INSIDE;
  if (b_in_a) return any(3) || any(4) ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS;
  if (any(0)) return VESICA_CROSS;
  return any(1) || any(3) || any(4) ? VESICA_TOUCH : VESICA_DISJOINT;
}

/// Another place, direction and size; coordinates stay integers times a power of two.
struct Map {
  double a, b, c, d, x, y, scale;

  explicit Map(Random& random) {
    do {
      a = random.integer(-3, 3);
      b = random.integer(-3, 3);
      c = random.integer(-3, 3);
      d = random.integer(-3, 3);
    } while (a * d == b * c);
    x = random.integer(-40, 40);
    y = random.integer(-40, 40);
    scale = std::ldexp(1.0, random.chance(0.5) ? 0 : random.integer(-1060, 1000));
  }
  Path of(const Path& path) const {
    Path mapped = path;
    for (std::size_t i = 0; i < path.xy.size(); i += 2) {
      mapped.xy[i] = (a * path.xy[i] + b * path.xy[i + 1] + x) * scale;
      mapped.xy[i + 1] = (c * path.xy[i] + d * path.xy[i + 1] + y) * scale;
    }
    return mapped;
  }
};

}  // namespace polygons
