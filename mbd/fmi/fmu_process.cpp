// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/fmu_process.hpp"

#include "core/base/errors.hpp"
#include "mbd/fmi/packet.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

namespace gyro {
namespace {

using Clock = std::chrono::steady_clock;

/// First byte of an answer: whether the request succeeded, or how it failed.
enum class Answer : char { done, bad_input, stopped };

enum class Ended { no, closed, late };

constexpr Clock::time_point never = Clock::time_point::max();

/// Time left, at most an hour, so that poll() can take it [ms].
int milliseconds_until(Clock::time_point end) {
  constexpr int hour = 3'600'000;
  const Clock::time_point now = Clock::now();
  if (end > now + std::chrono::milliseconds(hour)) return hour;
  return static_cast<int>(std::max<long>(std::chrono::ceil<std::chrono::milliseconds>(end - now).count(), 0));
}

/// Reads `size` bytes, at the latest until `end`. Continues after an interruption by a signal.
Ended read_all(int socket, void* bytes, std::size_t size, Clock::time_point end) {
  char* at = static_cast<char*>(bytes);
  while (size > 0) {
    pollfd wait{socket, POLLIN, 0};
    const int ready = ::poll(&wait, 1, milliseconds_until(end));
    if (ready == 0 && Clock::now() < end) continue;
    if (ready == 0) return Ended::late;
    if (ready < 0 && errno == EINTR) continue;
    const ssize_t got = ::recv(socket, at, size, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Ended::closed;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return Ended::no;
}

bool write_all(int socket, const void* bytes, std::size_t size) {
  const char* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t put = ::send(socket, at, size, MSG_NOSIGNAL);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    at += put;
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

constexpr std::size_t max_packet = std::size_t{1} << 32;  ///< a saved state of 4 GB

bool send_packet(int socket, const Packet& packet) {
  const std::size_t size = packet.bytes().size();
  return write_all(socket, &size, sizeof size) && write_all(socket, packet.bytes().data(), size);
}

Ended receive_packet(int socket, Packet& packet, Clock::time_point end) {
  std::size_t size = 0;
  if (const Ended ended = read_all(socket, &size, sizeof size, end); ended != Ended::no) return ended;
  if (size > max_packet) return Ended::closed;  // the FMU has written into the socket
  std::vector<char> bytes(size);
  const Ended ended = read_all(socket, bytes.data(), size, end);
  packet = Packet(std::move(bytes));
  return ended;
}

void put_advance(Packet& packet, const ShaftAdvance& a) {
  for (const double value : {a.angle, a.spin_angle, a.motor_angle, a.speed_change, a.motor_impulse, a.motor_work,
                             a.loss_work, a.kinetic_gain, a.stopped_after})
    packet.put(value);
  packet.put_list(a.events);
}

ShaftAdvance get_advance(Packet& packet) {
  ShaftAdvance a;
  for (double* value : {&a.angle, &a.spin_angle, &a.motor_angle, &a.speed_change, &a.motor_impulse, &a.motor_work,
                        &a.loss_work, &a.kinetic_gain, &a.stopped_after})
    *value = packet.get<double>();
  a.events = packet.get_list<std::vector<DriveEvent>>();
  return a;
}

void put_notes(Packet& packet, const std::vector<std::string>& notes) {
  packet.put(notes.size());
  for (const std::string& note : notes) packet.put_list(note);
}

std::string seconds(std::chrono::milliseconds time) {
  std::ostringstream text;
  text << static_cast<double>(time.count()) / 1000;
  return text.str();
}

std::string signal_text(int signal) {
  const char* text = ::strsignal(signal);
  return "signal " + std::to_string(signal) + (text != nullptr ? std::string(" (") + text + ")" : "");
}

}  // namespace

/// The child process: an FmuDrive that answers requests until the socket is closed.
class FmuProcess::Server {
 public:
  Server(int socket, const FmuSetup& setup, std::chrono::milliseconds patience)
      : socket_(socket), patience_(patience), setup_(setup) {}

  /// Ends the process by _exit(), so that destructors of objects that belong to the parent process do not run here.
  [[noreturn]] void run() {
    limit_time();
    answer([this](Packet& out) {
      drive_.emplace(setup_);
      out.put(drive_->start()).put(drive_->start_angle()).put_list(drive_->unsaveable());
    });
    ::alarm(0);  // until the first request: the program may place millions of particles meanwhile
    for (Packet request; drive_ && receive_packet(socket_, request, never) == Ended::no;) {
      limit_time();
      answer([&](Packet& out) { serve(request, out); });
      ::alarm(0);
    }
    limit_time();
    drive_.reset();        // terminates the FMU
    std::fflush(nullptr);  // what it has printed
    ::_exit(0);
  }

 private:
  /// Ends this process if the FMU hangs and the parent process no longer exists.
  void limit_time() const { ::alarm(static_cast<unsigned>(patience_.count() / 1000 + 5)); }

  void serve(Packet& in, Packet& out) {
    const auto request = in.get<Request>();
    if (request == Request::save) return static_cast<void>(out.put_list(drive_->save()));
    if (request == Request::restore) return drive_->restore(in.get_list<std::vector<std::uint8_t>>());
    const auto duration = in.get<double>();
    const auto load = in.get<ShaftLoad>();
    auto motion = in.get<ShaftMotion>();
    put_advance(out, request == Request::preview ? drive_->preview(duration, load, motion)
                                                 : drive_->advance(duration, load, motion));
    out.put(motion);
  }

  template <class Work>
  void answer(const Work& work) {
    Packet body;
    Answer kind = Answer::done;
    std::string reason;
    try {
      work(body);
    } catch (const BadInput& bad) {
      kind = Answer::bad_input, reason = bad.what();
    } catch (const StoppedByGuard& stop) {
      kind = Answer::stopped, reason = stop.what();
    } catch (const std::exception& thrown) {
      kind = Answer::stopped, reason = "the drivetrain FMU " + setup_.name + " threw an exception: " + thrown.what();
    } catch (...) {
      kind = Answer::stopped, reason = "the drivetrain FMU " + setup_.name + " threw an exception of unknown type";
    }
    Packet packet;
    packet.put(kind).put_list(reason).put(drive_ ? now() : Now{});
    put_notes(packet, drive_ ? drive_->take_notes() : std::vector<std::string>{});
    packet.put_list(body.bytes());
    if (!send_packet(socket_, packet)) ::_exit(0);
  }

  Now now() const {
    return {drive_->energy({}), drive_->motor_speed({}), drive_->motor_torque_now({}, {}), drive_->idle_speed()};
  }

  int socket_;
  std::chrono::milliseconds patience_;
  const FmuSetup& setup_;
  std::optional<FmuDrive> drive_;
};

/// This program's end of the socket, and the child process.
class FmuProcess::Channel {
 public:
  Channel(const FmuSetup& setup, std::chrono::milliseconds patience);
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// Sends a request, if there is one, and waits for the answer's body.
  /// @throws BadInput, StoppedByGuard as the child process did; StoppedByGuard if it has ended or does not answer
  Packet ask(const Packet* request, Now& now, std::vector<std::string>& notes);

 private:
  [[noreturn]] void give_up(Ended how);
  static Packet body_of(Packet& answer, Now& now, std::vector<std::string>& notes);
  std::string end_of_process();

  std::string name_;
  std::chrono::milliseconds patience_;
  int socket_ = -1;
  pid_t process_ = -1;
};

FmuProcess::Channel::Channel(const FmuSetup& setup, std::chrono::milliseconds patience)
    : name_(setup.name), patience_(patience) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot create the socket for the FMU's process");
  std::cout << std::flush;  // otherwise both processes would write the buffered output
  std::cerr << std::flush;
  std::fflush(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    // The parent process handles signals to the terminal's group, because it may save the FMU's state first.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGXCPU}) ::signal(signal, SIG_IGN);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGALRM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
      ::signal(signal, SIG_DFL);
    constexpr int kept = 3;  // all other files are closed here, such as the lock of the run's directory
    if (::dup2(ends[1], kept) != kept) ::_exit(1);
    ::fcntl(kept, F_SETFD, FD_CLOEXEC);  // a program that the FMU starts must not keep the socket open
    ::close_range(kept + 1, ~0U, 0);
    Server(kept, setup, patience).run();
  }
  ::close(ends[1]);
  socket_ = ends[0];
  if (process_ < 0) {
    const int reason = errno;
    ::close(socket_);
    throw std::system_error(reason, std::generic_category(), "cannot start the FMU's process");
  }
}

FmuProcess::Channel::~Channel() {
  ::close(socket_);
  if (process_ >= 0) end_of_process();
}

/// Waits for the end of the process; ends it when it lives on. @returns how it ended
std::string FmuProcess::Channel::end_of_process() {
  const Clock::time_point end = Clock::now() + std::min<std::chrono::milliseconds>(patience_, std::chrono::seconds(10));
  int status = 0;
  while (::waitpid(process_, &status, WNOHANG) == 0) {
    if (Clock::now() > end) ::kill(process_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process_ = -1;
  if (WIFSIGNALED(status)) return "was ended by " + signal_text(WTERMSIG(status));
  return "ended its process with exit code " + std::to_string(WEXITSTATUS(status));
}

void FmuProcess::Channel::give_up(Ended how) {
  const std::string who = "the drivetrain FMU " + name_ + " ";
  if (how == Ended::closed) throw StoppedByGuard(who + end_of_process());
  ::kill(process_, SIGKILL);
  end_of_process();
  throw StoppedByGuard(who + "has not answered for " + seconds(patience_) + " s");
}

Packet FmuProcess::Channel::ask(const Packet* request, Now& now, std::vector<std::string>& notes) {
  if (process_ < 0) throw StoppedByGuard("the drivetrain FMU " + name_ + " has ended");
  if (request != nullptr && !send_packet(socket_, *request)) give_up(Ended::closed);
  Packet answer;
  if (const Ended ended = receive_packet(socket_, answer, Clock::now() + patience_); ended != Ended::no) give_up(ended);
  try {
    return body_of(answer, now, notes);
  } catch (const std::out_of_range&) {
    throw StoppedByGuard("the drivetrain FMU " + name_ + " has damaged its process: its answer cannot be read");
  }
}

Packet FmuProcess::Channel::body_of(Packet& answer, Now& now, std::vector<std::string>& notes) {
  const auto kind = answer.get<Answer>();
  const auto reason = answer.get_list<std::string>();
  now = answer.get<Now>();
  for (auto count = answer.get<std::size_t>(); count > 0; --count) notes.push_back(answer.get_list<std::string>());
  if (kind == Answer::bad_input) throw BadInput(reason);
  if (kind == Answer::stopped) throw StoppedByGuard(reason);
  return Packet(answer.get_list<std::vector<char>>());
}

FmuProcess::FmuProcess(FmuSetup setup, std::chrono::milliseconds patience)
    : setup_(std::move(setup)), channel_(std::make_unique<Channel>(setup_, patience)) {
  try {
    Packet answer = channel_->ask(nullptr, now_, notes_);
    start_ = answer.get<ShaftMotion>();
    start_angle_ = answer.get<double>();
    unsaveable_ = answer.get_list<std::string>();
  } catch (const StoppedByGuard& failure) {
    throw BadInput(failure.what());
  }
}

FmuProcess::~FmuProcess() = default;

ShaftAdvance FmuProcess::move(Request request, double duration, const ShaftLoad& load, ShaftMotion& motion) {
  const Packet packet = Packet().put(request).put(duration).put(load).put(motion);
  Packet answer = channel_->ask(&packet, now_, notes_);
  ShaftAdvance gained = get_advance(answer);
  motion = answer.get<ShaftMotion>();
  return gained;
}

ShaftAdvance FmuProcess::preview(double duration, const ShaftLoad& load, ShaftMotion& motion) {
  return move(Request::preview, duration, load, motion);
}

ShaftAdvance FmuProcess::advance(double duration, const ShaftLoad& load, ShaftMotion& motion) {
  return move(Request::advance, duration, load, motion);
}

std::vector<std::uint8_t> FmuProcess::save() const {
  const Packet packet = Packet().put(Request::save);
  Now same;
  return channel_->ask(&packet, same, notes_).get_list<std::vector<std::uint8_t>>();
}

void FmuProcess::restore(std::span<const std::uint8_t> bytes) {
  Packet packet;
  packet.put(Request::restore).put_list(bytes);
  channel_->ask(&packet, now_, notes_);
}

std::vector<std::string> FmuProcess::take_notes() {
  return std::exchange(notes_, {});
}

}  // namespace gyro
