#include "results/storage/table_storage.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "results/storage/hdf5_limits.hpp"
#include "results/storage/result_layout.hpp"
#include "results/types/map_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace asperity::results {
namespace {

constexpr const char* title = "title";

void require_name(const std::string& what, const std::string& name) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos)
    throw std::domain_error(
        fmt::format("{} = \"{}\", but must be a name without '/'", what, name));
}

struct PlacedColumn {
  double place = 0.0;
  Column column;
};

PlacedColumn read_column(const Hdf5Group& group, const std::string& name,
                         double otherwise) {
  PlacedColumn read;
  read.column.name = name;
  read.column.values = group.column(name);
  const Hdf5Group dataset = group.open_dataset(name);
  read.column.unit =
      dataset.has_attribute("unit") ? dataset.text_attribute("unit") : "";
  read.place = dataset.has_attribute(layout::column_place)
                   ? dataset.number_attribute(layout::column_place)
                   : otherwise;
  return read;
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
  std::vector<PlacedColumn> read;
  for (const std::string& child : group.children()) {
    require_good_name(child, group.place());
    read.push_back(read_column(group, child, static_cast<double>(read.size())));
  }
  std::stable_sort(read.begin(), read.end(),
                   [](const PlacedColumn& a, const PlacedColumn& b) {
                     return a.place < b.place;
                   });
  for (PlacedColumn& one : read) {
    table.columns.push_back(std::move(one.column));
    const Column& column = table.columns.back();
    const std::size_t length = table.columns.front().values.size();
    if (column.values.size() != length)
      throw input::InputError(fmt::format(
          "{} has {} values, but must have {}, as {}", group.place(column.name),
          column.values.size(), length, table.columns.front().name));
  }
  return table;
}

} // namespace asperity::results
