// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/results_content.hpp"

#include <fstream>

using namespace gyro;

TEST_CASE("Results read back as they were written") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  const int rows = 2500;  // more than two chunks
  write_run(path, rows);

  const hdf5::File file = hdf5::File::open(path);
  const ResultsContent content = full_content();
  CHECK(file.string_attribute("/case", "title") == content.record.title);
  CHECK(file.string_attribute("/case", "resolved_yaml") == content.record.resolved_yaml);
  CHECK(file.string_attribute("/case", "git_hash") == "abc123");
  CHECK(file.string_attribute("/case", "device") == "cpu");
  CHECK(file.integer_attribute("/case", "seed") == content.record.seed);
  CHECK(file.children("/series") == std::vector<std::string>{"mantle_force", "particles", "time"});
  CHECK(file.dataset("/series/mantle_force").string_attribute("units") == "N");

  const std::vector<double> time = file.dataset("/series/time").read();
  const std::vector<double> force = file.dataset("/series/mantle_force").read();
  const std::vector<double> particles = file.dataset("/series/particles").read();
  REQUIRE(time.size() == rows);
  REQUIRE(force.size() == 3 * rows);
  REQUIRE(particles.size() == rows);
  bool equal = true;
  for (int row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    equal = equal && time[r] == 0.001 * row && force[3 * r] == 0.1 + row && force[3 * r + 1] == 0.2 + row &&
            force[3 * r + 2] == 0.3 + row && particles[r] == 1e9 + row;
  }
  CHECK(equal);
  CHECK(file.dataset("/ledger/kinetic").rows() == rows);
}

TEST_CASE("Numbers of all kinds and wide rows read back as they were written") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  std::vector<double> map(5001, 1.5e6);
  map[0] = 1;
  {
    ResultsFile results(path, full_content());
    results.append("/breakage", std::vector{0.5, 1.0, 4e9});
    results.append("/breakage", std::vector{0.6, 2.0, 11.0});
    results.append("/product", std::vector{1.0, 0.1, 0.4, 1.0});
    results.append("/product", std::vector{2.0, 0.2, 0.5, 1.0});
    results.append("/liners/mantle", map);
    results.close();
  }
  const hdf5::File file = hdf5::File::open(path);
  CHECK(file.dataset("/breakage/time").read() == std::vector{0.5, 0.6});
  CHECK(file.dataset("/breakage/mode").read() == std::vector{1.0, 2.0});
  CHECK(file.dataset("/breakage/mode").number() == hdf5::Number::uint8);
  CHECK(file.dataset("/breakage/i").read() == std::vector{4e9, 11.0});
  CHECK(file.dataset("/product/sizes").read() == std::vector{0.01, 0.02, 0.04});
  CHECK(file.dataset("/product/passing").columns() == 3);
  CHECK(file.dataset("/product/passing").read() == std::vector{0.1, 0.4, 1.0, 0.2, 0.5, 1.0});
  CHECK(file.dataset("/liners/mantle/pressure").read() == std::vector<double>(5000, 1.5e6));
}

TEST_CASE("Every dataset has attributes for units, sampling and description") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  write_run(path, 1);
  const hdf5::File file = hdf5::File::open(path);
  const hdf5::Dataset pressure = file.dataset("/liners/mantle/pressure"), sizes = file.dataset("/product/sizes");
  CHECK(pressure.string_attribute("units") == "Pa");
  CHECK(pressure.string_attribute("sampling") == "mean");
  CHECK(pressure.string_attribute("description") == "mean pressure");
  CHECK(sizes.string_attribute("units") == "m");
  CHECK(sizes.string_attribute("sampling") == "instant");
  CHECK(sizes.string_attribute("description") == "of sieves");
}

TEST_CASE("The results contain only the groups of their content") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  ResultsContent content;
  content.groups = {{"/series", {{"time", "s"}}}};
  ResultsFile results(path, content);
  CHECK_THROWS_AS(results.append("/product", std::vector{1.0}), std::logic_error);
  CHECK_THROWS_AS(results.append("/series", std::vector{1.0, 2.0}), std::logic_error);
  results.close();
  const hdf5::File file = hdf5::File::open(path);
  CHECK(file.children("/") == std::vector<std::string>{"case", "series"});
  CHECK_FALSE(file.contains("/breakage/time"));
  CHECK(file.contains("/series/time"));
  CHECK(file.dataset("/series/time").read().empty());
}

TEST_CASE("The same rows written twice give the same file") {
  const ScratchDirectory scratch;
  write_run(scratch.path() / "a.h5", 1500);
  write_run(scratch.path() / "b.h5", 1500);
  CHECK(bytes(scratch.path() / "a.h5") == bytes(scratch.path() / "b.h5"));
}

TEST_CASE("A file can be read while it grows") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "results.h5";
  ResultsFile results(path, full_content());
  results.append("/ledger", std::vector{1.0, 2.0});
  CHECK(hdf5::File::open(path).dataset("/ledger/kinetic").rows() == 0);  // the row is still in memory
  results.flush();
  CHECK(hdf5::File::open(path).dataset("/ledger/kinetic").read() == std::vector{2.0});
}

TEST_CASE("Many flushes do not bloat the file") {
  const ScratchDirectory scratch;
  ResultsContent content;
  content.groups = {{"/series", {}}};
  for (int c = 0; c < 24; ++c) content.groups[0].channels.push_back({"channel_" + std::to_string(c), "1"});
  const int rows = 4096;
  ResultsFile results(scratch.path() / "results.h5", content);
  for (int row = 0; row < rows; ++row) {
    results.append("/series", std::vector<double>(24, row));
    if (row % 10 == 0) results.flush();
  }
  results.close();
  const auto data = 24u * rows * sizeof(double);
  CHECK(std::filesystem::file_size(scratch.path() / "results.h5") < 1.2 * static_cast<double>(data));
}

TEST_CASE("Strings, compressed chunks and attributes of HDF5 files read back as written") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "any.h5";
  const std::vector<std::string> names{"concave", "", "Mantel ü"};
  std::vector<double> values(2000);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = 0.5 * static_cast<double>(k);
  {
    hdf5::File file = hdf5::File::create(path);
    file.write_strings("/walls/names", names);
    file.write_numbers("/empty", {});
    file.set_attribute("/walls", "height", 4.25);
    hdf5::Dataset table = file.create_dataset("/deep/down/table", {hdf5::Number::float32, 2, 500, 4});
    table.append(values);
    CHECK_THROWS_AS(table.append(std::vector{1.0}), std::logic_error);
  }
  {
    hdf5::File file = hdf5::File::modify(path);
    file.dataset("/deep/down/table").append(std::vector{-1.0, -2.0});
    file.close();
  }
  const hdf5::File file = hdf5::File::open(path);
  CHECK(file.read_strings("/walls/names") == names);
  CHECK(file.dataset("/empty").read().empty());
  CHECK(file.number_attribute("/walls", "height") == 4.25);
  values.insert(values.end(), {-1.0, -2.0});
  CHECK(file.dataset("/deep/down/table").read() == values);
  CHECK_FALSE(file.contains("/deep/nowhere/table"));
  CHECK_THROWS_AS(file.dataset("/nowhere"), OutputError);
}

TEST_CASE("Errors of HDF5 files name the file and the reason") {
  const ScratchDirectory scratch;
  try {
    hdf5::File::create(scratch.path() / "missing" / "results.h5");
    FAIL("created a file in a directory that does not exist");
  } catch (const OutputError& error) {
    CHECK_THAT(error.what(), Catch::Matchers::Contains("missing/results.h5"));
    CHECK_THAT(error.what(), Catch::Matchers::Contains("No such file or directory"));
  }
  std::ofstream(scratch.path() / "text.h5") << "no HDF5";
  CHECK_THROWS_AS(hdf5::File::open(scratch.path() / "text.h5"), OutputError);
}
