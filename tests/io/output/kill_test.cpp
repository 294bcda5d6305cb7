// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/random.hpp"
#include "io/results.hpp"
#include "tests/catch.hpp"
#include "tests/io/output/scratch.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

using namespace gyro;

namespace {

constexpr int channels = 24;

ResultsContent content_of_writer() {
  ResultsContent content;
  for (int c = 0; c < channels; ++c) content.series.push_back({"channel_" + std::to_string(c), "1"});
  content.breakage = true;
  return content;
}

/// Writes rows and flushes every few until it is killed. Tells through the pipe when it has begun.
[[noreturn]] void write_forever(const std::filesystem::path& path, int pipe_end) {
  ResultsFile results(path, content_of_writer());
  for (int row = 0;; ++row) {
    results.append_series(std::vector<double>(channels, row));
    const double t = row;
    results.append_breakages(std::vector<Breakage>{{t, BreakMode::shear, {t, t, t}, 1, 2, 3, t}});
    if (row % 7 == 0) results.flush();
    if (row == 70 && ::write(pipe_end, "b", 1) != 1) ::_exit(1);
  }
}

/// Every channel must hold 0, 1, 2, ... whatever its length.
std::size_t count_good_rows(const hdf5::Dataset& dataset) {
  const std::vector<double> values = dataset.read();
  for (std::size_t row = 0; row < values.size(); ++row) REQUIRE(values[row] == static_cast<double>(row));
  return values.size();
}

void kill_writer_after(const std::filesystem::path& path, useconds_t microseconds) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) write_forever(path, ends[1]);
  char begun = 0;
  REQUIRE(::read(ends[0], &begun, 1) == 1);
  ::usleep(microseconds);
  {
    const hdf5::File growing = hdf5::File::open(path);  // another process writes it at this moment
    CHECK(count_good_rows(growing.dataset("/series/channel_0")) >= 70);
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ends[0]);
  ::close(ends[1]);
  REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("Results can be read while they are written, and read and repaired after a kill") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  for (int kill = 0; kill < 20; ++kill) {
    CAPTURE(kill);
    const double wait = 60e3 * uniform(1, Stream::place, static_cast<std::uint64_t>(kill), 0);
    kill_writer_after(path, static_cast<useconds_t>(wait));
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
