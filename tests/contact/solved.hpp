#pragma once

// What a contact solver finds on rows that ranks share, to be compared with the
// answer of one process bit by bit.

#include "contact/solvers/solver.hpp"

#include <span>
#include <string>
#include <vector>

#include "ranks/shared_rows.hpp"

namespace asperity::contact {

/// Everything that a solution says, with the fields of all rows.
struct Solved {
  std::vector<double> pressure, gap, displacement;
  double nominal_pressure, mean_gap, gap_error;
  int iterations, transforms;
  bool converged;
  std::string note;

  bool operator==(const Solved&) const = default;
};

inline Solved all_rows(const ContactSolution& own, const SharedRows& rows) {
  return {rows.gathered(own.pressure),
          rows.gathered(own.gap),
          rows.gathered(own.displacement),
          own.nominal_pressure,
          own.mean_gap,
          own.gap_error,
          own.iterations,
          own.transforms,
          own.converged,
          own.note};
}

/// The rows of this process in a field of all rows.
inline std::span<const double> rows_in(const SharedRows& rows,
                                       std::span<const double> field) {
  return field.subspan(static_cast<std::size_t>(rows.first()) * rows.width(),
                       rows.size());
}

} // namespace asperity::contact
