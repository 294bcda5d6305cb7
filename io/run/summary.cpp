// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary.hpp"

#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/run/progress.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/summary_lines.hpp"
#include "io/run/summary_table.hpp"

#include <cmath>
#include <filesystem>

namespace gyro {
namespace {

template <class S>
void list_figures(const std::vector<Figure<S>>& table, const std::string& prefix, std::vector<SummaryMember>& all) {
  for (const Figure<S>& f : table)
    all.push_back({prefix + std::string(f.name), std::string(f.units), f.when, std::string(f.description)});
}

}  // namespace

std::vector<SummaryMember> summary_members() {
  std::vector<SummaryMember> all;
  list_figures(summary_figures(), "", all);
  list_figures(steady_figures(), "steady.", all);
  list_figures(motor_figures(), "motor.", all);
  list_figures(laboratory_figures(), "laboratory.", all);
  list_figures(fines_figures(), "fines.", all);
  list_figures(drive_event_figures(), "drive_events[].", all);
  return all;
}

std::string to_string(RunStatus status) {
  switch (status) {
    case RunStatus::done:
      return "done";
    case RunStatus::interrupted:
      return "interrupted";
    case RunStatus::stopped:
      return "stopped";
    case RunStatus::failed:
      return "failed";
  }
  return "failed";
}

std::string to_json(const Summary& summary) {
  // A title may contain bytes that are not UTF-8; the summary must be written nevertheless.
  return json_of(summary_figures(), summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_text(const Summary& s, const std::filesystem::path& directory) {
  std::string text = "\n" + (s.title.empty() ? std::string("Run") : s.title) + ": " + to_string(s.status);
  if (!s.reason.empty()) text += " (" + s.reason + ")";
  text += format(", %.6g s simulated in ", s.simulated_seconds) + format_duration(s.wall_seconds) + "\n";
  return text + lines_of(summary_figures(), s) + line("output", directory.string());
}

void write_summary(const Summary& summary, const std::filesystem::path& directory) {
  replace_file(directory / "summary.json", to_json(summary), true);
}

Summary load_summary(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "summary.json";
  if (!std::filesystem::exists(path))
    throw BadInput(path.string() +
                   ": does not exist; give the directory of a run that has ended, which writes this file");
  const Json json = Json::parse(read_file(path), nullptr, false);
  try {
    if (!json.is_object() || !json.contains("status")) throw BadInput("it has no status");
    Summary summary;
    read(summary_figures(), json, summary);
    return summary;
  } catch (const std::exception& problem) {
    throw BadInput(path.string() + ": is not a summary of a run (" + problem.what() +
                   "); restore the file, or run the case again");
  }
}

std::optional<EarlierRun> read_summary(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "summary.json";
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Json json = Json::parse(read_file(file), nullptr, false);
  if (!json.is_object() || !json.contains("status") || !json["status"].is_string()) return std::nullopt;
  EarlierRun run{json["status"].get<std::string>(), 0};
  if (json.contains("simulated_seconds") && json["simulated_seconds"].is_number())
    run.simulated_seconds = json["simulated_seconds"].get<double>();
  return run;
}

}  // namespace gyro
