#pragma once

// This file compiles a loop for the instructions of several processors and
// chooses between them when it is called.

#include "base/simd_pack.hpp"

#include <atomic>
#include <cstddef>
#include <type_traits>

namespace asperity {

/// Bytes of the widest vectors that kernels use: 64, 32 or 16, those of this
/// processor. A test may set a smaller number, to compare the vectors of other
/// processors.
inline std::atomic<std::size_t>& widest_vectors() {
#ifdef __x86_64__
  static std::atomic<std::size_t> bytes = has_avx512() ? 64
                                          : has_avx2() ? 32
                                                       : 16;
#else
  static std::atomic<std::size_t> bytes = 16;
#endif
  return bytes;
}

#ifdef __x86_64__
/// Calls a kernel that is inlined and so compiled for these processors.
template <class Kernel>
[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] auto
on_avx512(const Kernel& kernel) {
  return kernel(std::integral_constant<std::size_t, 64>());
}

template <class Kernel>
[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw,fma")]] auto
on_avx512_with_fma(const Kernel& kernel) {
  return kernel(std::integral_constant<std::size_t, 64>());
}

template <class Kernel>
[[gnu::target("avx2")]] auto on_avx2(const Kernel& kernel) {
  return kernel(std::integral_constant<std::size_t, 32>());
}

template <class Kernel>
[[gnu::target("avx2,fma")]] auto on_avx2_with_fma(const Kernel& kernel) {
  return kernel(std::integral_constant<std::size_t, 32>());
}
#endif

/// Calls kernel(bytes) with the bytes of the widest vectors of this processor.
/// @param kernel  a lambda with the attribute always_inline, as must be what it
///                calls. In a source that is compiled with -ffp-contract=off it
///                rounds in the same way for all vectors, unless it adds
///                numbers in another order.
template <class Kernel>
auto on_this_processor(const Kernel& kernel) {
#ifdef __x86_64__
  const std::size_t bytes = widest_vectors().load(std::memory_order_relaxed);
  if (bytes >= 64)
    return on_avx512(kernel);
  if (bytes >= 32)
    return on_avx2(kernel);
#endif
  return kernel(std::integral_constant<std::size_t, 16>());
}

/// The same with fused multiply-add in vectors of 32 and 64 bytes, which are
/// not used without it. The bits of a result depend on the processor.
template <class Kernel>
auto on_this_processor_with_fma(const Kernel& kernel) {
#ifdef __x86_64__
  static const bool has_fma = has_avx2_and_fma();
  const std::size_t bytes = widest_vectors().load(std::memory_order_relaxed);
  if (bytes >= 64 && has_fma)
    return on_avx512_with_fma(kernel);
  if (bytes >= 32 && has_fma)
    return on_avx2_with_fma(kernel);
#endif
  return kernel(std::integral_constant<std::size_t, 16>());
}

} // namespace asperity
