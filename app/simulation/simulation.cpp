// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/simulation.hpp"

#include "app/simulation/start_check.hpp"
#include "core/base/errors.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gyro {
namespace {

Setup checked(Setup setup) {
  check_setup(setup);
  return setup;
}

std::vector<std::string> wall_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Wall& wall : scene.walls) names.push_back(wall.name);
  return names;
}

LedgerLimits ledger_limits(const Setup& setup) {
  const Scene& scene = setup.scene;
  return {.step = scene.limits, .energy_fraction = setup.max_energy_residual, .contact_step = scene.dt};
}

/// Gives the memory that the set-up has freed back to the system. In many small pieces, the C library would keep it.
void return_free_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

/// Does `work`; bad input that it meets is the fault of this part of the setup.
template <class Work>
auto blaming_part(SetupPart part, Work&& work) {
  try {
    return work();
  } catch (const BadSetup&) {
    throw;
  } catch (const BadInput& problem) {
    throw BadSetup(part, problem.what());
  }
}

}  // namespace

Simulation::Simulation(Setup setup, std::unique_ptr<Dem> dem, std::optional<Drivetrain> drivetrain,
                       const SavedState* saved)
    : setup_(checked(std::move(setup))),
      rock_density_(setup_.scene.materials[static_cast<std::size_t>(setup_.scene.rock_material)].density),
      dem_(std::move(dem)),
      drivetrain_(std::move(drivetrain)),
      ledger_(ledger_limits(setup_), wall_names(setup_.scene)),
      thin_walls_(setup_.scene) {
  state_.time_step = setup_.scene.dt;
  state_.substeps = setup_.scene.substeps;
  state_.inspection_interval = setup_.inspection_interval;
  if (setup_.feed)
    blaming_part(SetupPart::feed,
                 [&] { feed_.emplace(setup_.library, *setup_.feed, setup_.scene.walls, setup_.bond_strength); });
  if (setup_.discharge) {
    product_.emplace(rock_density_, setup_.discharge->concave, setup_.discharge->sieves);
    hold_up_.emplace(rock_density_, setup_.discharge->sieves);
    if (setup_.discharge->fines) fines_.emplace(*setup_.discharge->fines, rock_density_, setup_.discharge->sieves);
  }
  if (saved != nullptr)
    restore(*saved);
  else
    start();
  return_free_memory();
}

/// Inserts the rock of t = 0.
void Simulation::start() {
  blaming_part(SetupPart::start, [&] {
    check_start(setup_.scene, setup_.start);
    insert(setup_.start);
    setup_.start = {};  // they are in the scene now
  });
  if (setup_.filling) blaming_part(SetupPart::feed, [&] { fill_chamber(); });
  for (const double mass : dem_->particles().mass) state_.start_mass += mass;
  if (feed_) blaming_part(SetupPart::feed, [&] { insert(feed_->initial(dem_->wall_poses(), dem_->particles())); });
  inspect();
  open_balances();
}

void Simulation::fill_chamber() {
  ChamberFilling& filling = *setup_.filling;
  filled_ =
      fill(setup_.library, filling, setup_.scene.walls, dem_->wall_poses(), dem_->particles(), setup_.bond_strength);
  insert(filled_->rocks);
  filled_->rocks = {};
  filling.pieces = {};
}

/// Steps of the next window: fewer than the longest while the exchange with the drive is too coarse.
int Simulation::steps_ahead(int max_steps) const {
  const int divisor = drivetrain_ ? drivetrain_->window_divisor() : 1;
  return std::max(1, std::min(setup_.steps_per_window / divisor, max_steps));
}

WindowResult Simulation::advance(int max_steps) {
  WindowResult result;
  result.window = {state_.step, steps_ahead(max_steps), setup_.scene.dt};

  const MantlePath path = drivetrain_ ? drivetrain_->predict(result.window) : MantlePath{};  // 1. the mantle leads
  advance_rock(result.window, path);                                                         // 2. the rock responds
  state_.step += result.window.steps;
  note_load(result, path);
  if (drivetrain_) drivetrain_->advance(result.window, result.load);  // 3. the drivetrain catches up
  close_balances(result);                                             // 4. energy and momentum must balance
  if (!verdict_) feed_rock();                                         // 5. rock is fed
  result.breakages = dem_->take_breakages();
  if (fines_) fines_->add(result.breakages);
  result.wall_impulses = dem_->take_wall_impulses();
  result.holdup_mass = holdup();
  result.discharged_mass = discharged_mass();
  const bool due = inspection_due();
  if (due) ++state_.inspections;
  result.inspected = due || verdict_;
  if (result.inspected) inspect();  // 6. fragments are counted, product is removed
  result.left = take_left();
  return result;
}

void Simulation::advance_rock(const Window& window, const MantlePath& path) {
  try {
    dem_->advance(window, path);
  } catch (const WindowGivenUp&) {
    given_up_ = true;
    throw;
  }
}

/// What the walls report, and the load of the gyrating ones on the drive.
void Simulation::note_load(WindowResult& result, const MantlePath& path) const {
  result.walls = dem_->wall_loads();
  const double length = result.window.length();
  const Index first = gyrating_wall(setup_.scene);
  if (first == none) return;
  MantleWrench rock;
  Vec3d axis{0, 0, 1};
  for (std::size_t w = 0; w < result.walls.size(); ++w) {
    const auto* motion = std::get_if<GyrationMotion>(&setup_.scene.walls[w].motion);
    if (motion == nullptr) continue;
    rock.add(result.walls[w], motion->pivot_height);
    axis = mantle_axis(*motion, path.angle + path.speed * length / 2);
  }
  result.load = mantle_load(rock, axis, drivetrain_ ? drivetrain_->bushing_depth() : 0);
  result.mantle_force = result.walls[static_cast<std::size_t>(first)].force;
  result.crushing_power = result.load.work / length;
}

void Simulation::close_balances(const WindowResult& result) {
  const double length = result.window.length();
  std::vector<Vec3d> impulses{(state_.mass_inside * length) * setup_.scene.gravity};
  for (const WallLoad& wall : result.walls) impulses.push_back(-length * wall.force);
  const Balance now = dem_->balance();
  momentum_.close(now.momentum, impulses);
  verdict_ = ledger_.close(time(), now.energy, now.extremes);
}

void Simulation::open_balances() {
  ledger_.open(dem_->energy());
  momentum_.open(dem_->momentum());
}

void Simulation::require_sound() const {
  if (verdict_) throw StoppedByGuard(*verdict_);
}

void Simulation::insert(std::span<const NewRock> rocks) {
  if (rocks.empty()) return;
  for (const NewRock& rock : rocks) {
    state_.particles_inserted += static_cast<std::int64_t>(rock.particles.size());
    if (setup_.scene.bonds) state_.bonds_inserted += static_cast<std::int64_t>(rock.bonds.size());
    if (rock.id != none && state_.step > 0) {  // the feed gives out ascending numbers
      state_.fed_rocks.push_back(rock.id);
      state_.fed_times.push_back(time());
    }
    for (const NewParticle& p : rock.particles)
      state_.mass_inside += p.density * 4 / 3 * std::numbers::pi * p.radius * p.radius * p.radius;
  }
  dem_->insert(rocks);
  if (fines_) fines_->feed(rocks);
}

void Simulation::feed_rock() {
  std::vector<NewRock> rocks;
  if (feed_ && feed_->wants(time())) rocks = feed_->due(time(), dem_->wall_poses(), dem_->particles());
  if (rocks.empty()) {
    // The state is the one with which the window was closed: the ledger takes that energy again in place of a sum over
    // all particles. The momentum balance has kept that momentum and needs nothing.
    ledger_.open(ledger_.energy());
    return;
  }
  insert(rocks);
  open_balances();
}

bool Simulation::inspection_due() const {
  const double interval = setup_.inspection_interval;
  return interval > 0 && time() >= static_cast<double>(state_.inspections + 1) * interval * (1 - 1e-9);
}

void Simulation::inspect() {
  if (inspected_at_ == state_.step || !ledger_.extremes().finite) return;
  inspected_at_ = state_.step;
  const ParticleSnapshot particles = dem_->particles();
  if (!verdict_)
    if (const auto through = thin_walls_.find(particles, dem_->wall_poses())) verdict_ = stopped_at(time(), *through);
  const FragmentTable table = fragment_table(particles);
  state_.fragments = static_cast<std::int64_t>(table.size());
  state_.largest_fragment = 0;
  for (const Fragment& f : table.rows) state_.largest_fragment = std::max(state_.largest_fragment, f.mass);
  if (product_) count_product(particles, table);
  counted_ = mass_count(product_ ? product_->inside(particles) : static_cast<std::int64_t>(particles.size()));
}

/// Counts what has left the chamber, analyses what has not, and removes what lies far below the discharge plane.
void Simulation::count_product(const ParticleSnapshot& particles, const FragmentTable& table) {
  std::vector<FragmentRecord> left = product_->update(table, particles);
  for (FragmentRecord& fragment : left) {
    fragment.time = time();
    fragment.fed = fed_at(fragment.rock);
  }
  hold_up_->update(table, particles, *product_);
  if (fines_) fines_->update(table, particles, left, *product_, *hold_up_);
  left_.insert(left_.end(), left.begin(), left.end());
  const std::vector<ParticleId> gone = product_->removable(table, particles, setup_.discharge->removal_depth);
  if (gone.empty()) return;
  for (std::size_t n = 0; n < particles.size(); ++n)
    if (std::binary_search(gone.begin(), gone.end(), particles.id[n])) state_.mass_inside -= particles.mass[n];
  dem_->remove(gone);
  if (fines_) fines_->remove(gone, particles);
  open_balances();
}

std::vector<FragmentRecord> Simulation::fragments_inside(const ParticleSnapshot& particles) const {
  std::vector<FragmentRecord> inside;
  if (!ledger_.extremes().finite) return inside;
  const FragmentTable table = fragment_table(particles);
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (product_ && product_->has_left(particles.id[static_cast<std::size_t>(table.rows[row].first_particle)]))
      continue;
    inside.push_back(record_of(table, row, particles, rock_density_));
    inside.back().time = time();
    inside.back().fed = fed_at(inside.back().rock);
  }
  return inside;
}

double Simulation::fed_at(RockId rock) const {
  const auto found = std::lower_bound(state_.fed_rocks.begin(), state_.fed_rocks.end(), rock);
  if (found == state_.fed_rocks.end() || *found != rock) return 0;
  return state_.fed_times[static_cast<std::size_t>(found - state_.fed_rocks.begin())];
}

double Simulation::discharged_mass() const {
  return product_ ? product_->state().mass : 0;
}

double Simulation::escaped_mass() const {
  return product_ ? product_->state().escaped_mass : 0;
}

double Simulation::escaped_fraction() const {
  const double all = state_.start_mass + fed().mass;
  return all > 0 ? escaped_mass() / all : 0;
}

double Simulation::holdup() const {
  return state_.start_mass + fed().mass - discharged_mass() - escaped_mass();
}

bool Simulation::choked() const {
  if (!feed_ || !drivetrain_ || !(setup_.feed->rate > 0)) return false;
  const double speed = drivetrain_->idle_speed();
  return fed().waiting > setup_.feed->rate * 2 * std::numbers::pi / speed;
}

FeedAccount Simulation::fed() const {
  return feed_ ? feed_->account() : FeedAccount{};
}

MassCount Simulation::mass_count(std::int64_t inside) const {
  MassCount count;
  count.fed = state_.particles_inserted;
  count.inside = inside;
  if (product_) {
    count.discharged = product_->state().particles;
    count.escaped = product_->state().escaped_particles;
  }
  return count;
}

MassCount Simulation::mass_count() const {
  if (given_up_) return counted_;
  return mass_count(product_ ? product_->inside(dem_->particles()) : dem_->counts().particles);
}

SavedState Simulation::save() const {
  SavedState s = dem_->save();
  s.put_one("simulation", state_);
  if (drivetrain_) {
    s.put_one("drivetrain", drivetrain_->state());
    s.put("drivetrain/drive", drivetrain_->drive_state());
  }
  if (feed_) s.put_one("feed", feed_->state());
  if (product_) s.put_one("product", product_->state());
  if (hold_up_) s.put_one("hold_up", hold_up_->state());
  if (fines_) s.put_one("fines", fines_->state());
  s.put_one("ledger", ledger_.state());
  s.put_one("momentum", momentum_.state());
  return s;
}

void Simulation::restore(const SavedState& s) {
  const State now = state_;
  state_ = s.get_one<State>("simulation");
  if (state_.time_step != now.time_step)
    throw BadInput("was written with a time step of " + std::to_string(state_.time_step * 1e6) + " us, not of " +
                   std::to_string(now.time_step * 1e6) +
                   " us; resume with the program and the input files that wrote it");
  if (state_.substeps != now.substeps)
    throw BadInput("was written with " + std::to_string(state_.substeps) + " sub-steps, not with " +
                   std::to_string(now.substeps) + "; resume with the program and the input files that wrote it");
  if (state_.inspection_interval != now.inspection_interval) {  // the next inspection is the first one ahead
    const double interval = state_.inspection_interval = now.inspection_interval;
    state_.inspections = interval > 0 ? static_cast<std::int64_t>(std::floor(time() / interval * (1 + 1e-9))) : 0;
  }
  setup_.start = {};  // the saved state has the rock that is still there
  if (setup_.filling) setup_.filling->pieces = {};
  dem_->restore(s);
  if (drivetrain_)
    drivetrain_->restore(s.get_one<DrivetrainState>("drivetrain"), s.get<std::uint8_t>("drivetrain/drive"));
  if (feed_) feed_->restore(s.get_one<Feed::State>("feed"));
  if (product_)
    product_.emplace(rock_density_, setup_.discharge->concave, setup_.discharge->sieves,
                     s.get_one<Product::State>("product"));
  if (hold_up_) hold_up_.emplace(rock_density_, setup_.discharge->sieves, s.get_one<HoldUp::State>("hold_up"));
  if (fines_)
    fines_.emplace(*setup_.discharge->fines, rock_density_, setup_.discharge->sieves, s.get_one<Fines::State>("fines"));
  ledger_.restore(s.get_one<Ledger::State>("ledger"));
  momentum_.restore(s.get_one<MomentumBalance::State>("momentum"));
  counted_ = mass_count();
}

}  // namespace gyro
