#include "fem/multigrid/unknown_constraints.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace asperity::fem {

void UnknownConstraints::add(std::size_t unknown) {
  unknowns.push_back(static_cast<std::uint32_t>(unknown));
  is_node.push_back(false);
  start.push_back(static_cast<std::uint32_t>(masters.size()));
  if (unknown % 3 != 2 || rows() < 3)
    return;
  const std::size_t first = rows() - 3;
  if (is_node[first] || !is_shifted(first, 1) || !is_shifted(first, 2))
    return;
  is_node[first] = true;
  is_node.resize(first + 1);
  unknowns.resize(first + 1);
  start.resize(first + 2);
  masters.resize(start.back());
  weights.resize(start.back());
}

/// Whether the row that follows by `shift` differs from a row by so many
/// components only.
bool UnknownConstraints::is_shifted(std::size_t row,
                                    std::uint32_t shift) const {
  const std::uint32_t size = start[row + 1] - start[row];
  const std::uint32_t other = start[row + shift];
  if (unknowns[row + shift] != unknowns[row] + shift ||
      start[row + shift + 1] - other != size)
    return false;
  for (std::uint32_t i = 0; i < size; ++i)
    if (masters[other + i] != masters[start[row] + i] + shift ||
        weights[other + i] != weights[start[row] + i])
      return false;
  return true;
}

std::size_t UnknownConstraints::row_of(std::size_t unknown) const {
  const auto next = std::ranges::upper_bound(unknowns, unknown);
  if (next == unknowns.begin())
    return rows();
  const auto row = static_cast<std::size_t>(next - unknowns.begin()) - 1;
  return unknown < unknowns[row] + width(row) ? row : rows();
}

namespace {

/// Calls a function with each row and, as a constant, its number of unknowns.
template <class Visit>
void for_rows(const UnknownConstraints& constraints, const Visit& visit) {
  for (std::size_t row = 0; row < constraints.rows(); ++row)
    if (constraints.is_node[row])
      visit(row, std::integral_constant<std::size_t, 3>());
    else
      visit(row, std::integral_constant<std::size_t, 1>());
}

} // namespace

template <class Number>
void UnknownConstraints::distribute(Number* displacement) const {
  for_rows(*this, [&](std::size_t row, auto width) {
    std::array<double, width()> sum{};
    for (std::uint32_t i = start[row]; i < start[row + 1]; ++i)
      for (std::size_t c = 0; c < width(); ++c)
        sum[c] +=
            weights[i] * static_cast<double>(displacement[masters[i] + c]);
    for (std::size_t c = 0; c < width(); ++c)
      displacement[unknowns[row] + c] = static_cast<Number>(sum[c]);
  });
}

template <class Number>
void UnknownConstraints::condense(Number* force) const {
  for_rows(*this, [&](std::size_t row, auto width) {
    std::array<double, width()> own{};
    for (std::size_t c = 0; c < width(); ++c)
      own[c] = static_cast<double>(
          std::exchange(force[unknowns[row] + c], Number(0)));
    for (std::uint32_t i = start[row]; i < start[row + 1]; ++i)
      for (std::size_t c = 0; c < width(); ++c)
        force[masters[i] + c] += static_cast<Number>(weights[i] * own[c]);
  });
}

void UnknownConstraints::condense_diagonal(
    std::vector<double>& diagonal) const {
  for (std::size_t row = 0; row < rows(); ++row)
    for (std::size_t c = 0; c < width(row); ++c) {
      double& slave = diagonal[unknowns[row] + c];
      for (std::uint32_t i = start[row]; i < start[row + 1]; ++i)
        diagonal[masters[i] + c] += weights[i] * weights[i] * slave;
      slave = 0.0;
    }
}

template void UnknownConstraints::distribute(float*) const;
template void UnknownConstraints::distribute(double*) const;
template void UnknownConstraints::condense(float*) const;
template void UnknownConstraints::condense(double*) const;

} // namespace asperity::fem
