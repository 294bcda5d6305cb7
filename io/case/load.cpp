// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/printable.hpp"
#include "io/case/parts.hpp"
#include "io/files/read_file.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = 16 << 20;  // [bytes]; a case has some kB: this keeps a wrong file out of memory
constexpr std::string_view override_label = "--set";

/// A message on one line, whatever it quotes.
std::string one_line(std::string_view message) {
  std::string line = printable(message);
  for (std::size_t at = 0; (at = line.find('\n', at)) != std::string::npos;) line.replace(at, 1, "\\n");
  return line;
}

/// Text of the case file; empty, with a problem, if it cannot be read.
std::string read_text(const fs::path& file, CaseProblems& problems) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return problems.add({}, "there is no such file; give the path of a case file"), "";
  if (fs::is_directory(status)) return problems.add({}, "is a directory; give the path of a case file"), "";
  try {
    if (!fs::is_fifo(status)) return read_file(file, largest_file);
    static std::map<fs::path, std::string> pipes;  // what they held, for messages about them
    const auto known = pipes.find(file);
    return known != pipes.end() ? known->second : pipes[file] = read_file(file, largest_file);
  } catch (const UnreadableFile& unreadable) {
    return problems.add({}, unreadable.problem), "";
  }
}

/// Sets a value at a path; missing maps on the way are created.
void put(YamlNode& root, const std::vector<std::string_view>& path, const Mark& mark, YamlNode value) {
  YamlNode* node = &root;
  for (const std::string_view part : path) {
    if (node->kind != YamlNode::Kind::map) *node = {.kind = YamlNode::Kind::map, .mark = mark};
    YamlEntry* entry = node->find(part);
    if (entry == nullptr) entry = &node->entries.emplace_back(YamlEntry{std::string(part), mark, {.mark = mark}});
    node = &entry->value;
  }
  *node = std::move(value);
}

}  // namespace

void CaseProblems::add(const Mark& mark, std::string message) {
  problems_.push_back(
      {mark.source == 0 ? case_file_ : std::string(override_label), mark.line, mark.column, one_line(message)});
}

void CaseProblems::add_in_file(const fs::path& file, int line, int column, std::string message) {
  problems_.push_back({file.string(), line, column, one_line(message)});
}

std::vector<CaseProblem> CaseProblems::sorted() const {
  std::vector<CaseProblem> result = problems_;
  const auto place = [&](const CaseProblem& p) {
    const int group = p.file == case_file_ ? 0 : p.file == override_label ? 2 : 1;
    return std::make_tuple(group, std::string_view(p.file), p.line, p.column);
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const CaseProblem& a, const CaseProblem& b) { return place(a) < place(b); });
  const auto same = [](const CaseProblem& a, const CaseProblem& b) {
    return a.file == b.file && a.line == b.line && a.column == b.column && a.message == b.message;
  };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

void apply_overrides(YamlNode& root, const std::vector<std::string>& overrides, CaseProblems& problems) {
  for (std::size_t k = 0; k < overrides.size(); ++k) {
    const std::string_view text = overrides[k];
    const int number = static_cast<int>(k) + 1;
    const Mark begin{number, number, 1};
    const std::size_t equals = text.find('=');
    const std::vector<std::string_view> path = split(text.substr(0, equals), '.');
    const bool empty_part = std::find(path.begin(), path.end(), std::string_view{}) != path.end();
    if (equals == std::string_view::npos || path.empty() || empty_part || equals + 1 == text.size()) {
      problems.add(begin, '"' + overrides[k] + "\" is not an override; write key.path=value");
      continue;
    }
    const YamlDocument value = parse_yaml(text.substr(equals + 1), {number, number, static_cast<int>(equals) + 2});
    for (const MarkedProblem& problem : value.problems) problems.add(problem.mark, problem.message);
    if (value.problems.empty()) put(root, path, begin, value.root);
  }
}

namespace {

/// Gives the levels of detail that numerics.fidelity stands for, unless the case has its own or no bonds.
void choose_levels(YamlNode& root) {
  const auto given = [](const YamlNode& map, std::string_view key) -> const YamlNode* {
    const YamlEntry* entry = map.find(key);
    return entry == nullptr || entry->value.kind == YamlNode::Kind::null ? nullptr : &entry->value;
  };
  const YamlNode* numerics = given(root, "numerics");
  const YamlNode* fidelity = numerics == nullptr ? nullptr : given(*numerics, "fidelity");
  if (fidelity == nullptr || given(*numerics, "levels") != nullptr || given(root, "bonds") == nullptr) return;
  const Mark mark = fidelity->mark;
  if (fidelity->text == "engineering" || fidelity->text == "survey")
    put(root, {"numerics", "levels"}, mark, parse_yaml("{rigid: pieces}", mark).root);
}

}  // namespace

CaseReport load_case(const fs::path& file, const std::vector<std::string>& overrides) {
  CaseProblems problems(file.string());
  CaseReport report;
  const std::string text = read_text(file, problems);
  if (problems.empty()) {
    YamlDocument document = parse_yaml(text);
    for (const MarkedProblem& problem : document.problems) problems.add(problem.mark, problem.message);
    // In a document that is incomplete or not a map, further checks would report problems that do not exist.
    const bool whole = document.root.kind == YamlNode::Kind::map;
    if (whole) apply_overrides(document.root, overrides, problems), choose_levels(document.root);
    std::vector<MarkedProblem> marked;
    Setting root;
    if (whole || problems.empty()) root = read_settings(document.root, marked);
    for (const MarkedProblem& problem : marked) problems.add(problem.mark, problem.message);
    if (whole) {
      complete_settings(root, file, problems);
      const CaseTables tables = read_tables(root, problems);
      check_settings(root, problems);
      if (problems.empty()) {
        std::string digests = input_digests(root, problems);
        if (problems.empty()) {
          report.loaded = build_case(root, tables);
          report.loaded->file = fs::absolute(file).lexically_normal();
          report.loaded->resolved = write_settings(root);
          report.loaded->inputs = std::move(digests);
        }
      }
    }
  }
  report.problems = problems.sorted();
  return report;
}

CaseProblem problem_at(const fs::path& file, const std::vector<std::string>& overrides, const std::string& key,
                       std::string message) {
  CaseProblems problems(file.string()), unused(file.string());
  YamlDocument document = parse_yaml(read_text(file, unused));
  apply_overrides(document.root, overrides, unused);
  const YamlNode* node = &document.root;
  Mark mark{0, 1, 1};
  for (const std::string_view part : split(key, '.')) {
    const YamlEntry* entry = node->find(part);
    if (entry == nullptr) break;
    mark = entry->mark;
    node = &entry->value;
  }
  problems.add(mark, std::move(message));
  return problems.sorted().front();
}

std::string to_string(const CaseProblem& problem) {
  return problem.file + ":" + std::to_string(problem.line) + ":" + std::to_string(problem.column) + ": " +
         problem.message;
}

std::string resolved_yaml(const Case& checked) {
  return checked.resolved;
}

std::vector<PairProperties> pair_table(const Case& checked) {
  const std::size_t n = checked.materials.size();
  std::vector<PairProperties> table(n * n);
  for (const CaseContact& contact : checked.contacts) {
    const auto i = static_cast<std::size_t>(contact.first), j = static_cast<std::size_t>(contact.second);
    table[i * n + j] = table[j * n + i] = contact.properties;
  }
  return table;
}

}  // namespace gyro
