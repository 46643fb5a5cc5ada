#include "fem/full_block.hpp"

#include "base/require.hpp"
#include "fem/block_solver.hpp"
#include "fem/block_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace asperity::fem {
namespace {

using dealii::Vector;

/// a 2x2 system M (dd, dP) = r, by Cramer's rule.
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

class NewtonBlock final : public FullBlock {
public:
  NewtonBlock(const Grid& grid, int degree, const LayeredBlock& block,
              LinearSolver linear_solver);

  const Grid& grid() const override { return system_.grid(); }

  std::size_t unknowns() const override { return system_.n_unknowns(); }

  std::span<const double> nodal_weights() const override { return weights_; }

  std::vector<double> displacement(std::span<const double> pressure) override;

  BlockSolution solve(std::span<const double> heights, const BlockLoad& load,
                      const BlockContact& contact) override;

private:
  double face_displacement(std::size_t i) const {
    return displacement_(system_.face_unknowns()[i]);
  }

  double gap(std::size_t i) const {
    return rigid_gap_ + face_displacement(i) - heights_[i];
  }

  double mean_gap() const;
  double touching_gap(double nominal_pressure, double penalty) const;
  void update_pressure(double penalty);
  std::vector<bool> contact_set() const;
  void find_imbalance();
  bool newton_step(const BlockLoad& load, double penalty);
  bool newton(const BlockLoad& load, const BlockContact& contact,
              BlockSolution& answer);
  double violation() const;
  void record(const BlockContact& contact, double rms_height,
              BlockSolution& answer);

  BlockSystem system_;
  BlockSolver solver_;
  std::vector<double> weights_;
  // The state (F.1) is solved for.
  Vector<double> displacement_; ///< u [m]
  double rigid_gap_ = 0.0;      ///< d [m]
  double top_pressure_ = 0.0;   ///< P [Pa]
  std::vector<double> multiplier_;
  std::vector<double> pressure_;
  std::vector<double> heights_;
  Vector<double> imbalance_; ///< K u + P g - sum a p e [N]
};

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

/// Newton to a standing contact set at fixed multipliers.
bool NewtonBlock::newton(const BlockLoad& load, const BlockContact& contact,
                         BlockSolution& answer) {
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
    if (contact_set() == before)
      return true;
  }
  answer.note = "the contact set did not come to rest";
  return false;
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

} // namespace

std::unique_ptr<FullBlock> make_full_block(const Grid& grid, int degree,
                                           const LayeredBlock& block,
                                           LinearSolver linear_solver) {
  return std::make_unique<NewtonBlock>(grid, degree, block, linear_solver);
}

} // namespace asperity::fem
