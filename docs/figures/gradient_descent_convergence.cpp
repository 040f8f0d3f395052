// SPDX-License-Identifier: Apache-2.0
/// Error against iteration on the nineteen samples, for both schedules.
#include <algorithm>
#include <cmath>
#include <vesica/methods/ellipse_ellipse_distance_gradient_descent.hpp>

#include "figures.hpp"
#include "samples.hpp"

namespace figures {
namespace {

using vesica::methods::Schedule;

constexpr double width = 340, height = 300, top = 70;
constexpr int most_iterations = 500;

/// Axes of one panel: iterations to the right, powers of ten upward.
struct Chart {
  double left;
  int lowest, highest;  ///< exponents

  Point at(double iteration, double error) const {
    return {left + width * iteration / most_iterations,
            top + height * (highest - std::log10(error)) / (highest - lowest)};
  }
};

std::vector<double> errors_of(std::size_t sample, Schedule schedule) {
  vesica::methods::DescentResult<double> result;
  std::vector<double> errors(most_iterations);
  const auto first = nineteen_ellipses::ellipse<double>(nineteen_ellipses::first);
  const auto other = nineteen_ellipses::ellipse<double>(nineteen_ellipses::others[sample]);
  const std::int32_t code = vesica::methods::gradient_descent_distance(
      first, other, vesica::methods::descent_settings<double>(schedule), result, errors.data(), most_iterations);
  require(code == 1, "all nineteen samples converge");
  require(result.iterations <= most_iterations, "they do so within the chart");
  errors.resize(static_cast<std::size_t>(result.iterations));
  return errors;
}

void draw_axes(Svg& svg, const Chart& chart, const char* title, const char* unit) {
  svg.text({chart.left + width / 2, top - 34}, title, Anchor::middle, 15, black, true);
  svg.text({chart.left + width / 2, top - 15}, unit, Anchor::middle, 12, grey);
  for (int e = chart.lowest; e <= chart.highest; e += 2) {
    const Point left = chart.at(0, std::pow(10, e)), right = chart.at(most_iterations, std::pow(10, e));
    svg.line(left, right, {light, 1});
    svg.text({left.x - 8, left.y + 4}, format("1e%d", e), Anchor::end, 12, grey);
  }
  for (int i = 0; i <= most_iterations; i += 100) {
    const Point bottom{chart.at(i, 1).x, top + height};
    svg.line(bottom, {bottom.x, bottom.y + 5}, {grey, 1});
    svg.text({bottom.x, bottom.y + 19}, format("%d", i), Anchor::middle, 12, grey);
  }
  svg.text({chart.left + width / 2, top + height + 38}, "iteration", Anchor::middle, 13);
  svg.line(chart.at(0, 1e-8), chart.at(most_iterations, 1e-8), {black, 1, "none", 1, "5 4"});
  const Point end = chart.at(most_iterations, 1e-8);
  svg.text({end.x, end.y + 16}, "tolerance", Anchor::end, 12);
  svg.text({chart.left + 9, top + height - 8}, "1 to 6: below 1e-10 at once", Anchor::start, 12);
}

/// An error of 0 lies below every power of ten: such a sample is a dot on the chart's lower edge.
void draw_curve(Svg& svg, const Chart& chart, const std::vector<double>& errors, std::string_view colour) {
  const double lowest = std::pow(10, chart.lowest);
  std::vector<Point> points;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    points.push_back(chart.at(static_cast<double>(i), std::max(errors[i], lowest)));
  }
  svg.path(points, false, {colour, 2});
  svg.dot(points.back(), 4, colour);
}

void draw_legend(Svg& svg, Point at) {
  for (std::size_t i = 0; i < sample_groups.size(); ++i) {
    const Point here{at.x + 190 * static_cast<double>(i % 4), at.y + 24 * static_cast<double>(i / 4)};
    svg.line(here, {here.x + 22, here.y}, {sample_groups[i].colour, 3});
    svg.text({here.x + 29, here.y + 4}, std::string(sample_groups[i].numbers) + std::string(sample_groups[i].note));
  }
}

}  // namespace

std::string gradient_descent_convergence() {
  Svg svg(800, 480, "Convergence of gradient descent on nineteen pairs of ellipses");
  const Chart scale_aware{55, -10, 0}, literal{445, -10, 2};
  draw_axes(svg, scale_aware, "scale-aware steps", "error in radians");
  draw_axes(svg, literal, "steps as printed", "error in squared units of length");
  for (const SampleGroup& group : sample_groups) {
    for (std::size_t i = group.first; i <= group.last; ++i) {
      draw_curve(svg, scale_aware, errors_of(i, Schedule::scale_aware), group.colour);
      draw_curve(svg, literal, errors_of(i, Schedule::literal), group.colour);
    }
  }
  draw_legend(svg, {45, 436});
  return svg.str();
}

}  // namespace figures
