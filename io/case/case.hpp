// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh_frame.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/library.hpp"
#include "core/rocks/size_distribution.hpp"
#include "core/rocks/strength.hpp"
#include "core/scene/precision.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/liners.hpp"
#include "io/fmu/drive_fmu.hpp"
#include "io/rocks/shape_files.hpp"
#include "mbd/drivetrain_parameters.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gyro {

/// `case`: what the run is called and the key of all its random numbers.
struct CaseIdentity {
  std::string title;
  std::uint64_t seed = 1;
};

/// `time`.
struct CaseTime {
  double duration = 0;         ///< simulated [s]
  std::optional<double> step;  ///< [s]; none: safety x damped limit
  double safety = 0.7;         ///< step / damped limit when the step is chosen by the program [-]
};

/// One line of `contacts`: surface properties of two materials.
struct CaseContact {
  Index first = 0, second = 0;  ///< in Case::materials
  PairProperties properties;
};

/// `bonds`.
struct CaseBonds {
  BondRule rule;
  BondParameters parameters;
  BondModel model;
  std::optional<StrengthScatter> scatter;  ///< none: all bonds are equally strong
};

/// `rocks`: the library of meta-particles.
struct CaseRocks {
  ShapeSource shapes;  ///< paths are absolute
  SizeLaw sizes;
  int samples = 24;  ///< rocks in the library
  FillRule fill;
  bool density_compensated = true;  ///< particles are denser than rock, so that the rock's mass is right
};

/// `feed`. Three forms: a continuous feed (initial, rate), a batch (mass) and rocks that are placed
/// (rocks, at).
struct CaseFeed {
  double initial = 0;                 ///< mass in the chamber at t = 0 [kg]
  std::optional<double> initial_top;  ///< the initial charge lies below this height [m]
  double rate = 0;                    ///< [kg/s]
  double start = 0;                   ///< when the rate sets in or the batch is dropped [s]
  std::optional<double> mass;         ///< of the batch [kg]
  int rocks = 0;                      ///< number of rocks placed, in the library's order
  Vec3d at{0, 0, 0};                  ///< centre of mass of the first; the others are stacked above it [m]
  Index above = none;                 ///< wall above which rocks appear, in Case::walls
};

/// Shape from an STL or OBJ file, absolute path.
struct MeshFile {
  std::filesystem::path path;
  MeshFrame frame = {};
};
/// Shape of revolution from `crusher.profile`.
struct ProfileLiner {
  bool mantle = false;  ///< otherwise the concave
};

/// One entry of `walls`.
struct CaseWall {
  std::string name;
  std::variant<PlaneShape, MeshFile, ProfileLiner> shape;
  std::variant<Fixed, LinearMotion, RotationMotion, CircularMotion, GyrationMotion> motion;
  Index material = 0;  ///< in Case::materials
};

/// `crusher`.
struct CaseCrusher {
  std::filesystem::path profile;                                       ///< absolute; empty: the liners are meshes
  std::vector<LinerRow> liners;                                        ///< rows of the profile, z rising
  double closed_side_setting = 0, eccentricity = 0, pivot_height = 0;  ///< [m]
  std::optional<double> removal_depth;  ///< below the discharge plane [m]; none: chosen by the program
  std::optional<double> lid;            ///< height of the lid [m]; none: the chamber is open
};

/// Largest gap at the discharge plane over one gyration: OSS - CSS = throw = 2 x eccentricity [m].
inline double open_side_setting(const CaseCrusher& crusher) {
  return crusher.closed_side_setting + 2 * crusher.eccentricity;
}

/// `drivetrain` with an FMU.
struct CaseFmu : DriveFmu {
  double bushing_depth = 0;   ///< below the pivot; 0: it takes no forces of bearings [m]
  double residual_limit = 0;  ///< see DrivetrainParameters
};

/// `numerics`.
struct CaseNumerics {
  Precision precision = Precision::mixed;
  int substeps = 1;
};

/// `laboratory`: what a run measures on one rock between two platens.
struct CaseLaboratory {
  enum class Test { platen, brazilian, uniaxial };
  Test test = Test::platen;
  Index fixed = none, moving = none;  ///< planes, in Case::walls
};

/// A row of `particles.file`.
struct StartParticle {
  std::uint32_t id;
  Vec3d position, velocity, angular_velocity;
  double radius;
  RockId rock;  ///< as given, otherwise numbered by what the bonds hold together
};

/// A row of `particles.bonds`; i and j are rows of the particle table, i < j.
struct StartBond {
  Index i, j;
  double length;  ///< L0 [m]; the distance at the start where the file gives none
};

/// `particles`: the start state.
struct CaseParticles {
  std::filesystem::path file, bonds_file;  ///< absolute; bonds_file may be empty
  std::vector<StartParticle> particles;    ///< by rising id
  std::vector<StartBond> bonds;
};

/// `output.liners`.
struct CaseLinerMaps {
  double interval = 0;  ///< simulated time between maps [s]
  int rows = 32, sectors = 72;
  std::optional<double> wear_coefficient;  ///< Archard [1/Pa]
};

/// `output`.
struct CaseOutput {
  double series = 1e-3;      ///< simulated time between rows [s]
  double snapshots = 20e-3;  ///< simulated time between snapshots [s]; 0: none
  double checkpoints = 300;  ///< wall-clock time between checkpoints [s]; 0: only at the end
  bool vtp = true, hdf5 = false;
  std::optional<CaseLinerMaps> liners;
  std::vector<std::uint32_t> probes = {};  ///< ids of particles that the series follows
  std::vector<double> sieves = {};  ///< openings for product and hold-up, increasing [m]; empty: the default series
};

/// A checked case in SI units. A key that the file leaves out has its documented default or is absent.
struct Case {
  std::filesystem::path file;  ///< the case file, absolute
  CaseIdentity identity;
  CaseTime time;
  std::vector<Material> materials;  ///< in the order of the file
  Index rock_material = 0;          ///< the one named `rock`: all particles are made of it
  std::vector<CaseContact> contacts;
  std::optional<CaseBonds> bonds;
  std::optional<CaseRocks> rocks;
  std::optional<CaseFeed> feed;
  std::vector<CaseWall> walls;
  std::optional<CaseCrusher> crusher;
  std::optional<DrivetrainParameters> drivetrain;
  std::optional<CaseFmu> drivetrain_fmu;  ///< instead of drivetrain
  double coupling_interval = 0.5e-3;      ///< [s]
  Vec3d gravity{0, 0, -9.81};             ///< [m/s2]
  CaseNumerics numerics;
  std::optional<CaseParticles> particles;
  std::optional<CaseLaboratory> laboratory;
  CaseOutput output;
  std::string resolved;  ///< see resolved_yaml()
  std::string inputs;    ///< one line a file that it names: digest of the content, path
};

/// Something wrong with the input, and where.
struct CaseProblem {
  std::string file;  ///< as the user named it; `--set` for an override
  int line = 1;      ///< from 1; for an override which --set it is
  int column = 1;    ///< from 1
  std::string message;
};

/// A case, or every problem found in its file.
struct CaseReport {
  std::optional<Case> loaded;
  std::vector<CaseProblem> problems;
};

/// Reads and checks a case file and the tables it names. Bad input never throws.
/// @param overrides  `key.path=value` each, applied to the file's tree in order; the value is YAML,
///                   `null` leaves the key out
CaseReport load_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// FILE:LINE:COLUMN: problem; what to do
std::string to_string(const CaseProblem& problem);

/// A problem that showed only after loading, at the place of the key to blame: where the file or the last
/// override gives it, else where the closest section above it begins.
CaseProblem problem_at(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       const std::string& key, std::string message);

/// The case with every default written out: plain SI numbers, absolute paths. Reads back to the same case.
std::string resolved_yaml(const Case& checked);

/// A key with different values in two cases.
struct CaseDifference {
  std::string key;
  std::string value, other;  ///< "not there" where a case leaves it out
};

/// Where two resolved cases differ in other keys than time.duration and `output`, which a continued run may change.
std::optional<CaseDifference> difference(const std::string& resolved, const std::string& other);

/// Square table materials x materials for Scene::pairs. Pairs that cannot touch keep PairProperties' defaults.
std::vector<PairProperties> pair_table(const Case& checked);

}  // namespace gyro
