#pragma once

// The surfaces of a run that all ranks of mpirun make together.

#include "methods/surfaces_of_case.hpp"
#include "ranks/root_work.hpp"
#include "ranks/shared_rows.hpp"
#include "results/types/map_rows.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::methods {

/// A surface of which each rank builds or receives its rows, so that no rank
/// keeps a whole one. All calls are collective.
class SurfaceRows {
public:
  /// What a rank has built last, for all surfaces of a run.
  struct Kept {
    const SurfaceRows* of = nullptr;
    std::vector<double> heights;
    surfaces::MapFacts facts; ///< on rank 0, if it has built the whole map
  };

  /// @param source   grid is not read
  /// @param root     of ranks; must outlive this object
  /// @param threads  of each rank
  /// @throws  as surfaces::build_surface
  SurfaceRows(SurfaceSource source, RootWork& root, int threads,
              std::shared_ptr<Kept> kept);

  /// The surface without its heights, with the bits of one process.
  /// @param contact_modulus  E* [Pa]
  SurfaceOfCase described(double contact_modulus) const;

  /// Who builds the rows, as a sentence.
  std::string sentence() const;

  /// Gives up the heights of this rank [m], which are built if they are not
  /// those that were built last.
  std::vector<double> taken() const;

  /// Passes the heights to rank 0.
  void pass(const results::TakeValues& take) const;

private:
  const Kept& kept() const;

  SurfaceSource source_;
  RootWork& root_;
  int threads_;
  SharedRows rows_;
  /// Why rank 0 builds the whole surface and sends its rows
  /// (surfaces::reason_for_whole()); empty: each rank builds its own.
  std::string whole_because_;
  std::shared_ptr<Kept> kept_;
};

/// Lets each rank build its rows. A surface that must be built as a whole is
/// built by rank 0, which sends the rows and keeps only its own.
/// @param contact_modulus  E* [Pa]
/// @param threads          of each rank
BuildSurface surfaces_by_rows(RootWork& root, double contact_modulus,
                              int threads);

/// Lets rank 0 build the surfaces. The others receive grid and scales, and the
/// heights if each of them presses the whole surface.
BuildSurface surfaces_of_rank_0(RootWork& root, double contact_modulus,
                                bool sends_heights);

} // namespace asperity::methods
