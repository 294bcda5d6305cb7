// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <string_view>

#include <nlohmann/json.hpp>

namespace gyro {
namespace {

constexpr double live_interval = 0.2;    ///< between two updates of a live line [s]
constexpr double line_interval = 10;     ///< plain lines: at least one in this time [s] ...
constexpr double line_share = 0.02;      ///< ... and one after each such share of the run,
constexpr double shortest_interval = 1;  ///< but at most one in this time [s]
constexpr double memory = 20;            ///< time constant with which rates are smoothed [s]

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string print(const char* pattern, double value) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

std::string two_parts(double seconds, double large, const char* large_unit, double small, const char* small_unit) {
  const double whole = std::floor(seconds / large);
  return print("%.0f ", whole) + large_unit + print(" %02.0f ", std::floor((seconds - whole * large) / small)) +
         small_unit;
}

/// A bar of `cells` characters, filled to an accuracy of half a character.
std::string bar(double fraction, int cells, bool colour) {
  const int halves = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 2 * cells);
  std::string full, rest;
  for (int cell = 0; cell < cells; ++cell) {
    if (2 * cell + 1 < halves)
      full += "━";
    else if (2 * cell < halves)
      full += "╸";
    else
      rest += colour ? "━" : " ";
  }
  return colour ? "\033[36m" + full + "\033[90m" + rest + "\033[0m" : full + rest;
}

/// Joins as many whole parts as fit into `room` characters.
std::string join(const std::vector<std::string>& parts, std::size_t room) {
  std::string text;
  for (const std::string& part : parts) {
    const std::string more = text.empty() ? part : ", " + part;
    if (text.size() + more.size() > room) break;
    text += more;
  }
  return text;
}

}  // namespace

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "?";
  if (seconds < 9.95) return print("%.1f s", seconds);
  const double whole = std::round(seconds);
  if (whole < 60) return print("%.0f s", whole);
  if (whole < 3600) return two_parts(whole, 60, "min", 1, "s");
  if (whole < 86400) return two_parts(whole, 3600, "h", 60, "min");
  return two_parts(whole, 86400, "d", 3600, "h");
}

std::string format_count(double value) {
  constexpr std::array prefixes{"", " k", " M", " G", " T"};
  std::size_t p = 0;
  // With three digits, 999.5 would be printed as 1e+03.
  while (std::abs(value) >= 999.5 && p + 1 < prefixes.size()) {
    value /= 1000;
    ++p;
  }
  return print("%.3g", value) + prefixes[p];
}

ProgressStyle ProgressStyle::for_stderr(bool quiet) {
  ProgressStyle style;
  const char* kind = std::getenv("TERM");
  const bool terminal = ::isatty(STDERR_FILENO) != 0 && !(kind != nullptr && std::string_view(kind) == "dumb");
  const char* no_colour = std::getenv("NO_COLOR");  // by no-color.org, any value that is not empty disables colours
  style.form = quiet ? Form::silent : terminal ? Form::live : Form::lines;
  style.colour = terminal && (no_colour == nullptr || *no_colour == '\0');
  return style;
}

Progress::Progress(const ProgressState& begin, double end, ProgressStyle style)
    : Progress(begin, end, style, std::cerr, steady_seconds) {}

Progress::Progress(const ProgressState& begin, double end, ProgressStyle style, std::ostream& out, Clock clock)
    : begin_(begin),
      end_(end),
      style_(style),
      out_(out),
      clock_(std::move(clock)),
      started_(clock_()),
      shown_at_(started_),
      learnt_at_(started_),
      learnt_time_(begin.time),
      learnt_steps_(begin.particle_steps) {}

double Progress::fraction_at(double time) const {
  return end_ > 0 ? std::clamp(time / end_, 0.0, 1.0) : 1;
}

bool Progress::is_due(double now, double fraction) const {
  const double since = now - shown_at_;
  if (style_.form == ProgressStyle::Form::live) return since >= live_interval;
  // A run of hours does not need a line every 10 s: the interval grows to 2 % of the time that has passed.
  const double interval = std::max(line_interval, line_share * (now - started_));
  return since >= interval || (since >= shortest_interval && fraction - shown_fraction_ >= line_share);
}

void Progress::update(const ProgressState& state) {
  if (style_.form == ProgressStyle::Form::silent) return;
  const double now = clock_();
  const double fraction = fraction_at(state.time);
  if (!is_due(now, fraction) || state.time >= end_) return;  // finish() shows the end
  learn_rates(now, state);
  show(now, state);
  shown_fraction_ = fraction;
}

void Progress::finish(const ProgressState& state) {
  if (style_.form == ProgressStyle::Form::silent) return;
  const double now = clock_();
  // The last line shows the rates of the whole run, not those at its end.
  const double elapsed = now - started_;
  time_rate_ = elapsed > 0 ? (state.time - begin_.time) / elapsed : 0;
  step_rate_ = elapsed > 0 ? static_cast<double>(state.particle_steps - begin_.particle_steps) / elapsed : 0;
  show(now, state);
  if (style_.form == ProgressStyle::Form::live) out_ << '\n' << std::flush;
}

/// Exponential means over wall-clock time, so that the time left follows changes in the number of particles and bonds.
void Progress::learn_rates(double now, const ProgressState& state) {
  const double passed = now - learnt_at_;
  if (passed <= 0) return;
  const double time_rate = (state.time - learnt_time_) / passed;
  const double step_rate = static_cast<double>(state.particle_steps - learnt_steps_) / passed;
  // At first the estimates are plain means: the weight of a value is its share of the time that has passed so far.
  const double share = std::max(1 - std::exp(-passed / memory), passed / (now - started_));
  time_rate_ += share * (time_rate - time_rate_);
  step_rate_ += share * (step_rate - step_rate_);
  learnt_at_ = now;
  learnt_time_ = state.time;
  learnt_steps_ = state.particle_steps;
}

void Progress::show(double now, const ProgressState& state) {
  const double fraction = fraction_at(state.time);
  const std::string percent = print("%5.1f %%", 100 * fraction);
  if (style_.form == ProgressStyle::Form::json)
    out_ << json_line(now, state) << '\n' << std::flush;
  else if (style_.form == ProgressStyle::Form::live)
    show_live(percent, fraction, describe(now, state));
  else
    out_ << percent << "  " << join(describe(now, state), std::string::npos) << '\n' << std::flush;
  shown_at_ = now;
}

void Progress::show_live(const std::string& percent, double fraction, const std::vector<std::string>& parts) {
  constexpr int cells = 16;
  const int width = style_.width > 0 ? style_.width : terminal_width();
  // Everything except the bar is plain ASCII. The last column stays empty, because a full line would wrap.
  const int room = width - 1 - cells - static_cast<int>(percent.size()) - 3;
  out_ << "\r\033[K" << bar(fraction, cells, style_.colour) << ' ' << percent << "  "
       << join(parts, static_cast<std::size_t>(std::max(0, room))) << std::flush;
}

double Progress::seconds_left(const ProgressState& state) const {
  return time_rate_ > 0 ? std::max(0.0, end_ - state.time) / time_rate_ : -1;
}

/// One JSON object; what is unknown, or what the scene does not have, is null.
std::string Progress::json_line(double now, const ProgressState& state) const {
  const auto known = [](const auto& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  const double left = seconds_left(state);
  return nlohmann::ordered_json{{"time", state.time},
                                {"end", end_},
                                {"fraction", fraction_at(state.time)},
                                {"wall_seconds", now - started_},
                                {"seconds_left", known(left < 0 ? std::nullopt : std::optional(left))},
                                {"particle_steps_per_second", step_rate_},
                                {"particles", state.particles},
                                {"bonds_broken", known(state.bonds_broken)},
                                {"eccentric_speed", known(state.eccentric_speed)},
                                {"crushing_power", known(state.crushing_power)}}
      .dump();
}

/// The parts of a line, the most important first: parts that do not fit into the terminal are left out.
std::vector<std::string> Progress::describe(double now, const ProgressState& state) const {
  const bool over = state.time >= end_;
  const double left = seconds_left(state);
  std::vector<std::string> parts;
  parts.push_back("t " + print("%.4g", state.time) + print(" of %.4g s", end_));
  parts.push_back(over ? "took " + format_duration(now - started_) : format_duration(left) + " left");
  parts.push_back(format_count(step_rate_) + " particle-steps/s");
  parts.push_back(std::to_string(state.particles) + " particles");
  if (state.bonds_broken) parts.push_back(std::to_string(*state.bonds_broken) + " bonds broken");
  if (state.eccentric_speed) parts.push_back(print("%.1f rpm", *state.eccentric_speed * 30 / std::numbers::pi));
  if (state.crushing_power)
    parts.push_back(*state.crushing_power < 1e3 ? print("%.0f W", *state.crushing_power)
                                                : print("%.4g kW", *state.crushing_power / 1e3));
  return parts;
}

}  // namespace gyro
