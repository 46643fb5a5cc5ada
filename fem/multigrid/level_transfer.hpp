#pragma once

// Between the functions of a mesh and the next coarser ones: displacements,
// forces and contact.

#include "fem/multigrid/mesh_contact.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The interpolation of displacements and its transpose for forces. Ranks may
/// share the coarse functions as the fine ones, or each has all of them; their
/// forces are then those of all ranks. Calls are collective if the fine
/// functions are shared.
class LevelTransfer {
public:
  /// @param gathering  the ranks whose forces and contact each of them
  ///                   receives; null if there is nothing to gather
  explicit LevelTransfer(RankGroup* gathering) : gathering_(gathering) {}

  virtual ~LevelTransfer() = default;

  /// Sets the coarse force to the transposed interpolation of the fine one. It
  /// may be on constrained unknowns and those of other ranks, too.
  void restrict_force(const std::vector<float>& fine,
                      std::vector<float>& coarse);

  /// Adds the interpolated coarse displacement, whose constrained values and
  /// those of other ranks must be known, to the fine one.
  virtual void add_interpolated(const std::vector<float>& coarse,
                                std::vector<float>& fine) = 0;

  MeshContact coarse(const MeshContact& fine) const;

  virtual std::size_t bytes() const = 0;

protected:
  /// Adds what restrict_force() sets for this rank.
  virtual void add_restricted(const std::vector<float>& fine,
                              std::vector<float>& coarse) = 0;

  ContactTransfer& contact() { return contact_; }

  const ContactTransfer& contact() const { return contact_; }

private:
  RankGroup* gathering_;
  ContactTransfer contact_;
  std::vector<float> all_; ///< forces of all ranks
};

} // namespace asperity::fem
