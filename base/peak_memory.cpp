#include "base/peak_memory.hpp"

#include <fstream>
#include <limits>
#include <string>

namespace asperity {

double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kibibytes = 0.0; word == "VmHWM:" && status >> kibibytes)
      return 1024.0 * kibibytes;
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace asperity
