#include "suite/exchange/pressure_file.hpp"

#include "base/field_sums.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/trial_read.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;

surfaces::Matrix read_text_matrix(const fs::path& path) {
  surfaces::NumberTable table = surfaces::read_number_file(path.string());
  return {table.rows(), table.columns, std::move(table.numbers)};
}

surfaces::Matrix read_dataset(const results::Hdf5File& file,
                              const fs::path& path, std::size_t most) {
  const std::vector<std::string> names = file.children();
  const bool has_name = file.has("pressure");
  if (!has_name && names.size() != 1)
    throw input::InputError(
        fmt::format("{}: has the members {}, but must have the dataset "
                    "\"pressure\"",
                    path.string(), fmt::join(names, ", ")));
  const std::string name = has_name ? "pressure" : names.front();
  const std::vector<std::size_t> extents = file.extents(name);
  if (extents.size() != 2)
    throw input::InputError(fmt::format("{}: {} has {} dimensions, but must "
                                        "have 2: rows and columns",
                                        path.string(), name, extents.size()));
  if (extents[0] > 0 && extents[1] > most / extents[0])
    throw input::InputError(
        fmt::format("{}: {} has {} x {} numbers, but may have at most {}",
                    path.string(), name, extents[0], extents[1], most));
  return {extents[0], extents[1], file.numbers(name)};
}

} // namespace

surfaces::Matrix read_pressure_file(const fs::path& path, std::size_t most) {
  const std::string ending = path.extension().string();
  surfaces::Matrix matrix;
  if (ending == ".npy")
    matrix = surfaces::read_npy(path);
  else if (ending == ".h5" || ending == ".hdf5")
    matrix = results::read_any_hdf5(path, [&](const results::Hdf5File& file) {
      return read_dataset(file, path, most);
    });
  else if (ending == ".csv" || ending == ".txt" || ending == ".dat")
    matrix = read_text_matrix(path);
  else
    throw input::InputError(
        fmt::format("{}: has the ending \"{}\"; allowed are .npy, .h5, .hdf5, "
                    ".csv, .txt and .dat",
                    path.string(), ending));
  if (!all_finite(matrix.numbers))
    throw input::InputError(
        fmt::format("{}: has a number that is not finite", path.string()));
  return matrix;
}

} // namespace asperity::exchange
