#include "fem/linear/mesh_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::fem {

MeshBlock::MeshBlock(const BlockSystem& system,
                     std::shared_ptr<LocalUnknowns> unknowns,
                     MeshStiffness stiffness,
                     std::unique_ptr<MeshCorrection> correction)
    : system_(system),
      unknowns_(std::move(unknowns)),
      points_(contact_rows(system, *unknowns_)),
      multigrid_(std::move(stiffness)),
      correction_(std::move(correction)) {
  unknowns_->forget_cells();
  multigrid_.set_correction([this](const auto& residual, auto& displacement) {
    correction_->add(residual, displacement, multigrid_.unit());
  });
}

void MeshBlock::vmult(Vector& to, const Vector& from) const {
  copy_owned(from, displacement_);
  std::vector<double>& force = multigrid_.force();
  multigrid_.apply(displacement_, force);
  std::copy_n(force.begin(), unknowns_->owned(), to.begin());
}

void MeshBlock::prepare(std::span<const double> springs,
                        const std::vector<bool>& held, bool is_sticking) {
  std::vector<double> softened(springs.begin(), springs.end());
  const std::vector<bool> is_pair = soften_pairs(softened);
  const UnknownLayout& layout = unknowns_->layout();
  MeshContact contact =
      contact_of_points(points_, {springs, held, is_sticking, &is_pair},
                        layout.size, layout.ranks());
  contact.pairs.ghosts = layout.ghosts;
  correction_->prepare(softened, held, is_sticking, contact);
  multigrid_.set_contact(std::move(contact));
}

LinearSolution MeshBlock::solve(Vector& unknowns, const Vector& forces,
                                double tolerance, int most_iterations) {
  copy_owned(forces, multigrid_.force());
  copy_owned(unknowns, displacement_);
  // A correction of another contact state may be useless for this one.
  constexpr int most_with_old = 50;
  const bool is_old = !correction_->is_current();
  LinearSolution solution = multigrid_.solve(
      displacement_, tolerance,
      is_old ? std::min(most_with_old, most_iterations) : most_iterations);
  if (solution.has_converged || !is_old) {
    correction_->check_efficiency(
        solution.iterations,
        std::log10(solution.first_residual / solution.last_residual));
  } else {
    const int before = solution.iterations;
    correction_->renew();
    copy_owned(forces, multigrid_.force());
    solution = multigrid_.solve(displacement_, tolerance, most_iterations);
    solution.iterations += before;
  }
  multigrid_.clear_held(displacement_);
  std::copy_n(displacement_.begin(), unknowns_->owned(), unknowns.begin());
  return solution;
}

std::size_t MeshBlock::bytes() const {
  return unknowns_->bytes() + points_.bytes() + multigrid_.bytes() +
         correction_->bytes() + displacement_.size() * sizeof(double);
}

/// Finds the points whose springs make a contact pair, those that are stiffer
/// than the node of the first body, and softens them for the correction. Its
/// functions have no relative displacement there: the node follows the face of
/// the other body. Moving it by e from where the function would have it costs
/// at most k e^2/2, with the bound k on the stiffness of the node, and a spring
/// of this kind is what the correction has for that. With 3 k, the stiffness of
/// the correction is at least 3/4 of that of its functions.
/// @return  of each point, or empty if no points can be pairs
std::vector<bool> MeshBlock::soften_pairs(std::vector<double>& springs) const {
  constexpr double stiff = 2.0;
  constexpr double kept = 3.0;
  std::vector<bool> is_pair;
  if (!system_.has_counter() || !system_.contact().is_nodal())
    return is_pair;
  is_pair.resize(springs.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const double own =
        multigrid_.stiffness_bound(points_.column[points_.start[i]]);
    is_pair[i] = springs[i] > stiff * own;
    if (is_pair[i])
      springs[i] = std::min(springs[i], kept * own);
  }
  return is_pair;
}

/// Copies the own unknowns; those of other ranks are zero.
void MeshBlock::copy_owned(const Vector& from, std::vector<double>& to) const {
  to.assign(from.begin(), from.end());
  to.resize(unknowns_->size(), 0.0);
}

} // namespace asperity::fem
