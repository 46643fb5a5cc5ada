#pragma once

// Interface of the finite-element module to the rest of the program. The module
// is loaded at run time, so that only commands that need it pay for the
// start-up of deal.II.

#include "base/ranks/root_work.hpp"
#include "contact/operators/surface_operator.hpp"
#include "fem/block/full_block.hpp"
#include "fem/block/mesh_file.hpp"
#include "fem/full_request.hpp"
#include "mechanics/contact_law.hpp"
#include "mechanics/fem_settings.hpp"
#include "mechanics/flow/network.hpp"
#include "mechanics/material.hpp"
#include "mechanics/quantity.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::fem {

/// A cache that stores bytes from one process to the next.
struct OperatorCache {
  std::function<std::optional<std::string>()> read;
  std::function<void(std::string_view)> write;
};

/// One laterally uniform block to build, for one realisation of the surface.
struct BlockRequest {
  Grid grid;
  mechanics::BlockSettings settings;
  mechanics::Scales scales;
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1] -1..0.5
  int threads = 1;             ///< results are bitwise independent of it
  /// Cache of the condensed operator of this particular block; may be empty.
  OperatorCache cache = {};
  /// Layers bonded to the contact surface, outermost first; youngs_modulus and
  /// poisson_ratio are those of the material below them.
  std::vector<mechanics::MaterialLayer> layers = {};
};

/// The services of the finite-element module. Each call throws
/// std::domain_error with a description if a block cannot be built (for example
/// if layers do not fit, or for an odd grid with Q2).
class FemModule {
public:
  virtual ~FemModule() = default;

  /// The condensed method. The compliance blocks of Q2 cost more to build than
  /// to read, so they are requested from the cache first and written to it
  /// after they have been built.
  virtual std::unique_ptr<contact::SurfaceOperator>
  condensed(const BlockRequest& request) const = 0;

  /// The operator of condensed() on rows that all ranks share, bitwise the
  /// same. Collective; the cache of the request is not used.
  virtual std::unique_ptr<contact::SurfaceOperator>
  condensed_on_ranks(const BlockRequest& request) const = 0;

  /// The full method. Under mpirun all ranks share the work, and the call and
  /// those of the block are collective; rank 0 makes the mesh.
  /// @throws input::InputError  in addition, for a file that the request names
  virtual std::unique_ptr<FullBlock> full(const FullRequest& request) const = 0;

  /// As fem::read_mesh_file().
  virtual FileMesh mesh_file(const std::string& path, double unit) const = 0;

  /// Solves a network on this process alone, see flow::SolveNetwork.
  virtual flow::NetworkSolution
  solved_network(const flow::Network& network) const = 0;

  /// Must be called under mpirun before anything else. On rank 0 it returns
  /// false immediately, and the other ranks end when the program does. On the
  /// other ranks it returns true after rank 0 has ended.
  /// @param execute  what this rank does with the text of on_all_ranks()
  virtual bool has_followed(
      const std::function<void(const std::string& text)>& execute) const = 0;

  /// To be called on rank 0. Calls `share` here and the function of
  /// has_followed() with this text on the other ranks, and waits for all of
  /// them. A failure on every rank is thrown as an exception; a failure on some
  /// ranks ends all of them.
  virtual void on_all_ranks(const std::string& text,
                            const std::function<void()>& share) const = 0;

  /// All ranks of mpirun, to be used within on_all_ranks(). The first call is
  /// collective.
  virtual ProgramRanks& rank_group() const = 0;

  /// Number of processes that share a full 3-D block.
  virtual int ranks() const = 0;

  /// Library versions for the provenance, such as "deal.II 9.4.1, Trilinos
  /// 13.2.0, hypre 2.26.0".
  virtual std::string versions() const = 0;
};

/// Converts the contact law to SI units, as the full 3-D block needs it.
BlockContact block_contact(const mechanics::ContactSettings& settings,
                           const mechanics::Scales& scales);

/// Returns the finite-element module, loaded at the first call: the plugin
/// asperity_fem from the folder of the running program, from ../fem or
/// ../../fem relative to it (the build tree), or from ../lib/asperity relative
/// to it (an installation).
/// @throws std::runtime_error  no plugin could be loaded; the message lists the
///                             places searched and the loader's errors
const FemModule& load_fem_module();

} // namespace asperity::fem
