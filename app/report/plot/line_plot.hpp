// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

/// Plots as inline SVG. Colours, light and dark, are those of page.css, by the classes c0 to
/// c6; lines differ by their dashes as well.
namespace gyro::report {

struct Axis {
  std::string label;  ///< with the unit
  bool log = false;
  std::optional<double> low = {}, high = {};  ///< ends; by default those of the data
  bool zero = false;                          ///< zero belongs to the axis
  double step = 0;                            ///< from tick to tick of a linear axis; 0: one that suits
};

/// A line, or points.
struct Curve {
  enum class Line { plain, faint, dashed, none };

  std::string name = {};     ///< in the legend; empty: not in it
  std::vector<double> x, y;  ///< a value that is not finite breaks the line
  int style = 0;             ///< colour and dashes
  Line line = Line::plain;   ///< faint: thin and pale; dashed: an estimate; none: points only
  bool points = false;       ///< a mark at each point
};

/// The area between two curves over the same x.
struct Area {
  std::string name;
  std::vector<double> x, low, high;
  int style = 0;
};

/// A stretch of the x axis that is shaded.
struct Span {
  double from, to;
  std::string name;  ///< in the legend; empty: not in it
  std::string kind;  ///< class of page.css: steady, unknown, coarse
};

/// A vertical line with its name above.
struct Mark {
  double x;
  std::string name;
};

/// A point with lines to both axes.
struct Spot {
  double x, y;
  int style = 0;
};

struct LinePlot {
  std::string title;      ///< says what the plot shows
  std::string note = {};  ///< a sentence or two below the plot; it may have HTML in it
  Axis x = {}, y = {};
  std::vector<Span> spans = {};
  std::vector<Area> areas = {};
  std::vector<Curve> curves = {};
  std::vector<Mark> marks = {};
  std::vector<Spot> spots = {};
};

/// Whether a plot has a point to draw.
bool has_points(const LinePlot& plot);

/// The plot as an HTML figure with its title, legend and note.
std::string figure(const LinePlot& plot);

}  // namespace gyro::report
