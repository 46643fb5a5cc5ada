// The entry point of libFuzzer.
#include "tests/fuzz/fuzz_target.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  asperity::fuzz::read_input(
      std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
