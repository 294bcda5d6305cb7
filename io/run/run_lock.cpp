// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/run_lock.hpp"

#include "core/base/errors.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <ctime>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>

namespace gyro {
namespace {

namespace fs = std::filesystem;

/// What run.lock says.
struct Holder {
  std::string host, since;
  long pid = 0;
  long beat = 0;  ///< signs of life so far
};

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

std::string text_of(const Holder& holder) {
  std::ostringstream text;
  text << "host " << holder.host << "\npid " << holder.pid << "\nsince " << holder.since << "\nbeat " << holder.beat
       << "\n";
  return text.str();
}

Holder holder_in(int file) {
  std::array<char, 1024> bytes{};
  const ssize_t count = ::pread(file, bytes.data(), bytes.size() - 1, 0);
  Holder holder;
  std::istringstream text(std::string(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0));
  for (std::string word; text >> word;) {
    if (word == "host") text >> holder.host;
    if (word == "pid") text >> holder.pid;
    if (word == "since") text >> holder.since;
    if (word == "beat") text >> holder.beat;
  }
  return holder;
}

[[noreturn]] void fail(const fs::path& path, const char* what) {
  throw OutputError(path.string() + ": cannot " + what + ": " + std::generic_category().message(errno));
}

[[noreturn]] void refuse(const fs::path& path, const Holder& holder) {
  const std::string who =
      holder.host.empty() ? "another process"
                          : "process " + std::to_string(holder.pid) + " on " + holder.host + ", since " + holder.since;
  throw BadInput(path.parent_path().string() + ": a run is still writing here (" + who +
                 "); wait for its end or stop it, or give another directory with --out");
}

enum class Locked { yes, no, unknown };

/// Locks the open file: not for a process, but for this opening of it, so that it holds inside a process, too.
Locked try_lock(int file) {
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(file, F_OFD_SETLK, &whole) == 0) return Locked::yes;
  return errno == EAGAIN || errno == EACCES ? Locked::no : Locked::unknown;  // unknown: a file system without locks
}

bool is_file_of(const fs::path& path, int file) {
  struct stat named = {}, open = {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(file, &open) == 0 && named.st_ino == open.st_ino &&
         named.st_dev == open.st_dev;
}

/// Whether the holder gives a sign of life while we watch. The file is opened each time: then NFS looks at the server.
bool gives_sign_of_life(const fs::path& path, const Holder& holder, LockTimes times) {
  std::cerr << path.string() << " is of process " << holder.pid << " on " << holder.host << ", since " << holder.since
            << "; looking for " << std::chrono::duration_cast<std::chrono::seconds>(times.patience).count()
            << " s whether it still runs\n";
  const auto end = std::chrono::steady_clock::now() + times.patience;
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(times.patience / 20);
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const Holder now = holder_in(file);
    ::close(file);
    if (now.pid != holder.pid || now.host != holder.host || now.beat != holder.beat) return true;
  }
  return false;
}

void require_dead(const fs::path& path, const Holder& holder, Locked locked, LockTimes times) {
  if (holder.host.empty()) return;
  const bool here = holder.host == host_name();
  if (here && locked == Locked::yes) return;  // its lock has ended with it
  const bool alive =
      here ? ::kill(static_cast<pid_t>(holder.pid), 0) == 0 || errno == EPERM : gives_sign_of_life(path, holder, times);
  if (alive) refuse(path, holder);
}

}  // namespace

struct RunLock::Held {
  Held(fs::path file_path, LockTimes lock_times);
  ~Held();
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  bool open_and_lock(LockTimes times);
  void write();
  void give_signs_of_life();

  fs::path path;
  int file = -1;
  Holder holder;
  std::mutex mutex;
  std::condition_variable wake;
  bool over = false;
  std::thread beating;
};

RunLock::Held::Held(fs::path file_path, LockTimes times) : path(std::move(file_path)) {
  while (!open_and_lock(times)) {
  }
  holder = {host_name(), utc_now(), static_cast<long>(::getpid()), 0};
  write();
  beating = std::thread([this, pause = times.beat] {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, pause, [this] { return over; })) give_signs_of_life();
  });
}

/// @returns false when the file was removed meanwhile by its former holder
bool RunLock::Held::open_and_lock(LockTimes times) {
  file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) fail(path, "create the file");
  try {
    const Locked locked = try_lock(file);
    if (locked == Locked::no) refuse(path, holder_in(file));
    if (is_file_of(path, file)) {
      require_dead(path, holder_in(file), locked, times);
      return true;
    }
  } catch (...) {
    ::close(file);
    throw;
  }
  ::close(file);
  return false;
}

void RunLock::Held::write() {
  const std::string text = text_of(holder);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    fail(path, "write");
}

void RunLock::Held::give_signs_of_life() {
  ++holder.beat;
  const std::string text = text_of(holder);
  // A disk that is full now is reported by what the run itself writes.
  [[maybe_unused]] const ssize_t written = ::pwrite(file, text.data(), text.size(), 0);
}

RunLock::Held::~Held() {
  if (beating.joinable()) {
    const std::lock_guard lock(mutex);
    over = true;
  }
  wake.notify_all();
  if (beating.joinable()) beating.join();
  ::unlink(path.c_str());  // before the lock ends: who waits for it sees that the file is gone
  ::close(file);
}

RunLock::RunLock(const fs::path& directory, LockTimes times)
    : held_(std::make_unique<Held>(directory / "run.lock", times)) {}
RunLock::~RunLock() = default;
RunLock::RunLock(RunLock&&) noexcept = default;
RunLock& RunLock::operator=(RunLock&&) noexcept = default;

}  // namespace gyro
