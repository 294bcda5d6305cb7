// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/run_lock.hpp"

#include "core/base/errors.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <ctime>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace gyro {
namespace {

namespace fs = std::filesystem;

/// The contents of run.lock.
struct Holder {
  std::string host, since;
  long pid = 0;
  long beat = 0;  ///< number of signs of life so far
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
                          : "process " + std::to_string(holder.pid) + " on " + holder.host + " since " + holder.since;
  throw BadInput(
      path.parent_path().string() + ": " + lock_is_held + " (" + who +
      "); wait until it ends, stop it, or give another directory with --out. If that process is not a run of gyrosim, "
      "remove run.lock");
}

enum class Locked { yes, no, unknown };

/// Locks the open file. The lock belongs to this open file and not to the process, so that it also works within one
/// process.
Locked try_lock(int file) {
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(file, F_OFD_SETLK, &whole) == 0) return Locked::yes;
  return errno == EAGAIN || errno == EACCES ? Locked::no : Locked::unknown;  // unknown: the file system has no locks
}

bool is_file_of(const fs::path& path, int file) {
  struct stat named = {}, open = {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(file, &open) == 0 && named.st_ino == open.st_ino &&
         named.st_dev == open.st_dev;
}

/// Whether the holder gives a sign of life within times.patience. The file is opened again for each check, because NFS
/// then asks the server.
bool gives_sign_of_life(const fs::path& path, const Holder& holder, LockTimes times) {
  std::cerr << path.string() << " is held by process " << holder.pid << " on " << holder.host << " since "
            << holder.since << "; checking for "
            << std::chrono::duration_cast<std::chrono::seconds>(times.patience).count()
            << " s whether that process is still running\n";
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

bool is_process(long pid) {
  return pid > 0 && (::kill(static_cast<pid_t>(pid), 0) == 0 || errno == EPERM);
}

void require_dead(const fs::path& path, const Holder& holder, Locked locked, LockTimes times) {
  if (holder.host.empty()) return;
  const bool here = holder.host == host_name();
  if (here && locked == Locked::yes) return;  // the holder has ended, and its lock with it
  const bool alive = here ? is_process(holder.pid) : gives_sign_of_life(path, holder, times);
  if (alive) refuse(path, holder);
}

/// The file run.lock, open and locked, with this process as its holder.
class LockFile {
 public:
  LockFile(fs::path path, LockTimes times);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

  /// Writes a sign of life. @returns false if the file now has another holder
  bool beat();

 private:
  bool open_and_lock(LockTimes times);
  bool is_ours() const;

  fs::path path_;
  int file_ = -1;
  Holder holder_;
};

LockFile::LockFile(fs::path path, LockTimes times) : path_(std::move(path)) {
  while (!open_and_lock(times)) {
  }
  holder_ = {host_name(), utc_now(), static_cast<long>(::getpid()), 0};
  const std::string text = text_of(holder_);
  if (::ftruncate(file_, 0) == 0 && ::pwrite(file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()))
    return;
  const int reason = errno;
  ::close(file_);
  errno = reason;
  fail(path_, "write");
}

LockFile::~LockFile() {
  if (is_ours()) ::unlink(path_.c_str());  // before the lock ends: the next holder must see that the file was removed
  ::close(file_);
}

/// @returns false if the former holder has removed the file meanwhile
bool LockFile::open_and_lock(LockTimes times) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail(path_, "create the file");
  try {
    const Locked locked = try_lock(file_);
    if (locked == Locked::no) refuse(path_, holder_in(file_));
    if (is_file_of(path_, file_)) {
      require_dead(path_, holder_in(file_), locked, times);
      return true;
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
  ::close(file_);
  return false;
}

bool LockFile::is_ours() const {
  const Holder now = holder_in(file_);
  return now.host == holder_.host && now.pid == holder_.pid && now.since == holder_.since;
}

bool LockFile::beat() {
  if (!is_ours()) return false;
  ++holder_.beat;
  const std::string text = text_of(holder_);
  // A failure is ignored here: the run reports a full disk when it writes its own files.
  [[maybe_unused]] const ssize_t written = ::pwrite(file_, text.data(), text.size(), 0);
  return true;
}

}  // namespace

struct RunLock::Held {
  Held(const fs::path& path, LockTimes times);
  ~Held();
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  LockFile file;
  std::mutex mutex;
  std::condition_variable wake;
  bool over = false;
  std::atomic<bool> lost{false};
  std::thread beating;
};

RunLock::Held::Held(const fs::path& path, LockTimes times) : file(path, times) {
  beating = std::thread([this, pause = times.beat] {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, pause, [this] { return over; }))
      if (!file.beat()) lost = true;
  });
}

RunLock::Held::~Held() {
  {
    const std::lock_guard lock(mutex);
    over = true;
  }
  wake.notify_all();
  beating.join();
}

RunLock::RunLock(const fs::path& directory, LockTimes times)
    : held_(std::make_unique<Held>(directory / "run.lock", times)) {}
bool RunLock::lost() const {
  return held_->lost;
}

bool is_locked(const fs::path& directory) {
  const int file = ::open((directory / "run.lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  const bool held = ::fcntl(file, F_OFD_GETLK, &whole) == 0 && whole.l_type != F_UNLCK;
  ::close(file);
  return held;
}

RunLock::~RunLock() = default;
RunLock::RunLock(RunLock&&) noexcept = default;
RunLock& RunLock::operator=(RunLock&&) noexcept = default;

}  // namespace gyro
