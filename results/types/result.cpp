#include "results/types/result.hpp"

#include <algorithm>

namespace asperity::results {

std::vector<double> Table::values(const std::string& column) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(),
                   [&](const Column& one) { return one.name == column; });
  return found == columns.end() ? std::vector<double>{} : found->values;
}

const Table* Result::table(const std::string& name) const {
  const auto found =
      std::find_if(tables.begin(), tables.end(),
                   [&](const Table& one) { return one.name == name; });
  return found == tables.end() ? nullptr : &*found;
}

} // namespace asperity::results
