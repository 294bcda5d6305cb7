// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

/// What is known of one curve, for the table beside the plot.
struct Row {
  std::string name;
  std::optional<SizeCurve> curve;
};

struct Content {
  LinePlot plot;
  std::vector<Row> rows;
  double low = INFINITY, high = 0;  ///< sizes where the curves rise from 0 to 1 [m]
};

void add_limits(const SizeCurve& c, Content& content) {
  for (std::size_t k = 0; k < c.sizes.size(); ++k) {
    if (c.passing[k] > 0) content.low = std::min(content.low, c.sizes[k > 0 ? k - 1 : 0]);
    if (c.passing[k] < 1 - 1e-9) content.high = std::max(content.high, c.sizes[std::min(k + 1, c.sizes.size() - 1)]);
  }
}

Curve part_of(const SizeCurve& c, int style, Curve::Line line, double from, double to) {
  Curve curve{.name = "", .x = {}, .y = {}, .style = style, .line = line};
  for (std::size_t k = 0; k < c.sizes.size(); ++k) {
    if (c.sizes[k] < from || c.sizes[k] > to) continue;
    curve.x.push_back(1e3 * c.sizes[k]);
    curve.y.push_back(100 * c.passing[k]);
  }
  return curve;
}

/// The curve with its value at one more size.
SizeCurve with_size(SizeCurve c, double size) {
  const auto next = std::ranges::upper_bound(c.sizes, size);
  if (next == c.sizes.begin() || next == c.sizes.end()) return c;
  const auto k = next - c.sizes.begin();
  const auto at = static_cast<std::size_t>(k);
  const double part = std::log(size / c.sizes[at - 1]) / std::log(c.sizes[at] / c.sizes[at - 1]);
  const double passing = c.passing[at - 1] + part * (c.passing[at] - c.passing[at - 1]);
  c.sizes.insert(c.sizes.begin() + k, size);
  c.passing.insert(c.passing.begin() + k, passing);
  return c;
}

/// Adds a curve; below the resolution it is drawn as an estimate, because it is incomplete there.
void add_curve(const std::string& name, const std::optional<SizeCurve>& curve, std::optional<double> resolution,
               int style, Content& content) {
  if (!curve) return;
  content.rows.push_back({name, curve});
  add_limits(*curve, content);
  const double limit = resolution.value_or(0);
  const SizeCurve whole = limit > 0 ? with_size(*curve, limit) : *curve;
  Curve known = part_of(whole, style, Curve::Line::plain, limit, INFINITY);
  known.name = name;
  content.plot.curves.push_back(std::move(known));
  if (limit > 0) content.plot.curves.push_back(part_of(whole, style, Curve::Line::dashed, 0, limit));
  if (const auto p80 = passing_size(*curve, 0.8)) content.plot.spots.push_back({1e3 * *p80, 80, style});
}

void add_fines(const std::string& name, const std::optional<SizeCurve>& curve, int style, Content& content) {
  if (!curve) return;
  content.rows.push_back({name, curve});
  Curve estimate = part_of(*curve, style, Curve::Line::dashed, 0, INFINITY);
  estimate.name = name;
  content.plot.curves.push_back(std::move(estimate));
}

std::string product_name(const RunData& run) {
  return run.summary.steady ? "Product since " + quantity(run.begin(), "s") : "Product of the whole run";
}

void add_run(const RunData& run, Content& content) {
  add_curve("Feed, as the case states it", feed_curve(run.facts), std::nullopt, 2, content);
  if (run.holdup)
    add_curve("Rock in the chamber at the end", size_curve(*run.holdup, 0), run.holdup->resolution, 1, content);
  if (!run.product) return;
  add_curve(product_name(run), size_curve(*run.product, run.begin()), run.product->resolution, 0, content);
  add_fines("Product with estimated fines", size_curve(*run.product, run.begin(), "passing_with_fines"), 3, content);
}

void add_runs(const Runs& runs, Content& content) {
  int style = 0;
  for (const RunData& run : runs) {
    if (run.product)
      add_curve(run.name, size_curve(*run.product, run.begin()), run.product->resolution, style % 7, content);
    ++style;
  }
  add_curve("Feed of " + runs.front().name, feed_curve(runs.front().facts), std::nullopt, 6, content);
}

void add_resolution(const Sieved& product, const std::string& finer, Content& content) {
  if (!product.resolution || !product.finest) return;
  content.low = std::min(content.low, *product.finest);
  content.plot.spans.push_back({1e-6, 1e3 * *product.finest, "Finer than all particles: " + finer, "unknown"});
  if (*product.resolution > 1.001 * *product.finest)
    content.plot.spans.push_back({1e3 * *product.finest, 1e3 * *product.resolution,
                                  "Sizes of particles, " + number(1e3 * *product.finest) + " to " +
                                      number(1e3 * *product.resolution) + " mm: incomplete",
                                  "coarse"});
}

void add_settings(const CaseFacts& facts, Content& content) {
  const auto add = [&](const char* name, const std::optional<double>& setting) {
    if (setting) content.plot.marks.push_back({1e3 * *setting, name + quantity(*setting, "m")});
  };
  add("closed side ", facts.closed_setting);
  add("open side ", facts.open_setting);
}

/// Settings and resolution where they are the same for all runs; else a note says that they differ.
void add_machine(const Runs& runs, Content& content) {
  const RunData* first = nullptr;
  bool same_settings = true, same_particles = true;
  for (const RunData& run : runs) {
    if (!run.product) continue;
    if (!first) first = &run;
    same_settings = same_settings && run.facts.closed_setting == first->facts.closed_setting &&
                    run.facts.open_setting == first->facts.open_setting;
    // Seeds change the sizes of particles by some percent.
    constexpr double alike = 0.1;
    const auto differs = [&](std::optional<double> a, std::optional<double> b) {
      return a.has_value() != b.has_value() || (a && std::abs(*a - *b) > alike * *b);
    };
    same_particles = same_particles && !differs(run.product->resolution, first->product->resolution);
  }
  if (same_settings) add_settings(first->facts, content);
  if (same_particles) add_resolution(*first->product, first->summary.fines ? "estimated" : "unknown", content);
  if (!same_settings) content.plot.note += "The runs differ in their side settings, which are not drawn. ";
  if (!same_particles) content.plot.note += "The runs differ in the sizes of their particles, which are not drawn. ";
}

std::string size_table(const Content& content) {
  std::vector<std::vector<std::string>> rows;
  const auto size = [](const SizeCurve& c, double share) {
    const auto found = passing_size(c, share);
    return found ? quantity(*found, "m") : std::string("–");
  };
  for (const Row& row : content.rows)
    rows.push_back({escape(row.name), row.curve->mass > 0 ? quantity(row.curve->mass, "kg") : "–",
                    size(*row.curve, 0.8), size(*row.curve, 0.5), size(*row.curve, 0.2)});
  return html_table({"Curve", "Mass", "P80", "P50", "P20"}, rows);
}

/// F80 / P80, of one run.
std::string reduction(const RunData& run) {
  const auto feed = feed_curve(run.facts);
  const auto product = run.product ? size_curve(*run.product, run.begin()) : std::nullopt;
  const auto f80 = feed ? passing_size(*feed, 0.8) : std::nullopt;
  const auto p80 = product ? passing_size(*product, 0.8) : std::nullopt;
  if (!f80 || !p80) return "";
  return "<p>Reduction ratio F80 / P80: <b>" + number(*f80 / *p80) + "</b>.</p>\n";
}

}  // namespace

std::string size_section(const Runs& runs) {
  Content content;
  content.plot.title =
      runs.size() == 1 ? "Size curves of feed, rock in the chamber and product" : "Size curves of the products";
  content.plot.x = {.label = "size [mm]", .log = true};
  content.plot.y = {.label = "cumulative passing [% of the mass]", .low = 0, .high = 100};
  if (runs.size() == 1)
    add_run(runs.front(), content);
  else
    add_runs(runs, content);
  const bool sieved = std::ranges::any_of(runs, [](const RunData& run) { return run.product.has_value(); });
  if (!sieved || content.rows.empty() || !(content.high > 0)) return "";
  add_machine(runs, content);
  for (const Mark& mark : content.plot.marks) content.high = std::max(content.high, mark.x / 1e3);
  content.plot.x.low = 1e3 * content.low / 1.3;
  content.plot.x.high = 1e3 * content.high * 1.15;
  content.plot.note +=
      "Dots mark P80, the size that 80 % of the mass passes. Rock is sieved through square openings; the "
      "feed is stated by the diameter of spheres of equal volume. Particles are the smallest pieces of "
      "the model: where a curve is dashed, it is incomplete or an estimate.";
  return section("sizes", "Sizes",
                 side_by_side(figure(content.plot) + "<div>" + size_table(content) +
                              (runs.size() == 1 ? reduction(runs.front()) : "") + "</div>"));
}

}  // namespace gyro::report
