// SPDX-License-Identifier: Apache-2.0
#include "svg.hpp"

namespace figures {
namespace {

std::string number(double x) {
  const std::string text = format("%.1f", x);
  return text == "-0.0" ? "0.0" : text;
}

std::string place(Point p) { return number(p.x).append(",").append(number(p.y)); }

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

/// One element's attributes.
class Attributes {
 public:
  Attributes& add(std::string_view name, std::string_view value) {
    text_ += ' ';
    text_.append(name).append("=\"").append(value).append("\"");
    return *this;
  }
  Attributes& add(std::string_view name, double value) { return add(name, number(value)); }
  Attributes& add(const Style& style) {
    add("stroke", style.stroke).add("fill", style.fill);
    if (style.stroke != "none") add("stroke-width", style.width);
    if (style.opacity != 1) add("fill-opacity", format("%.2f", style.opacity));
    if (!style.dashes.empty()) add("stroke-dasharray", style.dashes);
    return *this;
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

Svg::Svg(double width, double height, std::string_view title) {
  text_ = format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\"\n",
                 width, height, width, height);
  text_ += "     font-family=\"Helvetica, Arial, sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  text_.append("<title>").append(escaped(title)).append("</title>\n");
  text_ += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void Svg::line(Point from, Point to, const Style& style) { path({from, to}, false, style); }

void Svg::path(const std::vector<Point>& points, bool closed, const Style& style) {
  std::string d;
  for (const Point& p : points) {
    d += d.empty() ? 'M' : ' ';
    d += place(p);
  }
  if (closed) d += 'Z';
  text_.append("<path").append(Attributes().add("d", d).add(style).str()).append("/>\n");
}

void Svg::dot(Point centre, double radius, std::string_view colour) {
  const Attributes all = Attributes().add("cx", centre.x).add("cy", centre.y).add("r", radius).add("fill", colour);
  text_.append("<circle").append(all.str()).append("/>\n");
}

void Svg::text(Point at, std::string_view text, Anchor anchor, double size, std::string_view colour, bool bold) {
  constexpr std::string_view anchors[] = {"start", "middle", "end"};
  Attributes all = Attributes().add("x", at.x).add("y", at.y).add("font-size", size).add("fill", colour);
  all.add("text-anchor", anchors[static_cast<int>(anchor)]);
  if (bold) all.add("font-weight", "bold");
  // A margin of paper, so that lines behind do not run through it.
  all.add("stroke", "#ffffff").add("stroke-width", 3.0).add("paint-order", "stroke");
  text_.append("<text").append(all.str()).append(">").append(escaped(text)).append("</text>\n");
}

void Svg::clip(Point corner, Point size) {
  const std::string name = format("clip%d", clips_++);
  const Attributes box = Attributes().add("x", corner.x).add("y", corner.y).add("width", size.x).add("height", size.y);
  text_.append("<clipPath id=\"").append(name).append("\"><rect").append(box.str()).append("/></clipPath>\n");
  text_.append("<g clip-path=\"url(#").append(name).append(")\">\n");
}

void Svg::unclip() { text_ += "</g>\n"; }

}  // namespace figures
