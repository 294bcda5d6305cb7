// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::report {
namespace {

/// Terms of the ledger that are drawn as one area.
struct Term {
  const char* label;
  std::array<const char*, 2> columns;
  int style;
};
constexpr std::array<Term, 5> terms{{{"friction", {"friction", ""}, 1},
                                     {"damping of contacts and bonds", {"contact_damping", "bond_damping"}, 4},
                                     {"broken bonds", {"bond_breakage", "switched"}, 3},
                                     {"elastic energy of contacts and bonds", {"contact_elastic", "bond_elastic"}, 2},
                                     {"motion of the rock", {"kinetic", ""}, 5}}};

void add(std::vector<double>& to, const std::vector<double>& values, double sign = 1) {
  for (std::size_t k = 0; k < std::min(to.size(), values.size()); ++k) to[k] += sign * values[k];
}

std::vector<double> sum_of(const Table& ledger, const Term& term) {
  std::vector<double> sum(ledger.rows(), 0);
  for (const char* column : term.columns) add(sum, ledger.values(column));
  return sum;
}

/// What walls and gravity have given to the rock since the start.
std::vector<double> supplied(const Table& ledger) {
  std::vector<double> sum(ledger.rows(), 0);
  add(sum, ledger.values("wall_work"));
  add(sum, ledger.values("exchanged"));
  add(sum, ledger.values("potential"), -1);
  return sum;
}

/// Points of the curves that are drawn: areas that lie on each other must have the same ones.
std::vector<double> thinned(const std::vector<double>& values) {
  constexpr std::size_t most = 700;
  const std::size_t stride = std::max<std::size_t>(1, (values.size() + most - 1) / most);
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); k += stride) kept.push_back(values[k]);
  if (!values.empty() && (values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

std::string stack_plot(const Table& ledger) {
  const std::vector<double> given = supplied(ledger);
  const Unit unit = shown_unit("J", largest(given)), time = shown_unit("s", ledger.time().back());
  LinePlot plot{.title = "Where the energy of walls and gravity went"};
  plot.x = {.label = "time [" + time.name + "]", .low = 0, .high = time.factor * ledger.time().back()};
  plot.y = {.label = "energy since the start [" + unit.name + "]", .zero = true};
  const std::vector<double> x = thinned(scaled(ledger.time(), time.factor));
  std::vector<double> below(x.size(), 0);
  for (const Term& term : terms) {
    std::vector<double> above = below;
    add(above, thinned(scaled(sum_of(ledger, term), unit.factor)));
    plot.areas.push_back({term.label, x, below, above, term.style});
    below = std::move(above);
  }
  plot.curves.push_back(
      {.name = "given by walls and gravity", .x = x, .y = thinned(scaled(given, unit.factor)), .style = 6});
  plot.note =
      "The areas must reach the line: what lies between them is the residual, the error of the time integration.";
  return figure(plot);
}

std::string residual_plot(const Table& ledger) {
  const std::vector<double> residual = ledger.values("energy_residual");
  if (residual.empty()) return "";
  const Unit unit = shown_unit("J", largest(residual)), time = shown_unit("s", ledger.time().back());
  LinePlot plot{.title = "Residual of the energy balance"};
  plot.x = {.label = "time [" + time.name + "]", .low = 0, .high = time.factor * ledger.time().back()};
  plot.y = {.label = "residual [" + unit.name + "]", .zero = true};
  plot.curves.push_back(
      {.name = {}, .x = scaled(ledger.time(), time.factor), .y = scaled(residual, unit.factor), .style = 0});
  plot.note = "Energy that the accounts have too much, or too little where it is negative. At the end of the run " +
              quantity(residual.back(), "J") + " of " + quantity(supplied(ledger).back(), "J") + ".";
  return figure(plot);
}

std::string energy_table(const Table& ledger) {
  const double given = supplied(ledger).back();
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const std::string& name, double value) {
    rows.push_back({name, quantity(value, "J"), given != 0 ? number(100 * value / given) + " %" : "–"});
  };
  row("Given by walls and gravity", given);
  for (const Term& term : terms) row(std::string("… ") + term.label, sum_of(ledger, term).back());
  row("Residual", ledger.values("energy_residual").empty() ? 0 : ledger.values("energy_residual").back());
  return "<div><p>At the end of the run:</p>" + html_table({"Energy", "Amount", "Share"}, rows) + "</div>";
}

std::string ledger_of(const RunData& run) {
  if (!run.ledger || run.ledger->rows() == 0 || largest(supplied(*run.ledger)) == 0) return "";
  return side_by_side(stack_plot(*run.ledger) + residual_plot(*run.ledger) + energy_table(*run.ledger));
}

}  // namespace

std::string energy_section(const Runs& runs) {
  return section("energy", "Energy", by_run(runs, ledger_of));
}

}  // namespace gyro::report
