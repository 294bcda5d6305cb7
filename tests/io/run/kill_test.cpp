// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/random.hpp"
#include "io/run/results.hpp"
#include "io/run/state_file.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/kill_writer.hpp"
#include "tests/io/run/scratch.hpp"

using namespace gyro;

namespace {

constexpr int channels = 24;

ResultsContent content_of_writer() {
  ResultsContent content;
  content.groups = {{"/series", {}}, {"/breakage", {{"position", "m", 3}, {"energy", "J"}}}};
  for (int c = 0; c < channels; ++c) content.groups[0].channels.push_back({"channel_" + std::to_string(c), "1"});
  return content;
}

/// Writes rows, and flushes after every few rows, until it is killed. Writes a byte to the pipe when it has begun.
[[noreturn]] void write_forever(const std::filesystem::path& path, int pipe_end) {
  ResultsFile results(path, content_of_writer());
  for (int row = 0;; ++row) {
    results.append("/series", std::vector<double>(channels, row));
    results.append("/breakage", std::vector<double>(4, row));
    if (row % 7 == 0) results.flush();
    if (row == 70 && ::write(pipe_end, "b", 1) != 1) ::_exit(1);
  }
}

/// Requires that a channel contains 0, 1, 2, ... @return number of its rows
std::size_t count_good_rows(const hdf5::Dataset& dataset) {
  const std::vector<double> values = dataset.read();
  for (std::size_t row = 0; row < values.size(); ++row) REQUIRE(values[row] == static_cast<double>(row));
  return values.size();
}

SavedState state_number(int number) {
  SavedState state;
  for (int c = 0; c < 20; ++c)
    state.put("columns/" + std::to_string(c), std::vector<double>(5000, static_cast<double>(number)));
  return state;
}

[[noreturn]] void write_states_forever(const std::filesystem::path& path, int pipe_end) {
  for (int number = 1;; ++number) {
    write_state(path, state_number(number));
    if (number == 1 && ::write(pipe_end, "b", 1) != 1) ::_exit(1);
  }
}

}  // namespace

TEST_CASE("Results can be read while they are written, and read and repaired after a kill") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  for (int kill = 0; kill < 20; ++kill) {
    CAPTURE(kill);
    const double wait = 60e3 * uniform(1, Stream::place, static_cast<std::uint64_t>(kill), 0);
    kill_writer_after(
        static_cast<useconds_t>(wait), [&](int pipe_end) { write_forever(path, pipe_end); },
        [&] {
          const hdf5::File growing = hdf5::File::open(path);  // another process is writing it
          CHECK(count_good_rows(growing.dataset("/series/channel_0")) >= 70);
        });
    std::size_t rows = 0;
    {
      const hdf5::File file = hdf5::File::open(path);
      rows = count_good_rows(file.dataset("/series/channel_0"));
      CHECK(rows >= 70);
      count_good_rows(file.dataset("/series/channel_23"));
      count_good_rows(file.dataset("/breakage/energy"));
    }
    hdf5::File::modify(path).close();
    CHECK(count_good_rows(hdf5::File::open(path).dataset("/series/channel_0")) == rows);
  }
}

TEST_CASE("A checkpoint is complete at any time, also after its writer was killed") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "checkpoint.h5";
  const auto check_whole = [&] {
    const SavedState found = read_state(path);
    const int number = static_cast<int>(found.get<double>("columns/0").at(0));
    CHECK(number >= 1);
    CHECK(found.columns().size() == 20);
    for (const auto& [name, column] : found.columns())
      CHECK(std::get<std::vector<double>>(column.numbers) == std::vector<double>(5000, number));
  };
  for (int kill = 0; kill < 20; ++kill) {
    CAPTURE(kill);
    const double wait = 30e3 * uniform(2, Stream::place, static_cast<std::uint64_t>(kill), 0);
    kill_writer_after(
        static_cast<useconds_t>(wait), [&](int pipe_end) { write_states_forever(path, pipe_end); }, check_whole);
    check_whole();
  }
}
