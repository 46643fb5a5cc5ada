#pragma once

// Lets a test run the kernels of base/simd_pack.hpp as other processors do.

#include "base/simd_pack.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::tests {

/// Calls check() with each width of vectors below that of this processor. One
/// without AVX2 has a single width, and then nothing is called.
template <class Check>
void on_narrower_vectors(const Check& check) {
  const std::size_t widest = widest_vectors();
  for (std::size_t bytes = 16; bytes < widest; bytes *= 2) {
    const testing::ScopedTrace trace(__FILE__, __LINE__,
                                     std::to_string(bytes) + " bytes");
    widest_vectors() = bytes;
    check();
  }
  widest_vectors() = widest;
}

} // namespace asperity::tests
