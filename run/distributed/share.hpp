#pragma once

// Divides the members of an ensemble or a sweep among parts that run on
// different machines, the same way on each of them.

#include "cases/sweeps/sweep.hpp"
#include "cases/types/case.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::run {

/// One part of several, "3/8".
struct Part {
  int number = 1; ///< 1 <= number <= count
  int count = 1;

  bool operator==(const Part&) const = default;
};

/// Reads the value of --part.
/// @throws input::InputError  it is not I/N with 1 <= I <= N
Part read_part(const std::string& text);

/// Returns "3/8".
std::string part_text(const Part& part);

/// Returns the members of each part in ascending order. Every member belongs to
/// exactly one part. The most expensive members are given out first, each to
/// the part with the smallest cost so far, so that the costs of two parts
/// differ by at most that of one member; equal costs are dealt in turn.
///
/// @param costs    of the members, in any unit, >= 0
/// @param n_parts  >= 1; parts in excess of the members stay empty
/// @throws std::domain_error  an argument is outside its range
std::vector<std::vector<std::size_t>> shares(const std::vector<double>& costs,
                                             int n_parts);

/// Returns the costs of the realisations of a case: unknowns of all load steps
/// [1]. They depend on the case alone, so that every machine divides it in the
/// same way. A case whose methods build no surface has one member.
std::vector<double>
realization_costs(const cases::Case& contact_case,
                  const std::vector<cases::MethodSpec>& methods);

/// Returns the costs of the points of a sweep likewise.
/// @param methods, is_exact  as chosen_methods()
std::vector<double> point_costs(const cases::CaseSweep& sweep,
                                const std::vector<std::string>& methods,
                                bool is_exact);

} // namespace asperity::run
