#pragma once

// What the pressure of another program says of a state with adhesion: the
// energy of the gap that it leads to, and how far that is from a minimum.

#include "contact/solvers/contact_problem.hpp"
#include "suite/exchange/answers/certified_field.hpp"
#include "suite/exchange/submission.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace asperity::exchange {

/// A state of the path. Any gap >= 0 of the prescribed mean has an energy, so
/// that this number needs no trust: the lower, the better.
struct AdhesiveAnswer {
  double energy = 0.0; ///< U of the gap [J/m^2]
  /// What solve_adhesive() lowers it by on its way down from there [J/m^2].
  double energy_left = 0.0;
  /// From the gap to that of the minimum at the end of this way, rms [m].
  double distance = 0.0;
  double pressure_error = 0.0; ///< mean pressure less that of the minimum [Pa]
};

/// U = <v, K v>/2 + <W(g)> [J/m^2] of a gap g, with K = C^-1 and v = g + h
/// without its mean.
/// @param gap  [m] >= 0, one value per node
double adhesive_energy(contact::SurfaceOperator& elasticity,
                       const Problem& problem, std::span<const double> gap);

/// The state that a pressure leads to: g = u + C p - h, but 0 where the
/// pressure exceeds the law's by more than closes the gap, and nowhere
/// negative; the open nodes are shifted so that the mean is u. It has the
/// pressure as submitted.
/// @param mean_gap  u [m] > 0
/// @throws input::InputError  C p is 1e8 times as large as gap and heights
contact::ContactSolution adhesive_state(contact::SurfaceOperator& elasticity,
                                        const Problem& problem, double mean_gap,
                                        std::vector<double> pressure);

/// Goes down from a state to a minimum of the energy at the same mean gap.
/// @throws input::InputError  none was reached
AdhesiveAnswer adhesive_answer(contact::SurfaceOperator& elasticity,
                               const Problem& problem,
                               const contact::ContactSolution& state);

/// Claims that the gap is within claimed_error h_rms (rms) of a minimum, that
/// the mean pressure is that of the minimum to claimed_error of the largest
/// tension, and that the energy is as submitted to 1e-6 w (NaN: not submitted).
void add_adhesive_claims(const AdhesiveAnswer& answer, const Problem& problem,
                         double claimed_error, double energy,
                         CertifiedField& field);

/// The lines above the table.
/// @param width  of the column of method names
std::string adhesive_head(std::size_t width);

std::string adhesive_line(const AdhesiveAnswer& answer, const Problem& problem,
                          const CertifiedField& field, std::size_t width);

nlohmann::ordered_json adhesive_json(const AdhesiveAnswer& answer,
                                     const CertifiedField& field);

} // namespace asperity::exchange
