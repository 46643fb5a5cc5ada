#include "fem/solution/block_stress.hpp"

#include "fem/block/all_ranks.hpp"
#include "fem/material/hooke.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace asperity::fem {
namespace {

/// The linear functions at the vertices of a cell.
std::unique_ptr<dealii::FiniteElement<3>>
linear_element(const BlockSpace& space) {
  if (space.triangulation().all_reference_cells_are_hyper_cube())
    return std::make_unique<dealii::FE_Q<3>>(1);
  return std::make_unique<dealii::FE_SimplexP<3>>(1);
}

/// The matrix that maps values at the quadrature points of a cell to the values
/// of their linear projection at its vertices.
dealii::FullMatrix<double> projection_of(const BlockSpace& space) {
  const dealii::Quadrature<3>& points = space.cell_quadrature();
  const auto linear = linear_element(space);
  dealii::FullMatrix<double> matrix(linear->n_dofs_per_cell(), points.size());
  dealii::FETools::compute_projection_from_quadrature_points_matrix(
      *linear, points, points, matrix);
  return matrix;
}

dealii::FullMatrix<double> vertex_mass_of(const BlockSpace& space) {
  const dealii::Quadrature<3>& points = space.cell_quadrature();
  const auto linear = linear_element(space);
  const unsigned int n = linear->n_dofs_per_cell();
  dealii::FullMatrix<double> mass(n, n);
  double volume = 0.0;
  for (unsigned int q = 0; q < points.size(); ++q) {
    volume += points.weight(q);
    for (unsigned int v = 0; v < n; ++v)
      for (unsigned int w = 0; w < n; ++w)
        mass(v, w) += points.weight(q) *
                      linear->shape_value(v, points.point(q)) *
                      linear->shape_value(w, points.point(q));
  }
  mass /= volume;
  return mass;
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

VertexAverages::VertexAverages(std::size_t n_vertices, double ratio)
    : ratio_(ratio), first_(n_vertices) {}

void VertexAverages::add(unsigned int vertex, const Moduli& material,
                         double volume, const StressTensor& stress) {
  Share* share = &first_[vertex];
  if (share->volume > 0.0 && !(share->material == material)) {
    std::vector<Share>& others = others_[vertex];
    auto found = std::ranges::find(others, material, &Share::material);
    if (found == others.end())
      found = others.insert(others.end(), Share{});
    share = &*found;
  }
  share->material = material;
  share->volume += volume;
  share->volume_stress += volume * stress;
}

StressTensor VertexAverages::at(unsigned int vertex,
                                const Moduli& material) const {
  double volume = 0.0;
  StressTensor sum;
  const auto add_similar = [&](const Share& share) {
    const double scale = material.shear_modulus / share.material.shear_modulus;
    if (!(share.material == material) &&
        (std::max(scale, 1.0 / scale) > ratio_ ||
         !is_same_ratio(share.material, material)))
      return;
    volume += share.volume;
    sum += scale * share.volume_stress;
  };
  add_similar(first_[vertex]);
  if (!others_.empty())
    if (const auto found = others_.find(vertex); found != others_.end())
      std::ranges::for_each(found->second, add_similar);
  return sum / volume;
}

BlockStress::BlockStress(
    const BlockSystem& system,
    const dealii::TrilinosWrappers::MPI::Vector& displacement,
    const MaterialPoints* material)
    : system_(system),
      material_(material),
      strains_(system.space()),
      to_vertices_(projection_of(system.space())),
      mass_(vertex_mass_of(system.space())) {
  const BlockSpace& space = system.space();
  strains_.set(displacement);
  if (material == nullptr &&
      space.triangulation().all_reference_cells_are_hyper_cube())
    at_vertices_.emplace(space.element(), space.cell_quadrature(),
                         to_vertices_);
}

double BlockStress::volume(const Cell& cell) {
  if (cell->reference_cell().is_hyper_cube())
    if (const auto edges = box_edges(cell))
      return (*edges)[0] * (*edges)[1] * (*edges)[2];
  return cell->measure();
}

const std::vector<StressTensor>& BlockStress::at_points(const Cell& cell) {
  const Moduli material = system_.moduli_of(cell);
  stress_ = strains_.at_points(cell);
  if (material_ != nullptr)
    material_->subtract_from(stress_, cell);
  for (StressTensor& value : stress_)
    value = elastic_stress(value, material);
  return stress_;
}

const std::vector<StressTensor>&
BlockStress::projected(const Cell& cell, const Moduli& material) {
  if (at_vertices_ && strains_.in_box(cell, *at_vertices_, projected_)) {
    for (StressTensor& value : projected_)
      value = elastic_stress(value, material);
    return projected_;
  }
  const std::vector<StressTensor>& stress = at_points(cell);
  projected_.assign(to_vertices_.m(), {});
  for (unsigned int v = 0; v < projected_.size(); ++v)
    for (unsigned int q = 0; q < stress.size(); ++q)
      projected_[v] += to_vertices_(v, q) * stress[q];
  return projected_;
}

VertexAverages BlockStress::averages(double ratio) {
  VertexAverages averages(system_.space().triangulation().n_vertices(), ratio);
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    const Moduli material = system_.moduli_of(cell);
    const std::vector<StressTensor>& stress = projected(cell, material);
    const double weight = volume(cell);
    for (const unsigned int v : cell->vertex_indices())
      averages.add(cell->vertex_index(v), material, weight, stress[v]);
  }
  return averages;
}

void BlockStress::at_vertices(const TakeVertices& take, double ratio) {
  const VertexAverages around = averages(ratio);
  std::vector<StressTensor> at_vertex;
  for (const auto& cell :
       system_.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const Moduli material = system_.moduli_of(cell);
    at_vertex.clear();
    for (const unsigned int v : cell->vertex_indices())
      at_vertex.push_back(around.at(cell->vertex_index(v), material));
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
      const double strength = von_mises(stress[q]);
      if (-strength > best[0])
        continue;
      const dealii::Point<3> place =
          system_.space().mapping().transform_unit_to_real_cell(
              cell, system_.space().cell_quadrature().point(q));
      const RankedPlace here{-strength, place[0], place[1], place[2], 0.0};
      if (here < best) {
        best = here;
        best[4] = largest_shear(stress[q]);
      }
    }
  }
  for (const RankedPlace& found : of_all_ranks(std::vector{best}))
    best = std::min(best, found);
  return {.von_mises = -best[0],
          .largest_shear = best[4],
          .depth = std::abs(best[3]),
          .place = {best[1], best[2], best[3]}};
}

} // namespace asperity::fem
