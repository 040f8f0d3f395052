// SPDX-License-Identifier: Apache-2.0
/// The share of each cell of a grid that a shape covers.
///
/// The outline is cut at the lines of the grid. Each piece lies in one cell. It adds to that cell what is on its
/// right, and to all cells beyond their part at its height. Sums are of integers, in units of 2^-60: a cell inside has
/// share 1 and one outside 0, exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vesica/area/circular_segment.hpp>
#include <vesica/arithmetic/spectrum.hpp>
#include <vesica/bounds.hpp>
#include <vesica/check.hpp>
#include <vesica/polygon/own_area.hpp>

namespace vesica {

/// Cells of dx by dy from the corner (x, y) on: cell (i, j) begins at (x + i dx, y + j dy).
template <class T>
struct Grid {
  T x, y, dx, dy;
  std::int64_t columns, rows;
};

namespace detail::coverage {

/// A place on an outline, in cells. On an arc it is at the unit vector (c, s).
struct Place {
  double x, y, c = 0, s = 0;
};

/// The part of a straight edge between two places.
class Line {
 public:
  Line(const Place& from, const Place& to) noexcept : first(from), last(to) {}

  Place at_y(double y) const noexcept {
    return {first.x + (last.x - first.x) * ((y - first.y) / (last.y - first.y)), y};
  }
  Place at_x(double x) const noexcept {
    return {x, first.y + (last.y - first.y) * ((x - first.x) / (last.x - first.x))};
  }
  /// The area between a piece and its chord.
  double bulge(const Place& /*p*/, const Place& /*q*/) const noexcept { return 0; }

  Place first, last;
};

/// The points C + A c + B s of unit vectors (c, s). It turns left, as A to B does.
struct Ellipse {
  double cx, cy, ax, ay, bx, by;

  Place at(double c, double s) const noexcept { return {cx + (ax * c + bx * s), cy + (ay * c + by * s), c, s}; }
  double determinant() const noexcept { return ax * by - ay * bx; }
};

/// The unit vector at which an ellipse goes farthest along an axis, and how far that is.
struct Extreme {
  double c, s, reach;

  Extreme(double a, double b) noexcept {
    const auto u = arithmetic::unit_and_length(a, b);
    c = u.x;
    s = u.y;
    reach = arithmetic::scale(u.length.value, u.length.exponent);
  }
};

inline double cross(double ax, double ay, double bx, double by) noexcept { return ax * by - ay * bx; }

/// (w - sin w) / 2 for an arc of angle w, the area between it and its chord where the radius is 1. The chord's ends are
/// the unit vectors p and q. Little arcs by (arcsin s - s) / s^3 as a polynomial in s^2, for s = sin w up to 1/4, which
/// is interpolated at Chebyshev's points with a relative error of at most 2^-53.
inline double arc_and_chord(const Place& p, const Place& q) noexcept {
  const double sine = std::fabs(cross(p.c, p.s, q.c, q.s)), cosine = p.c * q.c + p.s * q.s;
  if (sine <= 0.25 && cosine > 0) {
    const double z = sine * sine, zz = z * z;
    const double low =
        (0x1.5555555555555p-4 + 0x1.3333333333254p-5 * z) + (0x1.6db6db6de5562p-6 + 0x1.f1c71c365301dp-7 * z) * zz;
    const double high = (0x1.6e8bb5eb0e553p-7 + 0x1.1c4b5d82f2727p-7 * z) +
                        (0x1.ca5005014b563p-8 + (0x1.6f82236a4e79dp-8 + 0x1.9999b904337f3p-8 * z) * z) * zz;
    return sine * z * (low + high * (zz * zz));
  }
  const double dc = q.c - p.c, ds = q.s - p.s, c = q.c + p.c, s = q.s + p.s;
  return area::segment_area(dc * dc + ds * ds, c * c + s * s);
}

/// A part of an ellipse between two extremes, along which x and y change one way each.
class Arc {
 public:
  Arc(const Ellipse& ellipse, const Extreme& right, const Extreme& top, const Place& from, const Place& to) noexcept
      : first(from), last(to), ellipse_(ellipse), right_(right), top_(top) {
    const double c = first.c + last.c, s = first.s + last.s;
    right_turn_ = std::copysign(1, cross(right.c, right.s, c, s));
    top_turn_ = std::copysign(1, cross(top.c, top.s, c, s));
    determinant_ = ellipse.determinant();
    across_ = 1 / right.reach;
    up_ = 1 / top.reach;
  }

  Place at_y(double y) const noexcept {
    Place p = at(top_, top_turn_, (y - ellipse_.cy) * up_);
    p.y = y;
    return p;
  }
  Place at_x(double x) const noexcept {
    Place p = at(right_, right_turn_, (x - ellipse_.cx) * across_);
    p.x = x;
    return p;
  }
  double bulge(const Place& p, const Place& q) const noexcept { return determinant_ * arc_and_chord(p, q); }

  Place first, last;

 private:
  /// The place whose unit vector has a given component along an extreme's.
  Place at(const Extreme& extreme, double turn, double along) const noexcept {
    const double t = std::clamp(along, -1.0, 1.0), across = turn * std::sqrt((1 - t) * (1 + t));
    return ellipse_.at(t * extreme.c - across * extreme.s, t * extreme.s + across * extreme.c);
  }

  const Ellipse& ellipse_;
  const Extreme &right_, &top_;
  double right_turn_, top_turn_, determinant_, across_, up_;
};

/// A number from 0 to 1, or a sum of such, in units of 2^-60.
inline std::int64_t fixed(double v) noexcept { return static_cast<std::int64_t>(v * 0x1p60); }

/// The most columns, and the most cells, whose shares are found together.
inline constexpr std::int64_t most_columns = 255, most_cells = 2048;

/// Some cells of a grid. The shares of a row are the sums of its numbers up to each.
class Tile {
 public:
  void clear(std::int64_t columns, std::int64_t rows) noexcept {
    columns_ = columns;
    rows_ = rows;
    std::fill_n(sum_, (columns + 1) * rows, 0);
  }
  const std::int64_t* row(std::int64_t j) const noexcept { return sum_ + j * (columns_ + 1); }

  /// Adds a part of the outline along which x and y change one way each. The inside is on its left. Coordinates are
  /// from the tile's corner.
  template <class Curve>
  void add(const Curve& curve) noexcept {
    const bool rises = curve.last.y > curve.first.y;
    Place p = rises ? curve.first : curve.last;
    const Place end = rises ? curve.last : curve.first;
    const auto rows = static_cast<double>(rows_);
    if (!(p.y < end.y) || end.y <= 0 || p.y >= rows) return;
    const double low = lesser(p.x, end.x), high = greater(p.x, end.x);
    if (low >= static_cast<double>(columns_)) return;
    const auto at_y = [&](double y) {
      Place q = curve.at_y(y);
      q.x = std::clamp(q.x, low, high);
      return q;
    };
    if (p.y < 0) p = at_y(0);
    for (auto j = static_cast<std::int64_t>(p.y); j < rows_; ++j) {
      const double top = static_cast<double>(j + 1);
      const bool ends = end.y <= top;
      const Place q = ends ? end : at_y(top);
      add_in_row(curve, j, rises ? p : q, rises ? q : p);
      if (ends) break;
      p = q;
    }
  }

 private:
  /// The part between two places of a row.
  template <class Curve>
  void add_in_row(const Curve& curve, std::int64_t j, Place p, Place q) noexcept {
    // From left to right; the heights of parts that go down on the right are positive.
    const bool reversed = q.x < p.x;
    if (reversed) std::swap(p, q);
    const std::int64_t sign = reversed ? 1 : -1;
    const auto columns = static_cast<double>(columns_), bottom = static_cast<double>(j);
    std::int64_t* const sum = sum_ + j * (columns_ + 1);
    const auto height = [&](const Place& from, const Place& to) {
      return sign * (fixed(to.y - bottom) - fixed(from.y - bottom));
    };
    const double low = lesser(p.y, q.y), high = greater(p.y, q.y);
    const auto at_x = [&](double x) {
      Place m = curve.at_x(x);
      m.y = std::clamp(m.y, low, high);
      return m;
    };
    if (p.x >= columns) return;
    if (q.x <= 0) {
      sum[0] += height(p, q);
      return;
    }
    if (p.x < 0) {
      const Place m = at_x(0);
      sum[0] += height(p, m);
      p = m;
    }
    for (auto i = static_cast<std::int64_t>(p.x); i < columns_; ++i) {
      const double right = static_cast<double>(i + 1);
      const bool ends = q.x <= right;
      const Place m = ends ? q : at_x(right);
      const double beside = (right - p.x) + (right - m.x);
      const std::int64_t all = height(p, m);
      const std::int64_t own = sign * fixed((m.y - p.y) * beside / 2) + fixed(curve.bulge(p, m));
      sum[i] += own;
      sum[i + 1] += all - own;
      if (ends) break;
      p = m;
    }
  }

  std::int64_t columns_, rows_;
  std::int64_t sum_[most_cells];
};

/// A grid's cells as units.
class Cells {
 public:
  explicit Cells(const Grid<double>& g) noexcept : x(g.x), y(g.y), dx(g.dx), dy(g.dy) {}

  double x, y, dx, dy;

  double across(double v) const noexcept { return count(v, x, dx); }
  double up(double v) const noexcept { return count(v, y, dy); }

 private:
  static double count(double to, double from, double size) noexcept {
    const double distance = to - from;
    return all_finite(distance) ? distance / size : 2 * ((to / 2 - from / 2) / size);
  }
};

/// The outline of a shape in cells, from a cell (i, j) on. Shapes without area have none.
class Outline {
 public:
  Outline(const Cells& cells, double i, double j, Tile& tile) noexcept : cells_(cells), i_(i), j_(j), tile_(tile) {}

  void add(const vesica::Point<double>& /*s*/) noexcept {}
  void add(const Segment<double>& /*s*/) noexcept {}
  void add(const Aabb<double>& s) noexcept {
    add_edges({place(s.min_x, s.min_y), place(s.max_x, s.min_y), place(s.max_x, s.max_y), place(s.min_x, s.max_y)});
  }
  void add(const Rect<double>& s) noexcept {
    if (s.hx == 0 || s.hy == 0) return;
    const double x = s.hx * s.ux, y = s.hx * s.uy, z = -s.hy * s.uy, w = s.hy * s.ux;
    add_edges({place(s.cx - x - z, s.cy - y - w), place(s.cx + x - z, s.cy + y - w), place(s.cx + x + z, s.cy + y + w),
               place(s.cx - x + z, s.cy - y + w)});
  }
  void add(const Circle<double>& s) noexcept { add_whole(ellipse(s.cx, s.cy, 1, 0, s.r, s.r)); }
  void add(const vesica::Ellipse<double>& s) noexcept {
    if (s.a != 0 && s.b != 0) add_whole(ellipse(s.cx, s.cy, s.ux, s.uy, s.a, s.b));
  }
  void add(const Capsule<double>& s) noexcept {
    if (s.r == 0) return;
    const auto u = arithmetic::unit_and_length(s.x1 / 2 - s.x0 / 2, s.y1 / 2 - s.y0 / 2);
    const Ellipse cap[] = {ellipse(s.x1, s.y1, u.x, u.y, s.r, s.r), ellipse(s.x0, s.y0, u.x, u.y, s.r, s.r)};
    add_line(cap[1].at(0, -1), cap[0].at(0, -1));
    add_arc(cap[0], 0, -1, 0, 1);
    add_line(cap[0].at(0, 1), cap[1].at(0, 1));
    add_arc(cap[1], 0, 1, 0, -1);
  }
  void add(const RoundRect<double>& s) noexcept {
    if (s.r == 0 && (s.hx == 0 || s.hy == 0)) return;
    const auto u = arithmetic::unit_and_length(s.ux, s.uy);
    const double x = s.hx * s.ux, y = s.hx * s.uy, z = -s.hy * s.uy, w = s.hy * s.ux;
    const Ellipse corner[] = {ellipse(s.cx + x - z, s.cy + y - w, u.x, u.y, s.r, s.r),
                              ellipse(s.cx + x + z, s.cy + y + w, u.x, u.y, s.r, s.r),
                              ellipse(s.cx - x + z, s.cy - y + w, u.x, u.y, s.r, s.r),
                              ellipse(s.cx - x - z, s.cy - y - w, u.x, u.y, s.r, s.r)};
    constexpr double turn[][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (int k = 0; k < 4; ++k) {
      const auto &from = turn[k], &to = turn[(k + 1) % 4];
      add_arc(corner[k], from[0], from[1], to[0], to[1]);
      add_line(corner[k].at(to[0], to[1]), corner[(k + 1) % 4].at(to[0], to[1]));
    }
  }
  template <class T>
  void add(const Polygon<T>& s) noexcept {
    const polygon::Edges<T> edges(s);
    if (polygon::is_flat(edges)) return;
    polygon::Senses<T> senses(edges);
    senses.for_edges(edges.all(), [&](const polygon::Edge& e, double sense) {
      const Place p = place(e.x0, e.y0), q = place(e.x1, e.y1);
      add_line(sense > 0 ? p : q, sense > 0 ? q : p);
    });
  }
  template <class T>
  void add(const Polyline<T>& /*s*/) noexcept {}

 private:
  Place place(double x, double y) const noexcept { return {cells_.across(x) - i_, cells_.up(y) - j_}; }
  Ellipse ellipse(double cx, double cy, double ux, double uy, double a, double b) const noexcept {
    const Place centre = place(cx, cy);
    return {centre.x, centre.y, a * ux / cells_.dx, a * uy / cells_.dy, -b * uy / cells_.dx, b * ux / cells_.dy};
  }

  void add_line(const Place& p, const Place& q) noexcept { tile_.add(Line(p, q)); }
  void add_edges(const Place (&corner)[4]) noexcept {
    for (int k = 0; k < 4; ++k) add_line(corner[k], corner[(k + 1) % 4]);
  }
  void add_whole(const Ellipse& e) noexcept {
    add_arc(e, 1, 0, -1, 0);
    add_arc(e, -1, 0, 1, 0);
  }
  /// The arc from one unit vector to another, at most half a turn to the left, cut at the extremes between them.
  void add_arc(const Ellipse& e, double c0, double s0, double c1, double s1) noexcept {
    const Extreme right(e.ax, e.bx), top(e.ay, e.by);
    // The chord of an arc that covers less than a unit of the sums.
    if (!(e.determinant() > 0) || right.reach < 0x1p-200 || top.reach < 0x1p-200) {
      add_line(e.at(c0, s0), e.at(c1, s1));
      return;
    }
    const double extreme[][2] = {{right.c, right.s}, {top.c, top.s}, {-right.c, -right.s}, {-top.c, -top.s}};
    Place from = e.at(c0, s0);
    const auto add_to = [&](const Place& to) {
      tile_.add(Arc(e, right, top, from, to));
      from = to;
    };
    const auto is_left = [&](int k) { return cross(c0, s0, extreme[k % 4][0], extreme[k % 4][1]) > 0; };
    int next = 0;  // the first extreme on the left of the arc's beginning
    while (next < 4 && !(is_left(next) && !is_left(next + 3))) ++next;
    for (int k = next; k < next + 2; ++k) {
      const auto& [c, s] = extreme[k % 4];
      if (is_left(k) && cross(c, s, c1, s1) > 0) add_to(e.at(c, s));
    }
    add_to(e.at(c1, s1));
  }

  const Cells& cells_;
  double i_, j_;
  Tile& tile_;
};

/// Coordinates in cells are at most this.
inline constexpr double most_distance = 0x1p44;

/// True if a number of cells can be counted.
inline bool is_near(double cells) noexcept { return std::fabs(cells) <= most_distance; }

/// The shares of a row of a tile: sums of its numbers up to each.
inline void find_shares(const std::int64_t* row, std::int64_t count, double* shares) noexcept {
  std::int64_t sum = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    sum += row[i];
    // A single ring may turn right.
    shares[i] = std::min(1.0, std::fabs(static_cast<double>(sum)) * 0x1p-60);
  }
}

/// Calls visit(row, first column, shares, count) with the shares of all cells, part by part; if `all` is false, of
/// those parts that the shape's box meets.
template <class Shape, class Visit>
std::int32_t for_shares(const Shape& shape, const Aabb<double>& box, const Grid<double>& grid, bool all,
                        const Visit& visit) noexcept {
  const Cells cells(grid);
  const double left = cells.across(box.min_x), right = cells.across(box.max_x);
  const double bottom = cells.up(box.min_y), top = cells.up(box.max_y);
  if (!is_near(left) || !is_near(right) || !is_near(bottom) || !is_near(top)) return error_range;
  if (grid.columns == 0) return 0;
  const std::int64_t width = std::min(grid.columns, most_columns);
  const std::int64_t height = most_cells / (width + 1);
  Tile tile;
  double shares[most_columns];
  for (std::int64_t j = 0; j < grid.rows; j += height) {
    const std::int64_t rows = std::min(height, grid.rows - j);
    for (std::int64_t i = 0; i < grid.columns; i += width) {
      const std::int64_t columns = std::min(width, grid.columns - i);
      const auto x = static_cast<double>(i), y = static_cast<double>(j);
      // Roundings of the box may be another cell's.
      const bool meets = left - 1 < x + static_cast<double>(columns) && right + 1 > x &&
                         bottom - 1 < y + static_cast<double>(rows) && top + 1 > y;
      if (meets) {
        tile.clear(columns, rows);
        Outline(cells, x, y, tile).add(shape);
      } else if (!all) {
        continue;
      } else {
        std::fill_n(shares, columns, 0.0);
      }
      for (std::int64_t k = 0; k < rows; ++k) {
        if (meets) find_shares(tile.row(k), columns, shares);
        visit(j + k, i, shares, columns);
      }
    }
  }
  return 0;
}

/// True if a grid has cells that can be counted.
inline bool is_grid(const Grid<double>& g) noexcept {
  return all_finite(g.x, g.y, g.dx, g.dy) && g.dx > 0 && g.dy > 0 && g.columns >= 0 && g.rows >= 0 &&
         is_near(static_cast<double>(g.columns)) && is_near(static_cast<double>(g.rows));
}

}  // namespace detail::coverage

/// Calls visit(row, first column, shares, count) with the shares from 0 to 1 that a shape covers of the cells of a
/// grid, part by part: of all, or of all that it may meet. Returns 0, or error_argument (a grid without cells of a
/// size), error_range (the shape is farther than 2^44 cells from the corner), or the error of bounds(), and calls
/// nothing.
template <class Shape, class T, class Visit>
std::int32_t coverage_or_error(const Shape& shape, const Grid<T>& grid, bool all, const Visit& visit) noexcept {
  const Grid<double> wide{static_cast<double>(grid.x),
                          static_cast<double>(grid.y),
                          static_cast<double>(grid.dx),
                          static_cast<double>(grid.dy),
                          grid.columns,
                          grid.rows};
  if (!detail::coverage::is_grid(wide)) return error_argument;
  if constexpr (Path<Shape>) {
    detail::polygon::Box box;
    if (detail::polygon::Edges(shape).check(box) != 0) return error_shape;
    return detail::coverage::for_shares(shape, box, wide, all, visit);
  } else {
    Aabb<double> box;
    const auto& s = widen(shape);
    if (const std::int32_t error = bounds(s, box); error != 0) return error;
    return detail::coverage::for_shares(s, box, wide, all, visit);
  }
}

}  // namespace vesica
