// The entry point of libFuzzer.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  asperity::fuzz::read_input(
      std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
