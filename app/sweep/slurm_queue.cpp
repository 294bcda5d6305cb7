// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/slurm_queue.hpp"

#include "app/sweep/shell_text.hpp"
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/run/replace_file.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <sstream>

namespace gyro {
namespace {

namespace fs = std::filesystem;

fs::path jobs_file(const fs::path& directory) {
  return directory / "slurm-jobs.csv";
}

struct CommandOutput {
  int code = 0;
  std::string text;  ///< standard output and errors
};

CommandOutput output_of(const std::vector<std::string>& words) {
  FILE* pipe = ::popen((shell_line(words) + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw NoDevice("the system starts no more processes");
  CommandOutput output;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
    output.text.append(part.data(), count);
  const int status = ::pclose(pipe);
  output.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  while (!output.text.empty() && output.text.back() == '\n') output.text.pop_back();
  return output;
}

}  // namespace

std::string job_number(const std::string& output) {
  const std::string last = output.substr(output.rfind('\n') + 1), number = last.substr(0, last.find(';'));
  const bool digits = !number.empty() &&
                      std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return digits ? number : "";
}

std::vector<SlurmTask> submitted_tasks(const fs::path& directory) {
  std::vector<SlurmTask> tasks;
  if (!fs::exists(jobs_file(directory))) return tasks;
  std::istringstream lines(read_file(jobs_file(directory)));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (const std::size_t comma = line.find(','); comma != std::string::npos)
      tasks.push_back({line.substr(0, comma), line.substr(comma + 1)});
  return tasks;
}

std::set<std::string> points_in_queue(const fs::path& directory) {
  const std::vector<SlurmTask> tasks = submitted_tasks(directory);
  if (tasks.empty()) return {};
  const CommandOutput queue = output_of({"squeue", "--noheader", "--array", "--me", "--format=%F_%K"});
  if (queue.code != 0)
    throw NoDevice("squeue does not say which points are still in the queue: " + queue.text +
                   "; repeat the command where Slurm is installed and running");
  std::set<std::string> queued, points;
  std::istringstream words(queue.text);
  for (std::string word; words >> word;) queued.insert(word);
  for (const SlurmTask& task : tasks)
    if (queued.contains(task.id)) points.insert(task.point);
  return points;
}

std::string submit(const fs::path& directory, const std::vector<const CheckedPoint*>& points) {
  const fs::path script = directory / "job.sh";
  const CommandOutput answer = output_of({"sbatch", "--parsable", script.string()});
  const std::string job = job_number(answer.text);
  if (answer.code != 0 || job.empty())
    throw NoDevice("sbatch has not taken the job: " + answer.text + "; " + script.string() +
                   " is complete: submit it where Slurm is installed");
  std::string text = fs::exists(jobs_file(directory)) ? read_file(jobs_file(directory)) : "task,point\n";
  for (std::size_t k = 0; k < points.size(); ++k)
    text += job + "_" + std::to_string(k + 1) + "," + points[k]->name + "\n";
  replace_file(jobs_file(directory), text, true);
  return job;
}

}  // namespace gyro
