#include "fem/block/plastic_flow.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace asperity::fem {

PlasticFlow::PlasticFlow(const BlockSystem& system, const Plasticity& law)
    : system_(system),
      law_(law),
      strains_(system.space()),
      values_(system.space().mapping(), system.space().element(),
              system.space().cell_quadrature(),
              dealii::update_gradients | dealii::update_JxW_values),
      before_(system.space().triangulation().n_active_cells()),
      now_(before_) {}

void PlasticFlow::follow(const Vector& displacement, Vector& force) {
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
      flow(cell, own);
    if (!cell->is_locally_owned())
      continue;
    ++own;
    const CellHistory& history = now_[cell->active_cell_index()];
    if (!history.empty())
      subtract_force(cell, history, force);
  }
  force.compress(dealii::VectorOperation::add);
}

bool PlasticFlow::is_flowing() const {
  return dealii::Utilities::MPI::max(tangents_.empty() ? 0 : 1,
                                     MPI_COMM_WORLD) == 1;
}

/// Finds the history and the tangents of a cell.
/// @param number  of the cell among those of this rank, if it is one
void PlasticFlow::flow(const Cell& cell, std::size_t number) {
  const Moduli moduli = system_.moduli_of(cell);
  const std::vector<CellStrains::Strain>& strains = strains_.at_points(cell);
  const CellHistory& before = before_[cell->active_cell_index()];
  CellHistory& now = now_[cell->active_cell_index()];
  now = before;
  CellTangents tangents{number, {}};
  bool is_flowing = false;
  for (std::size_t q = 0; q < strains.size(); ++q) {
    const FlowResponse response = plastic_response(
        strains[q], before.empty() ? PointHistory{} : before[q], moduli, law_);
    tangents.points.at(q) = response.tangent;
    if (!response.is_flowing)
      continue;
    is_flowing = true;
    now.resize(strains.size());
    now[q] = response.history;
  }
  if (is_flowing && cell->is_locally_owned())
    tangents_.push_back(tangents);
}

void PlasticFlow::subtract_force(const Cell& cell, const CellHistory& history,
                                 Vector& force) {
  values_.reinit(cell);
  const dealii::FEValuesExtractors::Vector field(0);
  const double shear = system_.moduli_of(cell).shear_modulus;
  dealii::Vector<double> own(values_.dofs_per_cell);
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const auto stress =
        -2.0 * shear * values_.JxW(q) * history[q].plastic_strain;
    for (const unsigned int i : values_.dof_indices())
      own(i) += stress * values_[field].symmetric_gradient(i, q);
  }
  std::vector<dealii::types::global_dof_index> unknowns(own.size());
  cell->get_dof_indices(unknowns);
  system_.space().constraints().distribute_local_to_global(own, unknowns,
                                                           force);
}

// Of each cell the number of its points with a history, and these.
void PlasticFlow::save(std::vector<double>& numbers) const {
  for (const CellHistory& cell : before_) {
    numbers.push_back(static_cast<double>(cell.size()));
    for (const PointHistory& point : cell) {
      numbers.insert(numbers.end(), point.plastic_strain.begin_raw(),
                     point.plastic_strain.end_raw());
      numbers.push_back(point.equivalent);
    }
  }
}

void PlasticFlow::restore(std::span<const double> numbers) {
  auto next = numbers.begin();
  for (CellHistory& cell : before_) {
    cell.resize(static_cast<std::size_t>(*next++));
    for (PointHistory& point : cell) {
      std::copy_n(next, point.plastic_strain.n_independent_components,
                  point.plastic_strain.begin_raw());
      next += point.plastic_strain.n_independent_components;
      point.equivalent = *next++;
    }
  }
  now_ = before_;
}

void PlasticFlow::subtract_from(std::vector<CellStrains::Strain>& strains,
                                const Cell& cell) const {
  const CellHistory& history = now_[cell->active_cell_index()];
  for (std::size_t q = 0; q < history.size(); ++q)
    strains[q] -= history[q].plastic_strain;
}

/// The integral of the yield stress over the equivalent plastic strain.
double PlasticFlow::work() const {
  dealii::FEValues<3> values(
      system_.space().mapping(), system_.space().element(),
      system_.space().cell_quadrature(), dealii::update_JxW_values);
  double work = 0.0;
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    const CellHistory& history = now_[cell->active_cell_index()];
    if (!cell->is_locally_owned() || history.empty())
      continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const double strain = history[q].equivalent;
      work += values.JxW(q) * strain * law_.yield_stress_after(0.5 * strain);
    }
  }
  return dealii::Utilities::MPI::sum(work, MPI_COMM_WORLD);
}

double PlasticFlow::largest_strain() const {
  double largest = 0.0;
  for (const CellHistory& history : now_)
    for (const PointHistory& point : history)
      largest = std::max(largest, point.equivalent);
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

} // namespace asperity::fem
