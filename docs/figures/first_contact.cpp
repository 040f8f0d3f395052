// SPDX-License-Identifier: Apache-2.0
/// A rectangle at rest, an ellipse that moves, and their first contact; and a pair that only just touches, magnified.
#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

std::vector<Point> moved(std::vector<Point> points, Point by) {
  for (Point& p : points) p = p + by;
  return points;
}

void draw_shape(Svg& svg, const Plane& plane, const std::vector<Point>& points, std::string_view colour,
                double opacity) {
  svg.path(plane(points), true, {colour, 2, colour, opacity, ""});
}

void draw_arrow(Svg& svg, Point from, Point to, std::string_view colour) {
  const Point along = to - from;
  const double length = std::hypot(along.x, along.y);
  const Point unit = (1 / length) * along, across{-unit.y, unit.x};
  svg.line(from, to, {colour, 2});
  svg.path({to, to - 9 * unit + 4 * across, to - 9 * unit - 4 * across}, true, filled(colour));
}

void draw_frame(Svg& svg, double left, std::string_view caption, std::string_view more) {
  svg.path({{left, 15}, {left + 365, 15}, {left + 365, 330}, {left, 330}}, true, {light, 1});
  svg.text({left, 355}, caption, Anchor::start, 14);
  svg.text({left, 375}, more, Anchor::start, 14);
}

void draw_cast(Svg& svg) {
  const Rect a{1.2, 0, 0.8, 0.6, 1.2, 0.8};
  const Ellipse b{-4, 1.5, 0.8, -0.6, 1.1, 0.5};
  const Point v{2, -0.25};
  vesica::Impact<double> impact{};
  require(vesica::cast_or_error(a, b, v.x, v.y, forever, impact) == vesica::cast_hit, "the ellipse hits");
  require(impact.t > 1.5 && impact.t < 2.5, "within the picture");
  const Plane plane{{225, 180}, 42};
  svg.clip({15, 15}, {365, 315});
  draw_shape(svg, plane, corners(a), blue, 0.2);
  draw_shape(svg, plane, outline(b), green, 0.25);
  for (const double share : {0.25, 0.5, 0.75}) {
    svg.path(plane(moved(outline(b), (share * impact.t) * v)), true, {green, 1, "none", 1, "3 4"});
  }
  draw_shape(svg, plane, moved(outline(b), impact.t * v), green, 0.25);
  draw_arrow(svg, plane({b.cx, b.cy}), plane(Point{b.cx, b.cy} + v), black);
  const Point contact{impact.x, impact.y};
  draw_arrow(svg, plane(contact), plane(contact + 1.2 * Point{impact.nx, impact.ny}), red);
  svg.dot(plane(contact), 4, red);
  svg.unclip();
  draw_frame(svg, 15, format("b moves by t v (black) and touches a at t = %.3f,", impact.t),
             "at the red point, along the normal from a to b.");
}

void draw_graze(Svg& svg) {
  const Circle a{0, 0, 1};
  const Point from{-2.4, 1}, v{1, 0};
  const Point below{from.x, 1 - 0x1p-52}, above{from.x, 1 + 0x1p-52};
  vesica::Impact<double> at{}, under{}, over{};
  const auto ray = [&](Point p, vesica::Impact<double>& out) {
    return vesica::cast_or_error(a, vesica::Point<double>{p.x, p.y}, v.x, v.y, forever, out);
  };
  require(ray(from, at) == vesica::cast_hit && at.t == 2.4 && at.ny == 1, "the ray that grazes touches at the top");
  require(ray(below, under) == vesica::cast_hit && under.t < 2.4, "the ray below enters before");
  require(ray(above, over) == vesica::cast_miss, "the ray above misses");
  const Plane plane{{582, 215}, 75};
  svg.clip({400, 15}, {365, 315});
  draw_shape(svg, plane, outline(a), blue, 0.2);
  svg.line(plane(from), plane({2.4, 1}), {green, 2});
  svg.dot(plane({0, 1}), 4, red);
  // The top, magnified: half a chord of the ray below is 2.1e-8.
  const Point corner{625, 30};
  constexpr double wide = 125, high = 90, unit = 0x1p-52;
  svg.path({corner, corner + Point{wide, 0}, corner + Point{wide, high}, corner + Point{0, high}}, true,
           {grey, 1, "white"});
  const auto zoomed = [&](double x, double y) {
    return corner + Point{wide / 2 + x / 4e-8 * wide / 2, high / 2 - y / unit * 22};
  };
  svg.unclip();
  svg.clip(corner, {wide, high});
  std::vector<Point> cap;
  for (int i = -40; i <= 40; ++i) cap.push_back(zoomed(i * 1e-9, -0.5 * (i * 1e-9) * (i * 1e-9)));
  svg.path(cap, false, {blue, 2});
  for (const double y : {-1., 0., 1.}) svg.line(zoomed(-4e-8, y * unit), zoomed(4e-8, y * unit), {green, 1.5});
  svg.dot(zoomed(under.t - 2.4, -unit), 3.5, red);
  svg.dot(zoomed(0, 0), 3.5, red);
  svg.unclip();
  draw_frame(svg, 400, "Rays one double apart: the lowest enters the disc,",
             "the middle one touches it, the highest misses.");
}

}  // namespace

std::string first_contact() {
  Svg svg(780, 392, "First contact of moving shapes");
  draw_cast(svg);
  draw_graze(svg);
  return svg.str();
}

}  // namespace figures
