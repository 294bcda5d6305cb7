// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/case_record.hpp"

#include <variant>

namespace gyro {
namespace {

struct Attribute {
  const char* name;
  std::variant<std::string CaseRecord::*, std::uint64_t CaseRecord::*> value;
  const char* description;
};

constexpr Attribute attributes[] = {
    {"title", &CaseRecord::title, "title of the case"},
    {"resolved_yaml", &CaseRecord::resolved_yaml, "the case with all defaults and --set applied"},
    {"version", &CaseRecord::version, "version of gyrosim"},
    {"git_hash", &CaseRecord::git_hash, "commit that gyrosim was built from"},
    {"device", &CaseRecord::device, "cpu, or the name of the GPU"},
    {"precision", &CaseRecord::precision, "mixed or double"},
    {"seed", &CaseRecord::seed, "seed of all random numbers"},
};

}  // namespace

void write_record(hdf5::File& file, const CaseRecord& record) {
  if (!file.contains("/case")) file.create_group("/case");
  for (const Attribute& attribute : attributes)
    std::visit([&](const auto& value) { file.set_attribute("/case", attribute.name, record.*value); }, attribute.value);
}

std::vector<RecordAttribute> record_attributes() {
  std::vector<RecordAttribute> all;
  for (const Attribute& attribute : attributes) all.push_back({attribute.name, attribute.description});
  return all;
}

}  // namespace gyro
