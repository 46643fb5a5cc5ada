#include "fem/solution/block_stress.hpp"

#include "fem/block/elastic_response.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

/// The matrix that maps values at the quadrature points of a cell to the values
/// of their linear projection at its vertices.
dealii::FullMatrix<double> projection_of(const BlockSpace& space) {
  const dealii::Quadrature<3>& points = space.cell_quadrature();
  const auto project = [&](const dealii::FiniteElement<3>& linear) {
    dealii::FullMatrix<double> matrix(linear.n_dofs_per_cell(), points.size());
    dealii::FETools::compute_projection_from_quadrature_points_matrix(
        linear, points, points, matrix);
    return matrix;
  };
  if (space.triangulation().all_reference_cells_are_hyper_cube())
    return project(dealii::FE_Q<3>(1));
  return project(dealii::FE_SimplexP<3>(1));
}

/// Whether lambda / mu, and so Poisson's ratio, is the same up to roundoff.
bool is_same_ratio(const Moduli& a, const Moduli& b) {
  return std::abs(a.lame_modulus * b.shear_modulus -
                  b.lame_modulus * a.shear_modulus) <=
         1e-9 * a.shear_modulus * b.shear_modulus;
}

/// A place ordered by decreasing stress, then by increasing coordinates:
/// -von Mises [Pa], x, y, z [m], and the largest shear stress there [Pa].
using RankedPlace = std::array<double, 5>;

} // namespace

double von_mises(const StressTensor& stress) {
  return std::sqrt(1.5) * dealii::deviator(stress).norm();
}

double largest_shear(const StressTensor& stress) {
  const std::array<double, 3> principal = dealii::eigenvalues(stress);
  return 0.5 * (principal.front() - principal.back());
}

BlockStress::BlockStress(
    const BlockSystem& system,
    const dealii::TrilinosWrappers::MPI::Vector& displacement)
    : system_(system),
      displacement_(system.space().owned(), system.space().relevant(),
                    MPI_COMM_WORLD),
      values_(system.space().mapping(), system.space().element(),
              system.space().cell_quadrature(),
              dealii::update_gradients | dealii::update_quadrature_points |
                  dealii::update_JxW_values),
      to_vertices_(projection_of(system.space())) {
  dealii::TrilinosWrappers::MPI::Vector whole = system.space().make_vector();
  whole = displacement;
  system.space().constraints().distribute(whole);
  displacement_ = whole;
}

const std::vector<StressTensor>& BlockStress::at_points(const Cell& cell) {
  const Moduli material = system_.moduli_of(cell);
  values_.reinit(cell);
  stress_.resize(values_.n_quadrature_points);
  values_[dealii::FEValuesExtractors::Vector(0)]
      .get_function_symmetric_gradients(displacement_, stress_);
  for (StressTensor& value : stress_)
    value = elastic_response(value, material).stress;
  return stress_;
}

BlockStress::Share& BlockStress::share_of(std::vector<Share>& shares,
                                          const Moduli& material) {
  const auto found =
      std::find_if(shares.begin(), shares.end(), [&](const Share& share) {
        return share.material == material;
      });
  if (found != shares.end())
    return *found;
  shares.push_back({material, 0.0, {}});
  return shares.back();
}

BlockStress::VertexShares BlockStress::shares() {
  VertexShares all(system_.space().triangulation().n_vertices());
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    const std::vector<StressTensor>& stress = at_points(cell);
    const Moduli material = system_.moduli_of(cell);
    double volume = 0.0;
    for (const unsigned int q : values_.quadrature_point_indices())
      volume += values_.JxW(q);
    for (const unsigned int v : cell->vertex_indices()) {
      Share& share = share_of(all[cell->vertex_index(v)], material);
      share.volume += volume;
      for (unsigned int q = 0; q < stress.size(); ++q)
        share.volume_stress += volume * to_vertices_(v, q) * stress[q];
    }
  }
  return all;
}

/// The average at a vertex for a cell of a material.
StressTensor BlockStress::average_of(std::span<const Share> shares,
                                     const Moduli& material, double ratio) {
  double volume = 0.0;
  StressTensor sum;
  for (const Share& share : shares) {
    const double scale = material.shear_modulus / share.material.shear_modulus;
    if (!(share.material == material) &&
        (std::max(scale, 1.0 / scale) > ratio ||
         !is_same_ratio(share.material, material)))
      continue;
    volume += share.volume;
    sum += scale * share.volume_stress;
  }
  return sum / volume;
}

void BlockStress::at_vertices(const TakeVertices& take, double ratio) {
  VertexShares all = shares();
  std::vector<StressTensor> at_vertex;
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const Moduli material = system_.moduli_of(cell);
    at_vertex.clear();
    for (const unsigned int v : cell->vertex_indices())
      at_vertex.push_back(
          average_of(all[cell->vertex_index(v)], material, ratio));
    take(cell, at_vertex);
  }
}

StressPeak BlockStress::strongest() {
  RankedPlace best{};
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const std::vector<StressTensor>& stress = at_points(cell);
    for (unsigned int q = 0; q < stress.size(); ++q) {
      const dealii::Point<3>& place = values_.quadrature_point(q);
      const RankedPlace here{-von_mises(stress[q]), place[0], place[1],
                             place[2], 0.0};
      if (here < best) {
        best = here;
        best[4] = largest_shear(stress[q]);
      }
    }
  }
  for (const RankedPlace& found :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, best))
    best = std::min(best, found);
  return {.von_mises = -best[0],
          .largest_shear = best[4],
          .depth = std::abs(best[3]),
          .place = {best[1], best[2], best[3]}};
}

} // namespace asperity::fem
