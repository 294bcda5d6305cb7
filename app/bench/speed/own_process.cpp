// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/own_process.hpp"

#include "core/base/errors.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

namespace gyro::bench {
namespace {

enum class Kind : int { done, bad_input, stopped, output, resources, internal };

nlohmann::json failure(Kind kind, const std::string& message) {
  return {{"kind", kind}, {"message", message}};
}

nlohmann::json outcome_of(const std::function<nlohmann::json()>& work) {
  try {
    return {{"kind", Kind::done}, {"result", work()}};
  } catch (const BadInput& e) {
    return failure(Kind::bad_input, e.what());
  } catch (const StoppedByGuard& e) {
    return failure(Kind::stopped, e.what());
  } catch (const OutputError& e) {
    return failure(Kind::output, e.what());
  } catch (const NoDevice& e) {
    return failure(Kind::resources, e.what());
  } catch (const std::bad_alloc&) {
    return failure(Kind::resources, "out of memory; measure a smaller scene");
  } catch (const std::exception& e) {
    return failure(Kind::internal, e.what());
  }
}

[[noreturn]] void child(int pipe, const std::function<nlohmann::json()>& work) {
  const std::string text = outcome_of(work).dump();
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t n = ::write(pipe, text.data() + sent, text.size() - sent);
    if (n < 0 && errno != EINTR) ::_exit(1);
    if (n > 0) sent += static_cast<std::size_t>(n);
  }
  ::_exit(0);  // not exit(): what the parent has not yet printed is the parent's
}

std::string all_of(int pipe) {
  std::string text;
  char part[4096];
  for (;;) {
    const ssize_t n = ::read(pipe, part, sizeof part);
    if (n == 0 || (n < 0 && errno != EINTR)) return text;
    if (n > 0) text.append(part, static_cast<std::size_t>(n));
  }
}

nlohmann::json result_of(const std::string& text, int status) {
  if (WIFSIGNALED(status))
    throw NoDevice(std::string("a measurement was ended by a signal (") + ::strsignal(WTERMSIG(status)) +
                   "); if it was killed, the machine may lack memory: measure a smaller scene");
  const nlohmann::json outcome = nlohmann::json::parse(text);
  const std::string message = outcome.value("message", "");
  switch (outcome.at("kind").get<Kind>()) {
    case Kind::done:
      return outcome.at("result");
    case Kind::bad_input:
      throw BadInput(message);
    case Kind::stopped:
      throw StoppedByGuard(message);
    case Kind::output:
      throw OutputError(message);
    case Kind::resources:
      throw NoDevice(message);
    case Kind::internal:
      break;
  }
  throw std::runtime_error(message);
}

}  // namespace

nlohmann::json in_own_process(const std::function<nlohmann::json()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw NoDevice(std::string("no pipe to a measurement: ") + std::strerror(errno));
  const pid_t id = ::fork();
  if (id < 0) throw NoDevice(std::string("no process for a measurement: ") + std::strerror(errno));
  if (id == 0) {
    ::close(ends[0]);
    child(ends[1], work);
  }
  ::close(ends[1]);
  const std::string text = all_of(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) continue;
  return result_of(text, status);
}

}  // namespace gyro::bench
