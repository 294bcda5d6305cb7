// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// The present state of a run.
struct ProgressState {
  double time = 0;                  ///< simulated [s]
  std::int64_t particle_steps = 0;  ///< since the start of the run
  std::int64_t particles = 0;
  std::optional<std::int64_t> bonds_broken = {};  ///< none: the scene has no bonds
  std::optional<double> eccentric_speed = {};     ///< [rad/s]; none: no drivetrain
  std::optional<double> crushing_power = {};      ///< [W]
};

/// How progress is shown.
struct ProgressStyle {
  enum class Form { silent, lines, live, json } form = Form::lines;
  bool colour = false;
  int width = 0;  ///< of the terminal in characters; 0: determined whenever a line is drawn

  /// Live on a terminal; plain lines in a pipe or file, or with TERM=dumb; silent if `quiet`. Colour on a terminal
  /// unless NO_COLOR is set. `json`, for programs that start runs, is chosen by them.
  static ProgressStyle for_stderr(bool quiet);
};

/// Shows the progress of a run, with the expected time left. A call costs almost nothing if no line is due.
class Progress {
 public:
  using Clock = std::function<double()>;  ///< wall clock [s], any origin
  /// Progress on standard error. @param begin  state at which this process starts  @param end  of the whole run [s]
  Progress(const ProgressState& begin, double end, ProgressStyle style);
  Progress(const ProgressState& begin, double end, ProgressStyle style, std::ostream& out, Clock clock);
  void update(const ProgressState& state);
  /// Shows the last state and moves the cursor to a new line.
  void finish(const ProgressState& state);

 private:
  bool is_due(double now, double fraction) const;
  void learn_rates(double now, const ProgressState& state);
  void show(double now, const ProgressState& state);
  void show_live(const std::string& percent, double fraction, const std::vector<std::string>& parts);
  std::string json_line(double now, const ProgressState& state) const;
  std::vector<std::string> describe(double now, const ProgressState& state) const;
  double seconds_left(const ProgressState& state) const;  ///< negative while unknown

  double fraction_at(double time) const;  ///< fraction of the whole run

  ProgressState begin_;
  double end_;
  ProgressStyle style_;
  std::ostream& out_;
  Clock clock_;
  double started_;
  double shown_at_, shown_fraction_ = 0;  ///< of the last line
  double learnt_at_, learnt_time_;        ///< of the last update of the rates
  std::int64_t learnt_steps_;
  double time_rate_ = 0, step_rate_ = 0;  ///< per second of wall clock, smoothed
};

/// Short readable duration: "0.4 s", "37 s", "12 min 05 s", "3 h 20 min", "4 d 06 h".
std::string format_duration(double seconds);

/// A number with three digits and an SI prefix: 12345678 -> "12.3 M".
std::string format_count(double value);

}  // namespace gyro
