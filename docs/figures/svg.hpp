// SPDX-License-Identifier: Apache-2.0
/// Scalable Vector Graphics, as much of it as the figures need. Numbers are written with one decimal, so that a last
/// place of a cosine, which differs between mathematics libraries, does not show.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace figures {

struct Point {
  double x, y;
};

inline Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
inline Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
inline Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }

/// Okabe and Ito's colours, distinct for readers of any colour vision, and two darker greys.
inline constexpr std::string_view black = "#1a1a1a", grey = "#767676", light = "#d0d0d0", blue = "#0072b2",
                                  sky = "#56b4e9", green = "#009e73", orange = "#e69f00", red = "#d55e00",
                                  pink = "#cc79a7", brown = "#7a4a1e";

/// How something is drawn. Opacity is the fill's.
struct Style {
  std::string_view stroke = black;
  double width = 1.5;
  std::string_view fill = "none";
  double opacity = 1;
  std::string_view dashes = "";
};

inline constexpr Style filled(std::string_view colour, double opacity = 1) { return {"none", 0, colour, opacity, ""}; }

enum class Anchor { start, middle, end };

/// A picture under way, in pixels, y down. Text is what is shown, not markup.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void line(Point from, Point to, const Style& style);
  void path(const std::vector<Point>& points, bool closed, const Style& style);
  void dot(Point centre, double radius, std::string_view colour);
  void text(Point at, std::string_view text, Anchor anchor = Anchor::start, double size = 13,
            std::string_view colour = black, bool bold = false);
  /// Everything until unclip() is shown inside this box only.
  void clip(Point corner, Point size);
  void unclip();

  /// The whole file.
  std::string str() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
  int clips_ = 0;
};

/// Right-handed coordinates on a picture: a point of the plane is `scale` pixels from its neighbour at distance 1.
struct Plane {
  Point origin;
  double scale;

  Point operator()(Point p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }

  std::vector<Point> operator()(const std::vector<Point>& points) const {
    std::vector<Point> pixels;
    for (const Point& p : points) pixels.push_back((*this)(p));
    return pixels;
  }
};

/// printf to a string, of 200 characters at most.
std::string format(const char* pattern, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace figures
