// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/log.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <fstream>
#include <iterator>
#include <string>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Redirects standard error to a file while this object exists.
class Redirection {
 public:
  explicit Redirection(const std::filesystem::path& path) : kept_(::dup(STDERR_FILENO)) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, STDERR_FILENO);
    ::close(file);
  }
  ~Redirection() {
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }

 private:
  int kept_;
};

}  // namespace

TEST_CASE("The log contains all messages, and standard error only warnings and errors") {
  const ScratchDirectory scratch;
  {
    const Redirection redirection(scratch.path() / "stderr");
    Log log(scratch.path() / "log.txt");
    log.info("{} is no format here");
    log.warning("overlap 6 %");
    log.error("stopped");
  }
  Log(scratch.path() / "log.txt").info("resumed");
  CHECK(text_of(scratch.path() / "stderr") == "warning: overlap 6 %\nerror: stopped\n");
  CHECK_THAT(text_of(scratch.path() / "log.txt"), Contains("info: {} is no format here\n") &&
                                                      Contains("warning: overlap 6 %\n") &&
                                                      Contains("error: stopped\n") && Contains("info: resumed\n"));
}

TEST_CASE("A log that cannot be opened is an output error") {
  CHECK_THROWS_AS(Log("/proc/gyrosim-log/log.txt"), OutputError);
}
