// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

namespace gyro::report {

std::string section(std::string_view id, std::string_view title, const std::string& content) {
  if (content.empty()) return "";
  return "<section id=\"" + std::string(id) + "\"><h2>" + escape(title) + "</h2>\n" + content + "</section>\n";
}

std::string side_by_side(const std::string& figures) {
  return figures.empty() ? "" : "<div class=\"figures\">\n" + figures + "</div>\n";
}

std::string folded(std::string_view name, const std::string& content, bool open) {
  return std::string("<details") + (open ? " open=\"open\"" : "") + "><summary>" + escape(name) + "</summary>\n" +
         content + "</details>\n";
}

std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& cell : head) html += "<th scope=\"col\">" + cell + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k)
      html += k == 0 ? "<th scope=\"row\">" + row[k] + "</th>" : "<td>" + row[k] + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace gyro::report
