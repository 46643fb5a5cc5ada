#include "base/array_memory.hpp"

#include <cstdint>
#include <cstdlib> // defines __GLIBC__ where it is
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#ifdef __has_feature // clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ASPERITY_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) // GCC
#define ASPERITY_SANITIZED
#endif

namespace asperity {
namespace {

/// Asks for huge pages from the page of the first byte on, so that adjacent
/// arrays leave no gap. The system may ignore it.
void ask_for_huge_pages(void* first, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = reinterpret_cast<std::uintptr_t>(first) % page;
  madvise(static_cast<std::byte*>(first) - before,
          (before + bytes) / page * page, MADV_HUGEPAGE);
#endif
}

#ifndef ASPERITY_SANITIZED
/// The size of a usual huge page.
constexpr std::size_t smallest_huge_array = std::size_t{1} << 21;

/// Memory for free(), or null.
void* allocated(std::size_t bytes) {
  if (bytes < smallest_aligned_array)
    return std::malloc(bytes > 0 ? bytes : 1);
  void* array = nullptr;
  if (posix_memalign(&array, cache_line, bytes) != 0)
    return nullptr;
  if (bytes >= smallest_huge_array)
    ask_for_huge_pages(array, bytes);
  return array;
}
#endif

/// Whether the process may not have addresses that it does not use.
bool are_addresses_limited() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

} // namespace

bool has_aligned_arrays() {
#ifdef ASPERITY_SANITIZED
  return false;
#else
  return true;
#endif
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  constexpr int kept = 256 * megabyte;
  constexpr int default_mappings = 65536, default_padding = 1 << 17;
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_MMAP_MAX, default_mappings);    // Open MPI sets it to 0
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte); // the largest value accepted
  if (are_addresses_limited())
    return;
  // The addresses of all of it, because a page that was used before huge ones
  // were asked for stays small.
  auto* const first = static_cast<std::byte*>(sbrk(0));
  mallopt(M_TOP_PAD, kept);
  void* volatile grows_heap =
      std::malloc(megabyte); // a pair of calls is elided
  std::free(grows_heap);
  mallopt(M_TOP_PAD, default_padding);
  const auto* const end = static_cast<std::byte*>(sbrk(0));
  ask_for_huge_pages(first, static_cast<std::size_t>(end - first));
#endif
}

} // namespace asperity

#ifndef ASPERITY_SANITIZED
void* operator new(std::size_t bytes) {
  for (;;) {
    if (void* const array = asperity::allocated(bytes))
      return array;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* array) noexcept {
  std::free(array);
}

void operator delete(void* array, std::size_t) noexcept {
  std::free(array);
}
#endif
