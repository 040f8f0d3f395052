// SPDX-License-Identifier: Apache-2.0
/// The nine regions about a rectangle, and the vertices and edges to try when the ellipse's centre is in one of them.
#include <vesica/methods/rect_ellipse_closest_features.hpp>

#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr Rect rect{0, 0, 0.96, 0.28, 1.15, 0.85};
constexpr Point most{4.3, 2.5};  ///< how far from the centre the regions are drawn

constexpr char names[] = "ABCD";  ///< of corners, in the order of corners()

/// The region in column i, row j: its extent in the frame, and what to try.
struct Region {
  int i, j;

  static Point between(int i, double half, double limit) {
    return i < 0 ? Point{-limit, -half} : i > 0 ? Point{half, limit} : Point{-half, half};
  }

  std::vector<Point> outline() const {
    const Point x = between(i, rect.hx, most.x), y = between(j, rect.hy, most.y);
    return {in_frame(rect, x.x, y.x), in_frame(rect, x.y, y.x), in_frame(rect, x.y, y.y), in_frame(rect, x.x, y.y)};
  }

  /// The place of its text: the middle, or beside the ellipse that is drawn.
  Point middle() const {
    const std::vector<Point> all = outline();
    return i > 0 && j > 0 ? in_frame(rect, 1.95, 2) : 0.5 * (all[0] + all[2]);
  }

  std::string_view colour() const { return i == 0 && j == 0 ? green : i == 0 || j == 0 ? sky : orange; }
};

/// The corner with signs (sx, sy) as an index of corners().
int corner_index(int sx, int sy) { return sy < 0 ? (sx < 0 ? 0 : 1) : (sx < 0 ? 3 : 2); }

std::string edge_name(int p, int q) { return std::string(1, names[std::min(p, q)]) + names[std::max(p, q)]; }

/// Two lines of text: edges, then vertices.
std::pair<std::string, std::string> features(const Region& r) {
  if (r.i == 0 && r.j == 0) return {"overlap", "whatever its size"};
  if (r.i != 0 && r.j != 0) {
    const int corner = corner_index(r.i, r.j), beside = corner_index(-r.i, r.j), below = corner_index(r.i, -r.j);
    std::string vertices = {names[corner], ',', ' ', names[beside], ',', ' ', names[below]};
    return {"edges " + edge_name(corner, beside) + ", " + edge_name(corner, below), "vertices " + vertices};
  }
  const int p = r.i != 0 ? corner_index(r.i, -1) : corner_index(-1, r.j);
  const int q = r.i != 0 ? corner_index(r.i, 1) : corner_index(1, r.j);
  return {"edge " + edge_name(p, q), std::string("vertices ") + names[std::min(p, q)] + ", " + names[std::max(p, q)]};
}

void draw_region(Svg& svg, const Plane& plane, const Region& region) {
  svg.path(plane(region.outline()), true, {"#ffffff", 1.5, region.colour(), 0.3, ""});
  const auto [edges, vertices] = features(region);
  const Point at = plane(region.middle());
  svg.text({at.x, at.y - 3}, edges, Anchor::middle, 14);
  svg.text({at.x, at.y + 15}, vertices, Anchor::middle, 14);
}

/// An ellipse whose centre lies off corner C and which reaches only the far end of an edge at it: D. In the frame it is
/// centred at (x, y), and its half length b from D along the line to its centre.
Ellipse needle() {
  const Point centre = in_frame(rect, 1.55, 1.3), d = corners(rect)[3];
  const double length = std::hypot(centre.x - d.x, centre.y - d.y);
  return {centre.x, centre.y, (centre.x - d.x) / length, (centre.y - d.y) / length, length + 0.05, 0.09};
}

void draw_needle(Svg& svg, const Plane& plane) {
  const Ellipse e = needle();
  const auto reaches = [&](std::size_t i) {
    const Point corner = corners(rect)[i];
    return vesica::overlap(vesica::Point<double>{corner.x, corner.y}, e);
  };
  require(reaches(3) && !reaches(0) && !reaches(1) && !reaches(2), "the ellipse holds D and no other corner");
  require(vesica::methods::closest_features(rect, e) == 1, "the method finds that they overlap");
  svg.path(plane(outline(e)), true, {red, 2, red, 0.25, ""});
  svg.dot(plane({e.cx, e.cy}), 4, red);
}

}  // namespace

std::string closest_features() {
  Svg svg(760, 640, "The nine regions of closest features");
  const Plane plane{{380, 295}, 75};
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) draw_region(svg, plane, {i, j});
  }
  svg.path(plane(corners(rect)), true, {black, 2.5});
  const std::vector<Point> all = corners(rect);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Point at = plane(all[i]), out = plane(1.13 * all[i]);
    svg.dot(at, 4.5, black);
    svg.text({out.x, out.y + 5}, std::string(1, names[i]), Anchor::middle, 16, black, true);
  }
  draw_needle(svg, plane);
  svg.text(
      {380, 605},
      "What to try, by where the ellipse's centre is: beside an edge that edge and its ends, off a corner two edges",
      Anchor::middle, 13, grey);
  svg.text({380, 625}, "and three vertices. The red ellipse's centre is off C, and the one vertex it reaches is D.",
           Anchor::middle, 13, grey);
  return svg.str();
}

}  // namespace figures
