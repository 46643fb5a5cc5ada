#pragma once

// What a contact solver finds on rows that ranks share, to be compared with the
// answer of one process bit by bit.

#include "contact/certificate/certificate.hpp"
#include "contact/solvers/solver.hpp"
#include "ranks/shared_rows.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

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

/// What the certificate finds for heights as a pressure with some tension.
/// @param own  heights of the rows of the operator
inline std::vector<double> certificate_of(SurfaceOperator& elasticity,
                                          std::span<const double> own) {
  std::vector<double> pressure(own.begin(), own.end());
  for (double& value : pressure)
    value = std::max(-1e-3, value) + 1e-4;
  const FieldCheck c =
      check_field(elasticity, {own, 0.02, 1e-3, pressure, 0.01});
  return {c.load_error,      c.largest_tension,
          c.mean_gap,        c.area_fraction,
          c.complementarity, c.largest_penetration,
          c.rms_penetration, c.elastic_energy,
          c.duality_gap,     c.pressure_error,
          c.mean_gap_error,  static_cast<double>(c.nodes_in_tension)};
}

/// The rows of this process in a field of all rows.
inline std::span<const double> rows_in(const SharedRows& rows,
                                       std::span<const double> field) {
  return field.subspan(static_cast<std::size_t>(rows.first()) * rows.width(),
                       rows.size());
}

} // namespace asperity::contact
