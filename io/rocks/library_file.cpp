// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/library_file.hpp"

#include "core/base/errors.hpp"
#include "io/files/seal.hpp"
#include "io/hdf5/hdf5.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace gyro {
namespace {

constexpr std::uint64_t format = 2;

/// A number of a rock, which is written as an attribute of its group.
struct Figure {
  const char* name;
  double RockTemplate::*value;
};
constexpr Figure figures[] = {{"diameter", &RockTemplate::diameter},
                              {"solid_volume", &RockTemplate::solid_volume},
                              {"sieve_size", &RockTemplate::sieve_size},
                              {"particle_density", &RockTemplate::particle_density},
                              {"bounding_radius", &RockTemplate::bounding_radius},
                              {"packing_fraction", &RockTemplate::packing_fraction},
                              {"coordination", &RockTemplate::coordination},
                              {"mass_error", &RockTemplate::mass_error},
                              {"inertia_error", &RockTemplate::inertia_error},
                              {"centre_error", &RockTemplate::centre_error},
                              {"critical_step", &RockTemplate::critical_step},
                              {"bond_step", &RockTemplate::bond_step}};

/// The group of each rock: its name, with a number appended if several rocks have the same name.
std::vector<std::string> groups_of(const std::vector<std::string>& names) {
  std::set<std::string> used;
  std::vector<std::string> groups;
  for (const std::string& name : names) {
    std::string group = name;
    for (int k = 2; !used.insert(group).second; ++k) group = name + "#" + std::to_string(k);
    groups.push_back("/rocks/" + group);
  }
  return groups;
}

template <class T>
void write_table(hdf5::File& file, const std::string& name, const std::vector<T>& numbers, std::int64_t columns) {
  const auto rows = static_cast<std::int64_t>(numbers.size()) / columns;
  file.create_dataset(
          name, {.number = hdf5::number_of<T>(), .columns = columns, .chunk_rows = std::max(rows, std::int64_t{1})})
      .append(numbers.data(), numbers.size(), hdf5::number_of<T>());
}

template <class T>
void write_vectors(hdf5::File& file, const std::string& name, const std::vector<Vec3<T>>& vectors) {
  std::vector<T> numbers;
  for (const Vec3<T>& v : vectors) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  write_table(file, name, numbers, 3);
}

template <class T>
std::vector<Vec3<T>> read_vectors(const hdf5::File& file, const std::string& name) {
  const std::vector<T> numbers = file.dataset(name).read<T>();
  std::vector<Vec3<T>> vectors;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
    vectors.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  return vectors;
}

void write_bonds(hdf5::File& file, const std::string& group, const std::vector<TemplateBond>& bonds) {
  std::vector<Index> pairs;
  std::vector<double> lengths, radii;
  for (const TemplateBond& b : bonds) {
    pairs.insert(pairs.end(), {b.i, b.j});
    lengths.push_back(b.length);
    radii.push_back(b.radius);
  }
  write_table(file, group + "/bonds", pairs, 2);
  write_table(file, group + "/bond_length", lengths, 1);
  write_table(file, group + "/bond_radius", radii, 1);
}

std::vector<TemplateBond> read_bonds(const hdf5::File& file, const std::string& group) {
  const std::vector<Index> pairs = file.dataset(group + "/bonds").read<Index>();
  const std::vector<double> lengths = file.dataset(group + "/bond_length").read(),
                            radii = file.dataset(group + "/bond_radius").read();
  std::vector<TemplateBond> bonds;
  for (std::size_t k = 0; k < lengths.size(); ++k)
    bonds.push_back({pairs.at(2 * k), pairs.at(2 * k + 1), lengths[k], radii.at(k)});
  return bonds;
}

void write_rock(hdf5::File& file, const std::string& group, const RockTemplate& rock) {
  write_vectors(file, group + "/centres", rock.centres);
  write_table(file, group + "/radii", rock.radii, 1);
  write_bonds(file, group, rock.bonds);
  write_table(file, group + "/colour_begin", rock.colour_begin, 1);
  write_vectors(file, group + "/hull_vertices", rock.hull_vertices);
  write_vectors(file, group + "/hull_faces", rock.hull_faces);
  for (const Figure& figure : figures) file.set_attribute(group, figure.name, rock.*figure.value);
}

RockTemplate read_rock(const hdf5::File& file, const std::string& group, const std::string& name) {
  RockTemplate rock;
  rock.name = name;
  rock.centres = read_vectors<double>(file, group + "/centres");
  rock.radii = file.dataset(group + "/radii").read();
  rock.bonds = read_bonds(file, group);
  rock.colour_begin = file.dataset(group + "/colour_begin").read<Index>();
  rock.hull_vertices = read_vectors<double>(file, group + "/hull_vertices");
  rock.hull_faces = read_vectors<Index>(file, group + "/hull_faces");
  for (const Figure& figure : figures) rock.*figure.value = file.number_attribute(group, figure.name);
  return rock;
}

StoredLibrary read_all(const hdf5::File& file) {
  StoredLibrary stored;
  stored.recipe = file.read_strings("/recipe").at(0);
  const std::vector<std::string> names = file.read_strings("/names");
  if (file.contains("/notes")) stored.library.notes = file.read_strings("/notes");
  const std::vector<std::string> groups = groups_of(names);
  for (std::size_t k = 0; k < names.size(); ++k) stored.library.rocks.push_back(read_rock(file, groups[k], names[k]));
  return stored;
}

}  // namespace

void write_library(const RockLibrary& library, const std::filesystem::path& path, const std::string& recipe) {
  hdf5::File file = hdf5::File::create(path);
  std::vector<std::string> names;
  for (const RockTemplate& rock : library.rocks) names.push_back(rock.name);
  file.set_attribute("/", "format", format);
  file.write_strings("/recipe", std::vector{recipe});
  file.write_strings("/names", names);
  if (!library.notes.empty()) file.write_strings("/notes", library.notes);
  const std::vector<std::string> groups = groups_of(names);
  for (std::size_t k = 0; k < library.rocks.size(); ++k) write_rock(file, groups[k], library.rocks[k]);
  file.close();
  seal(path);
}

StoredLibrary read_library(const std::filesystem::path& path) {
  if (!is_sealed(path))
    throw BadInput(path.string() + ": is damaged, not a library, or one of an older version of gyrosim");
  std::uint64_t found = 0;
  try {
    const hdf5::File file = hdf5::File::open_closed(path);
    found = file.integer_attribute("/", "format");
    if (found == format) return read_all(file);
  } catch (const std::exception& problem) {
    throw BadInput(path.string() + ": is damaged or not a library (" + problem.what() + ")");
  }
  throw BadInput(path.string() + ": has format " + std::to_string(found) +
                 ", but this version of gyrosim reads format " + std::to_string(format));
}

}  // namespace gyro
