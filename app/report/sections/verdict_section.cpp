// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/headline.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"
#include "app/report/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

const char* css_of(Verdict::Tone tone) {
  return tone == Verdict::Tone::good ? "good" : tone == Verdict::Tone::caution ? "caution" : "bad";
}

std::string html_verdict(const RunData& run, bool named) {
  const Verdict v = verdict(run);
  std::string html = std::string("<div class=\"verdict ") + css_of(v.tone) + "\">";
  if (named) html += "<p class=\"runname\">" + escape(run.name) + "</p>";
  html += "<p class=\"headline\">" + escape(v.headline) + "</p>";
  if (!v.lead.empty()) html += "<p>" + escape(v.lead) + "</p>";
  return html + "</div>\n";
}

std::string html_trust(const RunData& run) {
  std::string html;
  for (const std::string& sentence : verdict(run).trust) html += "<li>" + escape(sentence) + "</li>\n";
  return html.empty() ? "" : "<h3>What can be trusted</h3>\n<ul class=\"trust\">\n" + html + "</ul>\n";
}

std::string html_tile(const Headline& f) {
  const Unit unit = shown_unit(f.units, f.value);
  std::string html = "<div class=\"tile\" title=\"" + escape(f.about) + "\"><p class=\"what\">" + escape(f.label) +
                     "</p><p class=\"big\">" + number(f.value * unit.factor) + " <small>" + escape(unit.name) +
                     "</small></p>";
  if (f.error && *f.error > 1e-6 * std::abs(f.value))
    html += "<p class=\"error\">± " + number(*f.error * unit.factor, 2) + " " + escape(unit.name) +
            (f.value != 0 ? " (" + number(100 * *f.error / std::abs(f.value), 2) + " %)" : "") + "</p>";
  return html + "</div>";
}

std::string html_events(const RunData& run) {
  std::vector<std::vector<std::string>> rows;
  for (const DriveHappening& event : run.summary.drive_events)
    rows.push_back({count(static_cast<std::int64_t>(rows.size()) + 1), quantity(event.time, "s"), escape(event.what)});
  return rows.empty() ? "" : "<h3>What happened to the drive</h3>\n" + html_table({"No.", "Time", "Event"}, rows);
}

std::string one_run(const RunData& run) {
  std::string tiles;
  std::vector<std::vector<std::string>> rows;
  for (const Headline& f : headlines(run.summary)) {
    if (f.big)
      tiles += html_tile(f);
    else
      rows.push_back({"<span title=\"" + escape(f.about) + "\">" + escape(f.label) + "</span>", escape(text_of(f))});
  }
  return html_verdict(run, false) + "<div class=\"tiles\">" + tiles + "</div>\n" + html_trust(run) + html_events(run) +
         folded("More figures of this run", html_table({"Figure", "Value"}, rows));
}

const Headline* find(const std::vector<Headline>& figures, const std::string& label) {
  const auto found = std::ranges::find(figures, label, &Headline::label);
  return found == figures.end() ? nullptr : &*found;
}

/// The figure of a run, and how far it is from that of the first run.
std::string html_compared(const Headline* figure, const Headline* first) {
  if (!figure) return "–";
  std::string html = escape(text_of(*figure));
  if (!first || first == figure || first->value == 0) return html;
  const bool share = figure->units == "%";  // a change in percent of a percentage would be misread
  const double change = share ? figure->value - first->value : 100 * (figure->value / first->value - 1);
  return html + "<br/><small>" + (change > 0 ? "+" : "") + number(change, 2) + (share ? " points" : " %") + "</small>";
}

std::string comparison(const Runs& runs) {
  std::vector<std::vector<Headline>> all;
  std::vector<std::string> head{"Figure"}, labels;
  for (const RunData& run : runs) {
    all.push_back(headlines(run.summary));
    head.push_back(escape(run.name));
    for (const Headline& f : all.back())
      if (std::ranges::find(labels, f.label) == labels.end()) labels.push_back(f.label);
  }
  std::vector<std::vector<std::string>> rows;
  for (const std::string& label : labels) {
    const Headline* first = find(all.front(), label);
    std::string about;
    std::vector<std::string> row{""};
    for (const auto& figures : all) {
      const Headline* figure = find(figures, label);
      if (figure && about.empty()) about = figure->about;
      row.push_back(html_compared(figure, first));
    }
    row.front() = "<span title=\"" + escape(about) + "\">" + escape(label) + "</span>";
    rows.push_back(std::move(row));
  }
  return html_table(head, rows);
}

}  // namespace

std::string verdict_section(const Runs& runs) {
  if (runs.size() == 1) return section("verdict", "Result", one_run(runs.front()));
  std::string html = "<div class=\"verdicts\">";
  for (const RunData& run : runs) html += html_verdict(run, true);
  html +=
      "</div>\n<p class=\"note\">Each figure with its difference from the first run in percent, of shares in points of "
      "percent. Figures with ± are of "
      "the steady part of a run; compare them with those of other steady runs only.</p>\n" +
      comparison(runs);
  for (const RunData& run : runs)
    html += folded("What can be trusted in " + run.name, html_trust(run) + html_events(run));
  return section("verdict", "Results side by side", html);
}

}  // namespace gyro::report
