// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/fmu_drive.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace gyro {
namespace {

constexpr std::size_t max_notes = 500;  ///< of one run, because a slave may write one in every step

const char* name_of(fmi2Status status) {
  constexpr const char* names[] = {"fmi2OK", "fmi2Warning", "fmi2Discard", "fmi2Error", "fmi2Fatal", "fmi2Pending"};
  return status >= fmi2OK && status <= fmi2Pending ? names[status] : "a status that FMI does not define";
}

bool fine(fmi2Status status) {
  return status == fmi2OK || status == fmi2Warning;
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

}  // namespace

DriveKnowledge knowledge_of(const FmuLinks& links) {
  const auto linked = [&](FmuQuantity quantity) { return links[static_cast<std::size_t>(quantity)].has_value(); };
  using enum FmuQuantity;
  DriveKnowledge k;
  k.motor_speed = linked(motor_speed);
  k.motor_torque = linked(motor_torque) || linked(motor_impulse);
  k.motor_power =
      linked(motor_power) || linked(motor_work) || ((linked(motor_speed) || linked(motor_angle)) && k.motor_torque);
  k.accounts = linked(motor_work) && linked(loss_work) && linked(kinetic_energy);
  return k;
}

/// The messages of the slave's logger.
struct FmuDrive::Messages {
  bool muted = false;  ///< during a preview, whose step will be repeated
  std::size_t count = 0;
  std::vector<std::string> notes;
  std::string last;

  static void take(fmi2ComponentEnvironment environment, fmi2String, fmi2Status status, fmi2String, fmi2String message,
                   ...) {
    Messages& self = *static_cast<Messages*>(environment);
    char text[1000];
    std::va_list values;
    va_start(values, message);
    std::vsnprintf(text, sizeof text, message != nullptr ? message : "", values);
    va_end(values);
    if (!fine(status)) self.last = text;
    if (self.muted || ++self.count > max_notes) return;
    self.notes.emplace_back(text);
    if (self.count == max_notes) self.notes.emplace_back("further messages of this FMU are not kept");
  }
};

FmuDrive::FmuDrive(FmuSetup setup)
    : setup_(std::move(setup)), messages_(std::make_unique<Messages>()), library_(setup_.library) {
  if (setup_.state && !library_.has_state())
    throw BadInput("declares that its state can be saved, but has no function for it");
  if (setup_.serialisation && !library_.has_serialisation())
    throw BadInput("declares that its state can be serialised, but has no function for it");
  if ((setup_.history && library_.get_integer == nullptr) ||
      (linked(FmuQuantity::tripped) && library_.get_boolean == nullptr))
    throw BadInput("has Integer or Boolean outputs, but lacks the functions that read them");
  callbacks_ = {&Messages::take, &std::calloc, &std::free, nullptr, messages_.get()};
  component_ = library_.instantiate(setup_.name.c_str(), fmi2CoSimulation, setup_.guid.c_str(),
                                    setup_.resources.c_str(), &callbacks_, fmi2False, fmi2False);
  if (component_ == nullptr)
    throw BadInput("cannot be instantiated" + (messages_->last.empty() ? "" : ": " + messages_->last));
  try {
    initialise();
  } catch (...) {
    if (!fatal_) library_.free_instance(component_);
    throw;
  }
}

FmuDrive::~FmuDrive() {
  if (fatal_) return;  // after fmi2Fatal no function may be called
  messages_->muted = true;
  if (saved_ != nullptr) library_.free_state(component_, &saved_);
  if (initialised_) library_.terminate(component_);
  library_.free_instance(component_);
}

void FmuDrive::initialise() {
  check_start(library_.setup_experiment(component_, fmi2False, 0, 0, fmi2False, 0), "fmi2SetupExperiment");
  for (const FmuStart& start : setup_.starts) set_start(start);
  check_start(library_.enter_initialisation(component_), "fmi2EnterInitializationMode");
  check_start(library_.exit_initialisation(component_), "fmi2ExitInitializationMode");
  initialised_ = true;
  try {
    values_ = read();
    if (setup_.history) events_reported_ = static_cast<int>(get(setup_.history->events, VariableType::integer));
  } catch (const StoppedByGuard& failure) {
    throw BadInput(failure.what());
  }
  start_.speed = now(FmuQuantity::eccentric_speed);
  start_.direction = sign(start_.speed);
  start_.spin = now(FmuQuantity::mantle_spin);
  start_angle_ = now(FmuQuantity::eccentric_angle);
}

void FmuDrive::set_start(const FmuStart& start) {
  const auto whole = static_cast<fmi2Integer>(start.value);
  const fmi2ValueReference* reference = &start.reference;
  const fmi2Status status = start.type == VariableType::real ? library_.set_real(component_, reference, 1, &start.value)
                            : start.type == VariableType::integer
                                ? library_.set_integer(component_, reference, 1, &whole)
                                : library_.set_boolean(component_, reference, 1, &whole);
  check_start(status, "setting a parameter");
}

std::string FmuDrive::complaint(fmi2Status status, const char* function) const {
  return std::string(function) + " returned " + name_of(status) +
         (messages_->last.empty() ? "" : " (\"" + messages_->last + "\")");
}

void FmuDrive::check_start(fmi2Status status, const char* function) {
  fatal_ = fatal_ || status == fmi2Fatal;
  if (!fine(status)) throw BadInput("cannot be started: " + complaint(status, function));
}

void FmuDrive::check(fmi2Status status, const char* function, double time) {
  fatal_ = fatal_ || status == fmi2Fatal;
  if (!fine(status))
    throw StoppedByGuard("the drivetrain FMU " + setup_.name + " failed at t = " + std::to_string(time) +
                         " s: " + complaint(status, function));
}

FmuDrive::Values FmuDrive::read() {
  Values values{};
  for (std::size_t k = 0; k < fmu_quantities; ++k) {
    if (!setup_.links[k] || is_input(static_cast<FmuQuantity>(k))) continue;
    const FmuLink& link = *setup_.links[k];
    values[k] = link.factor * get(link.reference, type_of(static_cast<FmuQuantity>(k))) + link.offset;
  }
  return values;
}

double FmuDrive::get(fmi2ValueReference reference, VariableType type) {
  double value = 0;
  int whole = 0;
  const fmi2Status status = type == VariableType::real      ? library_.get_real(component_, &reference, 1, &value)
                            : type == VariableType::integer ? library_.get_integer(component_, &reference, 1, &whole)
                                                            : library_.get_boolean(component_, &reference, 1, &whole);
  fatal_ = fatal_ || status == fmi2Fatal;
  if (!fine(status))
    throw StoppedByGuard("the drivetrain FMU " + setup_.name + " failed: " + complaint(status, "reading a value"));
  if (!std::isfinite(value))
    throw StoppedByGuard("the drivetrain FMU " + setup_.name + " gives a value that is not finite");
  return type == VariableType::real ? value : whole;
}

void FmuDrive::step(double time, double duration, const ShaftLoad& load, bool final) {
  const double inputs[] = {load.rock_torque, load.spin_torque, load.bearings.bushing, load.bearings.spider};
  for (std::size_t k = 0; k < std::size(inputs); ++k) {
    if (!setup_.links[k]) continue;
    const FmuLink& link = *setup_.links[k];
    const double value = (inputs[k] - link.offset) / link.factor;
    check(library_.set_real(component_, &link.reference, 1, &value), "fmi2SetReal", time);
  }
  check(library_.do_step(component_, time, duration, final ? fmi2True : fmi2False), "fmi2DoStep", time);
}

ShaftAdvance FmuDrive::gains(const Values& before, const Values& after, double duration) const {
  const auto gain = [&](FmuQuantity sum) {
    return after[static_cast<std::size_t>(sum)] - before[static_cast<std::size_t>(sum)];
  };
  /// Gain of an integral; if it is not given, the mean of its rate at both ends times the duration.
  const auto integral = [&](FmuQuantity sum, FmuQuantity rate) {
    const auto k = static_cast<std::size_t>(rate);
    return linked(sum) ? gain(sum) : duration * (before[k] + after[k]) / 2;
  };
  ShaftAdvance gained;
  gained.angle = integral(FmuQuantity::eccentric_angle, FmuQuantity::eccentric_speed);
  gained.spin_angle = integral(FmuQuantity::mantle_spin_angle, FmuQuantity::mantle_spin);
  gained.motor_angle = integral(FmuQuantity::motor_angle, FmuQuantity::motor_speed);
  gained.motor_impulse = integral(FmuQuantity::motor_impulse, FmuQuantity::motor_torque);
  gained.motor_work = integral(FmuQuantity::motor_work, FmuQuantity::motor_power);
  if (!linked(FmuQuantity::motor_work) && !linked(FmuQuantity::motor_power))
    gained.motor_work = gained.motor_impulse * gained.motor_angle / duration;
  gained.loss_work = gain(FmuQuantity::loss_work);
  gained.kinetic_gain = gain(FmuQuantity::kinetic_energy);
  gained.speed_change = gain(FmuQuantity::eccentric_speed);
  return gained;
}

ShaftAdvance FmuDrive::preview(double duration, const ShaftLoad& load, ShaftMotion& motion) {
  if (!setup_.state) {
    ShaftAdvance gained;
    gained.angle = duration * (motion.speed + last_acceleration_ * duration / 2);
    gained.spin_angle = duration * motion.spin;
    if (motion.direction == 0) gained.angle = 0;
    motion.time += duration;
    return gained;
  }
  messages_->muted = true;
  check(library_.get_state(component_, &saved_), "fmi2GetFMUstate", motion.time);
  step(motion.time, duration, load, false);
  const Values after = read();
  check(library_.set_state(component_, saved_), "fmi2SetFMUstate", motion.time);
  messages_->muted = false;
  motion.speed = after[static_cast<std::size_t>(FmuQuantity::eccentric_speed)];
  motion.spin = after[static_cast<std::size_t>(FmuQuantity::mantle_spin)];
  motion.direction = sign(motion.speed);
  motion.time += duration;
  return gains(values_, after, duration);
}

ShaftAdvance FmuDrive::advance(double duration, const ShaftLoad& load, ShaftMotion& motion) {
  step(motion.time, duration, load, true);
  const Values after = read();
  ShaftAdvance gained = gains(values_, after, duration);
  const Values before = std::exchange(values_, after);
  last_acceleration_ = gained.speed_change / duration;
  motion.speed = now(FmuQuantity::eccentric_speed);
  motion.direction = sign(motion.speed);
  motion.spin = now(FmuQuantity::mantle_spin);
  motion.time += duration;
  if (before[static_cast<std::size_t>(FmuQuantity::eccentric_speed)] > 0 && motion.speed <= 0)
    gained.stopped_after = duration;
  if (setup_.history)
    report_history(gained.events);
  else
    report_changes(before, motion, gained.events);
  return gained;
}

void FmuDrive::report_history(std::vector<DriveEvent>& events) {
  const FmuHistory& history = *setup_.history;
  const int count = static_cast<int>(get(history.events, VariableType::integer)), new_events = count - events_reported_;
  events_reported_ = count;
  const int kept = std::min(new_events, static_cast<int>(history.times.size()));
  if (kept < new_events)
    messages_->notes.push_back(std::to_string(new_events) + " events in one step, of which the FMU keeps the last " +
                               std::to_string(kept));
  for (int k = kept - 1; k >= 0; --k) {
    const auto row = static_cast<std::size_t>(k);
    const int kind = static_cast<int>(get(history.kinds[row], VariableType::integer));
    events.push_back({get(history.times[row], VariableType::real), static_cast<DriveEventKind>(kind)});
  }
}

void FmuDrive::report_changes(const Values& before, const ShaftMotion& motion, std::vector<DriveEvent>& events) const {
  const bool off = now(FmuQuantity::tripped) != 0,
             was_off = before[static_cast<std::size_t>(FmuQuantity::tripped)] != 0;
  if (off != was_off) events.push_back({motion.time, off ? DriveEventKind::trip : DriveEventKind::restart});
  if (!(before[static_cast<std::size_t>(FmuQuantity::eccentric_speed)] > 0 && motion.speed <= 0)) return;
  const bool driven = !off && (!linked(FmuQuantity::motor_torque) || now(FmuQuantity::motor_torque) > 0);
  events.push_back({motion.time, driven ? DriveEventKind::stall : DriveEventKind::standstill});
}

std::string FmuDrive::unsaveable() const {
  if (setup_.serialisation) return {};
  return "the drivetrain FMU " + setup_.name + " cannot save its state (" +
         (setup_.state ? "canSerializeFMUstate" : "canGetAndSetFMUstate") + " is false)";
}

std::vector<std::uint8_t> FmuDrive::save() const {
  const auto must = [](fmi2Status status) {
    if (!fine(status)) throw StoppedByGuard("the drivetrain FMU failed to save its state");
  };
  must(library_.get_state(component_, &saved_));
  std::size_t size = 0;
  must(library_.serialised_size(component_, saved_, &size));
  std::vector<std::uint8_t> bytes(size);
  must(library_.serialise(component_, saved_, reinterpret_cast<fmi2Byte*>(bytes.data()), size));
  return bytes;
}

void FmuDrive::restore(std::span<const std::uint8_t> bytes) {
  const auto must = [&](fmi2Status status) {
    fatal_ = fatal_ || status == fmi2Fatal;
    if (!fine(status)) throw BadInput("has a state that the drivetrain FMU refuses; use the FMU that saved it");
  };
  if (saved_ != nullptr) must(library_.free_state(component_, &saved_));
  saved_ = nullptr;
  must(library_.deserialise(component_, reinterpret_cast<const fmi2Byte*>(bytes.data()), bytes.size(), &saved_));
  must(library_.set_state(component_, saved_));
  values_ = read();
  if (setup_.history) events_reported_ = static_cast<int>(get(setup_.history->events, VariableType::integer));
}

std::vector<std::string> FmuDrive::take_notes() {
  std::vector<std::string> notes;
  notes.swap(messages_->notes);
  for (std::string& note : notes) note = "FMU " + setup_.name + ": " + note;
  return notes;
}

}  // namespace gyro
