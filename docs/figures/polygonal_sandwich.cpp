// SPDX-License-Identifier: Apache-2.0
/// The ellipse between its two polygons after 0 to 3 iterations, and what the method can say by then.
#include <vesica/methods/circle_ellipse_polygonal_sandwich.hpp>

#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr Ellipse ellipse{0, 0, 1, 0, 2, 1.1};
constexpr Circle circle{2.006, 1.112, 0.6};

/// The angle of the outline's point nearest to the circle's centre.
double nearest_angle() {
  constexpr int steps = 100000;
  double best = 0, least = HUGE_VAL;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * std::numbers::pi * i / steps;
    const Point away = at_angle(ellipse, t) - Point{circle.cx, circle.cy};
    if (std::hypot(away.x, away.y) >= least) continue;
    least = std::hypot(away.x, away.y);
    best = t;
  }
  return best;
}

/// The polygons of 2^(2 + iterations) sides: corners on the outline, and where the tangents there meet.
struct Polygons {
  double step;
  int sides;

  explicit Polygons(int iterations) : step(std::numbers::pi / 2 / (1 << iterations)), sides(4 << iterations) {}

  Point inner(int i) const { return at_angle(ellipse, i * step); }
  Point outer(int i) const { return 1 / std::cos(step / 2) * at_angle(ellipse, (i + 0.5) * step); }

  template <class Corner>
  std::vector<Point> all(Corner corner) const {
    std::vector<Point> points;
    for (int i = 0; i < sides; ++i) points.push_back((this->*corner)(i));
    return points;
  }
};

void draw_panel(Svg& svg, const Plane& plane, const Polygons& polygons, double line) {
  svg.path(plane(polygons.all(&Polygons::outer)), true, {orange, line, orange, 0.18, ""});
  svg.path(plane(polygons.all(&Polygons::inner)), true, {blue, line, sky, 0.35, ""});
  // The one triangle that matters: its arc holds the point nearest to the circle.
  const int i = static_cast<int>(nearest_angle() / polygons.step);
  svg.path(plane(std::vector<Point>{polygons.inner(i), polygons.outer(i), polygons.inner(i + 1)}), true,
           filled(pink, 0.75));
  svg.path(plane(outline(ellipse)), true, {black, line});
  svg.path(plane(outline(circle)), true, {green, 1.4 * line});
}

const char* name_of(std::int32_t answer) {
  if (answer == vesica::methods::uncertain) return "uncertain";
  return answer == vesica::methods::yes ? "yes, they overlap" : "no, they do not overlap";
}

}  // namespace

std::string polygonal_sandwich() {
  constexpr double width = 205, zoomed = 180;
  Svg svg(4 * width + 20, 470, "The polygonal sandwich after 0 to 3 iterations");
  const double t = nearest_angle();
  const Point near = at_angle(ellipse, t);
  for (int n = 0; n < 4; ++n) {
    vesica::methods::Approximation<double> reached{};
    const std::int32_t answer = vesica::methods::polygonal_sandwich(circle, ellipse, n, reached);
    require((answer == vesica::methods::uncertain) == (n < 3), "uncertain up to 2 iterations");
    const double left = 15 + width * n;
    const Polygons polygons(n);
    svg.text({left, 28}, format("%d iteration%s: %d sides", n, n == 1 ? "" : "s", polygons.sides), Anchor::start, 14,
             black, true);
    svg.text({left, 47}, name_of(answer), Anchor::start, 14, n < 3 ? red : green);
    draw_panel(svg, {{left + 86, 150}, 38}, polygons, 1.5);
    svg.text({left, 246}, format("outline error below %.3f", reached.outline_error), Anchor::start, 12, grey);
    // The same about the nearest point, eight times as large.
    const Point corner{left, 265};
    svg.clip(corner, {zoomed, zoomed});
    const Plane close{{corner.x + zoomed / 2 - 300 * near.x, corner.y + zoomed / 2 + 300 * near.y}, 300};
    draw_panel(svg, close, polygons, 2);
    svg.unclip();
    svg.path({corner, {left + zoomed, 265}, {left + zoomed, 265 + zoomed}, {left, 265 + zoomed}}, true, {grey, 1});
  }
  svg.text({15, 462},
           "Lower row: the place of contact, 8 times as large. Green: the circle; pink: the triangle looked at.",
           Anchor::start, 12, grey);
  return svg.str();
}

}  // namespace figures
