#include "fem/full_block.hpp"

#include "base/require.hpp"
#include "fem/newton_block.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::fem {

using dealii::Vector;

NewtonBlock::NewtonBlock(const Grid& grid, int degree,
                         const LayeredBlock& block, LinearSolver linear_solver)
    : system_(grid, degree, block),
      solver_(system_, linear_solver),
      weights_(system_.nodal_areas()),
      displacement_(system_.n_unknowns()),
      multiplier_(grid.size(), 0.0),
      pressure_(grid.size(), 0.0),
      heights_(grid.size(), 0.0),
      imbalance_(system_.n_unknowns()) {
  for (double& weight : weights_)
    weight /= grid.cell_area();
}

std::vector<double>
NewtonBlock::displacement(std::span<const double> pressure) {
  const std::vector<double>& areas = system_.nodal_areas();
  Vector<double> force(system_.n_unknowns());
  double total = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    force(system_.face_unknowns()[i]) = areas[i] * pressure[i];
    total += areas[i] * pressure[i];
  }
  force.add(-total / grid().area(), system_.top_load());
  solver_.set_springs({});
  Vector<double> whole(system_.n_unknowns());
  if (!solver_.solve(whole, force))
    return {};
  std::vector<double> face(pressure.size());
  double mean = 0.0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    face[i] = whole(system_.face_unknowns()[i]);
    mean += areas[i] * face[i] / grid().area();
  }
  for (double& value : face)
    value -= mean;
  return face;
}

/// Largest |gap| in contact at pressure p: what the law leaves of a wall.
double NewtonBlock::violation() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i)
    largest = std::max(largest, pressure_[i] > 0.0 ? std::abs(gap(i))
                                                   : std::max(0.0, -gap(i)));
  return largest;
}

void NewtonBlock::record(const BlockContact& contact, double rms_height,
                         BlockSolution& answer) {
  answer.pressure = pressure_;
  answer.gap.resize(grid().size());
  double borne = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i) {
    answer.gap[i] = gap(i);
    const double force = system_.nodal_areas()[i] * pressure_[i];
    borne += force;
    largest = std::max(largest, force);
  }
  answer.mean_gap = mean_gap();
  answer.nominal_pressure = borne / grid().area();
  find_imbalance();
  const double unbalanced =
      largest > 0.0 ? imbalance_.linfty_norm() / largest : 0.0;
  const double gap_violation = contact.law == cases::ContactLaw::penalty
                                   ? 0.0
                                   : violation() / rms_height;
  answer.residual = std::max(unbalanced, gap_violation);
}

BlockSolution NewtonBlock::solve(std::span<const double> heights,
                                 const BlockLoad& load,
                                 const BlockContact& contact) {
  require_positive("penalty", contact.penalty, "Pa/m");
  require_positive("tolerance", contact.tolerance, "1");
  if (load.control == cases::Control::nominal_pressure)
    require_positive("nominal pressure", load.target, "Pa");
  if (heights.size() != grid().size())
    refuse_argument("number of heights", static_cast<double>(heights.size()),
                    std::to_string(grid().size()));
  heights_.assign(heights.begin(), heights.end());
  const double square =
      std::inner_product(heights.begin(), heights.end(), heights.begin(), 0.0) /
      static_cast<double>(heights.size());
  const double rms_height = square > 0.0 ? std::sqrt(square) : 1.0;
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);

  BlockSolution answer;
  const bool is_wall = contact.law != cases::ContactLaw::penalty;
  do {
    if (!newton(load, contact, answer))
      break;
    answer.converged =
        !is_wall || violation() <= contact.tolerance * rms_height;
    if (!answer.converged)
      multiplier_ = pressure_;
  } while (!answer.converged);
  record(contact, rms_height, answer);
  if (answer.converged && !(answer.residual <= contact.tolerance)) {
    answer.converged = false;
    answer.note = "the nodal forces are not balanced to the tolerance";
  }
  return answer;
}

std::unique_ptr<FullBlock> make_full_block(const Grid& grid, int degree,
                                           const LayeredBlock& block,
                                           LinearSolver linear_solver) {
  return std::make_unique<NewtonBlock>(grid, degree, block, linear_solver);
}

} // namespace asperity::fem
