// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/math/regression.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double gravity = 9.81, d = 0.005;  // [m/s2]; mean diameter of the grains [m]
constexpr double dt = 1.5e-4;                // [s]
constexpr int tick = 150;                    // steps in which a grain falls from rest by d/2
constexpr double spacing = 1.12 * d;         // of the lattice on which grains start [m]
constexpr double loose = 1.55;               // height of that lattice / height of the filling after it has settled

/// Grains of diameter d (1 +- 0.1) in a flat-bottomed cylinder 2.5 times as wide as its round orifice. Grains that
/// leave are replaced on top, so that the flow is steady and can be averaged for any time.
class Silo {
 public:
  /// Fills the silo loosely and runs until the filling has settled; the orifice is open from the start.
  /// @param orifice  its diameter [m]  @param filling  approximate height after settling [m]
  Silo(double orifice, double filling, Precision precision);

  /// Runs for a number of ticks. @return the mean mass flow [kg/s]
  double flow(int ticks);
  /// Mass of grains per volume at heights of 0.5 to 1.5 orifice diameters [kg/m3].
  double bulk_density();
  /// Height that the filling would have with this density throughout [m].
  double level();

 private:
  struct Left {
    std::size_t grains = 0;
    double mass = 0;  ///< [kg]
  };
  Left advance();
  void pour(std::size_t grains);
  NewRock grain_at(const Vec3d& position, double downward);
  double mass_between(double low, double high);

  double orifice_, wall_;     // diameter, radius of the cylinder [m]
  double top_;                // height at which grains are replaced [m]
  std::vector<Vec3d> cells_;  // positions of the lattice across the cylinder, z = 0
  std::size_t first_cell_ = 0;
  ParticleId next_ = 0;
  Stage stage_;
};

/// Grains with a Young's modulus of 1 MPa; README.md gives the effect of their softness on the flow.
Scene silo_scene(double orifice, double wall) {
  const Material soft = elastic(1e6, 0.3, rock_density);
  Scene scene = scene_of(soft, soft, {0.5, 0.5, 0}, dt);
  scene.gravity = {0, 0, -gravity};
  scene.walls = {{"silo", ProfileShape{{{0.5 * orifice, 0}, {wall, 0}, {wall, 100 * orifice}}}, Fixed{}, 1}};
  return scene;
}

Silo::Silo(double orifice, double filling, Precision precision)
    : orifice_(orifice),
      wall_(1.25 * orifice),
      top_(filling + 4 * d),
      stage_(silo_scene(orifice, 1.25 * orifice), precision) {
  const int across = static_cast<int>(wall_ / spacing), layers = static_cast<int>(loose * filling / spacing);
  for (int j = -across; j <= across; ++j)
    for (int i = -across; i <= across; ++i)
      if (std::hypot(i, j) * spacing < wall_ - 0.6 * d) cells_.push_back({spacing * i, spacing * j, 0});
  std::vector<NewRock> grains;
  for (int k = 0; k < layers; ++k)
    for (const Vec3d& at : cells_) grains.push_back(grain_at(at + Vec3d{0, 0, spacing * (k + 0.6)}, 0));
  stage_.insert(grains);
  const double settling = 1.5 * std::sqrt(2 * (loose - 1) * filling / gravity);
  while (stage_.time() < settling) advance();
}

NewRock Silo::grain_at(const Vec3d& position, double downward) {
  const ParticleId id = next_++;
  const auto r = [&](std::uint32_t draw) { return random_number(id, draw); };
  return sphere(id, position, 0.1 * Vec3d{r(0), r(1), r(2)} - Vec3d{0, 0, downward}, 0.5 * d * (1 + 0.1 * r(3)),
                rock_density);
}

/// Runs for a tick and removes the grains that are then below the orifice.
Silo::Left Silo::advance() {
  stage_.advance(tick);
  const ParticleSnapshot s = stage_.dem().particles();
  std::vector<ParticleId> gone;
  double mass = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (s.position[k].z > -d) continue;
    gone.push_back(s.id[k]);
    mass += s.mass[k];
  }
  stage_.dem().remove(gone);
  return {gone.size(), mass};
}

/// Inserts grains all over the section of the cylinder. They fall fast enough to make room for those of the next tick.
void Silo::pour(std::size_t grains) {
  if (grains == 0) return;
  if (grains > cells_.size()) throw std::logic_error("silo: more grains leave in a tick than there is room for on top");
  const std::size_t stride = cells_.size() / grains;
  std::vector<NewRock> poured;
  for (std::size_t k = 0; k < grains; ++k)
    poured.push_back(grain_at(cells_[(first_cell_ + k * stride) % cells_.size()] + Vec3d{0, 0, top_}, 0.5));
  first_cell_ += 37;
  stage_.insert(poured);
}

double Silo::flow(int ticks) {
  double mass = 0;
  for (int k = 0; k < ticks; ++k) {
    const Left left = advance();
    mass += left.mass;
    pour(left.grains);
  }
  return mass / (ticks * tick * dt);
}

double Silo::mass_between(double low, double high) {
  const ParticleSnapshot s = stage_.dem().particles();
  double sum = 0;
  for (std::size_t k = 0; k < s.size(); ++k)
    if (s.position[k].z > low && s.position[k].z < high) sum += s.mass[k];
  return sum;
}

double Silo::bulk_density() {
  return mass_between(0.5 * orifice_, 1.5 * orifice_) / (pi * wall_ * wall_ * orifice_);
}

double Silo::level() {
  return mass_between(0, 2 * top_) / (pi * wall_ * wall_ * bulk_density());
}

struct Outflow {
  double rate, bulk_density, level;  ///< [kg/s], [kg/m3], height of the filling / orifice diameter [-]
};

/// Flow of a silo, measured during `ticks` ticks after 8 ticks in which it becomes steady.
/// @param diameters  of the orifice, in d  @param filling  height in orifice diameters
Outflow outflow(int diameters, double filling, int ticks, Precision precision) {
  const double orifice = diameters * d;
  Silo silo(orifice, filling * orifice, precision);
  silo.flow(8);
  const double rate = silo.flow(ticks);
  return {rate, silo.bulk_density(), silo.level() / orifice};
}

/// Factor of a small orifice on the flow that is proportional to (D - d)^(5/2):
///   1 - exp(-b (D/d - 1))/2 with b = 0.051 (Mankoc et al., Granular Matter 9 (2007) 407).
double small_orifice(int diameters) {
  return 1 - 0.5 * std::exp(-0.051 * (diameters - 1));
}

/// Beverloo's factor at each orifice size, and the exponent over all sizes after division by the factor of small
/// orifices; without this division and with k = 1.4 the exponent is larger (README.md).
void silo(Recorder& out) {
  struct Size {
    int diameters, ticks;
  };
  constexpr std::array<Size, 3> sizes{{{8, 32}, {10, 16}, {12, 16}}};
  constexpr double filling = 2.8;  // height / orifice diameter, before the filling becomes dense
  const std::string law = "Beverloo (1961): C rho_b sqrt(g) (D - k d)^2.5, C 0.58, k 1.4";
  std::array<double, sizes.size()> rate{}, width{}, flow_of_large{};
  for (std::size_t n = 0; n < sizes.size(); ++n) {
    const Outflow flow = outflow(sizes[n].diameters, filling, sizes[n].ticks, out.precision());
    rate[n] = flow.rate;
    const std::string name = "at-" + std::to_string(sizes[n].diameters) + "-diameters";
    const double whole = std::sqrt(gravity) * std::pow((sizes[n].diameters - 1.4) * d, 2.5);
    out.relative(name + "-factor", flow.rate / (flow.bulk_density * whole), 0.58, {0.15, 0.15}, law);
    width[n] = std::log(sizes[n].diameters - 1.0);
    flow_of_large[n] = std::log(flow.rate / (flow.bulk_density * small_orifice(sizes[n].diameters)));
    out.within(name + "-level", flow.level, 2, 3, "filled higher than two orifices");
  }
  out.absolute("power", regression_slope(width, flow_of_large).value(), 2.5, {0.1, 0.1},
               "Mankoc et al. (2007): (D - d)^2.5 (1 - exp(-0.051 (D/d - 1))/2)");
  const double high = outflow(sizes[0].diameters, 2 * filling, 24, out.precision()).rate;
  out.relative("filled-twice-as-high", high, rate[0], {0.05, 0.05},
               "flow does not depend on the height of the filling");
}

}  // namespace

std::vector<Verification> generic_silo_cases() {
  return {{"generic/silo", silo, Precisions::double_only, When::nightly}};
}

}  // namespace gyro::verify
