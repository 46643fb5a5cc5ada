#include "results/trial_read.hpp"

#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

namespace asperity::results {
namespace {

constexpr double least_time = 20.0;    // [s]
constexpr double longest_time = 600.0; // [s]
constexpr double time_per_byte = 1e-6; // [s]

} // namespace

double read_time_limit(const std::filesystem::path& path) {
  std::error_code none; // a file that is missing is reported by its reader
  const std::uintmax_t bytes =
      std::filesystem::file_size(file_of_result(path), none);
  return none ? least_time
              : std::clamp(time_per_byte * static_cast<double>(bytes),
                           least_time, longest_time);
}

void require_readable(const std::filesystem::path& path) {
  require_readable(path, [&] { read_result(path, MapsInFile::large); });
}

void require_readable(const std::filesystem::path& path,
                      const std::function<void()>& read) {
  ChildProcess child = ChildProcess::forked(
      [&](int) {
        try {
          read();
        } catch (const std::exception&) {
          // The caller reads the file again and reports the error.
        }
      },
      {.cpu_time = read_time_limit(path)});
  const ChildEnd& end = child.wait();
  if (!end.failure.empty())
    throw input::InputError(
        fmt::format("{}: is damaged or malicious: the HDF5 "
                    "library cannot read it to its end ({})",
                    path.string(), end.failure));
}

} // namespace asperity::results
