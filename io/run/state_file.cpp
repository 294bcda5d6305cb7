// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/state_file.hpp"

#include "io/files/seal.hpp"
#include "io/hdf5/hdf5.hpp"
#include "io/run/replace_file.hpp"

#include <algorithm>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk_bytes = 1 << 20;

void write_column(hdf5::File& file, const std::string& name, const SavedColumn& column) {
  std::visit(
      [&](const auto& numbers) {
        using Number = typename std::remove_cvref_t<decltype(numbers)>::value_type;
        const std::size_t rows = numbers.size() / column.width, row_bytes = column.width * sizeof(Number);
        hdf5::Dataset dataset = file.create_dataset(
            "/" + name, {.number = hdf5::number_of<Number>(),
                         .columns = static_cast<std::int64_t>(column.width),
                         .chunk_rows = static_cast<std::int64_t>(
                             std::clamp(rows, std::size_t{1}, std::max(std::size_t{1}, chunk_bytes / row_bytes)))});
        dataset.append(numbers.data(), numbers.size(), hdf5::number_of<Number>());
      },
      column.numbers);
}

SavedColumn read_column(const hdf5::Dataset& dataset) {
  SavedColumn column;
  column.width = static_cast<std::size_t>(dataset.columns());
  switch (dataset.number()) {
    case hdf5::Number::float64:
      column.numbers = dataset.read<double>();
      break;
    case hdf5::Number::float32:
      column.numbers = dataset.read<float>();
      break;
    case hdf5::Number::int64:
      column.numbers = dataset.read<std::int64_t>();
      break;
    case hdf5::Number::int32:
      column.numbers = dataset.read<std::int32_t>();
      break;
    case hdf5::Number::uint32:
      column.numbers = dataset.read<std::uint32_t>();
      break;
    case hdf5::Number::uint8:
      column.numbers = dataset.read<std::uint8_t>();
      break;
  }
  return column;
}

void read_columns(const hdf5::File& file, const std::string& group, SavedState& state) {
  for (const std::string& child : file.children("/" + group)) {
    const std::string name = group.empty() ? child : group + "/" + child;
    if (file.is_group("/" + name))
      read_columns(file, name, state);
    else
      state.columns()[name] = read_column(file.dataset("/" + name));
  }
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw BadInput(path.string() + ": " + why);
}

}  // namespace

void write_state(const fs::path& path, const SavedState& state) {
  const fs::path part = path.string() + ".tmp";
  try {
    hdf5::File file = hdf5::File::create(part);
    file.set_attribute("/", "format", state_format);
    for (const auto& [name, column] : state.columns()) write_column(file, name, column);
    file.close();
    seal(part);
    put_in_place(path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);  // frees space on a full disk
    throw;
  }
}

SavedState read_state(const fs::path& path, const std::string& advice) {
  if (!fs::exists(path)) refuse(path, "there is no such checkpoint; give the directory of a run that wrote one");
  if (!is_sealed(path)) refuse(path, "is damaged, not a checkpoint, or one of an older version of gyrosim; " + advice);
  std::uint64_t format = 0;
  try {
    const hdf5::File file = hdf5::File::open_closed(path);
    format = file.integer_attribute("/", "format");
    if (format == state_format) {
      SavedState state;
      read_columns(file, "", state);
      return state;
    }
  } catch (const std::exception& problem) {
    refuse(path, std::string("is damaged or not a checkpoint (") + problem.what() + "); " + advice);
  }
  refuse(path, "has format " + std::to_string(format) + "; format " + std::to_string(state_format) +
                   " is needed: use the version of gyrosim that wrote it, or " + advice);
}

}  // namespace gyro
