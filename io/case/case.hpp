// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fines_law.hpp"
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

/// `case`: the title of the run and the seed of all its random numbers.
struct CaseIdentity {
  std::string title;
  std::uint64_t seed = 1;
};

/// `time`.
struct CaseTime {
  double duration = 0;         ///< simulated [s]
  std::optional<double> step;  ///< [s]; none: safety x stability limit with damping
  double safety = 0.7;         ///< largest step / stability limit with damping [-]
};

/// One entry of `contacts`: the surface properties of two materials.
struct CaseContact {
  Index first = 0, second = 0;  ///< indices in Case::materials
  PairProperties properties;
};

/// `bonds`.
struct CaseBonds {
  BondRule rule;
  BondParameters parameters;
  BondModel model;
  std::optional<StrengthScatter> scatter;  ///< none: all bonds have the strength factor 1
};

/// `rocks`: the library of meta-particles.
struct CaseRocks {
  ShapeSource shapes;  ///< paths are absolute
  SizeLaw sizes;
  int samples = 24;  ///< number of rocks in the library
  FillRule fill;
  bool density_compensated = true;  ///< particles are denser than rock, so that a rock has the mass of solid rock
};

/// `feed`, in one of three forms: a continuous feed (initial, rate), a batch (mass), or rocks placed at a point (rocks,
/// at).
struct CaseFeed {
  double initial = 0;                  ///< mass in the chamber at t = 0 [kg]
  std::optional<double> initial_top;   ///< the initial charge lies below this height [m]
  std::filesystem::path initial_from;  ///< checkpoint of the run whose hold-up fills the chamber; empty: none
  double rate = 0;                     ///< [kg/s]
  double start = 0;                    ///< time at which the feed starts or the batch is dropped [s]
  std::optional<double> mass;          ///< of the batch [kg]
  int rocks = 0;                       ///< number of rocks placed, in the order of the library
  Vec3d at{0, 0, 0};                   ///< centre of mass of the first rock; the others are stacked above it [m]
  Index above = none;                  ///< wall above which rocks appear, index in Case::walls
};

/// Shape from an STL or OBJ file; the path is absolute.
struct MeshFile {
  std::filesystem::path path;
  MeshFrame frame = {};
};
/// Shape of revolution from `crusher.profile`.
struct ProfileLiner {
  bool mantle = false;  ///< false: the concave
};

/// One entry of `walls`.
struct CaseWall {
  std::string name;
  std::variant<PlaneShape, MeshFile, ProfileLiner> shape;
  std::variant<Fixed, LinearMotion, RotationMotion, CircularMotion, GyrationMotion> motion;
  Index material = 0;  ///< index in Case::materials
};

/// `crusher`.
struct CaseCrusher {
  std::filesystem::path profile;                                       ///< absolute; empty: the liners are meshes
  std::vector<LinerRow> liners;                                        ///< rows of the profile, by increasing z
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
  double bushing_depth = 0;  ///< depth of the bushings below the pivot; 0: the FMU has no inputs for bearing forces [m]
  double residual_limit = 0;  ///< see DrivetrainParameters
};

/// `numerics.levels` with rigid rocks; as RigidLevel.
struct CaseRigidRocks {
  bool pieces = false;                                                                      ///< also of broken rocks
  double bonded_above = RigidLevel{}.bonded_above, rigid_below = RigidLevel{}.rigid_below;  ///< [-]
  double calm_time = RigidLevel{}.calm_time;                                                ///< [s]
};

/// `numerics`.
struct CaseNumerics {
  Precision precision = Precision::mixed;
  int substeps = 1;                 ///< of all rocks, unless there is a hold
  std::optional<double> hold = {};  ///< largest step of contacts [s]; 0: chosen by the program
  std::optional<CaseRigidRocks> rigid = {};
};

/// `laboratory`: a test of one rock between two platens.
struct CaseLaboratory {
  enum class Test { platen, brazilian, uniaxial };
  Test test = Test::platen;
  Index fixed = none, moving = none;  ///< planes, indices in Case::walls
};

/// A row of `particles.file`, in SI units.
struct StartParticle {
  std::uint32_t id;
  Vec3d position, velocity, angular_velocity;
  double radius;
  RockId rock;  ///< as given; without a column `rock`, the number of the set of particles that bonds hold together
};

/// A row of `particles.bonds`; i < j are indices in CaseParticles::particles.
struct StartBond {
  Index i, j;
  double length;  ///< L0 [m]; the distance at the start if the file does not give it
};

/// `particles`: the start state.
struct CaseParticles {
  std::filesystem::path file, bonds_file;  ///< absolute; bonds_file is empty if there is none
  std::vector<StartParticle> particles;    ///< by increasing id
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
  std::vector<std::uint32_t> probes = {};  ///< ids of particles whose motion the series records
  std::vector<double> sieves = {};     ///< openings for product and hold-up, increasing [m]; empty: the default series
  std::optional<FinesLaw> fines = {};  ///< none: product finer than the particles is not estimated
};

/// A checked case in SI units. A key that the file leaves out has its documented default, or its member is empty.
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
  std::string inputs;    ///< one line for each file that the case names: digest of its content, path
};

/// A problem of the input, and its place.
struct CaseProblem {
  std::string file;  ///< as the user named it; `--set` for an override
  int line = 1;      ///< from 1; for an override the number of the --set
  int column = 1;    ///< from 1
  std::string message;
};

/// A case, or all problems found in its files.
struct CaseReport {
  std::optional<Case> loaded;
  std::vector<CaseProblem> problems;
};

/// Reads and checks a case file and the tables that it names. Bad input becomes a problem and is never thrown.
/// @param overrides  each is `key.path=value`; they are applied in order to the file's tree. The value is YAML; `null`
///                   removes the key
CaseReport load_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// FILE:LINE:COLUMN: problem; what to do
std::string to_string(const CaseProblem& problem);

/// A problem that was found only after loading, with the place of the key that caused it: where the file or the last
/// override gives the key, or else where the closest section above it begins.
CaseProblem problem_at(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       const std::string& key, std::string message);

/// The case with every default written out, with plain SI numbers and absolute paths. Loading it gives the same case.
std::string resolved_yaml(const Case& checked);

/// A key with different values in two cases.
struct CaseDifference {
  std::string key;
  std::string value, other;  ///< in the two cases; "absent" where a case leaves it out
};

/// The first key in which two resolved cases differ. Keys that a continued run may change are not compared:
/// time.duration, output.series, output.snapshots and output.checkpoints.
std::optional<CaseDifference> difference(const std::string& resolved, const std::string& other);

/// The first key at or below `section` (as "materials.rock") in which two resolved cases differ.
std::optional<CaseDifference> difference_in(const std::string& section, const std::string& resolved,
                                            const std::string& other);

/// Whether a resolved case has a section or a key, as "crusher".
bool has_key(const std::string& resolved, const std::string& key);

/// Square table materials x materials for Scene::pairs. Pairs without an entry in `contacts` keep the defaults of
/// PairProperties.
std::vector<PairProperties> pair_table(const Case& checked);

}  // namespace gyro
