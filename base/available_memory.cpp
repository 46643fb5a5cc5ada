#include "base/available_memory.hpp"

#include "base/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

namespace asperity {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number after `key` in a kernel file, or the first number if the key is
/// ""; unlimited if there is none ("max").
double number_in(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string word; file >> word;) {
    double number = unlimited;
    if (key.empty())
      return word.find_first_not_of("0123456789") == std::string::npos
                 ? std::stod(word)
                 : unlimited;
    if (word == key)
      return file >> number ? number : unlimited;
  }
  return unlimited;
}

double left_in_system() {
  return 1024.0 * number_in("/proc/meminfo", "MemAvailable:");
}

/// Smallest remaining memory of the control groups (version 2) from that of
/// this process up to the root.
double left_in_groups() {
  namespace fs = std::filesystem;
  std::ifstream file("/proc/self/cgroup");
  double left = unlimited;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("0::/"))
      for (fs::path group = line.substr(3);; group = group.parent_path()) {
        const std::string folder = "/sys/fs/cgroup" + group.string();
        const double limit = number_in(folder + "/memory.max", "");
        if (limit < unlimited)
          left = std::min(
              left, limit - number_in(folder + "/memory.current", "") +
                        number_in(folder + "/memory.stat", "inactive_file"));
        if (group == group.parent_path())
          break;
      }
  return left;
}

double left_in_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return unlimited;
  return static_cast<double>(limit.rlim_cur) -
         number_in("/proc/self/statm", "") *
             static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

double available_memory() {
  return std::max(0.0, std::min({left_in_system(), left_in_groups(),
                                 left_in_address_space()}));
}

std::string memory_shortage(double bytes) {
  const double available = available_memory();
  return bytes > available
             ? fmt::format("needs {} of memory, but {} are available",
                           bytes_text(bytes), bytes_text(available))
             : "";
}

} // namespace asperity
