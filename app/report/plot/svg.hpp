// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/plot/ticks.hpp"

#include <span>
#include <string>
#include <string_view>

/// Pieces of SVG that the plots share.
namespace gyro::report {

/// A coordinate with one decimal.
std::string place(double value);

/// " name=\"value\"".
std::string attribute(const char* name, double value);

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view css_class);

/// @param anchor  start, middle or end
std::string svg_text(double x, double y, std::string_view text, std::string_view anchor,
                     std::string_view css_class = "");

/// An <svg> of a size that grows with the page; `title` is read out where pictures cannot be seen.
std::string svg_picture(double width, double height, std::string_view title, const std::string& content);

/// A figure of the page. @param note  may have HTML in it
std::string html_figure(std::string_view title, const std::string& legend, const std::string& picture,
                        const std::string& note, std::string_view css_class = "");

/// Area of a plot inside its margins, and its two scales.
struct Frame {
  double width, height;  ///< of the picture
  double left, top, right, bottom;
  Scale x, y;
};

/// Axes with ticks, grid and labels around a frame.
std::string svg_axes(const Frame& frame, std::span<const Tick> x, std::span<const Tick> y, std::string_view x_label,
                     std::string_view y_label);

}  // namespace gyro::report
