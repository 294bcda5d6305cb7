// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/text.hpp"
#include "app/report/headline.hpp"
#include "app/report/page.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <limits>

using namespace gyro;
using namespace gyro::report;
using Catch::Matchers::Contains;

TEST_CASE("Texts are safe in HTML and XML, whatever bytes a case has in its title") {
  CHECK(escape("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
  CHECK(escape(std::string("\x01\xff", 2)) == "\\x01\\xFF");
  CHECK(escape("</pre><script>alert(1)</script>") == "&lt;/pre&gt;&lt;script&gt;alert(1)&lt;/script&gt;");
  const std::string page = html_page("<T>", "s", "");
  CHECK_THAT(page, Contains("<title>&lt;T&gt;</title>") && Contains("<h1>&lt;T&gt;</h1>") && !Contains("<T>"));
}

TEST_CASE("Numbers have three significant figures") {
  CHECK(number(27.8618) == "27.9");
  CHECK(number(0.0034181) == "0.00342");
  CHECK(number(1239.6) == "1240");
  CHECK(number(999.6) == "1000");
  CHECK(number(0.99961) == "1.00");
  CHECK(number(-3.14159) == "−3.14");
  CHECK(number(0) == "0");
  CHECK(number(4.7e-11) == "4.70\u00a0×\u00a010⁻¹¹");
  CHECK(number(1.5e6) == "1.50\u00a0×\u00a010⁶");
  CHECK(number(std::nan("")) == "–");
  CHECK(number(std::numeric_limits<double>::infinity()) == "–");
  CHECK(number_with_error(27.8618, 0.4123) == "27.86 ± 0.41");
  CHECK(number_with_error(1234.5, 56.7) == "1234 ± 57");
  CHECK(number_with_error(5, 0) == "5.00");
  CHECK(number_with_error(100, 3.3e-14) == "100");
  CHECK(number_with_error(1.56e-5, 4.1e-6) == "(1.56 ± 0.41)\u00a0×\u00a010⁻⁵");
  CHECK(number_with_error(0, 2e-7) == "(0.0 ± 2.0)\u00a0×\u00a010⁻⁷");
  CHECK(count(1234567) == "1\u202f234\u202f567");
  CHECK(count(-12) == "−12");
}

TEST_CASE("Quantities have the unit in which they are best read") {
  CHECK(quantity(27.86, "W") == "27.9\u00a0W");
  CHECK(quantity(150e3, "W") == "150\u00a0kW");
  CHECK(quantity(-2e6, "J") == "−2.00\u00a0MJ");
  CHECK(quantity(0.01459, "m") == "14.6\u00a0mm");
  CHECK(quantity(0.05, "kg") == "50.0\u00a0g");
  CHECK(quantity(2500, "kg") == "2.50\u00a0t");
  CHECK(quantity(1, "kg/s") == "3.60\u00a0t/h");
  CHECK(quantity(0.5, "t/h") == "500\u00a0kg/h");
  CHECK(quantity(1.562e-6, "s") == "1.56\u00a0µs");
  CHECK(quantity(0, "s") == "0\u00a0µs");
  CHECK(shown_unit("rad/s", 1).factor == Approx(9.5493));
  CHECK(shown_unit("1", 1).name.empty());
  CHECK(shown_unit("lux", 3).name == "lux");
}

TEST_CASE("The figures on top are those of the steady part with their errors if there is one") {
  Summary s;
  s.mean_crushing_power = 100;
  s.throughput_tph = 5;
  s.energy_residual_fraction = 0.0017;
  std::vector<Headline> start = headlines(s);
  REQUIRE(start.size() >= 3);
  CHECK(start[0].label == "Crushing power");
  CHECK(text_of(start[0]) == "100\u00a0W");
  CHECK_THAT(start[0].about, Contains("mean over the run"));
  s.steady = SteadyFigures{.from = 1, .crushing_power = {2500, 40}, .throughput_tph = {7, 0.2}};
  const std::vector<Headline> steady = headlines(s);
  CHECK(text_of(steady[0]) == "2.500 ± 0.040\u00a0kW");
  CHECK(steady[0].about == "crushing power, mean since then");
  CHECK(text_of(steady[1]) == "7.00 ± 0.20\u00a0t/h");
}
