#pragma once

// This file compiles a loop for the instructions of several processors and
// chooses between them when it is called.

#include "base/simd_pack.hpp"

#include <cstddef>
#include <type_traits>

namespace asperity::contact {

#ifdef __x86_64__
/// Calls a kernel that is inlined and so compiled for these processors.
template <class Kernel>
[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] auto
on_avx512(const Kernel& kernel) {
  return kernel(std::integral_constant<std::size_t, 64>());
}

template <class Kernel>
[[gnu::target("avx2")]] auto on_avx2(const Kernel& kernel) {
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
  static const bool is_widest = has_avx512();
  static const bool is_wide = has_avx2();
  if (is_widest)
    return on_avx512(kernel);
  if (is_wide)
    return on_avx2(kernel);
#endif
  return kernel(std::integral_constant<std::size_t, 16>());
}

} // namespace asperity::contact
