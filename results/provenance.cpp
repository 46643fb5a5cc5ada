#include "results/provenance.hpp"

#include "base/fourier.hpp"
#include "results/build_info.hpp"
#include "results/storage/hdf5_file.hpp"

#include <boost/version.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fstream>
#include <string>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <thread>
#include <unistd.h>

namespace asperity::results {
namespace {

std::string memory() {
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<double>(sysconf(_SC_PAGESIZE));
  return fmt::format("{:.1f} GiB", bytes / (1 << 30));
}

std::string host_system() {
  utsname name{};
  uname(&name);
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

} // namespace

Provenance program_facts() {
  return {
      {"program", "asperity " ASPERITY_PROJECT_VERSION},
      {"commit", build_commit},
      {"dirty", build_dirty},
      {"compiler", "g++ " __VERSION__},
      {"build type", ASPERITY_BUILD_TYPE},
      {"FFTW", fourier_library()},
      {"HDF5", hdf5_version()},
      {"Boost", BOOST_LIB_VERSION},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000,
                          FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"toml11", ASPERITY_TOML11_VERSION},
      {"numerics", std::string(build_numerics).substr(0, 12)},
      {"processor", processor_name()},
      {"cores", std::to_string(std::thread::hardware_concurrency())},
      {"memory", memory()},
      {"system", host_system()},
  };
}

std::string build_stamp() {
  return build_numerics;
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(file, line);)
    if (line.compare(0, key.size(), key) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string utc_now() {
  const std::time_t now =
      std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

RunClock::RunClock() : start_(std::chrono::steady_clock::now()) {}

Provenance RunClock::facts(double peak_memory) const {
  const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - start_;
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  };
  return {
      {"finished", utc_now()},
      {"wall time", fmt::format("{:.2f} s", wall.count())},
      {"CPU time", fmt::format("{:.2f} s", seconds(used.ru_utime) +
                                               seconds(used.ru_stime))},
      {"peak memory", fmt::format("{:.0f} MiB", peak_memory / (1 << 20))},
  };
}

} // namespace asperity::results
