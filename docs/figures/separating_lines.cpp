// SPDX-License-Identifier: Apache-2.0
/// Rectangles apart, and the line along an edge that separates them: one of the first's, or of the second's only.
#include <vesica/methods/rect_rect_separating_lines.hpp>

#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr Rect first{0, 0, 1, 0, 2, 1};
constexpr double root = std::numbers::sqrt2 / 2;

/// Do all corners of b lie beyond the line along one edge of a, at `side` half extents along x or y?
bool beyond(const Rect& a, const Rect& b, bool along_x, double side) {
  for (const Point& p : corners(b)) {
    const double dx = p.x - a.cx, dy = p.y - a.cy;
    const double at = along_x ? dx * a.ux + dy * a.uy : dy * a.ux - dx * a.uy;
    if (side * at <= (along_x ? a.hx : a.hy)) return false;
  }
  return true;
}

/// The lines along a's four edges: bold where one separates, else dashed. How many do.
int draw_lines(Svg& svg, const Plane& plane, const Rect& a, const Rect& b, std::string_view colour) {
  constexpr double far = 20;
  int separating = 0;
  for (const bool along_x : {true, false}) {
    for (const double side : {-1., 1.}) {
      const bool separates = beyond(a, b, along_x, side);
      separating += separates;
      const Point from = along_x ? in_frame(a, side * a.hx, -far) : in_frame(a, -far, side * a.hy);
      const Point to = along_x ? in_frame(a, side * a.hx, far) : in_frame(a, far, side * a.hy);
      const Style dashed{colour, 1, "none", 1, "3 4"}, bold{red, 3};
      svg.line(plane(from), plane(to), separates ? bold : dashed);
    }
  }
  return separating;
}

void draw_rect(Svg& svg, const Plane& plane, const Rect& rect, std::string_view colour, std::string_view name) {
  svg.path(plane(corners(rect)), true, {colour, 2.5, colour, 0.2, ""});
  for (const Point& p : corners(rect)) svg.dot(plane(p), 4, colour);
  const Point at = plane({rect.cx, rect.cy});
  svg.text({at.x, at.y + 6}, name, Anchor::middle, 17, colour, true);
}

void draw_panel(Svg& svg, double left, const Rect& second, bool lines_of_second, std::string_view caption,
                std::string_view more) {
  require(vesica::methods::separating_lines(first, second) == 0, "the rectangles are apart");
  const Plane plane{{left + 115, 205}, 44};
  svg.clip({left, 15}, {365, 315});
  const int of_first = draw_lines(svg, plane, first, second, blue);
  int of_second = 0;
  if (lines_of_second) of_second = draw_lines(svg, plane, second, first, green);
  require(lines_of_second ? of_first == 0 && of_second == 1 : of_first == 1, "one line separates, the one described");
  draw_rect(svg, plane, first, blue, "A");
  draw_rect(svg, plane, second, green, "B");
  svg.unclip();
  svg.path({{left, 15}, {left + 365, 15}, {left + 365, 330}, {left, 330}}, true, {light, 1});
  svg.text({left, 355}, caption, Anchor::start, 14);
  svg.text({left, 375}, more, Anchor::start, 14);
}

}  // namespace

std::string separating_lines() {
  Svg svg(780, 392, "The separating line of two rectangles");
  draw_panel(svg, 15, {3.9, 0.6, 0.8, 0.6, 1.2, 0.8}, false, "All corners of B lie beyond a line along",
             "an edge of A (red): they are apart.");
  draw_panel(svg, 400, {2.9, 1.9, root, -root, 1.5, 0.4}, true, "No line of A does it, but with B at the origin",
             "one of B's has all corners of A beyond it.");
  return svg.str();
}

}  // namespace figures
