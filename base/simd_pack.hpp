#pragma once

// This file declares vectors of numbers that the compiler keeps in SIMD
// registers, and tells which of them this processor has.

#include <cstddef>

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

} // namespace asperity
