// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/run_output.hpp"

#include "core/scene/wall_motion.hpp"

#include <cmath>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

namespace gyro {
namespace {

constexpr std::string_view marks_prefix = "results";
constexpr const char* with_fines_name = "gyrations_with_fines";
constexpr std::string_view rows_suffix = "/rows", digests_suffix = "/digests";  // a group may hold another

/// A line for each channel: its digest and its name.
std::string lines_of_digests(const GroupMark& mark) {
  std::string lines;
  for (const auto& [channel, digest] : mark.digests) lines += digest + " " + channel + "\n";
  return lines;
}

std::map<std::string, std::string> read_digests(const std::string& text) {
  std::map<std::string, std::string> digests;
  std::istringstream lines(text);
  for (std::string digest, channel; lines >> digest && std::getline(lines.ignore(1), channel);)
    digests[channel] = digest;
  return digests;
}

ResultsMarks saved_marks(const SavedState& saved) {
  ResultsMarks marks;
  for (const auto& [name, column] : saved.columns()) {
    if (!name.starts_with(marks_prefix) || !name.ends_with(rows_suffix)) continue;
    const std::string group = name.substr(marks_prefix.size(), name.size() - marks_prefix.size() - rows_suffix.size());
    marks[group] = {saved.get_one<std::int64_t>(name),
                    read_digests(saved.get_text(std::string(marks_prefix) + group + std::string(digests_suffix)))};
  }
  return marks;
}

/// Number of intervals that are complete at a time.
std::int64_t intervals(double interval, double time) {
  return interval > 0 ? static_cast<std::int64_t>(std::floor(time / interval * (1 + 1e-9))) : 0;
}

/// Whether another interval is complete.
bool due(double interval, std::int64_t counted, double time) {
  return interval > 0 && time >= static_cast<double>(counted) * interval * (1 - 1e-9);
}

PosedWall posed(const WallPicture& picture, const WallPose& pose) {
  PosedWall out{picture.mesh, picture.wall, {}};
  for (Vec3d& v : out.mesh.vertices) v = to_world(pose, v);
  return out;
}

}  // namespace

RunOutput::RunOutput(const Case& input, const Assembly& assembly, const CaseRecord& record,
                     const std::filesystem::path& directory, RequireOwn require_own, const SavedState* saved)
    : input_(input),
      assembly_(assembly),
      state_(saved ? saved->get_one<State>("output") : State{}),
      rows_(input, output_form(input, assembly), assembly.resolution),
      maps_(input, assembly),
      require_own_(std::move(require_own)),
      results_(saved ? ResultsFile(directory / "results.h5", content(record), saved_marks(*saved))
                     : ResultsFile(directory / "results.h5", content(record))) {
  if (input.output.vtp) snapshots_.emplace(directory, state_.snapshot_times);
  if (input.output.hdf5) fields_.emplace(directory, state_.snapshot_times);
  if (input.output.fines) with_fines_.emplace();
  if (!saved) return;
  rows_.restore(*saved);
  maps_.restore(*saved);
  history_ = FragmentHistory(saved->get_one<FragmentHistory::State>("fragment_history"));
  gyrations_.restore(*saved);
  if (with_fines_) with_fines_->restore(*saved, with_fines_name);
  motor_.restore(*saved);
  // If the interval has changed, the next frame is the first one after the present time.
  const CaseOutput& now = input_.output;
  if (now.snapshots != state_.snapshot_interval) state_.frames = intervals(now.snapshots, state_.time) + 1;
}

ResultsContent RunOutput::content(const CaseRecord& record) const {
  ResultsContent content;
  content.record = record;
  rows_.declare(content);
  maps_.declare(content);
  return content;
}

void RunOutput::begin(Simulation& simulation) {
  rows_.write(results_, simulation.take_left());
  if (input_.output.snapshots > 0) write_snapshot(simulation);
}

void RunOutput::take(const WindowResult& result, const Simulation& simulation) {
  writer_.check();
  lost_ = lost_ || !is_finite(result, simulation);
  if (lost_) return;
  rows_.add(results_, result, simulation);
  state_.crushing_work += result.load.work;
  state_.time = simulation.time();
  maps_.take(result.wall_impulses, state_.time, results_);
  if (simulation.drivetrain()) note_drive(result, simulation);
  if (result.inspected) write_row(simulation);
  if (due(input_.output.snapshots, state_.frames, state_.time)) write_snapshot(simulation);
}

void RunOutput::note_drive(const WindowResult& result, const Simulation& simulation) {
  const Drivetrain& drive = *simulation.drivetrain();
  const double length = result.window.length();
  GyrationWindow window{.time = state_.time,
                        .length = length,
                        .angle = drive.state().angle,
                        .power = result.crushing_power,
                        .motor_power = drive.means().motor_power,
                        .holdup = result.holdup_mass,
                        .discharged = result.discharged_mass};
  if (simulation.product()) window.sieve_mass = simulation.product()->state().sieve_mass;
  gyrations_.add(window);
  if (with_fines_) {
    window.sieve_mass = simulation.fines()->sieve_mass();
    with_fines_->add(window);
  }
  motor_.add(length, drive.means().motor_power);
}

void RunOutput::write_row(const Simulation& simulation) {
  motor_.end_row(state_.time);
  rows_.write(results_, simulation, wall_seconds());
}

/// Gives the writer a frame that owns its data.
void RunOutput::write_snapshot(const Simulation& simulation) {
  writer_.wait_for_room();
  const auto frame = std::make_shared<Frame>();
  frame->time = simulation.time();
  frame->particles = simulation.dem().particles();
  if (input_.bonds) {
    frame->bonds = simulation.dem().bonds();
    frame->fragments = history_.look(frame->time, simulation.fragments_inside(frame->particles), frame->particles);
  }
  add_walls(*frame, simulation);
  writer_.add([this, frame] {
    require_own_();
    write_files(*frame);
  });
  state_.snapshot_times.push_back(frame->time);
  ++state_.frames;
}

void RunOutput::write_files(const Frame& frame) {
  const SnapshotFrame written{frame.time, &frame.particles, frame.bonds ? &*frame.bonds : nullptr, frame.walls,
                              frame.fragments ? &*frame.fragments : nullptr};
  if (snapshots_) {
    snapshots_->write_fixed(frame.fixed);
    snapshots_->write(written);
  }
  if (fields_) {
    fields_->take_fixed(frame.fixed);
    fields_->write(written);
  }
}

void RunOutput::add_walls(Frame& frame, const Simulation& simulation) {
  const std::vector<WallPose> poses = simulation.dem().wall_poses();
  for (const WallPicture& picture : assembly_.pictures) {
    const auto number = static_cast<std::size_t>(picture.wall);
    std::optional<WallLoads> loads = maps_.loads(picture.wall);
    const bool same = std::holds_alternative<Fixed>(assembly_.setup.scene.walls[number].motion) && !loads;
    if (same && fixed_given_) continue;
    PosedWall wall = posed(picture, poses[number]);
    wall.loads = std::move(loads);
    (same ? frame.fixed : frame.walls).push_back(std::move(wall));
  }
  fixed_given_ = true;
}

double RunOutput::wall_seconds() const {
  return state_.wall_seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RunOutput::save(SavedState& to) const {
  State state = state_;
  state.wall_seconds = wall_seconds();
  state.snapshot_interval = input_.output.snapshots;
  to.put_one("output", state);
  for (const auto& [group, mark] : results_.marks()) {
    const std::string name = std::string(marks_prefix) + group;
    to.put_one(name + std::string(rows_suffix), mark.rows);
    to.put_text(name + std::string(digests_suffix), lines_of_digests(mark));
  }
  rows_.save(to);
  maps_.save(to);
  to.put_one("fragment_history", history_.state());
  gyrations_.save(to);
  if (with_fines_) with_fines_->save(to, with_fines_name);
  motor_.save(to);
}

bool RunOutput::lost(const Simulation& simulation) {
  const EnergyTerms energy = simulation.dem().energy();
  lost_ = lost_ || !std::isfinite(energy.kinetic + energy.potential + norm(simulation.dem().momentum()));
  return lost_;
}

void RunOutput::close(Simulation& simulation) {
  if (!rows_.empty() && !lost_) write_row(simulation);
  rows_.write(results_, simulation.take_left());
  rows_.write(results_, simulation.fragments_inside());
  close();
}

void RunOutput::sync() {
  writer_.finish();
  require_own_();
  results_.sync();
  if (fields_) fields_->sync();
}

void RunOutput::close() {
  writer_.finish();
  maps_.close(results_);
  results_.close();
}

}  // namespace gyro
