#include "fem/multigrid/sparse_rows.hpp"

#include <limits>

namespace asperity::fem {

SparseRows transposed(const SparseRows& matrix, std::size_t columns) {
  SparseRows result;
  result.start.assign(columns + 1, 0);
  for (const std::size_t column : matrix.column)
    ++result.start[column + 1];
  for (std::size_t i = 0; i < columns; ++i)
    result.start[i + 1] += result.start[i];
  result.column.resize(matrix.column.size());
  result.weight.resize(matrix.column.size());
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t row = 0; row < matrix.rows(); ++row)
    for (std::size_t i = matrix.start[row]; i < matrix.start[row + 1]; ++i) {
      const std::size_t at = next[matrix.column[i]]++;
      result.column[at] = row;
      result.weight[at] = matrix.weight[i];
    }
  return result;
}

SparseRows product(const SparseRows& left, const SparseRows& right,
                   std::size_t columns) {
  constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place(columns, nowhere); // in the present row
  SparseRows result;
  const auto add = [&](std::size_t column, double weight) {
    if (place[column] == nowhere) {
      place[column] = result.column.size();
      result.column.push_back(column);
      result.weight.push_back(0.0);
    }
    result.weight[place[column]] += weight;
  };
  for (std::size_t row = 0; row < left.rows(); ++row) {
    const std::size_t first = result.column.size();
    for (std::size_t i = left.start[row]; i < left.start[row + 1]; ++i) {
      const std::size_t middle = left.column[i];
      for (std::size_t j = right.start[middle]; j < right.start[middle + 1];
           ++j)
        add(right.column[j], left.weight[i] * right.weight[j]);
    }
    for (std::size_t i = first; i < result.column.size(); ++i)
      place[result.column[i]] = nowhere;
    result.start.push_back(result.column.size());
  }
  return result;
}

SparseRows some_rows(const SparseRows& matrix, std::size_t first,
                     std::size_t count) {
  SparseRows result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = (first + i) % matrix.rows();
    for (std::size_t at = matrix.start[row]; at < matrix.start[row + 1]; ++at) {
      result.column.push_back(matrix.column[at]);
      result.weight.push_back(matrix.weight[at]);
    }
    result.start.push_back(result.column.size());
  }
  return result;
}

} // namespace asperity::fem
