// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"
#include "io/case/case.hpp"
#include "tests/catch.hpp"
#include "tests/io/mesh/written.hpp"

#include <chrono>

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
      {std::string("size_mm\0", 8), "not a text in UTF-8"},
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

TEST_CASE("A table in UTF-16 or with other signs between thousands is refused with its cause", "[csv]") {
  const auto [text, reason] = GENERATE(table<std::string, std::string>({
      {std::string("\xFF\xFEs\0i\0z\0e\0", 10), "is a text in UTF-16; save it as UTF-8"},
      {std::string("\xFE\xFF\0s\0i\0z\0e", 10), "is a text in UTF-16"},
      {std::string("s\0i\0z\0e\0_\0", 10), "is a text in UTF-16"},
      {"size_mm;passing_percent\n1.234.567;0\n", "without thousands separators"},
      {"size_mm;passing_percent\n1'234;0\n", "without thousands separators"},
      {"size_mm;passing_percent\n1\xC2\xA0"
       "234;0\n",
       "without thousands separators"},
  }));
  INFO(text);
  const CsvTable table = table_of(text);
  REQUIRE(table.problems.size() == 1);
  CHECK_THAT(table.problems[0].message, Contains(reason));
}

TEST_CASE("A point that may stand between thousands is refused where whole numbers stand beside it", "[csv]") {
  const CsvTable german = table_of("size_mm;passing_percent\n500;0\n1.500;50\n2.000;100\n");
  REQUIRE(german.problems.size() == 1);
  CHECK(german.problems[0].line == 3);
  CHECK_THAT(german.problems[0].message, Contains("write thousands without a separator") && Contains("(1 more row"));
  for (const char* decimal : {
           "size_mm,passing_percent\n1.125,0\n500,100\n",      // points are decimal between commas
           "size_mm;passing_percent\n1.125;0\n500.000;100\n",  // three decimals everywhere
           "size_mm;passing_percent\n1.125;0\n500;50\n500.5;100\n",
           "size_mm;passing_percent\n1.125;0\n0.500;50\n500;100\n",
       }) {
    INFO(decimal);
    CHECK(table_of(decimal).problems.empty());
    CHECK(table_of(decimal).rows[0][0] == 1.125);
  }
}

TEST_CASE("What a problem quotes of a table is printable", "[csv]") {
  const std::vector<CaseProblem> problems =
      problems_of_sieves(std::string(200, '1') + ",0\n" + std::string("\x1b[31m\xE4\0,0\n", 10));
  REQUIRE(!problems.empty());
  CHECK_THAT(problems[0].message, Contains("\\x1B[31m\\xE4\\x00"));
}

TEST_CASE("A motor's table outside what motors have is refused", "[csv]") {
  const auto [rows, line, reason] = GENERATE(table<std::string, int, std::string>({
      {"0,1e300\n1500,7.4\n1697,0\n", 2, "the torque is more than 1e9 N m"},
      {"-100,6\n0,6\n1697,0\n", 2, "the first speed is negative; begin at 0 rpm"},
      {"0,6\n1e300,0\n", 3, "the speed is more than 100,000 rpm"},
  }));
  INFO(rows);
  const std::vector<CaseProblem> problems = problems_of_motor(rows);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].line == line);
  CHECK_THAT(problems[0].message, Contains(reason));
}

TEST_CASE("A voltage in percent or volts is refused", "[csv]") {
  const std::string rows = GENERATE("0,100\n1,80\n", "0,690\n1,690\n");
  const std::vector<CaseProblem> problems =
      problems_with("drivetrain.motor.voltage_file", "time_s,voltage_ratio\n" + rows);
  REQUIRE(problems.size() == 1);
  CHECK_THAT(problems[0].message, Contains("divide percent by 100") && Contains("(1 more row like this)"));
}

TEST_CASE("A profile in millimetres is refused once, with what to do", "[csv]") {
  const std::string header = "z_m,mantle_radius_m,concave_radius_m\n";
  const auto problems_of = [&](const std::string& rows) { return problems_with("crusher.profile", header + rows); };
  std::vector<CaseProblem> problems = problems_of("0,119,137\n200,60,160\n400,44,240\n");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].line == 2);
  CHECK_THAT(problems[0].message, Contains("the profile is in metres: divide numbers in mm by 1000 (2 more rows"));
  problems = problems_of("0,1e-30,0.1\n0.4,0.04,0.24\n");
  REQUIRE(problems.size() == 1);
  CHECK_THAT(problems[0].message, Contains("less than 0.01 mm"));
  std::string many;
  for (int k = 0; k <= 20000; ++k) many += std::to_string(k * 2e-5) + ",0.1,0.2\n";
  problems = problems_of(many);
  REQUIRE(problems.size() == 1);
  CHECK_THAT(problems[0].message, Contains("20001 rows, more than 5000; keep one row in 5"));
}

TEST_CASE("Particles of impossible size, place or speed are refused", "[csv]") {
  const auto problems_of = [](const std::string& rows) {
    const ScratchDirectory folder;
    return load_case(GYRO_CASES "/box.yaml",
                     {"particles.file=" + written(folder, "p.csv", "id,x,y,z,r,vx,vy,vz\n" + rows)})
        .problems;
  };
  CHECK(problems_of("1,0,0,0.05,0.01,0,0,-1\n").empty());
  const auto [rows, reason] = GENERATE(table<std::string, std::string>({
      {"1,0,0,0.05,1e-30,0,0,0\n2,0,0,0.07,1e-30,0,0,0\n",
       "not between 1e-8 and 1000 m; lengths are in metres (1 more"},
      {"1,0,0,1e9,0.01,0,0,0\n", "more than 10,000 km away"},
      {"1,0,0,0.05,0.01,0,0,-1e160\n", "more than 100 km/s"},
  }));
  INFO(rows);
  REQUIRE(problems_of(rows).size() == 1);
  CHECK_THAT(problems_of(rows)[0].message, Contains(reason));
}

TEST_CASE("Many rows of particles or bonds with the same cause are one message, at once", "[csv]") {
  constexpr int rows = 200000;
  const auto lines = [](const std::string& header, const auto& row) {
    std::string text = header + "\n";
    for (int k = 0; k < rows; ++k) text += row(k) + "\n";
    return text;
  };
  const std::string two = "id,x,y,z,r\n1,0,0,1,0.01\n2,0.02,0,1,0.01\n";
  const auto problems = [](const std::string& particles, const std::string& bonds) {
    const ScratchDirectory folder;
    return load_case(GYRO_CASES "/quickstart.yaml",
                     {"feed=null", "rocks=null", "particles.file=" + written(folder, "p.csv", particles),
                      "particles.bonds=" + written(folder, "b.csv", bonds)})
        .problems;
  };
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<CaseProblem> unknown =
      problems(two, lines("i,j", [](int k) { return std::to_string(k + 3) + ",1"; }));
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  REQUIRE(unknown.size() == 1);
  CHECK(unknown[0].line == 2);
  CHECK(unknown[0].message == "there is no particle 3; give an id of particles.file (199999 more rows like this)");
  CHECK(passed.count() < 10);  // 0.2 s on a quiet machine, a minute when quadratic
  const std::vector<CaseProblem> bonds = problems(two, lines("i,j", [](int) { return std::string("2,1"); }));
  REQUIRE(bonds.size() == 1);
  CHECK(bonds[0].line == 3);
  CHECK(bonds[0].message == "the bond is given twice; give each pair once (199998 more rows like this)");
  // Sorted by id, the first row that repeats one is not the first in the file.
  const std::vector<CaseProblem> particles =
      problems(lines("id,x,y,z,r", [](int k) { return std::to_string(k % 2 == 0 ? 9 : 8) + ",0,0,1,0.01"; }),
               "i,j,length0\n8,9,1\n");
  REQUIRE(particles.size() == 1);
  CHECK(particles[0].line == 4);
  CHECK(particles[0].message == "id 9 is given twice; give each id once (199997 more rows like this)");
}
