#include "results/trial_read.hpp"

#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>

namespace asperity::results {
namespace {

constexpr double longest_read = 600.0; // CPU time [s]

} // namespace

void require_readable(const std::filesystem::path& path) {
  require_readable(path, [&] { read_result(path); });
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
      {.cpu_time = longest_read});
  const ChildEnd& end = child.wait();
  if (!end.failure.empty())
    throw input::InputError(
        fmt::format("{}: is damaged or malicious: the HDF5 "
                    "library cannot read it to its end ({})",
                    path.string(), end.failure));
}

} // namespace asperity::results
