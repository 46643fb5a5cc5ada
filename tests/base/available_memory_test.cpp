// Tests of base/available_memory.hpp.
#include "base/available_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sys/resource.h>

namespace asperity::available_memory_test {

TEST(AvailableMemory, IsLessThanAPetabyteAndMoreThanAMebibyte) {
  EXPECT_GT(available_memory(), 1024.0 * 1024.0);
  EXPECT_LT(available_memory(), 1e15);
}

// The limit on the address space counts, less what is used of it.
TEST(AvailableMemory, RespectsTheLimitOfTheProcess) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  rlimit low = before;
  low.rlim_cur = static_cast<rlim_t>(4.0 * gibibyte);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &low), 0);

  const double available = available_memory();
  setrlimit(RLIMIT_AS, &before);

  EXPECT_LT(available, 4.0 * gibibyte);
}

TEST(MemoryShortage, StatesRequiredAndAvailableMemory) {
  EXPECT_EQ(memory_shortage(0.0), "");
  EXPECT_EQ(memory_shortage(std::nan("")), "");
  const std::string shortage = memory_shortage(std::ldexp(1.0, 53));
  EXPECT_TRUE(shortage.starts_with("needs 8 PiB of memory, but ")) << shortage;
  EXPECT_TRUE(shortage.ends_with(" are available")) << shortage;
}

} // namespace asperity::available_memory_test
