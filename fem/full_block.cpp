#include "fem/full_block.hpp"

#include "base/require.hpp"
#include "fem/newton_block.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::fem {

using dealii::Vector;

namespace {

/// The springs that Newton's method is given, in shear moduli a spacing: with
/// softer ones a multiplier takes many rounds, with stiffer ones the rounding
/// of a gap is no longer small in the pressure.
constexpr double softest_spring = 1e3;
constexpr double stiffest_spring = 1e5;

/// rms height [m], or the spacing for a flat surface: what a gap's tolerance
/// is a share of.
double height_scale_of(std::span<const double> heights, double spacing) {
  const double square =
      std::inner_product(heights.begin(), heights.end(), heights.begin(), 0.0) /
      static_cast<double>(heights.size());
  return square > 0.0 ? std::sqrt(square) : spacing;
}

} // namespace

NewtonBlock::NewtonBlock(const Grid& grid, int degree,
                         const LayeredBlock& block, LinearSolver linear_solver)
    : system_(grid, degree, block),
      solver_(system_, linear_solver),
      weights_(system_.nodal_areas()),
      stiffness_scale_(block.layers.front().shear_modulus / grid.spacing_x()),
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

/// The spring that Newton's method works with. A penalty within reach is its
/// own; a wall ends at the same answer with any.
double NewtonBlock::own_spring(const BlockContact& contact) const {
  const double low = contact.law == cases::ContactLaw::penalty
                         ? 0.0
                         : softest_spring * stiffness_scale_;
  return std::clamp(contact.penalty, low, stiffest_spring * stiffness_scale_);
}

/// Largest |gap + c p| in contact and overlap outside it: what the law still
/// lacks.
double NewtonBlock::violation(double compliance) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i)
    largest =
        std::max(largest, pressure_[i] > 0.0
                              ? std::abs(gap(i) + compliance * pressure_[i])
                              : std::max(0.0, -gap(i)));
  return largest;
}

/// Heights are kept below the highest: what bears a small load lies near it,
/// and the gap there is no difference of large numbers. The block stays where
/// it was.
void NewtonBlock::take_heights(std::span<const double> heights) {
  const double highest = *std::max_element(heights.begin(), heights.end());
  rigid_gap_ += highest_ - highest;
  highest_ = highest;
  heights_.assign(heights.begin(), heights.end());
  for (double& height : heights_)
    height -= highest;
}

void NewtonBlock::record(BlockSolution& answer) {
  answer.pressure = pressure_;
  answer.gap.resize(grid().size());
  double borne = 0.0;
  for (std::size_t i = 0; i < grid().size(); ++i) {
    answer.gap[i] = gap(i);
    borne += system_.nodal_areas()[i] * pressure_[i];
  }
  answer.mean_gap = mean_gap();
  answer.nominal_pressure = borne / grid().area();
  answer.residual = std::max(answer.residual, unbalanced());
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
  take_heights(heights);
  const double height_scale = height_scale_of(heights, grid().spacing_x());
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);

  BlockSolution answer;
  BlockContact spring = contact;
  spring.penalty = own_spring(contact);
  const double compliance =
      contact.law == cases::ContactLaw::penalty ? 1.0 / contact.penalty : 0.0;
  // The part of a pressure that the working spring does not show in the gap.
  const bool is_own = contact.law == cases::ContactLaw::penalty &&
                      spring.penalty == contact.penalty;
  const double kept = is_own ? 0.0 : 1.0 - spring.penalty * compliance;
  do {
    if (!newton(load, spring, answer))
      break;
    answer.residual = is_own ? 0.0 : violation(compliance) / height_scale;
    answer.converged = answer.residual <= contact.tolerance;
    if (!answer.converged)
      for (std::size_t i = 0; i < multiplier_.size(); ++i)
        multiplier_[i] = kept * pressure_[i];
  } while (!answer.converged);
  record(answer);
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
