// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"

#include "core/base/fields.hpp"
#include "core/math/vec3.hpp"

#include <string>
#include <vector>

using namespace gyro;

namespace {

std::vector<double> three() {
  return {1, 2, 3};
}

struct Whole {
  int number = 7;
  Vec3d vector{1, 2, 3};
  std::vector<double> numbers = three();

  template <class F, class... W>
  static constexpr void for_each_field(F&& f, W&... w) {
    f("number", w.number...);
    f("vector", w.vector...);
    f("numbers", w.numbers...);
  }
};

struct alignas(64) Forgetful {
  double known, forgotten;

  template <class F, class... G>
  static constexpr void for_each_field(F&& f, G&... g) {
    f("known", g.known...);
  }
};

struct Bare {
  double x;
};

static_assert(HasFields<Whole> && HasFields<Forgetful> && !HasFields<Bare> && !HasFields<double>);
static_assert(declares_every_field<Whole>);
static_assert(!declares_every_field<Forgetful>);

}  // namespace

TEST_CASE("Fields are visited by name, in several objects at the same time", "[base]") {
  Whole from, to;
  from.number = 8;
  from.vector.y = 9;
  from.numbers = {4};
  std::string names;
  Whole::for_each_field(
      [&](const std::string& name, auto& a, auto& b) {
        names += name + " ";
        b = a;
      },
      from, to);
  CHECK(names == "number vector numbers ");
  CHECK(to.number == 8);
  CHECK(to.vector.y == 9);
  CHECK(to.numbers == std::vector<double>{4});
}
