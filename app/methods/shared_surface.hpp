#pragma once

// Surfaces of which each rank of mpirun builds or receives its rows, so that no
// rank keeps a whole one.

#include "app/methods/surfaces_of_case.hpp"
#include "results/types/map_rows.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

#include "ranks/shared_rows.hpp"

namespace asperity::app {

/// Returns whether no rank needs to keep a whole surface: every method that
/// presses it is one whose rows so many ranks share (is_shared_by_ranks).
bool has_surfaces_by_rows(const cases::Case& contact_case,
                          const std::vector<cases::MethodSpec>& methods,
                          int n_ranks);

/// Builds a surface on all ranks. Each rank builds its rows, unless the surface
/// must be built as a whole (surfaces::reason_for_whole): then rank 0 does so,
/// sends the rows and keeps only its own. To be called on rank 0, as the next
/// functions; one call at a time may be active.
/// @param asked            grid and whole_because are not read
/// @param contact_modulus  E* [Pa]
/// @param threads          of each rank
/// @return  the surface without its heights, with the bits of one process
/// @throws  as surfaces::build_surface
SurfaceOfCase surface_by_rows(const SurfaceSource& asked,
                              double contact_modulus, int threads);

/// Who builds the rows of such a surface, as a sentence.
std::string rows_sentence(const SurfaceSource& source, int n_ranks);

/// The heights of such a surface, which the ranks send in pieces of a few MB.
results::MapRows heights_by_rows(const SurfaceSource& source, int threads);

/// Returns whether a text that rank 0 has sent to all ranks is a command of
/// these functions.
bool is_for_shared_surface(const std::string& text);

/// Executes such a command on a rank other than 0.
void follow_shared_surface(const std::string& text);

/// Lets rank 0 build the surface if it must be built as a whole. To be called
/// on rank 0 before a command that takes its heights.
void prepare_heights(const SurfaceSource& source);

/// The way of a source to the other ranks, as a part of a command.
nlohmann::json json_of(const SurfaceSource& source);

/// The heights of this rank [m]. Collective. A rank keeps the heights that it
/// has built last until they are taken.
/// @param source  a result of json_of()
std::vector<double> take_heights(const nlohmann::json& source,
                                 const SharedRows& rows, int threads);

} // namespace asperity::app
