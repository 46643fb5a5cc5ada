#pragma once

// Load steps of a half-space or condensed block that all ranks of mpirun solve
// together.

#include "app/methods/load_steps.hpp"
#include "cases/types/case.hpp"
#include "mechanics/elastic_block.hpp"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>
#include <variant>

namespace asperity::app {

/// Smallest number of nodes whose rows the ranks share: below it, a step takes
/// less than a tenth of a second in one process.
inline constexpr std::size_t least_shared_nodes = std::size_t{512} * 512;

/// Returns whether the ranks share the rows of a method on this grid: it is a
/// half-space or slab or a condensed block, with at least least_shared_nodes
/// nodes, and the rows can be divided among so many ranks.
bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks);

/// Why so many ranks cannot share the rows of a method of this kind and size,
/// as a part of a sentence; empty if they can, and for other methods.
std::string obstacle_to_sharing(const cases::MethodSpec& method,
                                const Grid& grid, int n_ranks);

/// A half-space with free boundaries.
struct FreeBlock {
  double contact_modulus = 0.0; ///< E* [Pa] > 0
};

/// The elastic block whose rows are shared: a periodic continuum, one with free
/// boundaries, or the text of a request of a condensed block
/// (fem::FemModule::text_of).
using SharedBlock =
    std::variant<mechanics::ElasticBlock, FreeBlock, std::string>;

/// The way of a continuum to the other ranks, as a part of a command.
nlohmann::json json_of_block(const mechanics::ElasticBlock& block);
mechanics::ElasticBlock block_in(const nlohmann::json& text);

/// Solves the load steps on all ranks, with the bits of one process. To be
/// called on rank 0; the fields of the solver are divided among the ranks. One
/// call at a time may be active for all such objects.
/// @param surface  the ranks build its rows if it has a source; otherwise rank
/// 0
///                 sends its heights to them
std::unique_ptr<LoadSteps>
make_shared_load_steps(const SurfaceOfCase& surface, const SharedBlock& block,
                       const LoadStepsSetting& setting);

/// Returns whether a text that rank 0 has sent to all ranks is a command of
/// shared load steps.
bool is_for_shared_steps(const std::string& text);

/// Executes such a command on a rank other than 0.
void follow_shared_steps(const std::string& text);

} // namespace asperity::app
