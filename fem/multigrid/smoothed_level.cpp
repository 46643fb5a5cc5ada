#include "fem/multigrid/smoothed_level.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

/// Terms of the polynomial before and after the correction.
constexpr int terms = 4;

} // namespace

SmoothedLevel::SmoothedLevel(std::unique_ptr<MeshOperator<float>> stiffness,
                             const std::vector<double>& diagonal, double bound)
    : stiffness_(std::move(stiffness)),
      inverse_(diagonal.begin(), diagonal.end()) {
  const double estimate = eigenvalue_estimate(
      inverse_, [&](float* from, float* to) { stiffness_->apply(from, to); },
      layout().ranks());
  const auto eigenvalue = static_cast<float>(std::min(estimate, bound));
  for (float& value : inverse_)
    value = value > 0.0F ? 1.0F / (eigenvalue * value) : 0.0F;
  displacement.assign(inverse_.size(), 0.0F);
  residual = direction = displacement;
}

void SmoothedLevel::set_contact(MeshContact contact) {
  for (const auto& [unknown, value] : without_contact_)
    inverse_[unknown] = value;
  without_contact_.clear();
  contact_ = std::move(contact);
  held_ = contact_.held_unknowns(layout().step);
  if (contact_.has_springs || contact_.pairs.exist)
    soften();
  for (const std::size_t unknown : held_)
    set_inverse(unknown, 0.0F);
  relative_.resize(contact_.pairs.nodes.size());
  product_.resize(contact_.pairs.exist ? inverse_.size() : 0);
}

double SmoothedLevel::stiffness_bound(std::size_t unknown) const {
  const auto changed = without_contact_.find(unknown);
  const float inverse =
      changed == without_contact_.end() ? inverse_[unknown] : changed->second;
  return inverse > 0.0F ? 1.0 / static_cast<double>(inverse) : 0.0;
}

void SmoothedLevel::smooth_before() {
  contact_.pairs.add_to_faces(residual.data());
  std::fill(displacement.begin(), displacement.end(), 0.0F);
  smooth_by_chebyshev(*this, inverse_, terms, false, [this] { subtract(); });
  clear_held(residual);
}

void SmoothedLevel::take_relative() {
  const std::vector<std::size_t>& nodes = contact_.pairs.nodes;
  for (std::size_t pair = 0; pair < nodes.size(); ++pair)
    relative_[pair] = std::exchange(residual[nodes[pair]], 0.0F);
  std::fill(direction.begin(), direction.end(), 0.0F);
}

void SmoothedLevel::end_correction() {
  const std::vector<std::size_t>& nodes = contact_.pairs.nodes;
  for (std::size_t pair = 0; pair < nodes.size(); ++pair) {
    residual[nodes[pair]] = relative_[pair];
    direction[nodes[pair]] = 0.0F;
  }
  clear_held(direction);
  for (std::size_t i = 0; i < displacement.size(); ++i)
    displacement[i] += direction[i];
  subtract();
}

void SmoothedLevel::smooth_after() {
  smooth_by_chebyshev(*this, inverse_, terms, true, [this] { subtract(); });
  clear_held(displacement);
  contact_.pairs.add_common(displacement.data());
}

std::size_t SmoothedLevel::bytes() const {
  return stiffness_->bytes() +
         (4 * inverse_.size() + product_.size() + relative_.size()) *
             sizeof(float) +
         contact_.bytes() + held_.size() * sizeof(std::size_t) +
         without_contact_.size() * sizeof(*without_contact_.begin());
}

/// Adds the sum of the magnitudes in each row of the springs to the diagonal.
void SmoothedLevel::soften() {
  std::vector<double> sums(inverse_.size(), 0.0);
  const SparseRows& springs = contact_.springs;
  for (std::size_t row = 0; row < springs.rows(); ++row)
    for (std::size_t i = springs.start[row]; i < springs.start[row + 1]; ++i)
      sums[contact_.unknowns[row]] += std::abs(springs.weight[i]);
  add_common_stiffness(sums);
  layout().collect(sums.data());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] > 0.0)
      set_inverse(i, static_cast<float>(1.0 / (stiffness_bound(i) + sums[i])));
}

void SmoothedLevel::set_inverse(std::size_t unknown, float value) {
  without_contact_.emplace(unknown, inverse_[unknown]);
  inverse_[unknown] = value;
}

/// Adds what makes the diagonal an upper bound on K in relative variables and
/// on the springs: with K <= D and any a > 0,
///
///     D (r + N m)^2 <= (1 + a) D r^2 + (1 + 1/a) D (sum |N|) (sum |N| m^2).
void SmoothedLevel::add_common_stiffness(std::vector<double>& sums) const {
  constexpr double a = 2.0;
  const ContactPairs& pairs = contact_.pairs;
  for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair) {
    const std::size_t node = pairs.nodes[pair];
    const double own = stiffness_bound(node);
    sums[node] += a * own + pairs.springs[pair];
    double shares = 0.0;
    for (std::size_t i = pairs.faces.start[pair];
         i < pairs.faces.start[pair + 1]; ++i)
      shares += std::abs(pairs.faces.weight[i]);
    for (std::size_t i = pairs.faces.start[pair];
         i < pairs.faces.start[pair + 1]; ++i)
      sums[pairs.faces.column[i]] +=
          (1.0 + 1.0 / a) * own * shares * std::abs(pairs.faces.weight[i]);
  }
}

/// Subtracts (K + S) direction from the residual.
void SmoothedLevel::subtract() {
  if (contact_.pairs.exist) {
    subtract_with_pairs();
    return;
  }
  stiffness_->add_own(direction.data(), residual.data(), -1.0F);
  contact_.add_spring_force(direction.data(), residual.data(), -1.0);
  layout().collect(residual.data());
}

/// The same in relative variables, of which the residual has the forces.
void SmoothedLevel::subtract_with_pairs() {
  const ContactPairs& pairs = contact_.pairs;
  for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair)
    relative_[pair] = direction[pairs.nodes[pair]];
  pairs.add_common(direction.data());
  stiffness_->apply_own(direction.data(), product_.data());
  contact_.add_spring_force(direction.data(), product_.data());
  layout().collect(product_.data());
  pairs.add_to_faces(product_.data());
  for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair) {
    direction[pairs.nodes[pair]] = relative_[pair];
    product_[pairs.nodes[pair]] +=
        static_cast<float>(pairs.springs[pair] * relative_[pair]);
  }
  for (std::size_t i = 0; i < product_.size(); ++i)
    residual[i] -= product_[i];
}

} // namespace asperity::fem
