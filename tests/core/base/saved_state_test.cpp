// SPDX-License-Identifier: GPL-3.0-or-later
// Values in a saved state are restored with the same bits, for all ways to declare fields.
#include "tests/catch.hpp"

#include "core/base/saved_state.hpp"
#include "core/math/quat.hpp"

#include <limits>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

enum class Kind : std::uint8_t { first = 1, second = 200 };

struct Inner {
  Vec3<float> vector{0, 0, 0};
  std::int64_t number = 0;

  template <class F, class... I>
  static constexpr void for_each_field(F&& f, I&... i) {
    f("vector", i.vector...);
    f("number", i.number...);
  }
  friend bool operator==(const Inner& a, const Inner& b) {
    return a.vector.x == b.vector.x && a.vector.y == b.vector.y && a.vector.z == b.vector.z && a.number == b.number;
  }
};

/// With gaps between its fields.
struct Row {
  Kind kind = Kind::first;
  double time = 0;
  Inner inner;
  std::uint32_t id = 0;

  template <class F, class... R>
  static constexpr void for_each_field(F&& f, R&... r) {
    f("kind", r.kind...);
    f("time", r.time...);
    f("inner", r.inner...);
    f("id", r.id...);
  }
  friend bool operator==(const Row& a, const Row& b) {
    return a.kind == b.kind && a.time == b.time && a.inner == b.inner && a.id == b.id;
  }
};

/// One of its kind, with columns of its own.
struct Group {
  std::vector<double> numbers;
  std::vector<Row> rows;
  Inner one;
  std::int32_t count = 0;

  template <class F, class... G>
  static constexpr void for_each_field(F&& f, G&... g) {
    f("numbers", g.numbers...);
    f("rows", g.rows...);
    f("one", g.one...);
    f("count", g.count...);
  }
};

std::vector<Row> some_rows() {
  return {{Kind::second, 0.1, {{1, 2, 1e-40F}, std::numeric_limits<std::int64_t>::min()}, 4294967295U},
          {Kind::first, -0.0, {{4, 5, 6}, 7}, 8}};
}

}  // namespace

TEST_CASE("Rows of a struct become a column for each field", "[base][state]") {
  SavedState s;
  s.put("rows", some_rows());
  REQUIRE(s.columns().size() == 5);
  CHECK(s.columns().at("rows/inner/vector").width == 3);
  CHECK(std::get<std::vector<float>>(s.columns().at("rows/inner/vector").numbers) ==
        std::vector<float>{1, 2, 1e-40F, 4, 5, 6});
  CHECK(std::get<std::vector<std::uint8_t>>(s.columns().at("rows/kind").numbers) == std::vector<std::uint8_t>{200, 1});
  CHECK(s.get<Row>("rows") == some_rows());
  CHECK(s.get<Row>("rows", 2) == some_rows());
  CHECK(std::signbit(s.get<Row>("rows")[1].time));
}

TEST_CASE("An empty table is restored as an empty table", "[base][state]") {
  SavedState s;
  s.put("rows", std::vector<Row>{});
  s.put("vectors", std::vector<Vec3d>{});
  CHECK(s.get<Row>("rows").empty());
  CHECK(s.get<Vec3d>("vectors").empty());
}

TEST_CASE("A struct is saved field by field, its vectors as columns", "[base][state]") {
  SavedState s;
  s.put_one("group", Group{{1, 2, 3}, some_rows(), some_rows()[0].inner, 5});
  const auto back = s.get_one<Group>("group");
  CHECK(back.numbers == std::vector<double>{1, 2, 3});
  CHECK(back.rows == some_rows());
  CHECK(back.one == some_rows()[0].inner);
  CHECK(back.count == 5);
}

TEST_CASE("Rows of equal numbers are one column", "[base][state]") {
  SavedState s;
  s.put("turns", std::vector<Quatd>{{1, 2, 3, 4}, {5, 6, 7, 8}});
  s.put_one("place", Vec3d{1, 2, 3});
  CHECK(s.columns().at("turns").width == 4);
  CHECK(s.get<Quatd>("turns")[1].w == 5);
  CHECK(s.get_one<Vec3d>("place").z == 3);
}

TEST_CASE("A saved column that is missing, or of another type or length, is refused with its name", "[base][state]") {
  SavedState s;
  s.put("rows", some_rows());
  s.put("numbers", std::vector<double>{1, 2});
  CHECK_THROWS_WITH(s.get<double>("nothing"), Contains("nothing"));
  CHECK_THROWS_WITH(s.get<float>("numbers"), Contains("numbers"));
  CHECK_THROWS_WITH(s.get<Vec3d>("numbers"), Contains("numbers"));
  CHECK_THROWS_WITH(s.get<double>("numbers", 3), Contains("2 rows of numbers"));
  CHECK_THROWS_WITH(s.get<Row>("rows", 1), Contains("2 rows of rows"));
  CHECK_THROWS_AS(s.get_one<Row>("rows"), BadInput);  // there are two rows
  s.put("rows/id", std::vector<std::uint32_t>{1});
  CHECK_THROWS_WITH(s.get<Row>("rows"), Contains("1 rows of rows/id"));
  s.columns().erase("rows/time");
  CHECK_THROWS_WITH(s.get<Row>("rows"), Contains("rows/time"));
}
