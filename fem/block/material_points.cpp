#include "fem/block/material_points.hpp"

#include "fem/material/hooke.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace asperity::fem {
namespace {

constexpr std::size_t n_components =
    CellStrains::Strain::n_independent_components;

} // namespace

MaterialPoints::MaterialPoints(const BlockSystem& system)
    : system_(system),
      law_(*system.law()),
      in_point_(n_components + law_.n_history()),
      strains_(system.space()),
      values_(system.space().mapping(), system.space().element(),
              system.space().cell_quadrature(),
              dealii::update_gradients | dealii::update_JxW_values),
      before_(system.space().triangulation().n_active_cells()),
      now_(before_) {}

CellStrains::Strain MaterialPoints::inelastic_strain(const CellStates& cell,
                                                     std::size_t point) const {
  CellStrains::Strain strain;
  std::copy_n(cell.data() + point * in_point_, n_components,
              strain.begin_raw());
  return strain;
}

void MaterialPoints::follow(const Vector& displacement, Vector& force) {
  strains_.set(displacement);
  tangents_.clear();
  std::size_t own = 0;
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    if (is_frozen_)
      now_[cell->active_cell_index()] = before_[cell->active_cell_index()];
    else
      respond(cell, own);
    if (!cell->is_locally_owned())
      continue;
    ++own;
    const CellStates& states = now_[cell->active_cell_index()];
    if (!states.empty())
      subtract_force(cell, states, force);
  }
  force.compress(dealii::VectorOperation::add);
}

bool MaterialPoints::is_elastic() const {
  return dealii::Utilities::MPI::max(tangents_.empty() ? 0 : 1,
                                     MPI_COMM_WORLD) == 0;
}

/// Finds the states and the tangents of a cell.
/// @param number  of the cell among those of this rank, if it is one
void MaterialPoints::respond(const Cell& cell, std::size_t number) {
  const Moduli moduli = system_.moduli_of(cell);
  const std::vector<CellStrains::Strain>& strains = strains_.at_points(cell);
  const CellStates& before = before_[cell->active_cell_index()];
  CellStates& now = now_[cell->active_cell_index()];
  next_ = before;
  next_.resize(strains.size() * in_point_, 0.0);
  CellTangents tangents{number, {}};
  bool is_elastic = true;
  for (std::size_t q = 0; q < strains.size(); ++q) {
    double* const numbers = next_.data() + q * in_point_;
    const PointResponse response =
        law_.respond(strains[q], inelastic_strain(next_, q), moduli,
                     {numbers + n_components, law_.n_history()});
    tangents.points.at(q) = response.tangent;
    if (response.is_elastic)
      continue;
    is_elastic = false;
    std::copy_n(response.inelastic_strain.begin_raw(), n_components, numbers);
  }
  if (is_elastic) {
    now = before;
    return;
  }
  now = next_;
  if (cell->is_locally_owned())
    tangents_.push_back(tangents);
}

void MaterialPoints::subtract_force(const Cell& cell, const CellStates& states,
                                    Vector& force) {
  values_.reinit(cell);
  const dealii::FEValuesExtractors::Vector field(0);
  const Moduli moduli = system_.moduli_of(cell);
  dealii::Vector<double> own(values_.dofs_per_cell);
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const auto stress =
        -values_.JxW(q) * elastic_stress(inelastic_strain(states, q), moduli);
    for (const unsigned int i : values_.dof_indices())
      own(i) += stress * values_[field].symmetric_gradient(i, q);
  }
  std::vector<dealii::types::global_dof_index> unknowns(own.size());
  cell->get_dof_indices(unknowns);
  system_.space().constraints().distribute_local_to_global(own, unknowns,
                                                           force);
}

// Of each cell the number of its points with a state, and these.
void MaterialPoints::save(std::vector<double>& numbers) const {
  for (const CellStates& cell : before_) {
    const std::size_t points = cell.size() / in_point_;
    numbers.push_back(static_cast<double>(points));
    numbers.insert(numbers.end(), cell.begin(), cell.end());
  }
}

void MaterialPoints::restore(std::span<const double> numbers) {
  auto next = numbers.begin();
  for (CellStates& cell : before_) {
    const auto count = static_cast<std::ptrdiff_t>(*next++) *
                       static_cast<std::ptrdiff_t>(in_point_);
    cell.assign(next, next + count);
    next += count;
  }
  now_ = before_;
}

void MaterialPoints::subtract_from(std::vector<CellStrains::Strain>& strains,
                                   const Cell& cell) const {
  const CellStates& states = now_[cell->active_cell_index()];
  for (std::size_t q = 0; q * in_point_ < states.size(); ++q)
    strains[q] -= inelastic_strain(states, q);
}

/// The integral per nominal area, or the largest value, over all ranks.
double MaterialPoints::value_of(const MaterialQuantity& quantity) const {
  dealii::FEValues<3> values(
      system_.space().mapping(), system_.space().element(),
      system_.space().cell_quadrature(), dealii::update_JxW_values);
  double integral = 0.0;
  double largest = 0.0;
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const CellStates& states = now_[cell->active_cell_index()];
    if (states.empty())
      continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const double value = quantity.of_point(
          {states.data() + q * in_point_ + n_components, law_.n_history()});
      integral += values.JxW(q) * value;
      largest = std::max(largest, value);
    }
  }
  return quantity.is_density
             ? dealii::Utilities::MPI::sum(integral, MPI_COMM_WORLD) /
                   system_.contact().area()
             : dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

std::map<std::string, double> MaterialPoints::quantities() const {
  std::map<std::string, double> values;
  for (const MaterialQuantity& quantity : law_.quantities())
    values[quantity.name] = value_of(quantity);
  return values;
}

} // namespace asperity::fem
