// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/verdict.hpp"

#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

using Tone = Verdict::Tone;

std::string percent(double share) {
  return number(100 * share) + "\u00a0%";
}

std::string gyrations_text(const RunData& run) {
  const auto gyrations = run.gyrations();
  return gyrations ? number(*gyrations, 2) + (*gyrations == 1 ? " gyration" : " gyrations") : quantity(run.end(), "s");
}

/// How the run ended, if not well.
void judge_end(const RunData& run, Verdict& v) {
  const Summary& s = run.summary;
  const std::string reason = s.reason.empty() ? "" : " Reason: " + s.reason + ".";
  const std::string at = " after " + quantity(s.simulated_seconds, "s") + " of simulated time";
  switch (s.status) {
    case RunStatus::done:
      return;
    case RunStatus::interrupted:
      if (v.tone == Tone::good) v.tone = Tone::caution;
      v.headline = "Interrupted: " + v.headline;
      v.trust.insert(v.trust.begin(), "The run was interrupted" + at + " and can be continued with --resume; the " +
                                          "figures are those up to there." + reason);
      return;
    case RunStatus::stopped:
      v.tone = Tone::bad;
      v.headline = "Stopped by a guard: do not use these figures";
      v.trust.insert(v.trust.begin(), "A guard stopped the run" + at +
                                          ", because what followed would have been wrong. What is shown leads up to "
                                          "that point." +
                                          reason);
      return;
    case RunStatus::failed:
      v.tone = Tone::bad;
      v.headline = "Failed: do not use these figures";
      v.trust.insert(v.trust.begin(), "The run failed" + at + "." + reason);
  }
}

void judge_machine(const RunData& run, Verdict& v) {
  const Summary& s = run.summary;
  if (s.steady) {
    v.headline = "Steady since " + quantity(s.steady->from, "s");
    v.lead = "The figures are means over " + std::to_string(s.steady->gyrations) +
             " gyrations without drift, ± one standard error.";
    v.trust.push_back("The standard errors come from " + std::to_string(s.steady->blocks) +
                      " blocks of whole gyrations. They cover the scatter of this one run, and not what another seed "
                      "of the random rocks or another model would change.");
    constexpr int enough = 20;  // gyrations, as --until steady asks for
    if (static_cast<int>(s.steady->gyrations) < enough) {
      v.tone = Tone::caution;
      v.trust.push_back("Fewer than " + std::to_string(enough) +
                        " gyrations are few: the errors may be larger than they look.");
    }
    return;
  }
  v.tone = Tone::caution;
  v.headline = "A start-up of " + gyrations_text(run) + ": no steady figures";
  v.lead = "The figures below are means over the whole run and no forecast of the machine in operation.";
  if (s.not_steady) v.trust.push_back("Why it is not steady: " + *s.not_steady + ".");
}

void judge_trouble(const Summary& s, Verdict& v) {
  if (s.stalled.value_or(false)) {
    const auto stall = std::ranges::find(s.drive_events, "stall", &DriveHappening::what);
    v.tone = Tone::bad;
    v.headline = "Stalled" + (stall == s.drive_events.end() ? "" : " at " + quantity(stall->time, "s")) +
                 ": the rock stopped the drive";
    v.trust.insert(v.trust.begin(),
                   "Power and throughput are means over the whole run, with the time after the stall.");
  }
  if (s.choked.value_or(false)) {
    if (v.tone == Tone::good) v.tone = Tone::caution;
    v.headline = "Choked: " + v.headline;
    v.trust.insert(v.trust.begin(),
                   "The chamber is choked: more rock waits for room than one gyration feeds, so that "
                   "the chamber and not the feed limits the throughput.");
  }
  if (s.escaped_fraction.value_or(0) > 0)
    v.trust.push_back(percent(*s.escaped_fraction) +
                      " of the rock left over the rim of the concave; no figure of the "
                      "product includes it.");
}

void judge_laboratory(const RunData& run, Verdict& v) {
  const LaboratoryFigures& l = *run.summary.laboratory;
  if (l.strength)
    v.headline = "Laboratory test (" + l.test + "): strength " + quantity(*l.strength, "Pa");
  else if (l.failure_force)
    v.headline = "Laboratory test (" + l.test + "): failure at " + quantity(*l.failure_force, "N");
  else
    v.headline = "Laboratory test (" + l.test + "): the rock did not fail", v.tone = Tone::caution;
  v.lead = "One rock of " + quantity(l.size, "m") +
           " between platens. Other seeds give other strengths: repeat the test "
           "over several before the figures are used.";
  if (l.broken_before > 0) v.trust.push_back(count(l.broken_before) + " bonds broke before the moving platen pressed.");
}

void judge_energy(const Summary& s, Verdict& v) {
  constexpr double good = 0.01, guard = 0.05;
  if (!s.energy_residual_fraction || *s.energy_residual_fraction == 0) return;  // 0: there is no rock
  const double residual = std::abs(*s.energy_residual_fraction);
  const std::string text = "The energy balance closes within " + percent(residual);
  const std::string measure = " of the work done, or of the largest energy if that is larger";
  if (residual <= good) {
    v.trust.push_back(text + measure + ": the time step is fine enough for power and energy.");
    return;
  }
  if (v.tone == Tone::good) v.tone = Tone::caution;
  v.trust.push_back(text + measure +
                    (residual <= guard ? ". That is more than usual (1\u00a0%): power and energy are uncertain; a "
                                         "smaller time step helps."
                                       : ". That is too much: power and energy cannot be trusted."));
}

void judge_resolution(const Summary& s, Verdict& v) {
  if (!s.resolution || !s.discharged_mass || !(*s.discharged_mass > 0)) return;
  const auto p80 = s.steady && s.steady->p80 ? std::optional(s.steady->p80->value) : s.p80;
  v.trust.push_back("The model has no pieces smaller than its particles, of up to " + quantity(*s.resolution, "m") +
                    ": finer product is " + (s.fines ? "an estimate." : "unknown.") +
                    (p80 && *p80 < 1.5 * *s.resolution
                         ? " P80 lies close to that size, so that it says more of the particles than of the crusher."
                         : ""));
}

void judge_overlaps(const Summary& s, Verdict& v) {
  constexpr double large = 0.3;
  if (s.max_overlap_ratio.value_or(0) > large)
    v.trust.push_back("Particles overlapped by up to " + percent(*s.max_overlap_ratio) +
                      " of their radius; the contact law assumes small overlaps. Stiffer material helps.");
}

}  // namespace

Verdict verdict(const RunData& run) {
  const Summary& s = run.summary;
  Verdict v;
  if (s.laboratory)
    judge_laboratory(run, v);
  else if (s.steady || s.not_steady)
    judge_machine(run, v);
  else
    v.headline = quantity(s.simulated_seconds, "s") + " simulated", v.lead = "A scene without a crusher and its drive.";
  judge_trouble(s, v);
  judge_end(run, v);
  judge_energy(s, v);
  judge_resolution(s, v);
  judge_overlaps(s, v);
  if (s.mean_crushing_power)
    v.trust.push_back(
        "gyrosim has not been validated against a measured crusher. Differences between runs are safer "
        "than the figures of one.");
  return v;
}

}  // namespace gyro::report
