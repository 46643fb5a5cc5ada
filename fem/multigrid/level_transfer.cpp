#include "fem/multigrid/level_transfer.hpp"

#include "base/ranks/rank_sums.hpp"

#include <algorithm>

namespace asperity::fem {

void LevelTransfer::restrict_force(const std::vector<float>& fine,
                                   std::vector<float>& coarse) {
  std::ranges::fill(coarse, 0.0F);
  add_restricted(fine, coarse);
  if (gathering_ == nullptr)
    return;
  all_ = values_of_ranks(gathering_, std::span<const float>(coarse));
  std::copy_n(all_.begin(), coarse.size(), coarse.begin());
  for (std::size_t i = coarse.size(); i < all_.size(); ++i)
    coarse[i % coarse.size()] += all_[i];
}

MeshContact LevelTransfer::coarse(const MeshContact& fine) const {
  const MeshContact own = contact_.coarse(fine);
  return gathering_ == nullptr ? own : of_all_ranks(*gathering_, own);
}

} // namespace asperity::fem
