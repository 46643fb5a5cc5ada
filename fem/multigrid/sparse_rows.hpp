#pragma once

// Small sparse matrices by rows: interpolation along an axis and on the contact
// surface, and the springs there.

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// A sparse matrix; row i has the entries start[i] to start[i + 1] - 1.
struct SparseRows {
  std::vector<std::size_t> start{0};
  std::vector<std::size_t> column;
  std::vector<double> weight;

  std::size_t rows() const { return start.size() - 1; }

  bool is_empty() const { return column.empty(); }

  std::size_t bytes() const {
    return start.size() * sizeof(std::size_t) +
           column.size() * (sizeof(std::size_t) + sizeof(double));
  }
};

SparseRows transposed(const SparseRows& matrix, std::size_t columns);

/// @param columns  of `right`
SparseRows product(const SparseRows& left, const SparseRows& right,
                   std::size_t columns);

/// The rows first..first+count-1, where row 0 follows the last.
SparseRows some_rows(const SparseRows& matrix, std::size_t first,
                     std::size_t count);

} // namespace asperity::fem
