// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/run_output.hpp"

#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace gyro {
namespace {

std::vector<Channel> ledger_channels() {
  std::vector<Channel> channels{{"time", "s"}};
  for (const char* name : {"kinetic", "potential", "contact_elastic", "bond_elastic", "contact_damping", "friction",
                           "bond_damping", "bond_breakage", "wall_work", "exchanged", "energy_residual"})
    channels.push_back({name, "J"});
  channels.push_back({"momentum_residual", "N s"});
  channels.push_back({"mass_residual", "1"});
  channels.push_back({"power_residual", "W"});
  return channels;
}

/// What the run itself took: everything that two equal runs may differ in.
std::vector<Channel> performance_channels() {
  return {{"time", "s"}, {"wall_seconds", "s"}, {"particle_steps", "1"}, {"bond_steps", "1"}, {"list_rebuilds", "1"}};
}

constexpr const char* rows_prefix = "results";
constexpr std::string_view rows_suffix = "/rows";  // a group of results.h5 may hold another
constexpr const char* sums_prefix = "sums/";

/// Columns whose names begin so, by the rest of their names.
template <class T>
std::map<std::string, std::vector<T>> columns_below(const SavedState& saved, const std::string& prefix) {
  std::map<std::string, std::vector<T>> found;
  for (const auto& [name, column] : saved.columns())
    if (name.starts_with(prefix)) found[name.substr(prefix.size())] = saved.get<T>(name);
  return found;
}

ResultsRows saved_rows(const SavedState& saved) {
  ResultsRows rows;
  for (const auto& [name, count] : columns_below<std::int64_t>(saved, rows_prefix))
    rows[name.substr(0, name.size() - rows_suffix.size())] = count.at(0);
  return rows;
}

/// Intervals that are over at a time.
std::int64_t intervals(double interval, double time) {
  return interval > 0 ? static_cast<std::int64_t>(std::floor(time / interval * (1 + 1e-9))) : 0;
}

std::string probe_name(std::uint32_t id, const std::string& quantity) {
  return "probe_" + std::to_string(id) + "_" + quantity;
}

/// What is told of a sieve curve beside the curve. Shares below the settings are read between two sieves.
std::vector<Channel> curve_channels() {
  return {{"mass", "kg"}, {"fragments", "1"}, {"singles_share", "1"}, {"p80", "m"},
          {"p50", "m"},   {"below_css", "1"}, {"below_oss", "1"}};
}

std::vector<double> curve_figures(const ProductRow& row, const CaseCrusher& crusher) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto below = [&](double size) { return row.mass > 0 ? passing_at(row.passing, size) : none; };
  return {row.mass,
          static_cast<double>(row.fragments),
          row.singles_share,
          row.p80.value_or(none),
          row.p50.value_or(none),
          below(crusher.closed_side_setting),
          below(open_side_setting(crusher))};
}

PosedWall posed(const WallPicture& picture, const WallPose& pose) {
  PosedWall out{picture.mesh, picture.wall};
  for (Vec3d& v : out.mesh.vertices) v = to_world(pose, v);
  return out;
}

}  // namespace

RunOutput::RunOutput(const Case& input, const Assembly& assembly, const CaseRecord& record,
                     const std::filesystem::path& directory, const SavedState* saved)
    : input_(input),
      assembly_(assembly),
      gyrating_(gyrating_wall(assembly.setup.scene)),
      has_mantle_(gyrating_ != none),
      has_drive_(input.drivetrain || input.drivetrain_fmu),
      drive_knows_(input.drivetrain_fmu ? knowledge_of(input.drivetrain_fmu->links) : DriveKnowledge{}),
      has_bonds_(input.bonds.has_value()),
      has_feed_(input.feed.has_value()),
      has_product_(input.crusher.has_value()),
      series_(series_channels()),
      maps_(input, assembly),
      results_(saved ? ResultsFile(directory / "results.h5", content(record), saved_rows(*saved))
                     : ResultsFile(directory / "results.h5", content(record))),
      snapshots_(directory, saved ? saved->get<double>("output/snapshot_times") : std::vector<double>{}) {
  if (saved) restore(*saved);
}

std::vector<Channel> RunOutput::series_channels() const {
  using hdf5::Number;
  std::vector<Channel> c{{"time", "s"}};
  if (has_drive_) {
    if (drive_knows_.motor_speed) c.push_back({"motor_speed", "rad/s"});
    c.push_back({"eccentric_speed", "rad/s"});
    c.push_back({"eccentric_angle", "rad"});
    c.push_back({"mantle_spin", "rad/s"});
    if (drive_knows_.motor_torque) c.push_back({"motor_torque", "N m"});
    c.push_back({"mantle_torque", "N m"});
    if (drive_knows_.motor_power) c.push_back({"motor_power", "W"});
    if (drive_knows_.accounts) c.push_back({"loss_power", "W"});
  }
  if (has_mantle_) {
    c.push_back({"crushing_power", "W"});
    c.push_back({"mantle_force", "N", 3});
  }
  for (std::size_t w = 0; w < assembly_.setup.scene.walls.size(); ++w)
    if (static_cast<Index>(w) != gyrating_) c.push_back({"wall_force_" + assembly_.setup.scene.walls[w].name, "N", 3});
  if (has_feed_) c.push_back({"feed_mass", "kg"});
  if (has_product_) {
    c.push_back({"discharged_mass", "kg"});
    c.push_back({"holdup_mass", "kg"});
    c.push_back({"throughput", "kg/s"});
  }
  c.push_back({"particles", "1"});
  if (has_bonds_) {
    for (const char* name : {"bonds_intact", "bonds_broken_tension", "bonds_broken_shear", "fragments"})
      c.push_back({name, "1"});
    c.push_back({"largest_fragment", "kg"});
  }
  for (const std::uint32_t id : input_.output.probes) {
    c.push_back({probe_name(id, "position"), "m", 3});
    c.push_back({probe_name(id, "velocity"), "m/s", 3});
    c.push_back({probe_name(id, "spin"), "rad/s", 3});
  }
  c.push_back({"max_overlap_ratio", "1"});
  c.push_back({"wall_seconds", "s"});
  return c;
}

ResultsContent RunOutput::content(const CaseRecord& record) const {
  ResultsContent content;
  content.record = record;
  content.series = series_channels();
  content.ledger = ledger_channels();
  content.performance = performance_channels();
  content.breakage = has_bonds_;
  if (has_product_) content.product_sizes = sieve_series();
  content.liners = maps_.content();
  if (has_product_) content.curve_figures = curve_channels();
  return content;
}

bool RunOutput::due(double interval, std::int64_t written, double time) const {
  return interval > 0 && time >= static_cast<double>(written) * interval * (1 - 1e-9);
}

void RunOutput::begin(const Simulation& simulation) {
  if (input_.output.snapshots > 0) write_snapshot(simulation);
}

void RunOutput::take(const WindowResult& result, const Simulation& simulation) {
  add_means(result, simulation);
  time_ = simulation.time();
  maps_.take(result.wall_impulses, time_, results_);
  if (simulation.drivetrain())
    gyrations_.add(time_, result.window.length(), simulation.drivetrain()->state().angle, result.crushing_power,
                   result.holdup_mass, result.discharged_mass);
  if (has_bonds_) results_.append_breakages(result.breakages);
  if (result.inspected) write_row(simulation);
  if (due(input_.output.snapshots, frames_, time_)) write_snapshot(simulation);
}

/// Particles that are not there, because they have not been fed yet or are gone, are not a number.
void RunOutput::add_probes(const Simulation& simulation, Row& now) const {
  if (input_.output.probes.empty()) return;
  const ParticleSnapshot s = simulation.dem().particles();
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t id : input_.output.probes) {
    const auto found = std::lower_bound(s.id.begin(), s.id.end(), id);
    const bool there = found != s.id.end() && *found == id;
    const auto k = static_cast<std::size_t>(found - s.id.begin());
    const auto put = [&](const char* quantity, const std::vector<Vec3d>& values) {
      const Vec3d v = there ? values[k] : Vec3d{nowhere, nowhere, nowhere};
      now[probe_name(id, quantity)] = {v.x, v.y, v.z};
    };
    put("position", s.position);
    put("velocity", s.velocity);
    put("spin", s.angular_velocity);
  }
}

void RunOutput::add_means(const WindowResult& result, const Simulation& simulation) {
  const double length = result.window.length();
  const auto add = [&](const std::string& name, std::initializer_list<double> values) {
    std::vector<double>& sum = sums_[name];
    sum.resize(values.size(), 0);
    std::size_t k = 0;
    for (const double v : values) sum[k++] += v * length;
  };
  summed_time_ += length;
  crushing_work_ += result.load.work;
  add("crushing_power", {result.crushing_power});
  add("mantle_force", {result.mantle_force.x, result.mantle_force.y, result.mantle_force.z});
  for (std::size_t w = 0; w < result.walls.size(); ++w) {
    if (static_cast<Index>(w) == gyrating_) continue;
    const Vec3d& f = result.walls[w].force;
    add("wall_force_" + assembly_.setup.scene.walls[w].name, {f.x, f.y, f.z});
  }
  if (!simulation.drivetrain()) return;
  const DrivetrainMeans& m = simulation.drivetrain()->means();
  add("motor_speed", {m.motor_speed});
  add("eccentric_speed", {m.eccentric_speed});
  add("mantle_spin", {m.mantle_spin});
  add("motor_torque", {m.motor_torque});
  add("mantle_torque", {m.mantle_torque});
  add("motor_power", {m.motor_power});
  add("loss_power", {m.loss_power});
  add("power_residual", {m.power_residual});
}

void RunOutput::write_row(const Simulation& simulation) {
  std::map<std::string, double> now;
  const Counts counts = simulation.dem().counts();
  now["time"] = simulation.time();
  if (simulation.drivetrain()) {
    now["eccentric_angle"] = simulation.drivetrain()->state().angle;
  }
  const double fed = simulation.fed().mass;
  const double discharged = simulation.product() ? simulation.product()->state().mass : 0;
  now["feed_mass"] = fed;
  now["discharged_mass"] = discharged;
  now["holdup_mass"] = simulation.holdup();
  now["throughput"] = summed_time_ > 0 ? (discharged - discharged_before_) / summed_time_ : 0;
  discharged_before_ = discharged;
  now["particles"] = static_cast<double>(counts.particles);
  now["bonds_intact"] = static_cast<double>(counts.bonds_intact);
  now["bonds_broken_tension"] = static_cast<double>(counts.broken_tension);
  now["bonds_broken_shear"] = static_cast<double>(counts.broken_shear);
  now["fragments"] = static_cast<double>(simulation.fragments());
  now["largest_fragment"] = simulation.largest_fragment();
  now["max_overlap_ratio"] = simulation.ledger().extremes().overlap_ratio;
  now["wall_seconds"] = wall_seconds();

  Row probes;
  add_probes(simulation, probes);
  std::vector<double> row;
  for (const Channel& channel : series_) {
    const auto sum = sums_.find(channel.name);
    if (sum != sums_.end()) {
      for (const double v : sum->second) row.push_back(v / summed_time_);
    } else if (const auto probe = probes.find(channel.name); probe != probes.end()) {
      row.insert(row.end(), probe->second.begin(), probe->second.end());
    } else {
      row.push_back(now.at(channel.name));
    }
  }
  results_.append_series(row);
  write_ledger(simulation);
  results_.append_performance(
      std::vector<double>{now["time"], now["wall_seconds"], static_cast<double>(counts.particle_steps),
                          static_cast<double>(counts.bond_steps), static_cast<double>(counts.rebuilds)});
  if (simulation.product()) write_curves(simulation);
  sums_.clear();
  summed_time_ = 0;
}

void RunOutput::write_curves(const Simulation& simulation) {
  const ProductRow product = simulation.product()->row(simulation.time());
  const ProductRow held = simulation.hold_up()->row(simulation.time());
  results_.append_product(product.time, product.passing, curve_figures(product, *input_.crusher));
  results_.append_holdup(held.time, held.passing, curve_figures(held, *input_.crusher));
}

void RunOutput::write_ledger(const Simulation& simulation) {
  const EnergyTerms& e = simulation.ledger().energy();
  const auto residual = sums_.find("power_residual");
  const double power_residual = residual != sums_.end() ? residual->second[0] / summed_time_ : 0;
  const std::vector<double> row{simulation.time(),
                                e.kinetic,
                                e.potential,
                                e.contact_elastic,
                                e.bond_elastic,
                                e.contact_damping,
                                e.friction,
                                e.bond_damping,
                                e.bond_breakage,
                                e.wall_work,
                                e.exchanged,
                                e.residual(),
                                simulation.momentum().residual(),
                                static_cast<double>(simulation.mass_count().residual()),
                                power_residual};
  results_.append_ledger(row);
}

void RunOutput::write_snapshot(const Simulation& simulation) {
  const ParticleSnapshot particles = simulation.dem().particles();
  const BondSnapshot bonds = simulation.dem().bonds();
  std::vector<PosedWall> walls;
  const std::vector<WallPose> poses = simulation.dem().wall_poses();
  for (const WallPicture& picture : assembly_.pictures)
    walls.push_back(posed(picture, poses[static_cast<std::size_t>(picture.wall)]));
  snapshots_.write({simulation.time(), &particles, has_bonds_ ? &bonds : nullptr, walls});
  ++frames_;
}

double RunOutput::wall_seconds() const {
  return earlier_seconds_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RunOutput::save(SavedState& to) const {
  for (const auto& [group, rows] : results_.rows()) to.put_one(rows_prefix + group + std::string(rows_suffix), rows);
  for (const auto& [name, sum] : sums_) to.put(sums_prefix + name, sum);
  to.put("output/numbers", std::vector<double>{summed_time_, discharged_before_, crushing_work_, time_, wall_seconds(),
                                               input_.output.snapshots});
  to.put_one("output/frames", frames_);
  to.put("output/snapshot_times", snapshots_.times());
  maps_.save(to);
  gyrations_.save(to);
}

void RunOutput::restore(const SavedState& from) {
  sums_ = columns_below<double>(from, sums_prefix);
  maps_.restore(from);
  gyrations_.restore(from);
  const std::vector<double> numbers = from.get<double>("output/numbers", 6);
  summed_time_ = numbers[0];
  discharged_before_ = numbers[1];
  crushing_work_ = numbers[2];
  time_ = numbers[3];
  earlier_seconds_ = numbers[4];
  // With another interval the next frame is the first that lies ahead.
  const CaseOutput& now = input_.output;
  frames_ =
      now.snapshots == numbers[5] ? from.get_one<std::int64_t>("output/frames") : intervals(now.snapshots, time_) + 1;
}

void RunOutput::close(const Simulation& simulation) {
  if (summed_time_ > 0) write_row(simulation);
  maps_.close(results_);
  results_.close();
}

}  // namespace gyro
