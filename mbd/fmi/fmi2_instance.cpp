// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/fmi2_instance.hpp"

#include "core/base/errors.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace gyro {
namespace {

constexpr char state_magic[8] = {'G', 'Y', 'R', 'O', 'F', 'M', 'U', '2'};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  c = static_cast<char>(c | 0x20);
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/// Path of a file: URI (RFC 8089), with its %xx decoded.
std::string path_of(const std::string& uri) {
  constexpr std::string_view scheme = "file:";
  std::string rest = uri.starts_with(scheme) ? uri.substr(scheme.size()) : uri;
  if (rest.starts_with("//")) {
    const std::size_t path = rest.find('/', 2);
    rest = path == std::string::npos ? "" : rest.substr(path);
  }
  std::string text;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const bool coded =
        rest[k] == '%' && k + 2 < rest.size() && hex_digit(rest[k + 1]) >= 0 && hex_digit(rest[k + 2]) >= 0;
    text += coded ? static_cast<char>(hex_digit(rest[k + 1]) * 16 + hex_digit(rest[k + 2])) : rest[k];
    if (coded) k += 2;
  }
  return text;
}

DrivetrainParameters read_parameters(const std::string& guid, const std::string& resources) {
  const std::string file = path_of(resources) + "/drivetrain.txt";
  std::ifstream stream(file, std::ios::binary);
  std::string first;
  if (!std::getline(stream, first)) throw BadInput(file + " cannot be read");
  if (first != "guid " + guid)
    throw BadInput("the master asks for the GUID " + guid + ", but " + file + " has another one");
  return drive_from_text({std::istreambuf_iterator<char>(stream), {}});
}

}  // namespace

std::vector<char> SavedSlave::bytes() const {
  std::vector<double> numbers{static_cast<double>(mode), static_cast<double>(parameters.size())};
  for_each_number(state, [&](const auto& number) { numbers.push_back(static_cast<double>(number)); });
  numbers.insert(numbers.end(), parameters.begin(), parameters.end());
  std::vector<char> bytes(sizeof state_magic + numbers.size() * sizeof(double));
  std::memcpy(bytes.data(), state_magic, sizeof state_magic);
  std::memcpy(bytes.data() + sizeof state_magic, numbers.data(), numbers.size() * sizeof(double));
  return bytes;
}

SavedSlave SavedSlave::from_bytes(const char* bytes, std::size_t size) {
  SavedSlave saved;
  std::size_t count = 2;
  for_each_number(saved.state, [&](const auto&) { ++count; });
  const std::size_t minimum = sizeof state_magic + count * sizeof(double);
  if (size < minimum || (size - minimum) % sizeof(double) != 0 ||
      std::memcmp(bytes, state_magic, sizeof state_magic) != 0)
    throw BadInput("these bytes are not a saved state of this FMU");
  std::vector<double> numbers((size - sizeof state_magic) / sizeof(double));
  std::memcpy(numbers.data(), bytes + sizeof state_magic, numbers.size() * sizeof(double));
  saved.mode = static_cast<SlaveMode>(static_cast<unsigned>(numbers[0]));
  std::size_t next = 2;
  for_each_number(saved.state, [&](auto& number) {
    number = static_cast<std::remove_reference_t<decltype(number)>>(numbers[next++]);
  });
  saved.parameters.assign(numbers.begin() + static_cast<std::ptrdiff_t>(next), numbers.end());
  if (static_cast<double>(saved.parameters.size()) != numbers[1])
    throw BadInput("these bytes are not a saved state of this FMU");
  return saved;
}

Fmi2Instance::Fmi2Instance(std::string instance_name, const fmi2CallbackFunctions& functions, const std::string& guid,
                           const std::string& resources)
    : name(std::move(instance_name)),
      callbacks(functions),
      as_exported(read_parameters(guid, resources)),
      slave(std::make_unique<DriveSlave>(as_exported)) {}

void Fmi2Instance::log(fmi2Status status, const std::string& message) const {
  if (callbacks.logger == nullptr) return;
  const char* category = status == fmi2OK ? "logAll" : status == fmi2Warning ? "logStatusWarning" : "logStatusError";
  callbacks.logger(callbacks.componentEnvironment, name.c_str(), status, category, "%s", message.c_str());
}

void Fmi2Instance::apply_changes() {
  if (changed) slave->initialise(start_time);
  changed = false;
}

const DriveVariable& Fmi2Instance::variable(fmi2ValueReference reference, VariableType type) const {
  if (reference >= slave->variables().size() || slave->variables()[reference].type != type)
    throw BadInput("value reference " + std::to_string(reference) + " does not exist or has another type");
  return slave->variables()[reference];
}

double Fmi2Instance::get(fmi2ValueReference reference, VariableType type) {
  const DriveVariable& asked = variable(reference, type);
  if (asked.causality == Causality::output) apply_changes();
  return asked.get();
}

void Fmi2Instance::set(fmi2ValueReference reference, VariableType type, double value) {
  const DriveVariable& asked = variable(reference, type);
  if (!asked.set) throw BadInput(asked.name + " is an output and cannot be set");
  if (!std::isfinite(value)) throw BadInput(asked.name + " is not finite");
  const bool parameter = asked.causality == Causality::parameter;
  if (parameter && mode != SlaveMode::instantiated && mode != SlaveMode::initialising)
    throw BadInput(asked.name + " is fixed and can only be set before the end of the initialisation");
  asked.set(value);
  changed = changed || parameter;
}

void Fmi2Instance::step(double time, double duration) {
  if (!(duration > 0) || !std::isfinite(time) || !std::isfinite(duration))
    throw BadInput("a step must have a length > 0 and a finite time");
  for (const DriveEvent& event : slave->step(time, duration))
    log(fmi2Warning, to_string(event.kind) + " at t = " + std::to_string(event.time) + " s");
}

}  // namespace gyro
