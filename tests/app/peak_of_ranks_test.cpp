// Claim: the peak memory that a result records is that of the largest rank,
// not that of rank 0. Runs on two ranks.
#include "app/run/mpi_world.hpp"
#include "base/peak_memory.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace asperity::app::peak_of_ranks_test {

constexpr std::size_t large = 800'000'000; // [B]

bool is_second() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK"})
    if (const char* rank = std::getenv(name))
      return std::string(rank) == "1";
  return false;
}

TEST(PeakOfRanks, IsThatOfTheLargestRank) {
  if (is_second()) {
    std::vector<char>(large, 'x'); // every page is touched
    EXPECT_TRUE(has_followed_rank_0());
    return;
  }
  ASSERT_FALSE(has_followed_rank_0());
  ASSERT_EQ(n_mpi_ranks(), 2);

  EXPECT_GT(largest_peak_memory(), 1.0 * large);
  EXPECT_LT(peak_memory(), 0.6 * large); // of this rank
}

} // namespace asperity::app::peak_of_ranks_test
