#include "contact/solvers/load_sequence.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "contact/solvers/adhesive.hpp"
#include "contact/solvers/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity::contact {
namespace {

/// Tolerance of a coarse-to-fine initial guess, relative to the rms height: a
/// smaller one saves no iteration on the fine grid.
constexpr double coarse_accuracy = 1e-3;

/// Largest over rms value of half the second difference of Gaussian heights.
/// The former is about twice the residual of a coarse-to-fine guess, for
/// shortest waves of 2 to 16 points: docs/measurements/solver.md.
constexpr double largest_bend = 5.0;

/// Longest extrapolation, in units of the last load increment.
constexpr double longest_extrapolation = 2.5;

/// Share of the extrapolated change of a gap that is used: new contacts carry a
/// part of the next load.
constexpr double gap_share = 0.7;

/// Pressure that replaces an extrapolated overlap, times the compliance of
/// short waves over that overlap.
constexpr double overlap_stiffness = 0.5;

/// Distance of the target from the last step in units of the distance between
/// the two steps. Under pressure control, distances are ratios of loads, since
/// the mean gap falls with the logarithm of the load.
double extrapolation_reach(mechanics::Control control, double before,
                           double last, double target) {
  if (control == mechanics::Control::nominal_pressure)
    return std::log(target / last) / std::log(last / before);
  return (target - last) / (last - before);
}

/// The pressure where there is one, otherwise minus the gap: both in one field,
/// because one of them is 0 at every node.
std::vector<float> signed_state(const ContactSolution& solution) {
  std::vector<float> state(solution.pressure.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double pressure = solution.pressure[i];
    const double open = -std::max(0.0, solution.gap[i]);
    state[i] = static_cast<float>(pressure > 0.0 ? pressure : open);
  }
  return state;
}

/// Pressure at a node for the next load.
/// @param stiffness  pressure per overlap [Pa/m]
double extrapolated(double before, double last, double reach,
                    double stiffness) {
  if (before <= 0.0 && last <= 0.0) // a gap at both loads
    return stiffness *
           std::max(0.0, last + gap_share * reach * (last - before));
  const double old = before > 0.0 ? before : stiffness * before;
  const double now = last > 0.0 ? last : stiffness * last;
  return std::max(0.0, now + reach * (now - old));
}

/// With a soft penalty the penetration is far larger than the heights, and the
/// gap is known only to the roundoff of that penetration and of a sum over N
/// nearly equal values, whose roundoff errors are alike and add up.
double reachable_tolerance(double gap_tolerance,
                           const mechanics::LoadTarget& target,
                           double local_compliance, std::size_t nodes) {
  const double rounding = (8.0 + 0.125 * static_cast<double>(nodes)) *
                          std::numeric_limits<double>::epsilon();
  const double depth = target.control == mechanics::Control::nominal_pressure
                           ? local_compliance * target.amount
                           : std::abs(target.amount);
  return std::max(gap_tolerance, rounding * depth);
}

double rms_height_of(std::span<const double> heights, const Workers& workers) {
  const auto nodes = static_cast<double>(workers.all_nodes(heights.size()));
  const double mean = weighted_sum({}, heights, workers) / nodes;
  return std::sqrt(weighted_sum({}, heights.size(), workers,
                                [=, h = heights.data()](std::size_t i) {
                                  return (h[i] - mean) * (h[i] - mean);
                                }) /
                   nodes);
}

/// Rms of half the second differences of the heights along the rows [m].
double rms_bend(std::span<const double> heights, int points_x,
                const Workers& workers) {
  const auto width = static_cast<std::size_t>(points_x);
  const auto bend = [=, h = heights.data()](std::size_t i) {
    const std::size_t x = i % width;
    if (x == 0 || x + 1 == width)
      return 0.0;
    return h[i] - 0.5 * (h[i - 1] + h[i + 1]);
  };
  return std::sqrt(
      weighted_sum({}, heights.size(), workers,
                   [=](std::size_t i) { return bend(i) * bend(i); }) /
      static_cast<double>(workers.all_nodes(heights.size())));
}

/// Over the stiffness of short waves. The load of a stiffer spring moves it by
/// less than 1e-6 of the height of the waves that the load flattens.
constexpr double stiffest_spring = 1e6;

/// Of a prescribed mean gap by the spring. Each one leaves the stiffness of the
/// contact over that of the spring of the error.
constexpr int most_corrections = 5;

/// Steps of bisection for the state before faces part or come together.
constexpr int halvings_to_jump = 6;

} // namespace

LoadSequence::LoadSequence(std::unique_ptr<SurfaceOperator> elasticity,
                           std::vector<double> heights,
                           const mechanics::ContactInterface& interface,
                           double gap_tolerance, int max_iterations)
    : elasticity_(std::move(elasticity)),
      heights_(std::move(heights)),
      interface_(interface),
      solver_(mechanics::surface_solver_of(mechanics::traits_of(interface.law),
                                           interface)),
      gap_tolerance_(gap_tolerance),
      max_iterations_(max_iterations) {
  require_positive("gap_tolerance", gap_tolerance_, "m");
  if (mechanics::needs_penalty(interface_.law))
    require_positive("penalty", interface_.penalty, "Pa/m");
  if (std::isfinite(interface_.hardness))
    require_positive("hardness", interface_.hardness, "Pa");
  if (solver_ == mechanics::SurfaceSolver::adhesive) {
    require_positive("work_of_adhesion", interface_.work_of_adhesion, "J/m^2");
    require_positive("adhesion_range", interface_.adhesion_range, "m");
    if (!elasticity_->is_periodic())
      free_adhesion_.emplace(*elasticity_, heights_, interface_);
  }
}

bool LoadSequence::has_load(std::span<const double> pressure) const {
  const auto carries = [](double value) { return value > 0.0; };
  return total_count(elasticity_->workers(),
                     std::ranges::any_of(pressure, carries) ? 1 : 0) > 0;
}

double LoadSequence::local_compliance() const {
  return interface_.local_compliance();
}

ContactSolution LoadSequence::solve(mechanics::LoadTarget target) {
  if (target.control != control_)
    history_.clear();
  control_ = target.control;
  if (solver_ == mechanics::SurfaceSolver::adhesive) {
    return std::isfinite(target.spring) &&
                   target.spring * elasticity_->short_wave_compliance() >
                       stiffest_spring
               ? solve_with_stiff_spring(target)
               : solve_with_adhesion(target);
  }
  if (target.control == mechanics::Control::nominal_pressure &&
      target.amount > interface_.hardness)
    return beyond_hardness(target.amount);
  lower_heights();
  if (target.control == mechanics::Control::mean_gap)
    target.amount += mean_imprint_;
  ContactProblem problem = problem_to(reachable_tolerance(
      gap_tolerance_, target, local_compliance(), elasticity_->grid().size()));
  std::vector<double> start = extrapolation_to(target);
  OtherGuess other;
  if (!start.empty())
    other = {error_of_coarse_guess(), [&] { return coarse_guess(target); }};
  else
    start = coarse_guess(target);
  if (start.empty() && !history_.empty())
    for (const float value : history_.back().state)
      start.push_back(std::max(0.0, static_cast<double>(value)));
  ContactSolution solution;
  if (solver_ == mechanics::SurfaceSolver::multipliers) {
    problem.local_compliance = 1.0 / interface_.penalty;
    solution = solve_augmented(*elasticity_, problem, target, start);
  } else {
    solution = solve_contact_from(std::move(start), *elasticity_, problem,
                                  target, other);
  }
  remember(target, solution);
  if (problem.has_hardness())
    keep_imprint(solution);
  return solution;
}

ContactSolution LoadSequence::beyond_hardness(double nominal_pressure) const {
  const std::size_t nodes = heights_.size();
  ContactSolution none;
  none.pressure.assign(nodes, interface_.hardness);
  none.gap.assign(nodes, 0.0);
  none.displacement.assign(nodes, 0.0);
  none.nominal_pressure = nominal_pressure;
  none.converged = false;
  none.note = fmt::format("the nominal pressure must be at most the hardness, "
                          "{:.4g} Pa: no contact carries more",
                          interface_.hardness);
  return none;
}

void LoadSequence::lower_heights() {
  if (imprint_.empty())
    return;
  for (std::size_t i = 0; i < heights_.size(); ++i)
    heights_[i] -= imprint_[i];
  mean_imprint_ += mean_of_imprint_;
  imprint_ = {};
  rms_height_.reset();
  error_of_coarse_guess_.reset();
}

/// Overlaps within the tolerance are no imprint. They are not lost either: in a
/// next step they are still there.
void LoadSequence::keep_imprint(ContactSolution& solution) {
  solution.mean_gap -= mean_imprint_;
  mean_of_imprint_ = 0.0;
  if (solution.converged) {
    imprint_.resize(heights_.size());
    for (std::size_t i = 0; i < imprint_.size(); ++i) {
      const bool sinks = solution.pressure[i] >= interface_.hardness &&
                         solution.gap[i] < -gap_tolerance_;
      imprint_[i] = sinks ? -solution.gap[i] : 0.0;
      solution.gap[i] = sinks ? 0.0 : solution.gap[i];
    }
    mean_of_imprint_ =
        weighted_sum(elasticity_->nodal_weights(), imprint_,
                     elasticity_->workers()) /
        static_cast<double>(elasticity_->workers().all_nodes(imprint_.size()));
  }
  if (mean_of_imprint_ == 0.0)
    imprint_ = {};
  solution.mean_imprint = mean_imprint_ + mean_of_imprint_;
}

ContactProblem LoadSequence::problem_to(double gap_tolerance) const {
  return {heights_, local_compliance(), gap_tolerance, max_iterations_,
          interface_.hardness};
}

ContactSolution
LoadSequence::step_with_adhesion(const mechanics::LoadTarget& target,
                                 std::vector<double>& state) {
  if (!free_adhesion_ && !adhesive_scale_)
    adhesive_scale_ = adhesive_scale(*elasticity_, heights_);
  const AdhesiveProblem problem{heights_,
                                interface_,
                                gap_tolerance_,
                                max_iterations_,
                                adhesive_scale_.value_or(0.0),
                                load_tolerance()};
  if (free_adhesion_)
    return free_adhesion_->solve(problem, target, state);
  ContactSolution solution =
      solve_adhesive(*elasticity_, problem, target, std::move(state));
  state = solution.gap;
  return solution;
}

ContactSolution
LoadSequence::solve_with_adhesion(const mechanics::LoadTarget& target) {
  std::vector<double> state;
  if (!history_.empty()) {
    state.assign(history_.back().state.begin(), history_.back().state.end());
  } else {
    ContactSolution first = first_contact(target);
    state = free_adhesion_ ? free_adhesion_->state_of(first.pressure, first.gap)
                           : std::move(first.gap);
  }
  ContactSolution solution = step_with_adhesion(target, state);
  Step step{target.amount, {state.begin(), state.end()}};
  if (solution.converged && !history_.empty() &&
      touches(step.state) != touches(history_.back().state))
    find_jump(target, solution);
  history_.clear();
  if (solution.converged)
    history_.push_back(std::move(step));
  return solution;
}

ContactSolution
LoadSequence::solve_with_stiff_spring(const mechanics::LoadTarget& target) {
  if (target.amount <= 0.0)
    return solve_with_adhesion(target);
  const auto moved_by = [&](const ContactSolution& solution) {
    return solution.nominal_pressure / target.spring;
  };
  ContactSolution solution =
      solve_with_adhesion({target.control, target.amount});
  for (int n = 0; n < most_corrections && solution.converged; ++n) {
    const double gap = target.amount + moved_by(solution);
    if (std::abs(solution.mean_gap - gap) <= gap_tolerance_ || !(gap > 0.0))
      break;
    ContactSolution next = solve_with_adhesion({target.control, gap});
    next.iterations += solution.iterations;
    next.transforms += solution.transforms;
    next.jump_pressure = solution.jump_pressure;
    next.jump_gap = solution.jump_gap;
    solution = std::move(next);
  }
  return solution;
}

void LoadSequence::find_jump(const mechanics::LoadTarget& target,
                             ContactSolution& found) {
  const Step& last = history_.back();
  const bool touched = touches(last.state);
  std::vector<double> before(last.state.begin(), last.state.end());
  double from = last.amount;
  double to = target.amount;
  // The last step again, of which the loads are not known, and the halves.
  for (int halving = 0; halving <= halvings_to_jump; ++halving) {
    const double middle = halving == 0 ? from : 0.5 * (from + to);
    std::vector<double> state = before;
    const ContactSolution own =
        step_with_adhesion({target.control, middle, target.spring}, state);
    found.transforms += own.transforms;
    found.iterations += own.iterations;
    if (!own.converged)
      return;
    if (touches(std::vector<float>(state.begin(), state.end())) != touched) {
      to = middle;
      continue;
    }
    from = middle;
    before = std::move(state);
    found.jump_pressure = own.nominal_pressure;
    found.jump_gap = own.mean_gap;
  }
}

bool LoadSequence::touches(std::span<const float> state) const {
  const Grid& inside = elasticity_->grid();
  const auto width = static_cast<std::size_t>(inside.points_x);
  const std::size_t stride = free_adhesion_ ? 2 * width : width;
  const auto held = static_cast<float>(interface_.strongest_gap());
  for (std::size_t row = 0; row * width < heights_.size(); ++row) {
    const std::span<const float> gaps = state.subspan(row * stride, width);
    if (std::ranges::any_of(gaps, [held](float gap) { return gap <= held; }))
      return true;
  }
  return false;
}

ContactSolution
LoadSequence::first_contact(const mechanics::LoadTarget& target) {
  const bool by_spring = std::isfinite(target.spring);
  if (by_spring || (target.control == mechanics::Control::nominal_pressure &&
                    target.amount <= 0.0)) {
    double level = largest_of(heights_, elasticity_->workers());
    if (by_spring) // not nearer than without a load
      level = std::max(level,
                       target.amount +
                           weighted_sum({}, heights_, elasticity_->workers()) /
                               static_cast<double>(heights_.size()));
    ContactSolution touching;
    touching.pressure.assign(heights_.size(), 0.0);
    touching.gap.resize(heights_.size());
    std::ranges::transform(heights_, touching.gap.begin(),
                           [level](double height) { return level - height; });
    return touching;
  }
  const double tolerance =
      std::max(gap_tolerance_, coarse_accuracy * rms_height());
  ContactSolution hard =
      solve_contact_from(coarse_guess(target), *elasticity_,
                         {heights_, 0.0, tolerance, max_iterations_}, target);
  for (std::size_t i = 0; i < hard.gap.size(); ++i)
    hard.gap[i] = hard.pressure[i] > 0.0 ? 0.0 : std::max(0.0, hard.gap[i]);
  return hard;
}

/// The layout is: kind of load, with a hardness the mean imprint and the
/// lowered heights, then amount and state of each step.
std::vector<double> LoadSequence::memory() const {
  std::vector<double> memory;
  if (std::isfinite(interface_.hardness) &&
      (!history_.empty() || !imprint_.empty() || mean_imprint_ > 0.0)) {
    memory.reserve(2 + heights_.size());
    memory.push_back(static_cast<double>(control_));
    memory.push_back(mean_imprint_ + mean_of_imprint_);
    memory.insert(memory.end(), heights_.begin(), heights_.end());
    for (std::size_t i = 0; i < imprint_.size(); ++i)
      memory[2 + i] -= imprint_[i];
  }
  for (const Step& step : history_) {
    if (memory.empty())
      memory.push_back(static_cast<double>(control_));
    memory.push_back(step.amount);
    memory.insert(memory.end(), step.state.begin(), step.state.end());
  }
  return memory;
}

void LoadSequence::recall(std::span<const double> memory) {
  const std::size_t nodes =
      free_adhesion_ ? free_adhesion_->n_nodes() : heights_.size();
  const std::size_t length = nodes + 1;
  const bool has_hardness = std::isfinite(interface_.hardness);
  const std::size_t parts = memory.empty() ? 0 : (memory.size() - 1) / length;
  const std::size_t most = has_hardness ? 3 : 2;
  if (!memory.empty() &&
      (memory.size() != 1 + parts * length || parts < 1 || parts > most))
    refuse_argument("memory.size()", static_cast<double>(memory.size()),
                    "the size of one or two saved steps");
  const std::size_t first_step = has_hardness ? 1 + length : 1;
  std::vector<Step> history;
  for (std::size_t at = first_step; at < memory.size(); at += length) {
    const std::span<const double> state = memory.subspan(at + 1, nodes);
    for (const double value : state)
      if (!std::isfinite(value))
        refuse_argument("a saved pressure or gap", value, "finite");
    if (solver_ != mechanics::SurfaceSolver::adhesive && !has_load(state))
      refuse_argument("a saved load", 0.0, "> 0 [Pa] at some node");
    history.push_back({memory[at], std::vector<float>(state.size())});
    std::ranges::transform(
        state, history.back().state.begin(),
        [](double value) { return static_cast<float>(value); });
  }
  if (has_hardness && !memory.empty()) {
    const std::span<const double> heights = memory.subspan(2, heights_.size());
    if (!std::ranges::all_of(
            heights, [](double height) { return std::isfinite(height); }) ||
        !(memory[1] >= 0.0 && std::isfinite(memory[1])))
      refuse_argument("a saved imprint", memory[1], "finite and >= 0 [m]");
    std::ranges::copy(heights, heights_.begin());
    mean_imprint_ = memory[1];
  }
  imprint_ = {};
  mean_of_imprint_ = 0.0;
  history_ = std::move(history);
  if (memory.empty())
    return;
  control_ =
      memory[0] == static_cast<double>(mechanics::Control::nominal_pressure)
          ? mechanics::Control::nominal_pressure
          : mechanics::Control::mean_gap;
}

double LoadSequence::load_tolerance() {
  // A flat surface has no h_rms, and roundoff is no unit of a tolerance.
  constexpr double largest = 0.01;
  const double tolerance = gap_tolerance_ / rms_height();
  return tolerance <= largest ? tolerance : AdhesiveProblem{}.load_tolerance;
}

double LoadSequence::rms_height() {
  if (!rms_height_)
    rms_height_ = rms_height_of(heights_, elasticity_->workers());
  return *rms_height_;
}

double LoadSequence::error_of_coarse_guess() {
  if (!error_of_coarse_guess_)
    error_of_coarse_guess_ =
        largest_bend * rms_bend(heights_, elasticity_->grid().points_x,
                                elasticity_->workers());
  return *error_of_coarse_guess_;
}

std::vector<double>
LoadSequence::extrapolation_to(const mechanics::LoadTarget& target) const {
  if (history_.size() < 2)
    return {};
  const Step& before = history_[0];
  const Step& last = history_[1];
  const double reach =
      extrapolation_reach(control_, before.amount, last.amount, target.amount);
  if (!(std::abs(reach) <= longest_extrapolation))
    return {};
  std::vector<double> start(heights_.size());
  const double stiffness =
      overlap_stiffness /
      (elasticity_->short_wave_compliance() + local_compliance());
  chunked(start.size(), elasticity_->threads(),
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              start[i] = extrapolated(before.state[i], last.state[i], reach,
                                      stiffness);
          });
  return has_load(start) ? start : std::vector<double>();
}

std::vector<double>
LoadSequence::coarse_guess(const mechanics::LoadTarget& target) {
  return coarse_start(*elasticity_, problem_to(gap_tolerance_), target,
                      std::max(gap_tolerance_, coarse_accuracy * rms_height()));
}

void LoadSequence::remember(const mechanics::LoadTarget& target,
                            const ContactSolution& solution) {
  if (!solution.converged || !has_load(solution.pressure)) {
    history_.clear();
    return;
  }
  if (!history_.empty() && history_.back().amount == target.amount)
    history_.pop_back();
  if (history_.size() == 2)
    history_.erase(history_.begin());
  history_.push_back({target.amount, signed_state(solution)});
}

} // namespace asperity::contact
