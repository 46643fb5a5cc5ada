#pragma once

// The finite elements as the rest of the program sees them: loaded at run
// time, so that only commands that compute with them pay deal.II's start.

#include "cases/types/case.hpp"
#include "contact/operators/surface_operator.hpp"
#include "fem/block/full_block.hpp"
#include "fem/case_problem.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::fem {

/// A place that remembers bytes between two processes.
struct Keeper {
  std::function<std::optional<std::string>()> read;
  std::function<void(std::string_view)> write;
};

/// One block to build: the case's [fem] on one realisation of the surface.
struct BlockRequest {
  Grid grid;
  cases::FemSettings settings;
  cases::Scales scales;
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1] -1..0.5
  int threads = 1;             ///< changes no bit of an answer
  Keeper keeper = {}; ///< of this very block's condensed operator; may be empty
  /// Bonded to the contact face, whose first; E and nu are those below them.
  std::vector<cases::MaterialLayer> layers = {};
};

/// What the module gives. Each call throws std::domain_error, in words, for a
/// block that cannot be built (layers that do not fit, an odd grid for Q2).
class FemRoom {
public:
  virtual ~FemRoom() = default;

  /// Road 2: settings.solver automatic or condensed. What costs more to build
  /// than to read, the blocks of Q2, is asked of the keeper first and given to
  /// it when built.
  virtual std::unique_ptr<contact::SurfaceOperator>
  condensed(const BlockRequest& request) const = 0;

  /// Road 1: settings.solver full. Under mpirun all ranks share the work; a
  /// call at a time.
  /// @throws cases::CaseError  besides, for a file that the case names
  virtual std::unique_ptr<FullBlock> full(const FullRequest& request) const = 0;

  /// The same without a case: the block of condensed(), whole, on one process
  /// alone.
  virtual std::unique_ptr<FullBlock>
  uncondensed(const BlockRequest& request) const = 0;

  /// Under mpirun, before anything else is done: on rank 0 false, and the
  /// others end when the program does; on the others true, once it has ended.
  virtual bool has_followed() const = 0;

  /// Processes that share a whole block.
  virtual int ranks() const = 0;

  /// "deal.II 9.4.1, Trilinos 13.2.0": for the provenance.
  virtual std::string versions() const = 0;
};

/// The interface law of the case in the units the whole block takes.
BlockContact block_contact(const cases::ContactSettings& settings,
                           const cases::Scales& scales);

/// The room, loaded at the first call: the module asperity_fem from the folder
/// of the running program, from ../fem beside it (the build tree), or from
/// ../lib/asperity beside it (an installation).
/// @throws std::runtime_error  none could be loaded; says where it looked and
///                             what the loader answered
const FemRoom& load_fem_room();

} // namespace asperity::fem
