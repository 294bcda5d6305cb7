// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gyro {

/// Description of one dataset, field or attribute that a run writes.
struct OutputEntry {
  std::string name;
  std::string units;        ///< "1" for a pure number; empty if there is none
  std::string width;        ///< numbers in a row: "1", "3", or what each number belongs to, such as "sieve"
  std::string sampling;     ///< see Sampling, or "attribute"; empty if the entry has no time
  std::string when;         ///< "always", "with bonds"
  std::string description;  ///< one line
};

/// A group of results.h5, or another file of a run's directory.
struct OutputGroup {
  std::string name;     ///< "/series", "summary.json"
  std::string content;  ///< what its rows or members are
  std::vector<OutputEntry> entries;
};

/// Everything that a run can write, from the tables that write it.
std::vector<OutputGroup> output_reference();

/// The reference for the terminal, as JSON, and as the page cases/OUTPUTS.md.
std::string outputs_text();
std::string outputs_json();
std::string outputs_page();

}  // namespace gyro
