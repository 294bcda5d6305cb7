// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/svg.hpp"

#include "app/report/text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace gyro::report {

std::string place(double value) {
  constexpr double beyond = 1e5;  // what a viewer can still draw; such a place is cut off at the frame
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f", std::clamp(value, -beyond, beyond));
  std::string shown = text.data();
  if (shown.ends_with(".0")) shown.resize(shown.size() - 2);
  return shown == "-0" ? "0" : shown;
}

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + place(value) + "\"";
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view css_class) {
  return "<line class=\"" + std::string(css_class) + "\"" + attribute("x1", x1) + attribute("y1", y1) +
         attribute("x2", x2) + attribute("y2", y2) + "/>";
}

std::string svg_text(double x, double y, std::string_view text, std::string_view anchor, std::string_view css_class) {
  return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"" + std::string(anchor) + "\"" +
         (css_class.empty() ? "" : " class=\"" + std::string(css_class) + "\"") + ">" + escape(text) + "</text>";
}

std::string svg_picture(double width, double height, std::string_view title, const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"" + escape(title) + "\" viewBox=\"0 0 " +
         place(width) + " " + place(height) + "\">" + content + "</svg>";
}

std::string html_figure(std::string_view title, const std::string& legend, const std::string& picture,
                        const std::string& note, std::string_view css_class) {
  return "<figure" + (css_class.empty() ? "" : " class=\"" + std::string(css_class) + "\"") + "><figcaption>" +
         escape(title) + "</figcaption>" + (legend.empty() ? "" : "<ul class=\"legend\">" + legend + "</ul>") +
         picture + (note.empty() ? "" : "<p class=\"note\">" + note + "</p>") + "</figure>\n";
}

std::string svg_axes(const Frame& f, std::span<const Tick> x, std::span<const Tick> y, std::string_view x_label,
                     std::string_view y_label) {
  constexpr double tick = 4, below = 8, beside = 7;
  std::string svg;
  for (const Tick& t : x) {
    const double at = f.x.at(t.value);
    if (!t.label.empty()) svg += svg_line(at, f.top, at, f.bottom, "grid");
    svg += svg_line(at, f.bottom, at, f.bottom + (t.label.empty() ? tick / 2 : tick), "axis");
    if (!t.label.empty()) svg += "<g class=\"down\">" + svg_text(at, f.bottom + below, t.label, "middle") + "</g>";
  }
  for (const Tick& t : y) {
    const double at = f.y.at(t.value);
    svg += svg_line(f.left, at, f.right, at, "grid") + svg_text(f.left - beside, at, t.label, "end", "middle");
  }
  svg += svg_line(f.left, f.bottom, f.right, f.bottom, "axis") + svg_line(f.left, f.top, f.left, f.bottom, "axis");
  svg += svg_text(f.right, f.height - 5, x_label, "end", "label");
  return svg + svg_text(2, 14, y_label, "start", "label");
}

}  // namespace gyro::report
