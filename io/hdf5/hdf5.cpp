// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/hdf5/hdf5.hpp"

#include "core/base/errors.hpp"
#include "io/hdf5/internal.hpp"

#include <algorithm>
#include <array>

namespace gyro::hdf5 {
namespace {

/// Properties of file access: the newest format, which appending needs; file systems without locks are allowed.
Handle access_properties(const std::string& path) {
  Handle list = own(H5Pcreate(H5P_FILE_ACCESS), path, "prepare");
  check(H5Pset_libver_bounds(list.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), path, "prepare");
  check(H5Pset_file_locking(list.get(), true, true), path, "prepare");
  return list;
}

/// Without this, the library would wait for a writer of the pipe without end.
void refuse_pipe(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_fifo(path, error)) throw BadInput(path.string() + ": is a pipe; give a file");
}

/// Properties of links: names are UTF-8.
Handle link_properties(const std::string& where) {
  Handle list = own(H5Pcreate(H5P_LINK_CREATE), where, "prepare");
  check(H5Pset_char_encoding(list.get(), H5T_CSET_UTF8), where, "prepare");
  return list;
}

/// Properties of creation: no times are stored, so that the same data give the same file.
Handle creation_properties(hid_t what, const std::string& where) {
  Handle list = own(H5Pcreate(what), where, "prepare");
  check(H5Pset_obj_track_times(list.get(), false), where, "prepare");
  return list;
}

/// Creates the missing groups of a path. The library could do this, but it would store times.
void make_parents(const Handle& file, const std::string& name, const std::string& where) {
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    const std::string group = name.substr(0, slash);
    if (H5Lexists(file.get(), group.c_str(), H5P_DEFAULT) > 0) continue;
    own(H5Gcreate2(file.get(), group.c_str(), link_properties(where).get(),
                   creation_properties(H5P_GROUP_CREATE, where).get(), H5P_DEFAULT),
        where, "make the group");
  }
}

Handle make_dataset(const Handle& file, const std::string& name, const std::string& where, hid_t type,
                    const Handle& space, const Handle& creation) {
  make_parents(file, name, where);
  return own(H5Dcreate2(file.get(), name.c_str(), type, space.get(), link_properties(where).get(), creation.get(),
                        H5P_DEFAULT),
             where, "make the dataset");
}

Handle line_of(std::size_t length, const std::string& where) {
  const hsize_t size = length;
  return own(H5Screate_simple(1, &size, nullptr), where, "prepare");
}

herr_t collect_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

File File::create(const std::filesystem::path& path) {
  const InLibrary in_library;
  const Handle creation = creation_properties(H5P_FILE_CREATE, path.string());
  return {own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access_properties(path.string()).get()),
              path.string(), "create the file"),
          path.string()};
}

File File::open(const std::filesystem::path& path) {
  refuse_pipe(path);
  const InLibrary in_library;
  const Handle access = access_properties(path.string());
  // If metadata are inconsistent, a writer may be in the middle of a change. Therefore the library reads them again, up
  // to 100 times by default. Here it refuses them as damaged after 10 attempts.
  check(H5Pset_metadata_read_attempts(access.get(), 10), path.string(), "prepare");
  const hid_t live = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get());
  if (live >= 0) return {Handle(live), path.string()};
  // Files of older formats, which other programs may have written, cannot be read while they are written.
  return {own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), path.string(), "open the file"), path.string()};
}

File File::open_closed(const std::filesystem::path& path) {
  refuse_pipe(path);
  const InLibrary in_library;
  const Handle access = access_properties(path.string());
  return {own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), path.string(), "open the file"), path.string()};
}

File File::open_without_locks(const std::filesystem::path& path, unsigned flags) {
  const InLibrary in_library;
  const Handle access = access_properties(path.string());
  check(H5Pset_file_locking(access.get(), false, true), path.string(), "prepare");
  return {own(H5Fopen(path.c_str(), flags, access.get()), path.string(), "open the file"), path.string()};
}

File File::append_to(const std::filesystem::path& path) {
  return open_without_locks(path, H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE);
}

File File::change(const std::filesystem::path& path) {
  return open_without_locks(path, H5F_ACC_RDWR);
}

File File::modify(const std::filesystem::path& path, const std::filesystem::path& name) {
  const std::string shown = name.empty() ? path.string() : name.string();
  const InLibrary in_library;
  // A writer that was killed leaves the mark "open for writing" and an outdated end of file. This does what
  // `h5clear -s --increment=0` does.
  const Handle access = access_properties(shown);
  check(H5Pset_file_locking(access.get(), false, true), shown, "prepare");
  const hbool_t yes = true;
  check(H5Pset(access.get(), "clear_status_flags", &yes), shown, "prepare");
  check(H5Pset(access.get(), "skip_eof_check", &yes), shown, "prepare");
  File file(own(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()), shown, "open the file"), shown);
  // A file that is shorter than the length stored in it was cut off.
  haddr_t end = 0;
  check(H5Fget_eoa(file.handle_.get(), &end), shown, "read the length");
  if (std::filesystem::file_size(path) < end) throw OutputError(shown + ": the file is cut off");
  check(H5Fincrement_filesize(file.handle_.get(), 0), shown, "repair the file");
  return file;
}

std::string File::where(std::string_view name) const {
  return path_ + ":" + std::string(name);
}

void File::create_group(std::string_view name) {
  const InLibrary in_library;
  const Handle creation = creation_properties(H5P_GROUP_CREATE, where(name));
  make_parents(handle_, std::string(name), where(name));
  own(H5Gcreate2(handle_.get(), std::string(name).c_str(), link_properties(where(name)).get(), creation.get(),
                 H5P_DEFAULT),
      where(name), "make the group");
}

Dataset File::create_dataset(std::string_view name, const Layout& layout) {
  const InLibrary in_library;
  const int rank = layout.columns == 1 ? 1 : 2;
  const auto columns = static_cast<hsize_t>(layout.columns);
  const std::array<hsize_t, 2> size{0, columns}, limit{H5S_UNLIMITED, columns};
  const std::array<hsize_t, 2> chunk{static_cast<hsize_t>(layout.chunk_rows), columns};
  const Handle space = own(H5Screate_simple(rank, size.data(), limit.data()), where(name), "prepare");
  const Handle creation = creation_properties(H5P_DATASET_CREATE, where(name));
  check(H5Pset_chunk(creation.get(), rank, chunk.data()), where(name), "set chunks");
  if (layout.deflate > 0) {
    check(H5Pset_shuffle(creation.get()), where(name), "set compression");
    check(H5Pset_deflate(creation.get(), static_cast<unsigned>(layout.deflate)), where(name), "set compression");
  }
  return {make_dataset(handle_, std::string(name), where(name), file_type(layout.number), space, creation),
          where(name)};
}

void File::write_numbers(std::string_view name, std::span<const double> values, Number number) {
  const InLibrary in_library;
  const Handle creation = creation_properties(H5P_DATASET_CREATE, where(name));
  const Handle dataset = make_dataset(handle_, std::string(name), where(name), file_type(number),
                                      line_of(values.size(), where(name)), creation);
  check(H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), where(name), "write");
}

void File::write_strings(std::string_view name, std::span<const std::string> values) {
  const InLibrary in_library;
  const Handle creation = creation_properties(H5P_DATASET_CREATE, where(name));
  const Handle type = string_type();
  const Handle dataset =
      make_dataset(handle_, std::string(name), where(name), type.get(), line_of(values.size(), where(name)), creation);
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), where(name), "write");
}

bool File::contains(std::string_view name) const {
  const InLibrary in_library;
  // The library can only test one part of the path after the other.
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(handle_.get(), std::string(name.substr(0, end)).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string_view::npos) return true;
  }
}

bool File::is_group(std::string_view name) const {
  const InLibrary in_library;
  return H5Iget_type(object(name).get()) == H5I_GROUP;
}

std::vector<std::string> File::children(std::string_view group) const {
  const InLibrary in_library;
  std::vector<std::string> names;
  const Handle handle = object(group);
  check(H5Literate(handle.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_name, &names), where(group), "list");
  return names;
}

Dataset File::dataset(std::string_view name) const {
  return {object(name), where(name)};
}

std::vector<std::string> File::read_strings(std::string_view name) const {
  const InLibrary in_library;
  const Handle handle = object(name);
  const Handle space = own(H5Dget_space(handle.get()), where(name), "read");
  const Handle type = string_type();
  const hssize_t count = check(H5Sget_simple_extent_npoints(space.get()), where(name), "read");
  std::vector<char*> texts(static_cast<std::size_t>(count));
  check(H5Dread(handle.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()), where(name), "read");
  std::vector<std::string> values(texts.begin(), texts.end());
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, texts.data());
  return values;
}

Handle File::object(std::string_view name) const {
  const InLibrary in_library;
  return own(H5Oopen(handle_.get(), std::string(name).c_str(), H5P_DEFAULT), where(name), "open");
}

Handle File::attribute(std::string_view owner, std::string_view name) const {
  const InLibrary in_library;
  const Handle handle = object(owner);
  return own(H5Aopen(handle.get(), std::string(name).c_str(), H5P_DEFAULT), where(owner), "read the attribute");
}

void File::write_attribute(std::string_view owner, std::string_view name, std::int64_t type, const void* value) {
  const InLibrary in_library;
  write_attribute(owner, name, type, own(H5Screate(H5S_SCALAR), where(owner), "make an attribute"), value);
}

void File::write_attribute(std::string_view owner, std::string_view name, std::int64_t type, const Handle& space,
                           const void* value) {
  const InLibrary in_library;
  const Handle handle = object(owner);
  const std::string text(name);
  if (H5Aexists(handle.get(), text.c_str()) > 0)
    check(H5Adelete(handle.get(), text.c_str()), where(owner), "replace an attribute");
  const Handle made = own(H5Acreate2(handle.get(), text.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                          where(owner), "make an attribute");
  check(H5Awrite(made.get(), type, value), where(owner), "write an attribute");
}

void File::set_attribute(std::string_view owner, std::string_view name, std::string_view value) {
  const InLibrary in_library;
  const std::string text(value);
  const char* pointer = text.c_str();
  write_attribute(owner, name, string_type().get(), &pointer);
}

void File::set_attribute(std::string_view owner, std::string_view name, double value) {
  const InLibrary in_library;
  write_attribute(owner, name, H5T_NATIVE_DOUBLE, &value);
}

void File::set_attribute(std::string_view owner, std::string_view name, std::uint64_t value) {
  const InLibrary in_library;
  write_attribute(owner, name, H5T_NATIVE_UINT64, &value);
}

void File::set_attribute(std::string_view owner, std::string_view name, std::span<const std::int64_t> values) {
  const InLibrary in_library;
  write_attribute(owner, name, H5T_STD_I64LE, line_of(values.size(), where(owner)), values.data());
}

void File::set_fixed_text(std::string_view owner, std::string_view name, std::string_view text) {
  const InLibrary in_library;
  const Handle type = own(H5Tcopy(H5T_C_S1), where(owner), "make an attribute");
  check(H5Tset_size(type.get(), text.size()), where(owner), "make an attribute");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), where(owner), "make an attribute");
  write_attribute(owner, name, type.get(), text.data());
}

void File::set_integer(std::string_view owner, std::string_view name, std::int64_t value) {
  const InLibrary in_library;
  write_attribute(owner, name, H5T_STD_I64LE, &value);
}

void File::overwrite_integer(std::string_view owner, std::string_view name, std::int64_t value) {
  const InLibrary in_library;
  check(H5Awrite(attribute(owner, name).get(), H5T_NATIVE_INT64, &value), where(owner), "write an attribute");
}

void File::link_to_file(std::string_view name, const std::string& file, const std::string& object) {
  const InLibrary in_library;
  check(H5Lcreate_external(file.c_str(), object.c_str(), handle_.get(), std::string(name).c_str(),
                           link_properties(where(name)).get(), H5P_DEFAULT),
        where(name), "make the link");
}

std::string File::string_attribute(std::string_view owner, std::string_view name) const {
  const InLibrary in_library;
  return read_string(attribute(owner, name), where(owner));
}

double File::number_attribute(std::string_view owner, std::string_view name) const {
  const InLibrary in_library;
  double value = 0;
  check(H5Aread(attribute(owner, name).get(), H5T_NATIVE_DOUBLE, &value), where(owner), "read the attribute");
  return value;
}

std::uint64_t File::integer_attribute(std::string_view owner, std::string_view name) const {
  const InLibrary in_library;
  std::uint64_t value = 0;
  check(H5Aread(attribute(owner, name).get(), H5T_NATIVE_UINT64, &value), where(owner), "read the attribute");
  return value;
}

void File::start_appending() {
  const InLibrary in_library;
  check(H5Fstart_swmr_write(handle_.get()), path_, "start appending");
}

void File::flush() {
  const InLibrary in_library;
  check(H5Fflush(handle_.get(), H5F_SCOPE_GLOBAL), path_, "write");
}

void File::close() {
  const InLibrary in_library;
  flush();
  if (!handle_.close()) fail(path_, "close the file");
}

}  // namespace gyro::hdf5
