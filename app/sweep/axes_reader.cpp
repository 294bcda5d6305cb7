// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/axes_reader.hpp"

#include "app/sweep/latin_hypercube.hpp"
#include "app/sweep/value_text.hpp"
#include "io/schema/values.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace gyro {
namespace {

using Kind = YamlNode::Kind;

constexpr std::string_view vary_form = "a map of keys to lists, as `bonds.radius.relative: [0.1, 0.5]`";
constexpr std::string_view list_form = "a list of values; a single value for all points belongs below `set`";
constexpr std::string_view together_form =
    "a map of keys to lists of equal length, or a list of such maps; the keys of a map change together";
constexpr std::string_view hypercube_form = "a map of points, seed and ranges";
constexpr std::string_view ranges_form = "a map of keys to ranges, as `time.step: [1 us, 2 us]`";
constexpr std::string_view range_form = "[low, high] in one unit, or [low, high, log]";

/// The values of a key, as `[0.1, 0.5]`.
std::vector<SweepSetting> values_of(const YamlEntry& entry, MapReader& reader) {
  std::vector<SweepSetting> values;
  if (!reader.case_key(entry.key, entry.mark) || !reader.has_kind(entry, Kind::list, list_form)) return values;
  if (entry.value.items.empty()) reader.problem(entry.value.mark, entry.key + " has no values; give at least one");
  for (const YamlNode& item : entry.value.items) {
    SweepSetting setting{entry.key, value_text(item), entry.mark, item.mark};
    values.push_back(std::move(setting));
  }
  return values;
}

void refuse_twice(const std::vector<SweepSetting>& values, MapReader& reader) {
  for (std::size_t k = 1; k < values.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (values[j].value == values[k].value) {
        reader.problem(values[k].value_mark,
                       values[k].key + " has " + in_quotes(values[k].value) + " twice; give each value once");
        break;
      }
}

void read_vary(const YamlNode& root, MapReader& reader, std::vector<SweepAxis>& axes) {
  const YamlEntry* vary = reader.given(root, "vary", vary_form);
  if (vary == nullptr || !reader.has_kind(*vary, Kind::map, vary_form)) return;
  for (const YamlEntry& entry : vary->value.entries) {
    SweepAxis axis;
    const std::vector<SweepSetting> values = values_of(entry, reader);
    refuse_twice(values, reader);
    for (const SweepSetting& setting : values) axis.push_back({setting});
    if (!axis.empty()) axes.push_back(std::move(axis));
  }
}

void read_joined(const YamlNode& map, MapReader& reader, std::vector<SweepAxis>& axes) {
  std::vector<std::vector<SweepSetting>> columns;
  for (const YamlEntry& entry : map.entries) {
    if (std::vector<SweepSetting> values = values_of(entry, reader); !values.empty())
      columns.push_back(std::move(values));
    if (columns.size() > 1 && columns.back().size() != columns.front().size()) {
      reader.problem(entry.value.mark, entry.key + " has " + std::to_string(columns.back().size()) + " values and " +
                                           columns.front().front().key + " " + std::to_string(columns.front().size()) +
                                           "; keys that change together need equally many");
      columns.pop_back();
    }
  }
  SweepAxis axis(columns.empty() ? 0 : columns.front().size());
  for (const std::vector<SweepSetting>& column : columns)
    for (std::size_t k = 0; k < axis.size(); ++k) axis[k].push_back(column[k]);
  if (!axis.empty()) axes.push_back(std::move(axis));
}

void read_together(const YamlNode& root, MapReader& reader, std::vector<SweepAxis>& axes) {
  const YamlEntry* together = reader.given(root, "together", together_form);
  if (together == nullptr) return;
  if (together->value.kind == Kind::map) return read_joined(together->value, reader, axes);
  if (!reader.has_kind(*together, Kind::list, together_form)) return;
  for (const YamlNode& item : together->value.items)
    if (item.kind == Kind::map)
      read_joined(item, reader, axes);
    else
      reader.problem(item.mark, "together has the wrong form; give " + std::string(together_form));
}

/// A number and the unit behind it.
struct NumberWithUnit {
  double number = 0;
  std::string unit;
};

std::optional<NumberWithUnit> number_with_unit(const YamlNode& node) {
  if (node.kind != Kind::scalar) return {};
  NumberWithUnit result;
  const char* end = node.text.data() + node.text.size();
  const auto [rest, error] = std::from_chars(node.text.data(), end, result.number);
  if (error != std::errc() || !(result.number - result.number == 0)) return {};
  result.unit = std::string(rest, end);
  result.unit.erase(0, std::min(result.unit.find_first_not_of(' '), result.unit.size()));
  return result;
}

/// A range with the unit of its samples.
struct RangeWithUnit {
  SampledRange range;
  std::string unit;
};

std::optional<RangeWithUnit> read_range(const YamlEntry& entry, MapReader& reader) {
  const std::vector<YamlNode>& items = entry.value.items;
  const auto wrong = [&](const YamlNode& node, const std::string& what) {
    reader.problem(node.mark, entry.key + what + "; give " + std::string(range_form));
    return std::optional<RangeWithUnit>();
  };
  if (entry.value.kind != Kind::list || items.size() < 2 || items.size() > 3)
    return wrong(entry.value, " has the wrong form");
  const auto low = number_with_unit(items[0]), high = number_with_unit(items[1]);
  if (!low || !high) return wrong(items[low ? 1 : 0], ": this is not a number");
  if (low->unit != high->unit) return wrong(items[1], ": the two ends have different units");
  const bool logarithmic = items.size() == 3;
  if (logarithmic && items[2].text != "log") return wrong(items[2], ": this is not `log`");
  if (!(low->number < high->number)) return wrong(items[1], " does not rise");
  if (logarithmic && !(low->number > 0)) return wrong(items[0], ": a logarithmic range must be > 0");
  return RangeWithUnit{{low->number, high->number, logarithmic}, low->unit};
}

struct Hypercube {
  int points;
  std::uint64_t seed;
};

std::optional<Hypercube> read_hypercube(const YamlEntry& entry, MapReader& reader) {
  const YamlEntry* points = reader.given(entry.value, "points", "the number of points");
  const YamlEntry* seed = reader.given(entry.value, "seed", "a whole number");
  if (entry.value.find("points") == nullptr)
    reader.problem(entry.mark, "latin_hypercube has no points; give their number");
  if (entry.value.find("ranges") == nullptr)
    reader.problem(entry.mark, "latin_hypercube has no ranges; give " + std::string(ranges_form));
  const auto count = points ? reader.integer(points->value, "points", 1, max_points) : std::nullopt;
  const auto chosen = seed ? reader.integer(seed->value, "seed", 0, std::int64_t{1} << 53) : 1;
  if (!count || !chosen) return {};
  return Hypercube{static_cast<int>(*count), static_cast<std::uint64_t>(*chosen)};
}

void read_latin_hypercube(const YamlNode& root, MapReader& reader, std::vector<SweepAxis>& axes) {
  const YamlEntry* entry = reader.given(root, "latin_hypercube", hypercube_form);
  if (entry == nullptr || !reader.has_kind(*entry, Kind::map, hypercube_form)) return;
  reader.refuse_unknown(entry->value, {"points", "seed", "ranges"}, " in latin_hypercube");
  const auto cube = read_hypercube(*entry, reader);
  const YamlEntry* ranges = reader.given(entry->value, "ranges", ranges_form);
  if (ranges == nullptr || !reader.has_kind(*ranges, Kind::map, ranges_form)) return;
  SweepAxis axis(cube ? static_cast<std::size_t>(cube->points) : 0);
  int number = 0;
  for (const YamlEntry& range : ranges->value.entries) {
    const bool good = reader.case_key(range.key, range.mark);
    const auto read = read_range(range, reader);
    if (!good || !read || !cube) continue;
    const std::vector<std::string> samples = latin_hypercube(read->range, cube->points, cube->seed, number++);
    for (std::size_t k = 0; k < axis.size(); ++k)
      axis[k].push_back(
          {range.key, samples[k] + (read->unit.empty() ? "" : " " + read->unit), range.mark, range.value.mark});
  }
  if (!axis.empty() && !axis.front().empty()) axes.push_back(std::move(axis));
}

}  // namespace

std::vector<SweepAxis> read_axes(const YamlNode& root, MapReader& reader) {
  std::vector<SweepAxis> axes;
  read_vary(root, reader, axes);
  read_together(root, reader, axes);
  read_latin_hypercube(root, reader, axes);
  return axes;
}

}  // namespace gyro
