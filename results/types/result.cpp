#include "results/types/result.hpp"

#include <algorithm>

namespace asperity::results {

Fields Fields::on_map() const {
  Fields shown;
  shown.step = step;
  shown.nominal_pressure = nominal_pressure;
  shown.grid = map.grid(grid);
  shown.stored_pressure = map.of(pressure_map(), grid);
  shown.stored_gap = map.of(gap_map(), grid);
  return shown;
}

void Table::add(std::span<const double> row) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    columns[i].values.push_back(row[i]);
}

std::vector<double> Table::values(const std::string& column) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(),
                   [&](const Column& one) { return one.name == column; });
  return found == columns.end() ? std::vector<double>{} : found->values;
}

const Table* Result::table(const std::string& name) const {
  const auto found = std::ranges::find(tables, name, &Table::name);
  return found == tables.end() ? nullptr : &*found;
}

const MethodRecord* Result::method(const std::string& name) const {
  const auto found = std::ranges::find(methods, name, &MethodRecord::name);
  return found == methods.end() ? nullptr : &*found;
}

} // namespace asperity::results
