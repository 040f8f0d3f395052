// SPDX-License-Identifier: Apache-2.0
/// The rectangle grown by the ellipse, the ellipse's centre outside it, and the corner that the printed test looks at.
#include <vesica/methods/rect_ellipse_minkowski_sum.hpp>

#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr Rect rect{0, 0, 1, 0, 0.25, 0.875};
constexpr Ellipse ellipse{-1.25, -0.375, 8, 15, 3. / 17, 0.125 / 17};
constexpr Point centre{ellipse.cx, ellipse.cy};

/// The point of the ellipse about the origin that lies farthest along a direction.
Point farthest(Point along) {
  const Point p{ellipse.a * ellipse.ux, ellipse.a * ellipse.uy}, q{-ellipse.b * ellipse.uy, ellipse.b * ellipse.ux};
  const double x = p.x * along.x + p.y * along.y, y = q.x * along.x + q.y * along.y, length = std::hypot(x, y);
  return x / length * p + y / length * q;
}

/// Half the sides of the grown rectangle's box.
Point reach() { return {rect.hx + farthest({1, 0}).x, rect.hy + farthest({0, 1}).y}; }

/// Sums of farthest points of both, all round.
std::vector<Point> grown_rectangle() {
  constexpr int steps = 720;
  std::vector<Point> points;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / steps;
    const Point along{std::cos(t), std::sin(t)};
    points.push_back(Point{std::copysign(rect.hx, along.x), std::copysign(rect.hy, along.y)} + farthest(along));
  }
  return points;
}

/// The wedge at a corner in which its arc applies: between the points where the arc touches the box's sides.
struct Corner {
  Point at, a0, a1;

  Corner(double sx, double sy)
      : at{sx * rect.hx, sy * rect.hy}, a0(at + farthest({sx, 0})), a1(at + farthest({0, sy})) {}

  bool wedge_holds(Point p) const {
    const Point d = p - at, u = a0 - at, v = a1 - at;
    const double det = u.x * v.y - u.y * v.x;
    return (d.x * v.y - d.y * v.x) / det > 0 && (u.x * d.y - u.y * d.x) / det > 0;
  }

  Ellipse arc_ellipse() const { return {at.x, at.y, ellipse.ux, ellipse.uy, ellipse.a, ellipse.b}; }
};

/// Returns the answer of the test, which looks at one corner.
bool overlaps_by(const Corner& corner) {
  if (!corner.wedge_holds(centre)) return true;
  return vesica::overlap(vesica::Point<double>{centre.x, centre.y}, corner.arc_ellipse());
}

void draw_corner(Svg& svg, const Plane& plane, const Corner& corner, std::string_view colour) {
  const Point u = corner.a0 - corner.at, v = corner.a1 - corner.at;
  const Point away = 30 / std::hypot(u.x + v.x, u.y + v.y) * (u + v);  // beyond the box
  svg.path(plane(std::vector<Point>{corner.at, corner.at + 30 * u, corner.at + 30 * u + away, corner.at + 30 * v + away,
                                    corner.at + 30 * v}),
           true, filled(colour, 0.2));
  svg.path(plane(outline(corner.arc_ellipse())), true, {colour, 1.5, "none", 1, "5 3"});
  svg.dot(plane(corner.at), 4.5, colour);
}

void draw_legend(Svg& svg, double x) {
  struct Entry {
    std::string_view colour, first, second;
  };
  constexpr Entry entries[] = {
      {grey, "the rectangle", "half extents 1/4 and 7/8"},
      {black, "the ellipse and its centre K", "half lengths 3 and 1/8, axis (8, 15) / 17"},
      {green, "the rectangle grown by the ellipse", "K is outside: they do not overlap"},
      {red, "the printed test: the corner on K's side,", "chosen by the signs of K's coordinates"},
      {red, "K is not in this corner's narrow wedge,", "so the printed test says they overlap"},
      {blue, "the corner whose wedge does hold K:", "K is beyond its arc"},
  };
  double y = 70;
  for (const Entry& entry : entries) {
    svg.dot({x, y - 4}, 6, entry.colour);
    svg.text({x + 16, y}, entry.first, Anchor::start, 14);
    svg.text({x + 16, y + 19}, entry.second, Anchor::start, 14);
    y += 58;
  }
}

}  // namespace

std::string minkowski_sum() {
  const Corner printed(-1, -1), right(-1, 1);
  require(!vesica::overlap(rect, ellipse), "they do not overlap");
  require(overlaps_by(printed), "the printed test says they do");
  require(right.wedge_holds(centre) && !overlaps_by(right), "the other corner tells");
  require(vesica::methods::minkowski_sum(rect, ellipse) == 0, "the method here is right");

  Svg svg(720, 560,
          "Rectangle against ellipse by their Minkowski sum, and the corner that the printed test gets wrong");
  const Plane plane{{210, 275}, 70};
  const Point box = reach();
  svg.path(plane(corners({0, 0, 1, 0, box.x, box.y})), true, {grey, 1, "none", 1, "2 3"});
  svg.path(plane(grown_rectangle()), true, {green, 1.5, green, 0.15, ""});
  svg.clip(plane({-box.x, box.y}), 2 * plane.scale * box);
  draw_corner(svg, plane, right, blue);
  draw_corner(svg, plane, printed, red);
  svg.unclip();
  svg.path(plane(corners(rect)), true, {grey, 2, grey, 0.35, ""});
  svg.path(plane(outline(ellipse)), true, {black, 2});
  svg.dot(plane(centre), 4.5, black);
  const Point k = plane(centre);
  svg.text({k.x - 10, k.y + 5}, "K", Anchor::end, 16, black, true);
  draw_legend(svg, 385);
  return svg.str();
}

}  // namespace figures
