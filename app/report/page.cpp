// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page.hpp"

#include "app/report/resources.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

namespace gyro::report {
namespace {

std::string title_of(const Runs& runs) {
  const std::string& first = runs.front().summary.title;
  const std::string title = first.empty() ? runs.front().name : first;
  return runs.size() == 1 ? title : std::to_string(runs.size()) + " runs compared";
}

std::string subtitle_of(const Runs& runs) {
  std::string text = runs.size() == 1 ? "Report of the run " : "Report of the runs ";
  for (std::size_t k = 0; k < runs.size(); ++k)
    text += (k == 0 ? "" : k + 1 == runs.size() ? " and " : ", ") + runs[k].name;
  return text + ", simulated with gyrosim " + runs.front().provenance.version;
}

}  // namespace

std::string html_page(std::string_view title, std::string_view subtitle, const std::string& content) {
  return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
         "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n<title>" +
         escape(title) + "</title>\n<style>\n/*<![CDATA[*/\n" + std::string(resources::page_css) +
         "/*]]>*/\n</style>\n</head>\n<body>\n<header><h1>" + escape(title) + "</h1><p>" + escape(subtitle) +
         "</p></header>\n<main>\n" + content + "</main>\n<script>\n//<![CDATA[\n" + std::string(resources::view3d_js) +
         "//]]>\n</script>\n</body>\n</html>\n";
}

std::string report_page(const std::vector<std::filesystem::path>& directories) {
  Runs runs;
  for (const auto& directory : directories) runs.push_back(read_run(directory));
  name_runs(runs);
  const std::string content = verdict_section(runs) + size_section(runs) + time_section(runs) + load_section(runs) +
                              energy_section(runs) + breakage_section(runs) + performance_section(runs) +
                              provenance_section(runs) + view_section(runs);
  return html_page(title_of(runs), subtitle_of(runs), content);
}

}  // namespace gyro::report
