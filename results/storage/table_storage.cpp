#include "results/storage/table_storage.hpp"

#include "base/require.hpp"
#include "results/storage/hdf5_limits.hpp"
#include "results/storage/result_layout.hpp"
#include "results/types/map_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace asperity::results {
namespace {

constexpr const char* title = "title";

void require_name(const std::string& what, const std::string& name) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos)
    throw std::domain_error(
        fmt::format("{} = \"{}\", but must be a name without '/'", what, name));
}

/// The names of the columns in their order.
std::vector<std::string> names_in(const Hdf5Group& group) {
  std::vector<std::pair<double, std::string>> placed;
  for (const std::string& name : group.children()) {
    require_good_name(name, group.place());
    const Hdf5Group dataset = group.open_dataset(name);
    placed.emplace_back(dataset.has_attribute(layout::column_place)
                            ? dataset.number_attribute(layout::column_place)
                            : static_cast<double>(placed.size()),
                        name);
  }
  std::ranges::stable_sort(placed, {}, &std::pair<double, std::string>::first);
  std::vector<std::string> names;
  names.reserve(placed.size());
  for (auto& [place, name] : placed)
    names.push_back(std::move(name));
  return names;
}

Column read_column(const Hdf5Group& group, const std::string& name) {
  const Hdf5Group dataset = group.open_dataset(name);
  return {name,
          dataset.has_attribute("unit") ? dataset.text_attribute("unit") : "",
          group.column(name)};
}

} // namespace

void require_table(const Table& table) {
  require_name("table.name", table.name);
  std::set<std::string> names;
  for (const Column& column : table.columns) {
    require_name("column.name", column.name);
    if (!names.insert(column.name).second)
      throw std::domain_error("column.name = \"" + column.name +
                              "\", but must occur only once");
    require_size("column.values", column.values.size(),
                 table.columns.front().values.size());
  }
}

void write_table(Hdf5Group& group, const Table& table) {
  group.set_attribute(title, table.title);
  int place = 0;
  for (const Column& column : table.columns) {
    group.append(column.name, column.values, Hdf5Number::float64, column.unit);
    group.open_dataset(column.name)
        .set_attribute(layout::column_place, place++);
  }
}

Table read_table(const Hdf5Group& group, const std::string& name) {
  Table table;
  table.name = name;
  if (group.has_attribute(title))
    table.title = group.text_attribute(title);
  const std::vector<std::string> names = names_in(group);
  group.common_length(names);
  for (const std::string& column : names)
    table.columns.push_back(read_column(group, column));
  return table;
}

} // namespace asperity::results
