#include "base/array_memory.hpp"
#include "base/available_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <sys/resource.h>
#include <vector>

namespace asperity::array_memory_test {

bool begins_at_cache_line(const void* array) {
  return reinterpret_cast<std::uintptr_t>(array) % cache_line == 0;
}

// Claim: where addresses are limited, the process takes none that it does not
// use. Tolerance: half of the memory that it would keep. This is the first
// test, because later ones let it keep memory.
TEST(ArrayMemory, TakesNoAddressesWhereTheyAreLimited) {
  if (!has_aligned_arrays())
    GTEST_SKIP() << "a sanitizer needs more addresses";
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit low = before;
  low.rlim_cur = rlim_t{1} << 30U;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &low), 0);
  const double left = available_memory();

  keep_freed_memory();

  EXPECT_GT(available_memory(), left - 128e6);
  setrlimit(RLIMIT_AS, &before);
}

// Claim: large arrays of any size begin at a cache line, alone, after a small
// one and in memory that was freed before.
TEST(ArrayMemory, BeginsLargeArraysAtCacheLines) {
  if (!has_aligned_arrays())
    GTEST_SKIP() << "a sanitizer has its own operator new";
  for (int turn = 0; turn < 2; ++turn) {
    std::vector<std::unique_ptr<char[]>> arrays;

    for (std::size_t bytes = smallest_aligned_array; bytes < (1U << 24U);
         bytes += bytes / 3 + 1) {
      arrays.push_back(std::make_unique<char[]>(17));
      arrays.push_back(std::make_unique<char[]>(bytes));

      EXPECT_TRUE(begins_at_cache_line(arrays.back().get())) << bytes;
    }
  }
}

TEST(ArrayMemory, GivesNothingAPlaceOfItsOwn) {
  void* const one = ::operator new(0);
  void* const other = ::operator new(0);

  EXPECT_NE(one, nullptr);
  EXPECT_NE(one, other);

  ::operator delete(one);
  ::operator delete(other);
}

int n_handled = 0;

void give_up() {
  ++n_handled;
  std::set_new_handler(nullptr);
}

// Claim: memory that there is not is refused as the standard says, after the
// handler was called.
TEST(ArrayMemory, RefusesMoreThanThereIs) {
  if (!has_aligned_arrays())
    GTEST_SKIP() << "a sanitizer ends the program";
  volatile std::size_t bytes = std::numeric_limits<std::ptrdiff_t>::max();
  std::set_new_handler(give_up);

  EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc);

  EXPECT_EQ(n_handled, 1);
}

// Claim: arrays keep their values where the process keeps freed memory.
TEST(ArrayMemory, KeepsValuesInMemoryThatIsKept) {
  keep_freed_memory();
  keep_freed_memory();

  const std::vector<double> large(1 << 20, 1.5), larger(5 << 20, 2.5);

  EXPECT_EQ(large, std::vector<double>(large.size(), 1.5));
  EXPECT_EQ(larger, std::vector<double>(larger.size(), 2.5));
}

} // namespace asperity::array_memory_test
