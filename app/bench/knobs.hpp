// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/scenes.hpp"

#include <string>
#include <vector>

namespace gyro::bench {

/// One point of a work-precision curve: a scene's case with one numerical choice changed.
struct KnobSetting {
  std::string knob;
  std::string value;                   ///< a number, or a word such as `double`
  std::vector<std::string> overrides;  ///< of the case, as in --set
  int hold = 1;                 ///< numerics.substeps, set after the check of the case, so that its limit can be tested
  double hold_share = 0;        ///< Rates::share with numerics.hold=auto, set after the check as well; 0: no hold
  double margin = 0;            ///< of neighbour lists / smallest radius; 0: the program's choice
  bool exact = false;           ///< must change no bit: compared with the default setting instead of the reference
  bool to_first_break = false;  ///< the run ends with the window in which the first bond breaks
};

/// The overrides, with the hold as numerics.substeps of a case.
std::vector<std::string> as_overrides(const KnobSetting& setting);

/// All defaults.
KnobSetting default_setting();

/// All settings for a scene, the default first. Physical parameters (damping, moduli) are not varied.
/// @param quick  two or three points for each knob
std::vector<KnobSetting> settings_of(const AccuracyScene& scene, bool quick);

/// Double, a sixteenth of the default step, windows of 50 us.
KnobSetting reference_setting();
/// The same at twice the step, up to the first break; it bounds the error of the reference until then.
KnobSetting coarse_reference_setting();

}  // namespace gyro::bench
