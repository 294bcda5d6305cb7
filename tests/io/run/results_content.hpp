// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/results.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>
#include <iterator>

// A results file with groups of all kinds, for tests.
namespace gyro {

inline ResultsContent full_content() {
  ResultsContent content;
  content.record = {"Test é",
                    "case: {seed: 7}\n" + std::string(100000, '#'),
                    "0.1.0",
                    "abc123",
                    "cpu",
                    "mixed",
                    (std::uint64_t{1} << 63) + 5};
  const Channel time{"time", "s"};
  content.groups = {
      {"/series", {time, {"mantle_force", "N", 3}, {"particles", "1", 1, hdf5::Number::int64}}},
      {"/ledger", {time, {"kinetic", "J"}}},
      {"/breakage", {time, {"mode", "1", 1, hdf5::Number::uint8}, {"i", "1", 1, hdf5::Number::uint32}}},
      {"/product", {time, {"passing", "1", 3}}},
      {"/liners/mantle", {time, {"pressure", "Pa", 5000, hdf5::Number::float32, Sampling::mean, "mean pressure"}}},
      {"/liners/mantle/triangles", {time}}};
  content.fixed = {{"/product/sizes", {"sizes", "m", 1, hdf5::Number::float64, {}, "of sieves"}, {0.01, 0.02, 0.04}}};
  return content;
}

inline void append_rows(ResultsFile& results, int from, int to) {
  for (int row = from; row < to; ++row) {
    const double t = 0.001 * row;
    results.append("/series", std::vector{t, 0.1 + row, 0.2 + row, 0.3 + row, 1e9 + row});
    results.append("/ledger", std::vector{t, 2 * t});
  }
}

inline void write_run(const std::filesystem::path& path, int rows) {
  ResultsFile results(path, full_content());
  append_rows(results, 0, rows);
  results.close();
}

/// What a checkpoint keeps of such a run after some rows.
inline ResultsMarks marks_after(int rows) {
  const ScratchDirectory scratch;
  ResultsFile results(scratch.path() / "results.h5", full_content());
  append_rows(results, 0, rows);
  return results.marks();
}

inline std::string bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace gyro
