// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/summary.hpp"

#include <optional>
#include <string>

/// Lines of the summary on the terminal; empty where they say nothing about this run.
namespace gyro {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// "  name                value".
std::string line(const char* name, const std::string& value);

/// A line with a scaled number and what follows it; empty without the number.
std::string number_line(const char* name, const std::optional<double>& value, double scale, const char* unit,
                        int digits = 4);

/// Masses in t, kg or g, as fits.
std::string mass_line(const char* name, const std::optional<double>& mass);

// Figures of the product and of the drive: since the run is steady, with their standard errors; else of the whole run,
// and called those of a start-up where the run is not steady.
std::string throughput_line(const Summary& s);
std::string p80_line(const Summary& s);
std::string crushing_power_line(const Summary& s);
std::string specific_energy_line(const Summary& s);

std::string waiting_line(const Summary& s);
std::string escaped_line(const Summary& s);
std::string below_settings_line(const Summary& s);
std::string single_particles_line(const Summary& s);
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
