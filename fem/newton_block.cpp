#include "fem/newton_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace asperity::fem {
namespace {

/// A 2x2 system M (dd, dP) = r, by Cramer's rule.
struct Border {
  double force_d = 0.0, force_pressure = 0.0, force_right = 0.0;
  double control_d = 0.0, control_pressure = 0.0, control_right = 0.0;

  std::array<double, 2> solution() const {
    const double determinant =
        force_d * control_pressure - force_pressure * control_d;
    return {(force_right * control_pressure - force_pressure * control_right) /
                determinant,
            (force_d * control_right - force_right * control_d) / determinant};
  }
};

} // namespace

using dealii::Vector;

double NewtonBlock::mean_gap() const {
  double mean = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i)
    mean += system_.nodal_areas()[i] * gap(i) / grid().area();
  return mean;
}

/// The d at which the block as it is deformed now bears the pressure: a
/// monotone equation, by bisection between just touching and all pressed in.
double NewtonBlock::touching_gap(double nominal_pressure,
                                 double penalty) const {
  double high = -1e300;
  double low = 1e300;
  for (std::size_t i = 0; i < grid().size(); ++i) {
    const double own =
        heights_[i] - face_displacement(i) + multiplier_[i] / penalty;
    high = std::max(high, own);
    low = std::min(low, own - nominal_pressure / penalty);
  }
  const auto bears = [&](double d) {
    double sum = 0.0;
    for (std::size_t i = 0; i < grid().size(); ++i)
      sum +=
          system_.nodal_areas()[i] *
          std::max(0.0, multiplier_[i] -
                            penalty * (d + face_displacement(i) - heights_[i]));
    return sum / grid().area();
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (bears(middle) > nominal_pressure ? low : high) = middle;
  }
  return low;
}

void NewtonBlock::update_pressure(double penalty) {
  for (std::size_t i = 0; i < grid().size(); ++i)
    pressure_[i] = std::max(0.0, multiplier_[i] - penalty * gap(i));
}

std::vector<bool> NewtonBlock::contact_set() const {
  std::vector<bool> set(pressure_.size());
  std::transform(pressure_.begin(), pressure_.end(), set.begin(),
                 [](double pressure) { return pressure > 0.0; });
  return set;
}

void NewtonBlock::find_imbalance() {
  system_.stiffness().vmult(imbalance_, displacement_);
  imbalance_.add(top_pressure_, system_.top_load());
  for (std::size_t i = 0; i < grid().size(); ++i)
    imbalance_(system_.face_unknowns()[i]) -=
        system_.nodal_areas()[i] * pressure_[i];
}

/// The largest force left over, relative to the largest contact force [1].
double NewtonBlock::unbalanced() {
  find_imbalance();
  double largest = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i)
    largest = std::max(largest, system_.nodal_areas()[i] * pressure_[i]);
  return largest > 0.0 ? imbalance_.linfty_norm() / largest : 0.0;
}

/// Solves (F.1), linear for the contact set of now, for the changes of u, d
/// and P: u by block elimination, d and P from the two scalar equations.
bool NewtonBlock::newton_step(const BlockLoad& load, double penalty) {
  const std::size_t n_nodes = grid().size();
  const std::vector<double>& areas = system_.nodal_areas();
  std::vector<double> springs(n_nodes, 0.0);
  Vector<double> approach_force(system_.n_unknowns());
  Vector<double> mean(system_.n_unknowns());
  double borne = 0.0;
  for (std::size_t i = 0; i < n_nodes; ++i) {
    const auto unknown = system_.face_unknowns()[i];
    springs[i] = pressure_[i] > 0.0 ? penalty * areas[i] : 0.0;
    approach_force(unknown) = springs[i];
    mean(unknown) = areas[i] / grid().area();
    borne += areas[i] * pressure_[i];
  }
  solver_.set_springs(springs);
  Vector<double> by_imbalance(imbalance_.size());
  Vector<double> by_approach(imbalance_.size());
  Vector<double> by_top(imbalance_.size());
  find_imbalance();
  if (!solver_.solve(by_imbalance, imbalance_) ||
      !solver_.solve(by_approach, approach_force) ||
      !solver_.solve(by_top, system_.top_load()))
    return false;

  const double stiffness = std::accumulate(springs.begin(), springs.end(), 0.0);
  Border border;
  border.force_d = approach_force * by_approach - stiffness;
  border.force_pressure = approach_force * by_top - grid().area();
  border.force_right = -(approach_force * by_imbalance) -
                       (borne - top_pressure_ * grid().area());
  if (load.control == cases::Control::nominal_pressure) {
    border.control_pressure = 1.0;
    border.control_right = load.target - top_pressure_;
  } else {
    border.control_d = 1.0 - mean * by_approach;
    border.control_pressure = -(mean * by_top);
    border.control_right = load.target - mean_gap() + mean * by_imbalance;
  }
  const auto [approach, pressure] = border.solution();
  displacement_ -= by_imbalance;
  displacement_.add(-approach, by_approach, -pressure, by_top);
  rigid_gap_ += approach;
  top_pressure_ += pressure;
  return true;
}

/// Newton to a standing contact set at fixed multipliers. A step from far away
/// leaves the rounding of where it came from: steps on the same set refine it.
bool NewtonBlock::newton(const BlockLoad& load, const BlockContact& contact,
                         BlockSolution& answer) {
  constexpr int most_refinements = 3;
  int refinements = 0;
  update_pressure(contact.penalty);
  while (answer.iterations < contact.max_iterations) {
    const std::vector<bool> before = contact_set();
    const bool is_open =
        std::find(before.begin(), before.end(), true) == before.end();
    if (is_open && load.control == cases::Control::nominal_pressure) {
      rigid_gap_ = touching_gap(load.target, contact.penalty);
      update_pressure(contact.penalty);
      ++answer.iterations;
      continue;
    }
    ++answer.iterations;
    if (!newton_step(load, contact.penalty)) {
      answer.note = "the linear solver gave up";
      return false;
    }
    update_pressure(contact.penalty);
    if (contact_set() == before && (refinements++ == most_refinements ||
                                    unbalanced() <= contact.tolerance))
      return true;
  }
  answer.note = "the contact set did not come to rest";
  return false;
}

} // namespace asperity::fem
