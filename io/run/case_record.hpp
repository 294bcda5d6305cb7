// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace gyro {

/// How a run was made: the attributes of the group /case of results.h5.
struct CaseRecord {
  std::string title;
  std::string resolved_yaml;  ///< the case with defaults and --set applied
  std::string version, git_hash;
  std::string device;     ///< "cpu" or the name of the GPU
  std::string precision;  ///< "mixed" or "double"
  std::uint64_t seed = 0;
};

/// Writes the attributes of the group /case; existing ones are replaced, and a missing group is created.
void write_record(hdf5::File& file, const CaseRecord& record);

/// An attribute of /case, for the reference page of outputs.
struct RecordAttribute {
  std::string name, description;
};
std::vector<RecordAttribute> record_attributes();

}  // namespace gyro
