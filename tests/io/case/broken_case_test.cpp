// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/case.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

/// Lines `# expect LINE:COLUMN: fragment` (or FILE:LINE:COLUMN:) at the top of a broken case.
std::vector<std::string> expectations(const fs::path& file) {
  const std::string mark = "# expect ";
  std::ifstream stream(file);
  std::vector<std::string> wanted;
  for (std::string line; std::getline(stream, line) && line.starts_with(mark);)
    wanted.push_back(line.substr(mark.size()));
  return wanted;
}

/// FILE:LINE:COLUMN: message, with the name of the file only; without FILE: for the case itself.
std::string short_text(const gyro::CaseProblem& problem, const fs::path& file) {
  const fs::path name = fs::path(problem.file).filename();
  gyro::CaseProblem shortened = problem;
  shortened.file = name.string();
  const std::string text = to_string(shortened);
  return name == file.filename() ? text.substr(shortened.file.size() + 1) : text;
}

std::vector<fs::path> broken_cases() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(GYRO_CASE_TESTS "/broken"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("Every broken case is refused with exactly its problems at their places") {
  const std::vector<fs::path> files = broken_cases();
  REQUIRE(files.size() >= 25);
  for (const fs::path& file : files) {
    INFO(file.filename().string());
    const std::vector<std::string> wanted = expectations(file);
    REQUIRE(!wanted.empty());
    const gyro::CaseReport report = gyro::load_case(file);
    CHECK(!report.loaded);
    CHECK(report.problems.size() == wanted.size());
    for (std::size_t k = 0; k < std::min(wanted.size(), report.problems.size()); ++k) {
      const std::string text = short_text(report.problems[k], file);
      INFO(text);
      CHECK(text.starts_with(wanted[k]));
      CHECK(text.find("; ") != std::string::npos);  // problem; what to do
    }
  }
}

TEST_CASE("Files that cannot be read become problems and do not throw") {
  const gyro::CaseReport missing = gyro::load_case("no/such/case.yaml");
  REQUIRE(missing.problems.size() == 1);
  CHECK(to_string(missing.problems[0]) == "no/such/case.yaml:1:1: there is no such file; give the path of a case file");
  const gyro::CaseReport folder = gyro::load_case(GYRO_CASE_TESTS);
  REQUIRE(folder.problems.size() == 1);
  CHECK(folder.problems[0].message == "is a directory; give the path of a case file");
}

TEST_CASE("A read error in a case or its table is reported and not taken for the end of the file") {
  const gyro::CaseReport itself = gyro::load_case("/proc/self/mem");  // its first read fails with EIO
  REQUIRE(itself.problems.size() == 1);
  CHECK_THAT(itself.problems[0].message, Catch::Matchers::Contains("cannot be read: Input/output error"));
  const gyro::CaseReport table =
      gyro::load_case(GYRO_CASES "/quickstart.yaml", {"crusher.profile=/proc/self/mem", "feed.above=concave"});
  REQUIRE(table.problems.size() == 1);
  CHECK(table.problems[0].file == "/proc/self/mem");
  CHECK_THAT(table.problems[0].message, Catch::Matchers::Contains("cannot be read: Input/output error"));
}
