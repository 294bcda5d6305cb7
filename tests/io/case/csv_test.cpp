// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"
#include "io/case/case.hpp"
#include "tests/catch.hpp"
#include "tests/io/mesh/written.hpp"

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

CsvTable table_of(const std::string& text) {
  const ScratchDirectory folder;
  return read_csv(written(folder, "t.csv", text), {"size_mm", "passing_percent"});
}

using Rows = std::vector<std::vector<double>>;
const Rows two{{10, 0}, {20.5, 100}};

/// Problems of the case `cases/quickstart.yaml` with another table for one of its keys.
std::vector<CaseProblem> problems_with(const std::string& key, const std::string& text,
                                       const std::vector<std::string>& more = {}) {
  const ScratchDirectory folder;
  std::vector<std::string> overrides = more;
  overrides.push_back(key + "=" + written(folder, "t.csv", text));
  return load_case(GYRO_CASES "/quickstart.yaml", overrides).problems;
}

std::vector<CaseProblem> problems_of_sieves(const std::string& rows) {
  return problems_with("rocks.sizes.sieves", "size_mm,passing_percent\n" + rows, {"rocks.sizes.passing=null"});
}

std::vector<CaseProblem> problems_of_motor(const std::string& rows) {
  return problems_with("drivetrain.motor.file", "speed_rpm,torque_Nm\n" + rows, {"drivetrain.motor={model: curve}"});
}

}  // namespace

TEST_CASE("Tables are read in the forms in which spreadsheets write them", "[csv]") {
  const auto text = GENERATE(values<std::string>({
      "size_mm,passing_percent\n10,0\n20.5,100\n",
      "\xEF\xBB\xBFsize_mm,passing_percent\r\n10,0\r\n20.5,100",
      "size_mm,passing_percent\r10,0\r20.5,100\r",
      "size_mm;passing_percent\n10;0\n20,5;100\n",
      "size_mm;passing_percent\n10;0\n20.5;100\n",
      "sep=;\nsize_mm;passing_percent;\n10,0;0;;\n20,5;100,0;;\n;;;\n",
      "size_mm\tpassing_percent\n10\t0\n20,5\t100\n",
      "\"size_mm\",\"passing_percent\"\n\"10\",\"0\"\n\"20,5\",\"100\"\n",
      "# of the laboratory; May\n\nsize_mm , passing_percent\n,,\n +10 , 0e0\n\n 20.5,\" 100 \"\n\n",
  }));
  INFO(text);
  const CsvTable table = table_of(text);
  REQUIRE(table.problems.empty());
  CHECK(table.rows == two);
}

TEST_CASE("A cause that many rows share is reported once, with what to do", "[csv]") {
  const auto [text, reason] = GENERATE(table<std::string, std::string>({
      {"size_mm,passing_percent\n10,5,0\n20,5,100\n30,5,100\n", "export as CSV with semicolons"},
      {"size_mm,passing_percent\n10 mm,0\n20 mm,100\n30 mm,100\n", "(2 more rows like this)"},
      {"size_mm;passing_percent\n1.000;0\n2,5;100\n1.500;7\n", "a different decimal sign"},
      {"size_mm;passing_percent\n1.000,5;0\n2.000,5;100\n", "without thousands separators"},
      {"size_mm,passing_percent\n10\n20\n", "(1 more row like this)"},
      {"size;passing_percent\n10;1\n", "it must be size_mm,passing_percent"},
      {std::string("\xFF\xFEs\0i\0z\0e\0", 10), "is not a text in UTF-8"},
      {"", "the table is empty"},
  }));
  INFO(text);
  const CsvTable table = table_of(text);
  REQUIRE(table.problems.size() == 1);
  CHECK_THAT(table.problems[0].message, Contains(reason));
}

TEST_CASE("A comma that may be a thousands separator is refused", "[csv]") {
  const auto [text, line, column, more] = GENERATE(table<std::string, int, int, std::string>({
      {"size_mm,passing_percent\n10,0\n\"1,500\",100\n", 3, 1, ""},
      {"size_mm;passing_percent\n10;0\n1,500;100\n", 3, 1, ""},
      {"size_mm\tpassing_percent\n10\t0\n500\t-12,500\n", 3, 5, ""},
      {"size_mm;passing_percent\n10;0\n1,500;50\n+2,500;100\n", 3, 1, "(1 more row like this)"},
  }));
  INFO(text);
  const CsvTable table = table_of(text);
  REQUIRE(table.problems.size() == 1);
  CHECK(table.problems[0].line == line);
  CHECK(table.problems[0].column == column);
  CHECK_THAT(table.problems[0].message, Contains("write thousands without a separator") && Contains(more));
}

TEST_CASE("One unambiguous cell shows that the commas of a file are decimal", "[csv]") {
  const std::string shown = GENERATE("2,5", "0,125", "3,1250", "1500,125", "1,5e1");
  INFO(shown);
  const CsvTable table = table_of("size_mm;passing_percent\n1,500;0\n" + shown + ";100\n");
  REQUIRE(table.problems.empty());
  CHECK(table.rows[0][0] == 1.5);
}

TEST_CASE("Sieves may be listed in increasing or decreasing order", "[csv]") {
  const std::string sieves = GENERATE("30,0\n45,70\n60,100\n", "60,100\n45,70\n30,0\n");
  const ScratchDirectory folder;
  const CaseReport report =
      load_case(GYRO_CASES "/quickstart.yaml",
                {"rocks.sizes.passing=null",
                 "rocks.sizes.sieves=" + written(folder, "t.csv", "size_mm,passing_percent\n" + sieves)});
  REQUIRE(report.loaded);
  const auto& points = std::get<PassingTable>(report.loaded->rocks->sizes).points;
  REQUIRE(points.size() == 3);
  CHECK(points[0].size == Approx(0.030));
  CHECK(points[1].fraction == Approx(0.7));
}

TEST_CASE("A sieve curve that does not begin at 0 percent is refused with the row to add", "[csv]") {
  const std::vector<CaseProblem> falling = problems_of_sieves("60,100\n45,70\n30,5\n");
  REQUIRE(falling.size() == 1);
  CHECK(falling[0].line == 4);
  CHECK_THAT(falling[0].message, Contains("add a row with the smallest size to simulate and 0 percent"));
}

TEST_CASE("The table of a motor may continue above its synchronous speed", "[csv]") {
  CHECK(problems_of_motor("0,6\n1500,7.4\n1697,0\n").empty());
  CHECK(problems_of_motor("0,6\n1500,7.4\n1697,0\n1800,-5\n2000,-9\n").empty());
  CHECK(problems_of_motor("0,6\n1500,7.4\n1800,-5\n2000,-5\n").empty());
  const auto [rows, line, reason] = GENERATE(table<std::string, int, std::string>({
      {"0,6\n500,-6\n1000,6.2\n1697,0\n", 3, "does not drive here"},
      {"0,6\n500,0\n1000,6.2\n1697,0\n", 3, "does not drive here"},
      {"0,0\n500,6\n1697,0\n", 2, "does not drive here"},
      {"0,6\n1697,0\n1800,0\n", 4, "not negative"},
      {"0,6\n1697,0\n1800,-5\n2000,-3\n", 5, "rises at the last speed"},
  }));
  INFO(rows);
  const std::vector<CaseProblem> problems = problems_of_motor(rows);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].line == line);
  CHECK_THAT(problems[0].message, Contains(reason));
}

TEST_CASE("The wear coefficient is read in 1/Pa and related units", "[csv]") {
  const auto coefficient = [](const std::string& value) {
    const CaseReport report =
        load_case(GYRO_CASES "/quickstart.yaml", {"output.liners={interval: 10 ms, wear_coefficient: " + value + "}"});
    return report.loaded ? *report.loaded->output.liners->wear_coefficient : -1;
  };
  CHECK(coefficient("2e-13") == 2e-13);
  CHECK(coefficient("2e-13 1/Pa") == 2e-13);
  CHECK(coefficient("2e-4 1/GPa") == Approx(2e-13));
  CHECK(coefficient("2e-4 mm3/(N m)") == Approx(2e-13));
  CHECK(coefficient("2e-13 Pa") == -1);
}
