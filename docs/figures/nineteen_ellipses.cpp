// SPDX-License-Identifier: Apache-2.0
/// One ellipse, nineteen others, and the shortest segments between the outlines.
#include <vesica/boundary_distance.hpp>
#include <vesica/methods/ellipse_ellipse_distance_gradient_descent.hpp>

#include "figures.hpp"
#include "samples.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

vesica::ClosestPoints<double> shortest(const Ellipse& a, const Ellipse& b) {
  vesica::ClosestPoints<double> closest{};
  require(vesica::boundary_distance_or_error(a, b, closest) == 0, "all nineteen pairs have a distance");
  return closest;
}

/// A point that two outlines share: of several the one that gradient descent comes to. Which one the default gives is
/// nobody's business, and may change.
Point contact(const Ellipse& a, const Ellipse& b) {
  vesica::methods::DescentResult<double> r;
  const auto settings = vesica::methods::descent_settings<double>(vesica::methods::Schedule::scale_aware);
  require(vesica::methods::gradient_descent_distance(a, b, settings, r) == 1, "all nineteen samples converge");
  require(r.distance < 1e-6 && shortest(a, b).distance < 1e-14, "outlines that meet have distance 0");
  return at_angle(a, r.angle_a);
}

/// Beside the middle of a segment, on its upper side.
void label_segment(Svg& svg, Point from, Point to, const std::string& text) {
  const Point middle = 0.5 * (from + to), along = to - from;
  const double length = std::copysign(std::hypot(along.x, along.y), along.x);
  const Point up{along.y / length, -along.x / length};
  svg.text({middle.x + 10 * up.x, middle.y + 10 * up.y + 4}, text, up.x < -0.2 ? Anchor::end : Anchor::start, 13);
}

}  // namespace

std::string nineteen_ellipses() {
  Svg svg(700, 720, "Nineteen ellipses and their distances from one");
  const Plane plane{{375, 350}, 28};
  const Ellipse first = nineteen_ellipses::ellipse<double>(nineteen_ellipses::first);
  svg.path(plane(outline(first)), true, {black, 5});
  for (const SampleGroup& group : sample_groups) {
    for (std::size_t i = group.first; i <= group.last; ++i) {
      const Ellipse other = nineteen_ellipses::ellipse<double>(nineteen_ellipses::others[i]);
      svg.path(plane(outline(other)), true, {group.colour, 2});
    }
  }
  for (const SampleGroup& group : sample_groups) {
    for (std::size_t i = group.first; i <= group.last; ++i) {
      const Ellipse other = nineteen_ellipses::ellipse<double>(nineteen_ellipses::others[i]);
      if (nineteen_ellipses::touches_or_crosses(i)) {
        svg.dot(plane(contact(first, other)), 3.5, black);
        continue;
      }
      const auto s = shortest(first, other);
      const Point from = plane({s.ax, s.ay}), to = plane({s.bx, s.by});
      svg.line(from, to, {black, 2});
      svg.dot(from, 3.5, black);
      svg.dot(to, 3.5, black);
      if (i != group.last) continue;
      label_segment(svg, from, to, format("%.3f", s.distance));
      const Point centre = plane({other.cx, other.cy});
      svg.text({centre.x, centre.y + 5}, group.numbers, Anchor::middle, 14, group.colour, true);
    }
  }
  svg.text({350, 680},
           "Bold: the first ellipse. 1 and 2 equal it, 3 to 6 touch it from inside (grey), 7 and 8 cross it (red): "
           "distance 0.",
           Anchor::middle, 12.5, grey);
  svg.text({350, 700}, "Black: the shortest segment from outline to outline, and its length.", Anchor::middle, 12.5,
           grey);
  return svg.str();
}

}  // namespace figures
