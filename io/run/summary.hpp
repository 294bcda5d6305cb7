// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

enum class RunStatus {
  done,         ///< the whole duration, or up to --until
  interrupted,  ///< by a signal or --max-walltime
  stopped,      ///< by a guard or the ledger
  failed        ///< with any other error
};

/// @returns the word used in summary.json
std::string to_string(RunStatus status);

/// An event of the drive: a stall, a trip, a restart.
struct DriveHappening {
  double time = 0;  ///< [s]
  std::string what = {};
};

/// A figure and its standard error in the same unit.
struct Estimate {
  double value = 0, error = 0;
};

/// Figures of the steady part of a run, in which they no longer drift.
struct SteadyFigures {
  double from = 0;                                         ///< [s]
  std::int64_t gyrations = 0, blocks = 0;                  ///< whole gyrations since then; their blocks, for errors
  Estimate crushing_power = {};                            ///< [W]
  std::optional<Estimate> motor_power = {};                ///< [W]
  Estimate throughput_tph = {};                            ///< [t/h]
  std::optional<Estimate> specific_energy_kwh_per_t = {};  ///< crushing energy / discharged mass
  std::optional<Estimate> p80 = {}, p50 = {};              ///< sieve sizes that these shares of the product pass [m]
  std::optional<Estimate> product_below_css = {}, product_below_oss = {};  ///< mass shares of the product [-]
  std::optional<Estimate> p80_with_fines = {}, p50_with_fines = {};        ///< p80 and p50 with estimated fines [m]
  std::optional<double> residence_time = {};                               ///< hold-up / throughput [s]
};

/// The estimate of what is finer than particles, of the product of the whole run.
struct FinesFigures {
  std::string law = {};                     ///< breakage, gates_gaudin_schuhmann
  std::optional<double> p80 = {};           ///< sieve size that 80 % of the product with fines passes [m]
  std::optional<double> p50 = {};           ///< sieve size that 50 % of the product with fines passes [m]
  double share = 0;                         ///< mass share finer than the particles of its fragments [-]
  double released_energy_kwh_per_t = 0;     ///< elastic energy released by broken bonds / mass
  std::optional<double> t10 = {};           ///< mean over the mass [-]
  std::optional<double> beyond_share = {};  ///< mass share with a t10 above 40 % [-]
};

/// Mechanical power at the shaft of the motor, from rows of /series.
struct MotorFigures {
  double from = 0;                         ///< the rows that begin at this time or later are used [s]
  double mean = 0, p95 = 0, peak = 0;      ///< [W]
  std::optional<double> rated_power = {};  ///< [W]; none without a name plate
  std::optional<double> mean_fraction = {}, peak_fraction = {};  ///< of the rated power [-]
};

/// Results of a laboratory test of one rock.
struct LaboratoryFigures {
  std::string test;                                 ///< platen, brazilian, uniaxial
  double size = 0;                                  ///< distance of the platens at first contact [m]
  int broken_before = 0;                            ///< bonds that broke before the moving platen pressed
  std::optional<double> first_break_force = {};     ///< on the platens when the first bond broke [N]
  std::optional<double> middle_breaks = {};         ///< share of the first breaks in the middle third between platens
  std::optional<double> failure_force = {};         ///< largest force until failure [N]; empty: the rock did not fail
  std::optional<double> failure_displacement = {};  ///< of the platens since first contact [m]
  std::optional<double> strength = {};              ///< [Pa]
  std::optional<double> stiffness = {};             ///< slope between 20 and 60 % of the failure force [N/m]
  std::optional<double> modulus = {};               ///< uniaxial: stiffness x length / area [Pa]
};

/// The results of a run. A quantity that the case does not define, or that is not finite, is null in JSON.
struct Summary {
  RunStatus status = RunStatus::failed;
  std::string reason = {};  ///< why the run is not done, or with --until steady why it is; else empty
  std::string title = {}, version = {}, git_hash = {}, device = {}, precision = {};
  int threads = 0;
  double simulated_seconds = 0, wall_seconds = 0;
  std::optional<std::int64_t> particle_steps = {};  ///< particles in the scene, summed over steps
  std::optional<std::int64_t> bond_steps = {};      ///< intact bonds, summed over sub-steps
  double time_step = 0;                             ///< [s]
  double time_step_limit = 0;                       ///< stability limit before the safety factor [s]
  double hold = 0;                                  ///< from one evaluation of contact forces to the next [s]
  std::optional<std::int64_t> particles = {};       ///< in the scene at the end
  std::optional<std::int64_t> bonds_initial = {}, bonds_broken = {};
  std::optional<double> start_mass = {};     ///< placed by feed.initial_from, with that of `particles` [kg]
  std::optional<double> start_missing = {};  ///< found no room [kg]
  std::optional<double> feed_mass = {}, discharged_mass = {};  ///< [kg]
  std::optional<double> escaped_mass = {};                     ///< left over the rim; not a part of the product [kg]
  std::optional<double> escaped_fraction = {};                 ///< of the mass fed or present at the start [-]
  std::optional<double> feed_waiting = {};                     ///< was due but had found no room at the end [kg]
  std::optional<double> throughput_tph = {};                   ///< discharged mass / simulated time [t/h]
  std::optional<double> specific_energy_kwh_per_t = {};        ///< crushing energy / discharged mass
  std::optional<double> p80 = {};                              ///< sieve size that 80 % of the product passes [m]
  std::optional<double> p50 = {};                              ///< sieve size that 50 % of the product passes [m]
  std::optional<double> product_below_css = {};                ///< mass share of the product [-]
  std::optional<double> product_below_oss = {};                ///< mass share of the product [-]
  std::optional<double> singles_share = {};                    ///< mass share of single particles in the product [-]
  std::optional<double> resolution = {};                       ///< size of the coarsest particle that can break off [m]
  std::optional<double> finest_particle = {};                  ///< size of the finest one [m]
  std::optional<FinesFigures> fines = {};                      ///< what is finer than that; empty: it is unknown
  std::optional<double> swell_of_crumbled = {};                ///< loose volume of crumbled / volume of solid rock [-]
  std::optional<double> mean_crushing_power = {};              ///< [W]
  std::optional<double> energy_residual_fraction = {};         ///< residual / the larger of work and largest energy
  std::optional<double> momentum_residual_fraction = {};       ///< residual / impulses of walls and gravity
  std::optional<double> mass_residual_fraction = {};           ///< from particle counts
  std::optional<double> max_overlap_ratio = {};                ///< largest contact overlap / radius at window ends
  std::optional<bool> stalled = {};
  std::optional<bool> choked = {};             ///< more rock waits for room than one gyration feeds
  std::optional<double> holdup_mass = {};      ///< at the end [kg]
  std::optional<SteadyFigures> steady = {};    ///< of the steady part of the run
  std::optional<std::string> not_steady = {};  ///< why the run is not steady; empty: it is steady, or this is unknown
  std::optional<MotorFigures> motor = {};      ///< empty without a motor whose power is known
  std::optional<LaboratoryFigures> laboratory = {};
  std::vector<DriveHappening> drive_events = {};  ///< in order; empty without a drivetrain
};

/// A member of summary.json, for the reference page of outputs.
struct SummaryMember {
  std::string name;         ///< with the name of its parent: "steady.from"
  std::string units;        ///< "1" for a pure number, "-" for text, lists and yes/no values
  std::string when;         ///< when it has a value; otherwise it is null
  std::string description;  ///< one line
};
std::vector<SummaryMember> summary_members();

/// summary.json as text.
std::string to_json(const Summary& summary);

/// Text of one screen for the terminal, with only the lines that apply to this run.
std::string to_text(const Summary& summary, const std::filesystem::path& directory);

/// Writes DIRECTORY/summary.json as a whole. @throws OutputError
void write_summary(const Summary& summary, const std::filesystem::path& directory);

/// Reads all of DIRECTORY/summary.json, to print it again. Members that a file of an older version lacks stay empty.
/// @throws BadInput if it is missing or not a summary
Summary load_summary(const std::filesystem::path& directory);

/// What a later run in the same directory needs to know about an earlier one.
struct EarlierRun {
  std::string status;
  double simulated_seconds = 0;
};

/// Reads DIRECTORY/summary.json. @returns nothing if it is missing or not a summary
std::optional<EarlierRun> read_summary(const std::filesystem::path& directory);

}  // namespace gyro
