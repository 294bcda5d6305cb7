// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/simulation.hpp"

#include "app/simulation/bad_key.hpp"
#include "core/base/errors.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <numbers>

namespace gyro {

template <>
struct RowOf<DrivetrainState> : MadeOf<double> {};

namespace {

double rock_density(const Assembly& assembly) {
  return assembly.scene.materials[static_cast<std::size_t>(assembly.scene.rock_material)].density;
}

/// Of the bushings, below the pivot; 0 where nobody asks for the forces on them [m].
double bushing_depth(const Case& input) {
  if (input.drivetrain) return input.drivetrain->bearings.depth;
  return input.drivetrain_fmu ? input.drivetrain_fmu->bushing_depth : 0;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Wall& wall : scene.walls) names.push_back(wall.name);
  return names;
}

LedgerLimits ledger_limits(const Scene& scene) {
  return {.step = scene.limits, .contact_step = scene.substeps * scene.dt};
}

}  // namespace

Simulation::Simulation(const Case& input, const Assembly& assembly, std::unique_ptr<Dem> dem)
    : input_(input),
      assembly_(assembly),
      dem_(std::move(dem)),
      ledger_(ledger_limits(assembly.scene), wall_names(assembly.scene)),
      thin_walls_(assembly.scene) {
  make_parts();
  blaming("particles", [&] { put_in(assembly.start); });
  for (const double mass : dem_->particles().mass) start_mass_ += mass;
  if (feed_) blaming("feed", [&] { put_in(feed_->initial(dem_->wall_poses(), dem_->particles())); });
  inspect();
  open_balances();
}

Simulation::Simulation(const Case& input, const Assembly& assembly, std::unique_ptr<Dem> dem, const SavedState& saved)
    : input_(input),
      assembly_(assembly),
      dem_(std::move(dem)),
      ledger_(ledger_limits(assembly.scene), wall_names(assembly.scene)),
      thin_walls_(assembly.scene) {
  make_parts();
  restore(saved);
}

/// What a case has besides the DEM, at its start.
void Simulation::make_parts() {
  if (input_.drivetrain) blaming("drivetrain", [&] { drivetrain_.emplace(*input_.drivetrain); });
  if (input_.drivetrain_fmu)
    blaming("drivetrain.fmu",
            [&] { drivetrain_.emplace(open_drive(*input_.drivetrain_fmu), input_.drivetrain_fmu->residual_limit); });
  if (assembly_.feed)
    blaming("feed",
            [&] { feed_.emplace(assembly_.library, *assembly_.feed, assembly_.scene.walls, bond_strength(input_)); });
  if (!input_.crusher) return;
  product_.emplace(rock_density(assembly_));
  hold_up_.emplace(rock_density(assembly_));
}

/// Steps of the next window: fewer than the case asks while the exchange with the drive is too coarse, but whole holds.
int Simulation::steps_ahead() const {
  const int whole = assembly_.step.per_window, hold = input_.numerics.substeps;
  const int divisor = drivetrain_ ? drivetrain_->window_divisor() : 1;
  return std::max(hold, whole / divisor / hold * hold);
}

WindowResult Simulation::advance() {
  WindowResult result;
  result.window = {step_, steps_ahead(), assembly_.scene.dt};

  const MantlePath path = drivetrain_ ? drivetrain_->predict(result.window) : MantlePath{};  // 1. the mantle leads
  dem_->advance(result.window, path);                                                        // 2. the rock answers
  step_ += result.window.steps;
  result.walls = dem_->wall_loads();
  if (assembly_.gyrating != none) {
    result.load = mantle_load(result.walls, path, result.window.length());
    result.mantle_force = result.walls[static_cast<std::size_t>(assembly_.gyrating)].force;
    result.crushing_power = result.load.work / result.window.length();
  }
  if (drivetrain_) drivetrain_->advance(result.window, result.load);  // 3. the drivetrain catches up
  close_balances(result);                                             // 4. energy and momentum must balance
  if (!verdict_) feed_rock();                                         // 5. rock comes
  return result;
}

/// The rock's work on all gyrating walls, and its torques by virtual work: T_c = -M_O . (z - (z . u) u) about the
/// eccentric's axis, T_s = M_O . u about the mantle's, with M_O the mean moment about the pivot and u of mid-window.
MantleLoad Simulation::mantle_load(const std::vector<WallLoad>& walls, const MantlePath& path, double length) const {
  MantleLoad load;
  Vec3d force{0, 0, 0}, torque{0, 0, 0}, u{0, 0, 1};
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto* motion = std::get_if<GyrationMotion>(&assembly_.scene.walls[w].motion);
    if (motion == nullptr) continue;
    load.work += walls[w].work;
    force += walls[w].force;
    torque += walls[w].torque - cross(Vec3d{0, 0, motion->pivot_height}, walls[w].force);
    u = mantle_axis(*motion, path.angle + path.speed * length / 2);
  }
  load.resisting_torque = -dot(torque, Vec3d{0, 0, 1} - u.z * u);
  load.spin_torque = dot(torque, u);
  if (const double depth = bushing_depth(input_); depth > 0) load.bearings = bearing_forces(force, torque, u, depth);
  return load;
}

void Simulation::close_balances(const WindowResult& result) {
  const double length = result.window.length();
  std::vector<Vec3d> impulses{(mass_inside_ * length) * assembly_.scene.gravity};
  for (const WallLoad& wall : result.walls) impulses.push_back(-length * wall.force);
  momentum_.close(dem_->momentum(), impulses);
  verdict_ = ledger_.close(time(), dem_->energy(), dem_->extremes());
}

void Simulation::open_balances() {
  ledger_.open(dem_->energy());
  momentum_.open(dem_->momentum());
}

void Simulation::require_sound() const {
  if (verdict_) throw StoppedByGuard(*verdict_);
}

void Simulation::put_in(std::span<const NewRock> rocks) {
  if (rocks.empty()) return;
  for (const NewRock& rock : rocks) {
    particles_put_in_ += static_cast<std::int64_t>(rock.particles.size());
    bonds_put_in_ += static_cast<std::int64_t>(rock.bonds.size());
    for (const NewParticle& p : rock.particles)
      mass_inside_ += p.density * 4 / 3 * std::numbers::pi * p.radius * p.radius * p.radius;
  }
  dem_->insert(rocks);
}

void Simulation::feed_rock() {
  if (feed_ && feed_->wants(time())) put_in(feed_->due(time(), dem_->wall_poses(), dem_->particles()));
  open_balances();
}

void Simulation::inspect() {
  const ParticleSnapshot particles = dem_->particles();
  if (!verdict_)
    if (const auto through = thin_walls_.find(particles, dem_->wall_poses())) verdict_ = stopped_at(time(), *through);
  const FragmentTable table = fragment_table(particles);
  fragments_ = static_cast<std::int64_t>(table.size());
  largest_fragment_ = 0;
  for (const Fragment& f : table.rows) largest_fragment_ = std::max(largest_fragment_, f.mass);
  if (!product_) return;
  product_->update(table, particles);
  hold_up_->update(table, particles, *product_);
  const std::vector<ParticleId> gone = product_->removable(table, particles, assembly_.removal_depth);
  if (gone.empty()) return;
  for (std::size_t n = 0; n < particles.size(); ++n)
    if (std::binary_search(gone.begin(), gone.end(), particles.id[n])) mass_inside_ -= particles.mass[n];
  dem_->remove(gone);
  open_balances();
}

double Simulation::holdup() const {
  return start_mass_ + fed().mass - (product_ ? product_->state().mass : 0);
}

bool Simulation::choked() const {
  if (!feed_ || !drivetrain_ || !assembly_.feed || !(assembly_.feed->rate > 0)) return false;
  const double speed = drivetrain_->idle_speed();
  return fed().waiting > assembly_.feed->rate * 2 * std::numbers::pi / speed;
}

FeedAccount Simulation::fed() const {
  return feed_ ? feed_->account() : FeedAccount{};
}

MassCount Simulation::mass_count() const {
  MassCount count;
  count.fed = particles_put_in_;
  count.inside = dem_->counts().particles;
  if (product_) {
    count.discharged = product_->state().particles;
    count.inside = product_->inside(dem_->particles());
  }
  return count;
}

SavedState Simulation::save() const {
  SavedState s = dem_->save();
  s.put_one("simulation/time_step", assembly_.scene.dt);
  s.put_one("simulation/step", step_);
  s.put("simulation/counts", std::vector<std::int64_t>{particles_put_in_, bonds_put_in_, fragments_});
  s.put("simulation/mass", std::vector<double>{start_mass_, mass_inside_, largest_fragment_});
  if (drivetrain_) s.put_one("drivetrain/state", drivetrain_->state());
  if (input_.drivetrain_fmu) s.put("drivetrain/fmu", drivetrain_->drive_state());
  if (feed_) s.put_fields("feed", feed_->state());
  if (product_) s.put_fields("product", product_->state());
  if (hold_up_) s.put_fields("hold_up", hold_up_->state());
  ledger_.save(s);
  momentum_.save(s);
  return s;
}

void Simulation::restore(const SavedState& s) {
  const auto dt = s.get_one<double>("simulation/time_step");
  if (dt != assembly_.scene.dt)
    throw BadInput("was written with a time step of " + std::to_string(dt * 1e6) + " us, not of " +
                   std::to_string(assembly_.scene.dt * 1e6) + " us; the same program and input files are accepted");
  dem_->restore(s);
  step_ = s.get_one<std::int64_t>("simulation/step");
  const auto counts = s.get<std::int64_t>("simulation/counts", 3);
  particles_put_in_ = counts[0];
  bonds_put_in_ = counts[1];
  fragments_ = counts[2];
  const auto mass = s.get<double>("simulation/mass", 3);
  start_mass_ = mass[0];
  mass_inside_ = mass[1];
  largest_fragment_ = mass[2];
  std::vector<std::uint8_t> fmu;
  if (input_.drivetrain_fmu) fmu = s.get<std::uint8_t>("drivetrain/fmu");
  if (drivetrain_) drivetrain_->restore(s.get_one<DrivetrainState>("drivetrain/state"), fmu);
  if (feed_) feed_->restore(s.get_fields<Feed::State>("feed"));
  if (product_) product_.emplace(rock_density(assembly_), s.get_fields<Product::State>("product"));
  if (hold_up_) hold_up_.emplace(rock_density(assembly_), s.get_fields<HoldUp::State>("hold_up"));
  ledger_.restore(s);
  momentum_.restore(s);
}

}  // namespace gyro
