// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/describe.hpp"
#include "core/base/errors.hpp"
#include "core/rocks/recipe.hpp"
#include "io/case/case.hpp"
#include "io/schema/schema.hpp"
#include "mbd/motor.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <set>

TEST_CASE("Every key is described exactly once, with its own sentence") {
  const std::string all = gyro::describe();
  std::set<std::string_view> paths;
  for (const gyro::Key& key : gyro::schema_keys()) {
    CAPTURE(key.path);
    CHECK(paths.insert(key.path).second);
    CHECK(!key.doc.empty());
    CHECK(key.doc.back() == '.');
    CHECK(all.find("\n" + std::string(key.path) + "\n") != std::string::npos);
    CHECK(gyro::describe(std::string(key.path)).starts_with(std::string(key.path) + "\n"));
  }
  CHECK(paths.size() >= 100);
}

TEST_CASE("The table of keys is consistent") {
  for (const gyro::Key& key : gyro::schema_keys()) {
    CAPTURE(key.path);
    CHECK(!(key.required && !key.fallback.empty()));
    const bool section = key.type == gyro::KeyType::section || key.type == gyro::KeyType::named;
    const std::string_view parent = key.parent();
    const bool below_name = parent.ends_with(".<name>") || parent.ends_with(".<pair>");
    if (!parent.empty() && !below_name) CHECK(gyro::find_key(parent) != nullptr);
    if (key.type == gyro::KeyType::section) CHECK(!gyro::keys_below(key.path).empty());
    for (const std::string_view group : gyro::split(key.one_of, '|'))
      for (const std::string_view name : gyro::split(group, '+'))
        CHECK(gyro::find_key(std::string(key.path) + "." + std::string(name)) != nullptr);
    if (key.type == gyro::KeyType::word || key.type == gyro::KeyType::words) CHECK(!key.words.empty());
    if (section) CHECK(key.fallback.empty());
  }
}

TEST_CASE("The words of motor models are the motor models of the drivetrain, and nema") {
  std::vector<std::string> words;
  for (const std::string_view word : gyro::split(gyro::find_key("drivetrain.motor.model")->words, '|'))
    words.emplace_back(word);
  CHECK(std::erase(words, "nema") == 1);
  std::vector<std::string> models = gyro::motor_models();
  std::ranges::sort(words);
  std::ranges::sort(models);
  CHECK(words == models);
}

TEST_CASE("The largest library that a case may ask for can be made") {
  gyro::LibraryRecipe recipe;
  recipe.sizes = gyro::PassingTable{{{0.05, 0}, {0.5, 1}}};
  recipe.rock_density = 2600;
  const auto high = [](const char* path) { return static_cast<int>(gyro::find_key(path)->range.high); };
  const auto accepts = [](const gyro::LibraryRecipe& r) { CHECK_NOTHROW(gyro::check_recipe(r)); };
  const auto refuses = [](const gyro::LibraryRecipe& r) { CHECK_THROWS_AS(gyro::check_recipe(r), gyro::BadInput); };
  recipe.samples = high("rocks.samples");
  recipe.shapes = gyro::ProceduralShapes{high("rocks.shapes.procedural")};
  accepts(recipe);
  recipe.samples += 1;
  refuses(recipe);
  recipe.samples -= 1;
  recipe.shapes = gyro::GivenShapes{{{}}, high("rocks.shapes.corners")};
  accepts(recipe);
  recipe.shapes = gyro::GivenShapes{{{}}, high("rocks.shapes.corners") + 1};
  refuses(recipe);
}

TEST_CASE("describe finds keys by pattern and by name, and suggests a key for a misspelt one") {
  const std::string step = gyro::describe("time.step");
  CHECK(step.find("quantity [s] or auto, > 0; default auto") != std::string::npos);
  CHECK(step.find("units: s, ms, us") != std::string::npos);
  CHECK(gyro::describe("materials.rock.poisson_ratio").find(">= 0 and < 0.5; required") != std::string::npos);
  CHECK(gyro::describe("materials.rock").find("materials.<name>.density") != std::string::npos);
  CHECK(gyro::describe("drivetrain").find("drivetrain.motor.stall_torque") != std::string::npos);
  CHECK_THROWS_WITH(gyro::describe("time.duraton"), Catch::Contains("did you mean \"time.duration\"?"));
  CHECK_THROWS_WITH(gyro::describe("damping"), Catch::Contains("did you mean \"bonds.damping\"?"));
  CHECK_THROWS_AS(gyro::describe("nonsense.of.this.kind"), gyro::BadInput);
}

TEST_CASE("The closest word is suggested for a misspelt one") {
  const std::vector<std::string_view> words = {"duration", "step", "safety", "shear_stiffness"};
  CHECK(gyro::closest("duraton", words) == "duration");
  CHECK(gyro::closest("setp", words) == "step");
  CHECK(gyro::closest("stiffness", words) == "shear_stiffness");
  CHECK(gyro::closest("colour", words).empty());
}

TEST_CASE("The JSON Schema contains every key") {
  const std::string schema = gyro::json_schema();
  CHECK(schema.find("http://json-schema.org/draft-07/schema#") != std::string::npos);
  for (const gyro::Key& key : gyro::schema_keys()) {
    CAPTURE(key.path);
    CHECK(schema.find('"' + std::string(key.name()) + "\":") != std::string::npos);
  }
}
