// SPDX-License-Identifier: GPL-3.0-or-later
// results.h5 of a run that goes on: the rows to keep, and files that are damaged.
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/results_content.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <limits>

using namespace gyro;

TEST_CASE("Results that go on behind the rows kept read as if never interrupted") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5", whole = scratch.path() / "whole.h5";
  const int keep = GENERATE(0, 1, 700, 2499, 2500);
  write_run(whole, 2500);
  write_run(path, 2500);  // has gone on past its checkpoint
  const ResultsMarks marks = marks_after(keep);
  {
    ResultsFile results(path, full_content(), marks);
    CHECK(results.marks() == marks);
    append_rows(results, keep, 2500);
    CHECK(results.marks() == marks_after(2500));
    results.close();
  }
  const hdf5::File a = hdf5::File::open(whole), b = hdf5::File::open(path);
  for (const char* name : {"/series/time", "/series/mantle_force", "/series/particles", "/ledger/kinetic"})
    CHECK(a.dataset(name).read() == b.dataset(name).read());
  CHECK(b.string_attribute("/case", "resolved_yaml") == full_content().record.resolved_yaml);
  CHECK(b.dataset("/product/sizes").rows() == 3);
}

TEST_CASE("Results that lack rows or tables of the checkpoint are refused and stay as they were") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  ResultsMarks rows = marks_after(10);
  CHECK_THROWS_AS(ResultsFile(path, full_content(), rows), BadInput);
  write_run(path, 9);
  const std::string before = bytes(path);
  CHECK_THROWS_WITH(ResultsFile(path, full_content(), rows),
                    Catch::Matchers::Contains("has 9 rows of /series/time, not 10"));
  ResultsContent other = full_content();
  other.groups[1].channels.push_back({"friction", "J"});
  rows = marks_after(9);
  CHECK_THROWS_WITH(ResultsFile(path, other, rows), Catch::Matchers::Contains("has no /ledger/friction"));
  ResultsMarks without_digest = rows;
  without_digest.at("/series").digests.erase("time");
  CHECK_THROWS_WITH(ResultsFile(path, full_content(), without_digest),
                    Catch::Matchers::Contains("has /series/time, of which the checkpoint has no digest"));
  other = full_content();
  other.groups[3].channels.pop_back();
  CHECK_THROWS_WITH(ResultsFile(path, other, rows),
                    Catch::Matchers::Contains("has /product/passing, which this run does not write"));
  CHECK(bytes(path) == before);
}

namespace {

/// Rows of all groups; some numbers are not finite or do not fit the type of the file.
void append_odd_rows(ResultsFile& results) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  results.append("/series", std::vector{0.123, 1.25, nan, -infinity, 7e9});
  results.append("/ledger", std::vector{0.123, -nan});
  results.append("/breakage", std::vector{0.456, 2.0, 4e9});
  results.append("/breakage", std::vector{0.789, 300.0, -1.0});
  results.append("/product", std::vector{1.0, 0.1, 0.4375, 1.0});
  std::vector<double> map(5001, 0.1);
  map[17] = 1234567.5;
  map[18] = 1e300;
  map[19] = nan;
  for (int row = 0; row < 300; ++row) results.append("/liners/mantle", map);  // more than is read at once
  results.append("/liners/mantle/triangles", std::vector{0.321});
}

template <class T>
std::string bytes_of(T number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

}  // namespace

TEST_CASE("One changed bit of a number is found when a run goes on, and the dataset is named") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  ResultsMarks marks;
  {
    ResultsFile results(path, full_content());
    append_odd_rows(results);
    marks = results.marks();
    append_rows(results, 1000, 1100);  // not in the checkpoint
    results.close();
  }
  const std::string whole = bytes(path);
  const struct {
    std::string number;
    const char* dataset;
  } places[] = {{bytes_of(1.25), "/series/mantle_force"},
                {bytes_of(0.4375), "/product/passing"},
                {bytes_of(4000000000u), "/breakage/i"},
                {bytes_of(1234567.5f), "/liners/mantle/pressure"},
                {bytes_of(0.321), "/liners/mantle/triangles/time"}};
  for (const auto& [number, dataset] : places) {
    INFO(dataset);
    std::string changed = whole;
    const std::size_t at = whole.rfind(number);
    REQUIRE(at != std::string::npos);
    changed[at] = static_cast<char>(changed[at] ^ 1);
    std::ofstream(path, std::ios::binary) << changed;
    CHECK_THROWS_WITH(ResultsFile(path, full_content(), marks),
                      Catch::Matchers::Contains("results.h5: is damaged: the numbers of " + std::string(dataset) +
                                                " are not those that the run wrote; restore the file"));
    CHECK(bytes(path) == changed);
  }
  std::string behind = whole;  // a row that is dropped may be anything
  behind[whole.rfind(bytes_of(0.001 * 1050))] ^= 1;
  std::ofstream(path, std::ios::binary) << behind;
  ResultsFile(path, full_content(), marks).close();
  std::ofstream(path, std::ios::binary) << whole;
  ResultsFile results(path, full_content(), marks);
  CHECK(results.marks() == marks);
}

TEST_CASE("A file whose writer was killed just after it was opened goes on") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  write_run(path, 9);
  const pid_t child = ::fork();
  if (child == 0) {
    const hdf5::File opened = hdf5::File::modify(path);  // has the mark "open for writing"
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  ResultsFile(path, full_content(), marks_after(5)).close();
  CHECK(hdf5::File::open(path).dataset("/series/time").rows() == 5);
}

namespace {

/// Resumes a file in a process of its own. @returns its exit code: 0, 2 for BadInput, 5 for OutputError; -1 after a
/// crash, or when it takes more than 20 s
int resume_in_child(const std::filesystem::path& path, int rows) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGALRM}) std::signal(signal, SIG_DFL);
    ::alarm(20);
    try {
      ResultsFile results(path, full_content(), marks_after(rows));
      append_rows(results, rows, rows + 50);
      results.close();
      ::_exit(0);
    } catch (const BadInput&) {
      ::_exit(2);
    } catch (const OutputError&) {
      ::_exit(5);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("A results file with a changed bit goes on or is refused, and neither hangs nor crashes") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  write_run(path, 200);
  const std::string whole = bytes(path);
  int refused = 0;
  for (std::uint64_t k = 0; k < 150; ++k) {
    std::string changed = whole;
    // The first half of them in the head of the file, where the library keeps its tables.
    const auto at =
        static_cast<std::size_t>(uniform(1, Stream::place, k, 0) * static_cast<double>(k < 75 ? 4096 : whole.size()));
    changed[at] = static_cast<char>(changed[at] ^ (1 << (k % 8)));
    std::ofstream(path, std::ios::binary) << changed;
    CAPTURE(at, k % 8);
    const int code = resume_in_child(path, 150);
    CHECK((code == 0 || code == 2 || code == 5));
    refused += code != 0;
  }
  CHECK(refused > 20);
}

TEST_CASE("A results file that was cut off is refused, and nothing hangs") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  write_run(path, 5000);
  const std::string whole = bytes(path);
  for (int part = 1; part < 40; ++part) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 40);
    CAPTURE(part);
    CHECK(resume_in_child(path, 4000) == 2);
  }
}
