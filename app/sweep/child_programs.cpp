// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/child_programs.hpp"

#include "core/base/errors.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace gyro {
namespace {

constexpr int cannot_start = 127;  ///< exit code of a child whose program cannot be started

bool is_ignored(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

/// The child between fork and exec: only calls that are safe there.
[[noreturn]] void become_program(char* const* words, int log, const sigset_t& mask, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::sigprocmask(SIG_SETMASK, &mask, nullptr);
  if (::getppid() == parent) ::execv("/proc/self/exe", words);
  _exit(cannot_start);
}

}  // namespace

ChildPrograms::ChildPrograms() {
  sigemptyset(&signals_);
  std::signal(SIGCHLD, SIG_DFL);  // otherwise a caller that ignores it would take the exit codes of the children
  sigaddset(&signals_, SIGCHLD);
  // A blocked signal waits for sigtimedwait() even if it is ignored, as by `nohup`.
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGXCPU})
    if (!is_ignored(signal)) sigaddset(&signals_, signal);
  ::sigprocmask(SIG_BLOCK, &signals_, &before_);
}

ChildPrograms::~ChildPrograms() {
  while (wait(std::chrono::milliseconds(0)) != 0) {  // what came after the last child had ended
  }
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

pid_t ChildPrograms::start_self(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw OutputError(log.string() + ": cannot open: " + std::generic_category().message(errno));
  std::vector<std::string> words{"gyrosim"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become_program(pointers.data(), file, before_, parent);
  const int reason = errno;
  ::close(file);
  if (child < 0) throw NoDevice("the system starts no more processes: " + std::generic_category().message(reason));
  running_.push_back(child);
  return child;
}

int ChildPrograms::wait(std::chrono::milliseconds longest) {
  const timespec time{longest.count() / 1000, (longest.count() % 1000) * 1'000'000};
  const int signal = ::sigtimedwait(&signals_, nullptr, &time);
  return signal < 0 || signal == SIGCHLD ? 0 : signal;
}

std::vector<EndedChild> ChildPrograms::take_ended() {
  std::vector<EndedChild> ended;
  std::erase_if(running_, [&](pid_t child) {
    int status = 0;
    const pid_t found = ::waitpid(child, &status, WNOHANG);
    if (found == 0 || (found < 0 && errno == EINTR)) return false;
    const int signal = found > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    constexpr int unknown = 1;  // the child is not ours any more
    ended.push_back({child, signal != 0 ? 128 + signal : found < 0 ? unknown : WEXITSTATUS(status), signal});
    return true;
  });
  return ended;
}

void ChildPrograms::send(int signal) const {
  for (const pid_t child : running_) ::kill(child, signal);
}

}  // namespace gyro
