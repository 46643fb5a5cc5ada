#include "fem/solution/gap_error.hpp"

#include "fem/material/hooke.hpp"
#include "fem/solution/block_stress.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

/// The difference of the average stress and the projected one at the vertices
/// of the cells, for one displacement.
class VertexErrors {
public:
  VertexErrors(const BlockSystem& system,
               const dealii::TrilinosWrappers::MPI::Vector& displacement,
               double ratio)
      : stress_(system, displacement), averages_(stress_.averages(ratio)) {}

  const std::vector<StressTensor>& of(const BlockStress::Cell& cell,
                                      const Moduli& material) {
    errors_ = stress_.projected(cell, material);
    for (unsigned int v = 0; v < errors_.size(); ++v)
      errors_[v] -= averages_.at(cell->vertex_index(v), material);
    return errors_;
  }

  const BlockStress& stress() const { return stress_; }

private:
  BlockStress stress_;
  VertexAverages averages_;
  std::vector<StressTensor> errors_;
};

} // namespace

double gap_error(const BlockSystem& system, const LoadedResponse& by_load,
                 const LoadedResponse& response, double ratio) {
  VertexErrors of_load(system, by_load.displacement, ratio);
  VertexErrors of_response(system, response.displacement, ratio);
  const dealii::FullMatrix<double>& mass = of_load.stress().vertex_mass();
  std::array<double, 2> sums{}; // of the lines of (F.4)
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const Moduli material = system.moduli_of(cell);
    const std::vector<StressTensor>& error = of_load.of(cell, material);
    const std::vector<StressTensor>& other = of_response.of(cell, material);
    double product = 0.0;
    double square = 0.0;
    for (unsigned int v = 0; v < error.size(); ++v) {
      StressTensor weighted;
      for (unsigned int w = 0; w < error.size(); ++w)
        weighted += mass(v, w) * error[w];
      product += elastic_product(weighted, other[v], material);
      square += elastic_product(weighted, error[v], material);
    }
    const double volume = BlockStress::volume(cell);
    sums[0] += std::abs(product) * volume;
    sums[1] += square * volume;
  }
  for (double& value : sums)
    value = dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
  return std::min(sums[0] / response.force, sums[1] / by_load.force);
}

} // namespace asperity::fem
