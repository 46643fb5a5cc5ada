#include "suite/exchange/answers/adhesive_answer.hpp"

#include "base/field_sums.hpp"
#include "base/json.hpp"
#include "base/maximum.hpp"
#include "base/shown_number.hpp"
#include "contact/solvers/adhesive.hpp"
#include "contact/solvers/adhesive_state.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {
namespace {

constexpr double descent_tolerance = 1e-9; ///< of the gap [h_rms]
constexpr int most_descent_iterations = 20000;
constexpr double claimed_energy_error = 1e-6; ///< [w]

contact::AdhesiveProblem problem_of(contact::SurfaceOperator& elasticity,
                                    const Problem& problem) {
  return {problem.heights, *problem.adhesion,
          descent_tolerance * problem.rms_height, most_descent_iterations,
          contact::adhesive_scale(elasticity, problem.heights)};
}

} // namespace

double adhesive_energy(contact::SurfaceOperator& elasticity,
                       const Problem& problem, std::span<const double> gap) {
  std::vector<double> shape(gap.begin(), gap.end());
  for (std::size_t i = 0; i < shape.size(); ++i)
    shape[i] += problem.heights[i];
  std::vector<double> pressure(shape.size());
  elasticity.pressure_of(shape, pressure); // of mean 0, as is that of v
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i)
    sum += 0.5 * shape[i] * pressure[i] + problem.adhesion->energy(gap[i]);
  return sum / static_cast<double>(shape.size());
}

contact::ContactSolution adhesive_state(contact::SurfaceOperator& elasticity,
                                        const Problem& problem, double mean_gap,
                                        std::vector<double> pressure) {
  contact::ContactSolution state;
  state.pressure = std::move(pressure);
  state.nominal_pressure = mean(state.pressure);
  state.mean_gap = mean_gap;
  state.converged = true;
  state.displacement.resize(state.pressure.size());
  elasticity.displacement(state.pressure, state.displacement);
  constexpr double most = 1e8; // of which roundoff leaves a gap
  if (const double found = largest_magnitude(state.displacement);
      !(found <= most * (mean_gap + problem.rms_height)))
    throw input::InputError(
        fmt::format("moves the surface by {:.3g} m, but the mean gap is {:.3g} "
                    "m and the rms height {:.3g} m: pressures are in Pa",
                    found, mean_gap, problem.rms_height));
  std::vector<double> gap(state.pressure.size());
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double own = mean_gap + state.displacement[i] - problem.heights[i];
    const double open = std::max(0.0, own);
    const double excess = state.pressure[i] - problem.adhesion->pressure(open);
    gap[i] = excess * elasticity.short_wave_compliance() > own ? 0.0 : open;
  }
  // Which shifts the open nodes to the mean, as the solver does its start.
  const contact::AdhesiveProblem solved = problem_of(elasticity, problem);
  const mechanics::LoadTarget target{mechanics::Control::mean_gap, mean_gap};
  state.gap = std::move(
      contact::AdhesiveState(elasticity, solved, target, std::move(gap)).gap);
  return state;
}

AdhesiveAnswer adhesive_answer(contact::SurfaceOperator& elasticity,
                               const Problem& problem,
                               const contact::ContactSolution& state) {
  const contact::ContactSolution minimum = contact::solve_adhesive(
      elasticity, problem_of(elasticity, problem),
      {mechanics::Control::mean_gap, state.mean_gap}, state.gap);
  if (!minimum.converged)
    throw input::InputError(
        fmt::format("from the gap {:g} m, no minimum of the energy is reached: "
                    "{}",
                    state.mean_gap, minimum.note));
  AdhesiveAnswer answer;
  answer.energy = adhesive_energy(elasticity, problem, state.gap);
  answer.energy_left =
      answer.energy - adhesive_energy(elasticity, problem, minimum.gap);
  std::vector<double> way = state.gap;
  for (std::size_t i = 0; i < way.size(); ++i)
    way[i] -= minimum.gap[i];
  answer.distance = std::sqrt(dot(way, way) / static_cast<double>(way.size()));
  answer.pressure_error = state.nominal_pressure - minimum.nominal_pressure;
  return answer;
}

void add_adhesive_claims(const AdhesiveAnswer& answer, const Problem& problem,
                         double claimed_error, double energy,
                         CertifiedField& field) {
  const double work = problem.adhesion->work_of_adhesion;
  const double tension = -problem.adhesion->pressure_bounds().smallest;
  field.claims.push_back(
      {fmt::format("the gap that follows from the field is within {:g} h_rms "
                   "(rms) of a minimum of the energy (distance {:.2g} h_rms)",
                   claimed_error, answer.distance / problem.rms_height),
       answer.distance <= claimed_error * problem.rms_height});
  field.claims.push_back(
      {fmt::format("the mean pressure is that of this minimum to {:g} of the "
                   "largest tension (they differ by {:.2g} Pa)",
                   claimed_error, answer.pressure_error),
       std::abs(answer.pressure_error) <= claimed_error * tension});
  if (std::isfinite(energy))
    field.claims.push_back(
        {fmt::format("the energy is {:.8g} J/m^2 (from the field {:.8g} J/m^2)",
                     energy, answer.energy),
         std::abs(energy - answer.energy) <= claimed_energy_error * work});
}

std::string adhesive_head(std::size_t width) {
  return fmt::format(
      "Lengths in h_rms, energies in w. A descent from the gap of the field "
      "lowers its\nenergy U by `left` and ends in a minimum at `distance` "
      "(rms).\n"
      "  {:<{}} {:>4} {:>10} {:>11} {:>12} {:>9} {:>9}\n",
      "method", width, "step", "u", "p_0/E*", "U", "left", "distance");
}

std::string adhesive_line(const AdhesiveAnswer& answer, const Problem& problem,
                          const CertifiedField& field, std::size_t width) {
  const double work = problem.adhesion->work_of_adhesion;
  const double height = problem.rms_height;
  return fmt::format("  {:<{}} {:>4} {:>10.6f} {:>+11.4e} {:>+12.8f} {:>9.1e} "
                     "{:>9.1e}\n",
                     field.method, width, field.step, field.mean_gap / height,
                     Shown{field.nominal_pressure / field.contact_modulus},
                     Shown{answer.energy / work}, answer.energy_left / work,
                     answer.distance / height);
}

nlohmann::ordered_json adhesive_json(const AdhesiveAnswer& answer,
                                     const CertifiedField& field) {
  return {{"method", field.method},
          {"step", field.step},
          {"mean_gap [m]", field.mean_gap},
          {"nominal_pressure [Pa]", field.nominal_pressure},
          {"rms_height [m]", field.rms_height},
          {"energy [J/m^2]", answer.energy},
          {"energy_left [J/m^2]", answer.energy_left},
          {"distance [m]", answer.distance},
          {"pressure_error [Pa]", answer.pressure_error},
          {"claims", claims_json(field)}};
}

} // namespace asperity::exchange
