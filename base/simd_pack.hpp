#pragma once

// Vectors of numbers that the compiler keeps in SIMD registers, compiles a loop
// for the vectors of several processors and chooses between them when it is
// called.

#include <atomic>
#include <cstddef>
#include <type_traits>

namespace asperity {

/// As many numbers as fit into `bytes`: 16, 32 with AVX2, 64 with AVX-512. The
/// operators + - * / and comparisons act on each lane. They are vector types of
/// the compiler: a loop is a template in the number of bytes, which a function
/// with the target attribute of an instruction set instantiates. Libraries of
/// SIMD types would need a source file per instruction set (xsimd), or calls in
/// place of operators (highway), and no intrinsic is used here.
template <class Number, std::size_t bytes>
struct SimdPack {
  typedef Number Type __attribute__((vector_size(bytes)));
  /// The same in an array of numbers, at any place.
  typedef Number Unaligned
      __attribute__((vector_size(bytes), aligned(sizeof(Number)), may_alias));
  static constexpr std::size_t lanes = bytes / sizeof(Number);
};

#ifdef __x86_64__
inline bool has_avx2() {
  return __builtin_cpu_supports("avx2") > 0;
}

/// With fused multiply-add, which rounds once where two operations round twice.
inline bool has_avx2_and_fma() {
  return has_avx2() && __builtin_cpu_supports("fma") > 0;
}

/// The parts of AVX-512 that are compiled for: F, DQ, VL and BW.
inline bool has_avx512() {
  return __builtin_cpu_supports("avx512f") > 0 &&
         __builtin_cpu_supports("avx512dq") > 0 &&
         __builtin_cpu_supports("avx512vl") > 0 &&
         __builtin_cpu_supports("avx512bw") > 0;
}
#endif

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
