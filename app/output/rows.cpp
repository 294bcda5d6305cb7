// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/rows.hpp"

#include "app/assembly/assembly.hpp"

namespace gyro {

RowWriter::RowWriter(const Case& input, const OutputForm& form, const std::optional<Resolution>& resolution)
    : input_(input),
      resolution_(resolution),
      series_(series_table(), form),
      ledger_(ledger_table(), form),
      performance_(performance_table(), form),
      fragments_(fragments_table(), form) {
  if (breakage_table().presence.holds(form)) breakage_.emplace(breakage_table(), form);
  if (!product_table().presence.holds(form)) return;
  product_.emplace(product_table(), form, sieves_of(input).size());
  holdup_.emplace(holdup_table(), form, sieves_of(input).size());
}

void RowWriter::declare(ResultsContent& content) const {
  content.groups.insert(content.groups.end(), {series_.declaration(), ledger_.declaration(), performance_.declaration(),
                                               fragments_.declaration()});
  if (breakage_) content.groups.push_back(breakage_->declaration());
  if (!product_) return;
  for (const auto& [curves, sieves] :
       {std::pair(&*product_, &product_sieves()), std::pair(&*holdup_, &holdup_sieves())}) {
    content.groups.push_back(curves->declaration());
    for (const CurveAttribute& attribute : curve_attributes())
      if (resolution_) content.groups.back().attributes.push_back({attribute.name, (*resolution_).*attribute.value});
    for (FixedNumbers& fixed : fixed_numbers(*sieves, {}, Sieves{sieves_of(input_)}, curves->declaration().name))
      content.fixed.push_back(std::move(fixed));
  }
}

void RowWriter::add(ResultsFile& file, const WindowResult& result, const Simulation& simulation) {
  const WindowReading window = read_window(result, simulation);
  series_.add(window);
  ledger_.add(window);
  write(file, result.left);
  if (!breakage_) return;
  for (const Breakage& breakage : result.breakages) breakage_->append(file, breakage);
}

void RowWriter::write(ResultsFile& file, const std::vector<FragmentRecord>& fragments) {
  for (const FragmentRecord& fragment : fragments) fragments_.append(file, fragment);
}

CurveReading RowWriter::reading_of(const ProductRow& curve, const std::optional<FinesRow>& fines) const {
  return {curve, input_.crusher->closed_side_setting, open_side_setting(*input_.crusher), fines};
}

void RowWriter::write(ResultsFile& file, const Simulation& simulation, double wall_seconds) {
  SeriesReading now = read_series(simulation, input_.output.probes);
  now.interval = series_.length();
  now.discharged_before = discharged_before_;
  now.wall_seconds = wall_seconds;
  series_.append(file, now);
  ledger_.append(file, read_ledger(simulation));
  performance_.append(file, {now.time, wall_seconds, now.counts});
  if (product_) {
    const std::optional<Fines>& fines = simulation.fines();
    const auto if_asked = [&](auto part) { return fines ? std::optional(((*fines).*part)()) : std::nullopt; };
    product_->append(file, reading_of(simulation.product()->row(now.time), if_asked(&Fines::product)));
    holdup_->append(file, reading_of(simulation.hold_up()->row(now.time), if_asked(&Fines::hold_up)));
  }
  discharged_before_ = now.discharged_mass;
}

void RowWriter::save(SavedState& to) const {
  to.put_one("output/series", series_.state());
  to.put_one("output/ledger", ledger_.state());
  to.put_one("output/discharged_before", discharged_before_);
}

void RowWriter::restore(const SavedState& from) {
  series_.restore(from.get_one<decltype(series_)::State>("output/series"));
  ledger_.restore(from.get_one<decltype(ledger_)::State>("output/ledger"));
  discharged_before_ = from.get_one<double>("output/discharged_before");
}

}  // namespace gyro
