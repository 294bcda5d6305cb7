// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/summary.hpp"

#include <optional>
#include <string>

/// Lines of the summary on the terminal. A line is empty if it does not apply to the run.
namespace gyro {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// "  name                value".
std::string line(const char* name, const std::string& value);

/// A line with value x scale and the text `unit` after it; empty without a value.
std::string number_line(const char* name, const std::optional<double>& value, double scale, const char* unit,
                        int digits = 4);

/// A line with a mass in t, kg or g, depending on its size; empty without a mass.
std::string mass_line(const char* name, const std::optional<double>& mass);

// Figures of the product and of the drive. If the run is steady, they are those of its steady part, with their standard
// errors. Otherwise they are those of the whole run, marked as start-up if the run is known not to be steady.
std::string throughput_line(const Summary& s);
std::string p80_line(const Summary& s);
std::string crushing_power_line(const Summary& s);
std::string specific_energy_line(const Summary& s);

std::string waiting_line(const Summary& s);
std::string escaped_line(const Summary& s);
std::string below_settings_line(const Summary& s);
std::string single_particles_line(const Summary& s);
std::string resolution_line(const Summary& s);
std::string fines_lines(const Summary& s);
std::string steady_line(const Summary& s);
std::string not_steady_line(const Summary& s);
std::string motor_line(const Summary& s);
std::string drive_event_lines(const Summary& s);
std::string particles_line(const Summary& s);
std::string bonds_line(const Summary& s);
std::string time_step_line(const Summary& s);
std::string device_line(const Summary& s);
std::string failure_line(const LaboratoryFigures& l);

}  // namespace gyro
