#include "suite/exchange/answers/reference_answers.hpp"

#include "base/plain_text.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "input/input_error.hpp"
#include "mechanics/adhesion_scales.hpp"
#include "reports/analysis/exact.hpp"
#include "reports/analysis/refinement.hpp"
#include "results/observables/observables.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "suite/exchange/answers/adhesive_answer.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::exchange {
namespace {

constexpr double reference_tolerance = 1e-10; // [h_rms]
constexpr int most_reference_iterations = 20000;
constexpr int most_reference_points = 1024;

bool has_surface_operator(const cases::MethodSpec& method) {
  return method.uses_layers() && !methods::is_full_block(method);
}

const cases::MethodSpec& method_of_problem(const cases::Case& contact_case,
                                           const std::string& name) {
  std::vector<std::string> names;
  for (const cases::MethodSpec& method : contact_case.methods)
    if (has_surface_operator(method)) {
      if (name.empty() || method.name == name)
        return method;
      names.push_back(method.name);
    }
  throw input::InputError(
      names.empty()
          ? fmt::format("{}: has no half-space or condensed finite-element "
                        "method, which a problem needs",
                        contact_case.path)
          : fmt::format("{}: \"{}\" is no half-space or condensed "
                        "finite-element method of this case; it has {}",
                        contact_case.path, name, fmt::join(names, ", ")));
}

/// The solutions of all load steps on one grid.
class ReferenceSolver {
public:
  /// @param grid     that of the problem or a finer one
  /// @param heights  of this grid
  ReferenceSolver(const Problem& problem, const Grid& grid,
                  const std::vector<double>& heights)
      : problem_(problem),
        heights_(heights),
        elasticity_(surface_operator(problem, grid)),
        sequence_(elasticity_->clone(), heights,
                  problem.adhesion.value_or(mechanics::ContactInterface{}),
                  reference_tolerance * problem.rms_height,
                  most_reference_iterations) {}

  ProblemAnswer answer(const mechanics::LoadTarget& target) {
    contact::ContactSolution solution = sequence_.solve(target);
    if (!solution.converged ||
        !(problem_.adhesion || solution.nominal_pressure > 0.0))
      throw NoAnswer(fmt::format(
          "the problem has no answer at {:g}: {}", target.amount,
          solution.note.empty() ? "there is no contact" : solution.note));
    ProblemAnswer answer;
    answer.nominal_pressure = solution.nominal_pressure;
    answer.mean_gap = solution.mean_gap;
    answer.area_fraction = results::counted_area_fraction(
        problem_.adhesion
            ? results::ContactNodes({mechanics::ContactField::gap}, {},
                                    solution.gap)
            : results::ContactNodes::under(solution.pressure));
    answer.elastic_energy =
        results::elastic_energy(solution.pressure, solution.displacement, {});
    answer.largest_pressure = std::ranges::max(solution.pressure);
    if (problem_.adhesion)
      answer.energy = adhesive_energy(*elasticity_, problem_, solution.gap);
    pressure_ = std::move(solution.pressure);
    return answer;
  }

  /// The pressure of the last answer [Pa].
  const std::vector<double>& pressure() const { return pressure_; }

  /// A bound of the error of the last answer's mean gap [m].
  double certified_error(const ProblemAnswer& last) {
    return contact::bound_separation(
               *elasticity_,
               {heights_, 0.0, last.nominal_pressure, pressure_, last.mean_gap})
        .error;
  }

private:
  const Problem& problem_;
  const std::vector<double>& heights_;
  std::unique_ptr<contact::SurfaceOperator> elasticity_;
  contact::LoadSequence sequence_;
  std::vector<double> pressure_;
};

mechanics::LoadTarget pressure_target(double pressure) {
  return {mechanics::Control::nominal_pressure, pressure};
}

/// The mean gaps of the path of a case with adhesion.
/// @throws input::InputError  no problem can describe the contact
std::vector<mechanics::LoadTarget> path_of(const cases::Case& contact_case,
                                           const cases::MethodSpec& method,
                                           const mechanics::Scales& scales) {
  const mechanics::LoadingPath& load = contact_case.load;
  if (method.border() != mechanics::Border::periodic ||
      method.contact()->law != mechanics::ContactLaw::exponential ||
      load.control != mechanics::Control::mean_gap || load.spring)
    throw input::InputError(fmt::format(
        "{}: {} has adhesion, of which a problem can describe contact = "
        "\"exponential\" with periodic boundaries, along mean gaps without a "
        "spring",
        contact_case.path, method.name));
  std::vector<mechanics::LoadTarget> targets;
  for (const auto& target : load.targets)
    targets.push_back({load.control, target.in_si(scales)});
  return targets;
}

/// The loads without repetitions, ascending in the contact pressure.
std::vector<mechanics::LoadTarget> targets_of(const cases::Case& contact_case,
                                              const mechanics::Scales& scales) {
  const bool is_pressure =
      contact_case.load.control == mechanics::Control::nominal_pressure;
  std::vector<mechanics::LoadTarget> targets;
  for (std::size_t i = 0; i < contact_case.load.targets.size(); ++i)
    if (!contact_case.load.is_unloading[i])
      targets.push_back({is_pressure ? mechanics::Control::nominal_pressure
                                     : mechanics::Control::mean_gap,
                         contact_case.load.targets[i].in_si(scales)});
  std::ranges::sort(targets, [&](const auto& a, const auto& b) {
    return is_pressure ? a.amount < b.amount : a.amount > b.amount;
  });
  targets.erase(std::unique(targets.begin(), targets.end(),
                            [](const auto& a, const auto& b) {
                              return a.amount == b.amount;
                            }),
                targets.end());
  return targets;
}

/// Answers on the finer grids, coarse to fine, by load: mean gap and area.
struct Refined {
  std::vector<int> points;
  std::vector<double> spacings;
  std::vector<std::vector<ProblemAnswer>> answers;
};

Refined refined_answers(const cases::Case& contact_case,
                        const AnsweredProblem& answered) {
  const Grid& grid = answered.problem.grid;
  Refined refined{{grid.points_x}, {grid.spacing_x()}, {answered.answers}};
  for (int factor : {2, 4}) {
    const Grid fine{factor * grid.points_x, factor * grid.points_y,
                    grid.length_x, grid.length_y};
    if (std::max(fine.points_x, fine.points_y) > most_reference_points)
      break;
    const surfaces::HeightMap map =
        surfaces::build_surface_on(contact_case.surface, 0, fine);
    ReferenceSolver solver(answered.problem, fine, map.heights);
    std::vector<ProblemAnswer> answers;
    // The mean plane of an indenter depends on the grid, but its top does not.
    const double lower = contact_case.surface.is_indenter()
                             ? std::ranges::max(answered.problem.heights) -
                                   std::ranges::max(map.heights)
                             : 0.0;
    for (const ProblemAnswer& coarse : answered.answers) {
      answers.push_back(
          solver.answer(pressure_target(coarse.nominal_pressure)));
      answers.back().mean_gap += lower;
    }
    refined.points.push_back(fine.points_x);
    refined.spacings.push_back(fine.spacing_x());
    refined.answers.push_back(std::move(answers));
  }
  return refined;
}

/// Value and error of one quantity at one load: Richardson's limit of three
/// grids, or the finer of two with their difference.
std::pair<double, double> limit_of(const Refined& refined, std::size_t load,
                                   double ProblemAnswer::*quantity,
                                   double scale) {
  std::vector<std::vector<double>> values;
  for (const std::vector<ProblemAnswer>& answers : refined.answers)
    values.push_back({answers[load].*quantity});
  if (values.size() == 1)
    return {not_a_number, not_a_number};
  if (values.size() == 2)
    return {values[1][0], std::abs(values[1][0] - values[0][0])};
  const std::array unit{scale};
  const reports::RefinementLimit limit =
      reports::refinement_limit(values, refined.spacings, unit);
  return {limit.values[0], limit.uncertainty * scale};
}

/// The source of the exact solution of a shape; empty: there is none, or it is
/// a table or an approximation.
std::string exact_source(const cases::Case& contact_case,
                         const Problem& problem) {
  using enum mechanics::SurfaceKind;
  if (!problem.body.is_halfspace())
    return "";
  const mechanics::SurfaceKind kind = contact_case.surface.kind;
  if (problem.is_periodic())
    return kind == wave_1d ? "Westergaard (1939)" : "";
  return kind == sphere  ? "Hertz (1881), mean over the nodes"
         : kind == punch ? "Johnson (1985), Sec. 3.8, mean over the nodes"
         : kind == cone  ? "Sneddon (1965), mean over the nodes"
         : kind == rounded_punch ? "Ciavarella (1999), mean over the nodes"
                                 : "";
}

std::vector<ContinuumAnswer>
continuum_answers(const cases::Case& contact_case,
                  const AnsweredProblem& answered) {
  std::vector<ContinuumAnswer> continuum;
  if (const std::string exact_by = exact_source(contact_case, answered.problem);
      !exact_by.empty()) {
    for (const ProblemAnswer& answer : answered.answers) {
      const reports::ExactPoint exact = reports::exact_point(
          contact_case.surface, answered.problem.body.contact_modulus,
          answer.nominal_pressure, std::ranges::max(answered.problem.heights),
          !answered.problem.is_periodic());
      continuum.push_back({answer.nominal_pressure, exact.mean_gap, 0.0,
                           exact.area_fraction, 0.0, exact_by});
    }
    return continuum;
  }
  const Refined refined = refined_answers(contact_case, answered);
  if (refined.points.size() == 1)
    return continuum;
  const std::string source = fmt::format("solutions with {} points per side",
                                         fmt::join(refined.points, ", "));
  for (std::size_t i = 0; i < answered.answers.size(); ++i) {
    const auto [gap, gap_error] = limit_of(refined, i, &ProblemAnswer::mean_gap,
                                           answered.problem.rms_height);
    const auto [area, area_error] =
        limit_of(refined, i, &ProblemAnswer::area_fraction, 1.0);
    continuum.push_back({answered.answers[i].nominal_pressure, gap, gap_error,
                         area, area_error, source});
  }
  return continuum;
}

} // namespace

AnsweredProblem answered_problem(const cases::Case& contact_case,
                                 const std::string& method_name) {
  const cases::MethodSpec& method =
      method_of_problem(contact_case, method_name);
  if (contact_case.material.inclusion || contact_case.material.variation)
    throw input::InputError(
        fmt::format("{}: has a block that is not layered, which no problem can "
                    "describe",
                    contact_case.path));
  if (method.hardness())
    throw input::InputError(
        fmt::format("{}: {} has a hardness, which no problem can describe",
                    contact_case.path, method.name));
  if (method.border() == mechanics::Border::free &&
      contact_case.surface.kind == mechanics::SurfaceKind::measured)
    throw input::InputError(fmt::format(
        "{}: {} presses a measured map without its mirror images, of which no "
        "problem can state slope and continuum: {}.boundaries = \"periodic\" "
        "is allowed",
        contact_case.path, method.name, method.name));
  const methods::CaseSurfaces surfaces(contact_case, {method});
  const methods::SurfaceOfCase& surface = surfaces.of(method, 0);
  AnsweredProblem answered;
  answered.method = method.name;
  if (const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings))
    answered.block = fem->block;
  else
    answered.block.element = mechanics::Element::q1;
  Problem& problem = answered.problem;
  problem.name = good_name(contact_case.name);
  if (problem.name.front() == '.')
    problem.name.front() = '-';
  const std::string ellipsis = "...";
  problem.title =
      printable(contact_case.title.empty() ? problem.name : contact_case.title,
                longest_line - ellipsis.size());
  problem.grid = surface.record.grid;
  problem.heights = surface.record.heights;
  problem.rms_height = surface.record.rms_height;
  problem.rms_slope = surface.record.rms_slope;
  problem.body =
      methods::continuum_of(method, contact_case.material, surface.scales);
  if (method.is_adhesive())
    problem.adhesion = method.adhesion(
        mechanics::adhesion_scales(surface.scales, problem.grid));
  ReferenceSolver solver(problem, problem.grid, problem.heights);
  for (const mechanics::LoadTarget& target :
       problem.adhesion ? path_of(contact_case, method, surface.scales)
                        : targets_of(contact_case, surface.scales)) {
    ProblemAnswer answer = solver.answer(target);
    if (!problem.adhesion)
      answer.mean_gap_error = solver.certified_error(answer);
    problem.loads.push_back(problem.adhesion ? target.amount
                                             : answer.nominal_pressure);
    answered.answers.push_back(answer);
    answered.pressures.push_back(solver.pressure());
  }
  if (!problem.adhesion)
    answered.continuum = continuum_answers(contact_case, answered);
  return answered;
}

} // namespace asperity::exchange
