// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace gyro {

/// Integrates one small system of ordinary differential equations, dy/dt = f(y), with CVODE (variable
/// order BDF, Newton, dense difference Jacobian).
///
/// Every integration restarts at order one with a first step that is a fixed share of the interval: CVODE's history
/// cannot be saved, so with history a resumed run could not repeat the bits of one that was not interrupted. The price
/// is about 50 evaluations of f per interval.
class CvodeSession {
 public:
  /// Writes f(y) into `rate`.
  using Rate = std::function<void(std::span<const double> y, std::span<double> rate)>;
  /// Function of y that is watched; the integration ends where it becomes zero.
  using Event = std::function<double(std::span<const double> y)>;
  /// Several watched functions: writes the value of each into `values`.
  using Events = std::function<void(std::span<const double> y, std::span<double> values)>;

  struct Settings {
    int size = 0;                                ///< components of y
    double relative_tolerance = 1e-10;           ///< local error per step / |y| [-]
    std::span<const double> absolute_tolerance;  ///< one per component, > 0; copied
    double first_step = 1e-3;                    ///< share of the interval [-]
  };

  /// @param event  may be empty; then nothing is watched
  CvodeSession(const Settings& settings, Rate rate, Event event);
  /// @param events  `event_count` of them, watched together
  CvodeSession(const Settings& settings, Rate rate, Events events, int event_count);
  ~CvodeSession();
  CvodeSession(CvodeSession&&) noexcept;
  CvodeSession& operator=(CvodeSession&&) noexcept;

  /// Integrates y in place, from time 0 to `duration` > 0 [s], or to the event if that comes first.
  /// An event that is zero at the start does not end the integration if the solution moves away from the zero.
  /// @return the time reached [s]; less than `duration` only at an event
  /// @throws StoppedByGuard if CVODE fails or a value is not finite; exceptions of `rate` and of events are passed on
  double integrate(double duration, std::span<double> y);

  /// Whether the last integration ended at the zero of this event (two may be zero at once).
  bool fired(int event) const { return fired_.at(static_cast<std::size_t>(event)); }

  /// Evaluations of f in the last integration, without those for the Jacobian.
  long rate_evaluations() const;

 private:
  void note_roots(bool found);

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
  std::vector<bool> fired_;
};

}  // namespace gyro
