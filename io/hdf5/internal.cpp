// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/hdf5/internal.hpp"

#include "core/base/errors.hpp"

#include <memory>

namespace gyro::hdf5 {
namespace {

herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* reason) {
  if (depth == 0 && error->desc) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

/// "No space left on device" out of "file write failed: ..., error message = 'No space left on device', ...".
std::string innermost_reason() {
  std::string reason = "unknown reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  const std::string key = "error message = '";
  if (const auto begin = reason.find(key); begin != std::string::npos) {
    const auto text = begin + key.size();
    return reason.substr(text, reason.find('\'', text) - text);
  }
  return reason;
}

}  // namespace

InLibrary::InLibrary() {
  static std::recursive_mutex turns;
  turn_ = std::unique_lock(turns);
  // The library must not do anything at exit either: after a full disk it would try to write again and print errors.
  [[maybe_unused]] static const herr_t no_exit_work = H5dont_atexit();
  [[maybe_unused]] thread_local const herr_t silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hid_t file_type(Number number) {
  switch (number) {
    case Number::float32:
      return H5T_IEEE_F32LE;
    case Number::float64:
      return H5T_IEEE_F64LE;
    case Number::uint8:
      return H5T_STD_U8LE;
    case Number::int32:
      return H5T_STD_I32LE;
    case Number::uint32:
      return H5T_STD_U32LE;
    case Number::int64:
      return H5T_STD_I64LE;
  }
  return H5I_INVALID_HID;
}

hid_t memory_type(Number number) {
  switch (number) {
    case Number::float32:
      return H5T_NATIVE_FLOAT;
    case Number::float64:
      return H5T_NATIVE_DOUBLE;
    case Number::uint8:
      return H5T_NATIVE_UINT8;
    case Number::int32:
      return H5T_NATIVE_INT32;
    case Number::uint32:
      return H5T_NATIVE_UINT32;
    case Number::int64:
      return H5T_NATIVE_INT64;
  }
  return H5I_INVALID_HID;
}

std::size_t size_of(Number number) {
  const InLibrary in_library;
  return H5Tget_size(file_type(number));
}

void fail(const std::string& where, const std::string& what) {
  throw OutputError(where + ": cannot " + what + ": " + innermost_reason());
}

Handle string_type() {
  Handle type = own(H5Tcopy(H5T_C_S1), "HDF5", "make the string type");
  check(H5Tset_size(type.get(), H5T_VARIABLE), "HDF5", "make the string type");
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "HDF5", "make the string type");
  return type;
}

std::string read_string(const Handle& attribute, const std::string& where) {
  char* text = nullptr;
  check(H5Aread(attribute.get(), string_type().get(), &text), where, "read the attribute");
  const std::unique_ptr<char, decltype(&H5free_memory)> owner(text, &H5free_memory);
  return text ? std::string(text) : std::string();
}

Handle::~Handle() {
  close();
}

bool Handle::close() {
  const InLibrary in_library;
  const hid_t id = std::exchange(id_, -1);
  return id < 0 || H5Idec_ref(id) >= 0;
}

}  // namespace gyro::hdf5
