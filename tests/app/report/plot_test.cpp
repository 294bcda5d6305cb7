// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/decimate.hpp"
#include "app/report/plot/heat_map.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/plot/polar_plot.hpp"
#include "app/report/plot/ticks.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace gyro;
using namespace gyro::report;
using Catch::Matchers::Contains;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) all.push_back(tick.label);
  return all;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("Ticks lie at 1, 2 or 5 times a power of ten, with the decimals of their step") {
  CHECK(labels(linear_ticks(0, 1)) == std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(linear_ticks(0, 0.5)) == std::vector<std::string>{"0.0", "0.1", "0.2", "0.3", "0.4", "0.5"});
  CHECK(labels(linear_ticks(-12, 31, 5)) == std::vector<std::string>{"−10", "0", "10", "20", "30"});
  CHECK(labels(linear_ticks(444, 453, 5)) == std::vector<std::string>{"444", "446", "448", "450", "452"});
  CHECK(labels(linear_ticks(0, 2e6, 4)).back() == "2.00\u00a0×\u00a010⁶");
  CHECK(linear_ticks(1, 1).empty());
  CHECK(linear_ticks(0, std::numeric_limits<double>::infinity()).empty());
  CHECK(linear_ticks(unknown, 1).empty());
}

TEST_CASE("A logarithmic axis has labels at 1, 2 and 5 over few decades, at powers of ten over many") {
  CHECK(labels(log_ticks(4, 60)) == std::vector<std::string>{"5", "10", "20", "50"});
  CHECK(labels(log_ticks(0.5, 2)) == std::vector<std::string>{"0.5", "0.6", "0.8", "1", "2"});
  CHECK(labels(log_ticks(1, 1e4)) == std::vector<std::string>{"1", "10", "100", "1000", "10000"});
  CHECK(log_ticks(4, 60).size() == 12);  // 4 to 9, 10 to 60
  CHECK(log_ticks(0, 10).empty());
  const Scale scale{.low = 1, .high = 100, .begin = 0, .end = 200, .log = true};
  CHECK(scale.at(1) == Approx(0));
  CHECK(scale.at(10) == Approx(100));
  CHECK(std::isfinite(scale.at(0)));
  const Scale upward{.low = 0, .high = 4, .begin = 300, .end = 100};
  CHECK(upward.at(1) == Approx(250));
}

TEST_CASE("An axis of equal or missing values still has a width") {
  CHECK(widened({5, 5}).high > widened({5, 5}).low);
  CHECK(widened({0, 10}).low == 0);
  CHECK(widened({unknown, unknown}).high == 1);
}

TEST_CASE("Decimation keeps ends and extremes, and breaks where values are missing") {
  std::vector<double> y(100'000);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = std::sin(1e-3 * static_cast<double>(k));
  y[31'234] = 7, y[77'777] = -9;
  const std::vector<std::size_t> kept = decimated(y);
  CHECK(kept.size() <= 1500);
  CHECK(kept.size() > 1000);
  CHECK(kept.front() == 0);
  CHECK(kept.back() == y.size() - 1);
  CHECK(std::ranges::is_sorted(kept));
  CHECK(std::ranges::adjacent_find(kept) == kept.end());
  for (const std::size_t extreme : {31'234, 77'777}) CHECK(std::ranges::find(kept, extreme) != kept.end());
  y[50'000] = unknown;
  const std::vector<std::size_t> broken = decimated(y);
  CHECK(broken.size() <= 1500);
  CHECK(std::ranges::find(broken, std::size_t{50'000}) != broken.end());
  CHECK(decimated(std::vector<double>(10)).size() == 10);
  CHECK(decimated(std::vector<double>()).empty());
  CHECK(decimated(std::vector<double>(4000, unknown)).size() <= 1500);
}

TEST_CASE("A line plot has title, units, legend and one path for each curve, broken at missing values") {
  LinePlot plot{.title = "Speed <of> the \"eccentric\""};
  plot.x.label = "time [s]";
  plot.y.label = "speed [rpm]";
  plot.curves.push_back({.name = "one & two", .x = {0, 1, 2, 3}, .y = {1, unknown, 3, 4}});
  plot.curves.push_back({.name = "", .x = {0, 3}, .y = {2, 2}, .style = 1});
  const std::string html = figure(plot);
  CHECK_THAT(html, Contains("<figcaption>Speed &lt;of&gt; the &quot;eccentric&quot;</figcaption>"));
  CHECK_THAT(html, Contains(">time [s]</text>") && Contains(">speed [rpm]</text>") && Contains("one &amp; two</li>"));
  CHECK(count(html, "<path class=\"line c0\"") == 1);
  CHECK(count(html, "<li>") == 1);
  CHECK_THAT(html, !Contains("nan") && !Contains("inf"));
  const std::string path = html.substr(html.find("<path class=\"line c0\""));
  CHECK(count(path.substr(0, path.find("/>")), "M") == 2);
}

TEST_CASE("Plots of nothing, of one point and of huge numbers are drawn without numbers that are not finite") {
  for (const auto& [x, y] : {std::pair<std::vector<double>, std::vector<double>>{{}, {}},
                             {{1}, {5}},
                             {{unknown, unknown}, {unknown, unknown}},
                             {{0, 1}, {0, 0}},
                             {{0, 1}, {-1e300, 1e300}}}) {
    LinePlot plot{.title = "t"};
    plot.curves.push_back({.name = "c", .x = x, .y = y});
    for (const bool log : {false, true}) {
      plot.x.log = log;
      const std::string html = figure(plot);
      CHECK_THAT(html, !Contains("nan") && !Contains("inf\"") && Contains("</figure>"));
    }
  }
  CHECK_FALSE(has_points(LinePlot{.title = "t"}));
}

TEST_CASE("A map is drawn with one path for each colour, and large ones become coarser") {
  HeatMap map{.title = "Pressure",
              .x_label = "azimuth [°]",
              .y_label = "height [mm]",
              .value_label = "pressure [kPa]",
              .x = {0, 180, 360},
              .y = {0, 10, 20},
              .values = {0, 1, unknown, 100}};
  const std::string html = figure(map);
  CHECK(count(html, "<path class=\"h") == 2);  // of 0, and of 1 and 100 beyond the end of the scale
  CHECK_THAT(html, Contains(">pressure [kPa]</text>") && Contains(">270</text>") && !Contains("nan"));
  CHECK(end_of_scale({0, 0}) == 1);
  CHECK(end_of_scale({unknown, 5}) == 5);
  HeatMap large = map;
  large.x.clear(), large.y.clear(), large.values.clear();
  for (int k = 0; k <= 500; ++k) large.x.push_back(k);
  for (int k = 0; k <= 100; ++k) large.y.push_back(k);
  for (int k = 0; k < 500 * 100; ++k) large.values.push_back(k % 2);
  const HeatMap coarse = coarsened(large);
  CHECK(coarse.x.size() <= 121);
  CHECK(coarse.y.size() <= 61);
  CHECK(coarse.x.back() == 500);
  CHECK(coarse.values.size() == (coarse.x.size() - 1) * (coarse.y.size() - 1));
  CHECK(coarse.values[3] == Approx(0.5).margin(0.11));
}

TEST_CASE("A polar plot draws at most some 1500 points and the mean") {
  PolarPlot plot{
      .title = "Force", .label = "force [kN]", .along = {}, .across = {}, .directions = {"a", "b", "c", "d"}};
  for (int k = 0; k < 10'000; ++k) plot.along.push_back(2), plot.across.push_back(k % 2);
  const std::string html = figure(plot);
  CHECK(count(html, "dot c0 faint") <= 1500);
  CHECK(count(html, "dot c0 faint") > 1000);
  CHECK_THAT(html, Contains("class=\"arrow c1\"") && Contains(">force [kN]</text>"));
  CHECK_THAT(figure(PolarPlot{}), Contains("</figure>"));
}
