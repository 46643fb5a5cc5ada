#include "md/minimise/curvature_memory.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::md {
namespace {

/// Number of unknowns that remain in the first-level cache while all pairs are
/// applied to them.
constexpr std::size_t block = 2048;

/// Number of partial sums, in a fixed order, that allow vectorisation.
constexpr std::size_t lanes = 8;

double dot_of_floats(const float* left, const double* right,
                     std::size_t count) {
  std::array<double, lanes> sums{};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      sums[lane] += static_cast<double>(left[i + lane]) * right[i + lane];
  double sum = 0.0;
  for (; i < count; ++i)
    sum += static_cast<double>(left[i]) * right[i];
  for (const double part : sums)
    sum += part;
  return sum;
}

/// Returns the inner products of each column with x.
std::vector<double> products(const std::vector<const float*>& columns,
                             std::span<const double> x) {
  std::vector<double> sums(columns.size(), 0.0);
  for (std::size_t begin = 0; begin < x.size(); begin += block) {
    const std::size_t count = std::min(block, x.size() - begin);
    for (std::size_t k = 0; k < columns.size(); ++k)
      sums[k] += dot_of_floats(columns[k] + begin, x.data() + begin, count);
  }
  return sums;
}

/// Adds the linear combination of the columns to x.
void add(const std::vector<const float*>& columns,
         const std::vector<double>& factors, std::span<double> x) {
  for (std::size_t begin = 0; begin < x.size(); begin += block) {
    const std::size_t end = std::min(begin + block, x.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t i = begin; i < end; ++i)
        x[i] += factors[k] * static_cast<double>(columns[k][i]);
  }
}

} // namespace

CurvatureMemory::CurvatureMemory(std::size_t unknowns, int pairs)
    : unknowns_(unknowns),
      slots_(static_cast<std::size_t>(std::max(0, pairs))) {}

std::vector<const float*>
CurvatureMemory::columns(std::vector<float> Pair::*which) const {
  std::vector<const float*> pointers;
  for (const std::size_t slot : kept_)
    pointers.push_back((slots_[slot].*which).data());
  return pointers;
}

std::size_t CurvatureMemory::free_slot() {
  if (kept_.size() == slots_.size()) {
    const std::size_t oldest = kept_.front();
    kept_.erase(kept_.begin());
    return oldest;
  }
  for (std::size_t slot = 0;; ++slot)
    if (std::ranges::find(kept_, slot) == kept_.end())
      return slot;
}

void CurvatureMemory::learn(std::span<const double> direction, double length,
                            std::span<const double> before,
                            std::span<const double> after) {
  if (slots_.empty())
    return;
  const std::size_t slot = free_slot();
  Pair& pair = slots_[slot];
  pair.step.resize(unknowns_);
  pair.fall.resize(unknowns_);
  std::vector<double> step(unknowns_);
  std::vector<double> fall(unknowns_);
  double step_square = 0.0;
  double fall_square = 0.0;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    pair.step[i] = static_cast<float>(length * direction[i]);
    pair.fall[i] = static_cast<float>(before[i] - after[i]);
    step[i] = static_cast<double>(pair.step[i]);
    fall[i] = static_cast<double>(pair.fall[i]);
    step_square += step[i] * step[i];
    fall_square += fall[i] * fall[i];
  }
  const double curvature =
      dot_of_floats(pair.step.data(), fall.data(), unknowns_);
  // Below this threshold the curvature is dominated by single-precision
  // roundoff.
  if (!(curvature > 1e-7 * std::sqrt(step_square * fall_square)))
    return;
  kept_.push_back(slot);

  pair.products.assign(slots_.size(), 0.0);
  const std::vector<double> falls_on_step =
      products(columns(&Pair::fall), step);
  const std::vector<double> steps_on_fall =
      products(columns(&Pair::step), fall);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    pair.products[kept_[k]] = falls_on_step[k];
    slots_[kept_[k]].products[slot] = steps_on_fall[k];
  }
}

void CurvatureMemory::remaining(std::span<const double> forces,
                                std::span<double> rest) {
  std::ranges::copy(forces, rest.begin());
  const std::vector<double> on_forces = products(columns(&Pair::step), forces);
  std::vector<double> factors(kept_.size());
  for (std::size_t k = kept_.size(); k-- > 0;) {
    Pair& pair = slots_[kept_[k]];
    double sum = on_forces[k];
    for (std::size_t newer = k + 1; newer < kept_.size(); ++newer)
      sum -= slots_[kept_[newer]].weight * pair.products[kept_[newer]];
    pair.weight = sum / pair.products[kept_[k]];
    factors[k] = -pair.weight;
  }
  add(columns(&Pair::fall), factors, rest);
}

void CurvatureMemory::complete(std::span<double> direction) const {
  const std::vector<double> on_direction =
      products(columns(&Pair::fall), direction);
  std::vector<double> factors(kept_.size());
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const Pair& pair = slots_[kept_[k]];
    double sum = on_direction[k];
    for (std::size_t older = 0; older < k; ++older)
      sum += factors[older] * slots_[kept_[older]].products[kept_[k]];
    factors[k] = pair.weight - sum / pair.products[kept_[k]];
  }
  add(columns(&Pair::step), factors, direction);
}

} // namespace asperity::md
