// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <hdf5.h>
#include <mutex>
#include <string>

// For the files in io/hdf5 only: connects the types of the C API with ours.
namespace gyro::hdf5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// While it exists, no other thread is in the library, and the library prints no errors. Every function that calls the
/// library holds one; a thread may hold several.
class InLibrary {
 public:
  InLibrary();

 private:
  std::unique_lock<std::recursive_mutex> turn_;
};

/// Throws OutputError "WHERE: cannot WHAT: reason" with the library's innermost reason.
[[noreturn]] void fail(const std::string& where, const std::string& what);

/// Returns an identifier or status. @throws OutputError if it is negative
template <class Status>
Status check(Status status, const std::string& where, const char* what) {
  if (status < 0) fail(where, what);
  return status;
}

/// Checks an identifier like check(), and takes ownership of it.
inline Handle own(hid_t id, const std::string& where, const char* what) {
  return Handle(check(id, where, what));
}

/// Types of numbers in our files, and in memory.
hid_t file_type(Number number);
hid_t memory_type(Number number);

/// Type of strings in our files: UTF-8, variable length.
Handle string_type();

/// Reads an attribute of the type string_type(). @param attribute  open
std::string read_string(const Handle& attribute, const std::string& where);

}  // namespace gyro::hdf5
