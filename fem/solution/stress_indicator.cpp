#include "fem/solution/stress_indicator.hpp"

#include "fem/solution/block_stress.hpp"

#include <deal.II/fe/fe_q.h>

#include <cmath>

namespace asperity::fem {
namespace {

/// Share of the stress below which a difference counts as none. Solutions that
/// only decide on the mesh are not more accurate.
constexpr double least_share = 1e-3;

} // namespace

std::vector<double>
stress_indicator(const BlockSystem& system,
                 const dealii::TrilinosWrappers::MPI::Vector& displacement,
                 double ratio) {
  BlockStress stress(system, displacement);
  const dealii::Quadrature<3>& quadrature = system.space().cell_quadrature();
  const dealii::FE_Q<3> linear(1);
  std::vector<double> indicator(
      system.space().triangulation().n_active_cells());
  const auto take = [&](const BlockStress::Cell& cell,
                        std::span<const StressTensor> at_vertex) {
    const std::vector<StressTensor>& raw = stress.at_points(cell);
    double square = 0.0;
    double whole = 0.0;
    for (unsigned int q = 0; q < raw.size(); ++q) {
      StressTensor difference = raw[q];
      for (unsigned int v = 0; v < at_vertex.size(); ++v)
        difference -= linear.shape_value(v, quadrature.point(q)) * at_vertex[v];
      square += quadrature.weight(q) * (difference * difference);
      whole += quadrature.weight(q) * (raw[q] * raw[q]);
    }
    if (square < least_share * least_share * whole)
      square = 0.0;
    indicator[cell->active_cell_index()] =
        std::sqrt(square * cell->measure() /
                  (2.0 * system.moduli_of(cell).shear_modulus));
  };
  stress.at_vertices(take, ratio);
  return indicator;
}

} // namespace asperity::fem
