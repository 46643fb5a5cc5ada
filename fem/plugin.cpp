#include "fem/plugin.hpp"

#include "contact/operators/fourier_operator.hpp"
#include "fem/adaptive/adaptive_block.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "fem/parallel/network_solver.hpp"
#include "fem/parallel/ranks.hpp"
#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/q2_operator.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <HYPRE_config.h>
#include <deal.II/base/config.h>

#include <Trilinos_version.h>
#include <cstring>

namespace asperity::fem {
namespace {

int degree(const BlockRequest& request) {
  return degree_of(request.settings.element);
}

LayeredBlock layers_of(const BlockRequest& request) {
  return layered_block(request.settings, request.layers,
                       {request.youngs_modulus, request.poisson_ratio},
                       request.grid, request.scales);
}

/// Copies the cached raw bytes into the compliance blocks. Returns false if
/// there are none or if their number does not match the grid.
bool take_blocks(const std::optional<std::string>& bytes,
                 Q2Compliance& compliance) {
  const std::size_t size = sizeof(NodeClassBlock) *
                           static_cast<std::size_t>(compliance.columns()) *
                           static_cast<std::size_t>(compliance.rows());
  if (!bytes || bytes->size() != size)
    return false;
  compliance.blocks.resize(size / sizeof(NodeClassBlock));
  std::memcpy(compliance.blocks.data(), bytes->data(), size);
  return true;
}

Q2Compliance kept_or_built(const BlockRequest& request,
                           const LayeredBlock& block) {
  const OperatorCache& cache = request.cache;
  Q2Compliance compliance;
  compliance.grid = request.grid;
  compliance.class_weights = relative_nodal_areas(2);
  if (cache.read && take_blocks(cache.read(), compliance))
    return compliance;
  compliance = condensed_compliance_q2(request.grid, block, request.threads);
  if (cache.write)
    cache.write({reinterpret_cast<const char*>(compliance.blocks.data()),
                 compliance.blocks.size() * sizeof(NodeClassBlock)});
  return compliance;
}

std::unique_ptr<FullBlock> make_block(const BlockProblem& problem) {
  return problem.adaptive ? make_adaptive_block(problem)
                          : make_full_block(problem);
}

class DealiiModule final : public FemModule {
public:
  std::unique_ptr<contact::SurfaceOperator>
  condensed(const BlockRequest& request) const override {
    const LayeredBlock block = layers_of(request);
    if (degree(request) == 1)
      return std::make_unique<contact::FourierOperator>(
          request.grid,
          condensed_compliance_q1(request.grid, block, request.threads),
          request.threads);
    return std::make_unique<Q2Operator>(kept_or_built(request, block),
                                        request.threads);
  }

  std::unique_ptr<contact::SurfaceOperator>
  condensed_on_ranks(const BlockRequest& request) const override {
    if (degree(request) == 2)
      return std::make_unique<Q2Operator>(
          request.grid, mpi_group(),
          condensed_column_q2(request.grid, layers_of(request)),
          request.threads);
    return std::make_unique<contact::FourierOperator>(
        request.grid, mpi_group(),
        condensed_column_q1(request.grid, layers_of(request)), request.threads);
  }

  std::unique_ptr<FullBlock> full(const FullRequest& request) const override {
    return make_block(problem_on_ranks(request));
  }

  FileMesh mesh_file(const std::string& path, double unit) const override {
    return read_mesh_file(path, unit);
  }

  bool has_followed(const std::function<void(const std::string& text)>& execute)
      const override {
    if (own_rank() == 0) {
      end_followers_at_exit();
      return false;
    }
    follow_rank_0(execute);
    return true;
  }

  void on_all_ranks(const std::string& text,
                    const std::function<void()>& share) const override {
    do_on_all_ranks(text, share);
  }

  ProgramRanks& rank_group() const override { return mpi_group(); }

  int ranks() const override { return n_ranks(); }

  flow::NetworkSolution
  solved_network(const flow::Network& network) const override {
    start_mpi();
    return fem::solved_network(network);
  }

  std::string versions() const override {
    return "deal.II " DEAL_II_PACKAGE_VERSION
           ", Trilinos " TRILINOS_VERSION_STRING
           ", hypre " HYPRE_RELEASE_VERSION;
  }
};

} // namespace
} // namespace asperity::fem

/// The only symbol that the plugin exports.
extern "C" const asperity::fem::FemModule* asperity_fem_entry() {
  static const asperity::fem::DealiiModule instance;
  return &instance;
}
