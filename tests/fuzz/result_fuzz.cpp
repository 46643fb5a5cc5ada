// Reads any bytes as a result file: the result has consistent lists, or there
// is an InputError.
#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <filesystem>

namespace asperity::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where the system has a folder for it.
const fs::path& result_path() {
  static const fs::path path =
      (fs::exists("/dev/shm") ? fs::path("/dev/shm")
                              : fs::temp_directory_path()) /
      (temporary_beside("fuzz").filename().string() + ".h5");
  return path;
}

} // namespace

void read_input(const std::string& bytes) {
  write_file_atomically(result_path(), bytes);
  try {
    const results::Result result = results::read_result(result_path());
    for (const results::SurfaceRecord& surface : result.surfaces)
      require(surface.heights.empty() ||
                  surface.heights.size() == surface.grid.size(),
              "heights are as many as points");
    for (const results::MethodRecord& method : result.methods)
      for (const results::Curve& curve : method.realizations)
        for (const results::Fields& fields : curve.fields)
          require(fields.pressure.size() == fields.gap.size(),
                  "maps of a step are of one size");
  } catch (const input::InputError&) {
  }
  fs::remove(result_path());
}

} // namespace asperity::fuzz
