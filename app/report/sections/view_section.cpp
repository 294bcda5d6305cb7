// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"
#include "app/report/view3d/encode.hpp"

#include <algorithm>

namespace gyro::report {
namespace {

/// Limits for each run, so that a page with several runs is as large as one with a single run.
ViewLimits limits_of(std::size_t runs) {
  ViewLimits limits;
  limits.frames = std::clamp<std::size_t>(16 / runs, 2, limits.frames);
  limits.particles = std::max<std::size_t>(3000, limits.particles / runs);
  return limits;
}

std::string words_on_particles(const std::vector<ViewFrame>& frames) {
  const auto fullest = std::ranges::max_element(frames, {}, &ViewFrame::particles);
  if (fullest->particles <= fullest->colours.size()) return "All particles are drawn.";
  return "Of up to " + count(static_cast<std::int64_t>(fullest->particles)) + " particles in a frame the largest " +
         count(static_cast<std::int64_t>(fullest->colours.size())) +
         " are drawn (an even choice among equal ones); finer rock is left out.";
}

std::string view(const RunData& run, const ViewLimits& limits) {
  const std::vector<ViewFrame> frames = read_frames(run.directory, limits);
  if (frames.empty())
    return "<p>This run has no snapshots in .vtp files (output.snapshots of its case is 0, output.formats has no vtp, "
           "or "
           "the files were removed), so there is nothing to show in three dimensions.</p>\n";
  std::string html =
      "<div class=\"view3d\"><div class=\"live\" hidden=\"hidden\"><canvas tabindex=\"0\" "
      "aria-label=\"Rock and liners in three dimensions\"></canvas>\n<p class=\"controls\">"
      "<label>Time <input type=\"range\" min=\"0\" max=\"" +
      std::to_string(frames.size() - 1) + "\" step=\"1\" value=\"" + std::to_string(frames.size() - 1) +
      "\"/></label> <output></output> <button type=\"button\" class=\"in\">Closer</button> "
      "<button type=\"button\" class=\"out\">Farther</button> <button type=\"button\" class=\"walls\">"
      "Liners on/off</button></p>\n<p class=\"note\">Drag to turn. The half of the outer walls that stands before the "
      "axis is "
      "cut away.</p></div>\n<div class=\"still\">" +
      slice_picture(frames.back()) + "<p class=\"note\">Slice through the axis at " +
      quantity(frames.back().time, "s") +
      ": the rock behind the plane y = 0, and the outlines of the walls in it. The view that turns needs "
      "a browser with WebGL 2.</p></div>\n<p class=\"note\">Rock is coloured by fragment, the particles "
      "that are still joined; single particles are grey. " +
      words_on_particles(frames) + "</p>\n";
  for (const ViewFrame& frame : frames) html += html_frame(frame);
  return html + "</div>\n";
}

}  // namespace

std::string view_section(const Runs& runs) {
  const ViewLimits limits = limits_of(runs.size());
  return section("view", "Rock and liners", by_run(runs, [&](const RunData& run) { return view(run, limits); }));
}

}  // namespace gyro::report
