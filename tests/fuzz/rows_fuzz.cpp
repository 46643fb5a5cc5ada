// Reads any bytes as a map file by rows: every row has the heights that the
// file as a whole has, or the error is an InputError.
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/scan_formats.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <unistd.h>

namespace asperity::fuzz {
namespace {

class InputFile {
public:
  explicit InputFile(const std::string& bytes) {
    path_ = std::filesystem::temp_directory_path() /
            fmt::format("asperity-rows-{}", ::getpid());
    std::ofstream(path_, std::ios::binary) << bytes;
  }

  ~InputFile() { std::filesystem::remove(path_); }

  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string path() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

std::optional<surfaces::Scan> whole(const std::string& path,
                                    const surfaces::ScanRequest& request) {
  try {
    return surfaces::read_scan(path, request);
  } catch (const input::InputError&) {
    return std::nullopt;
  }
}

void compare_rows(const surfaces::OpenMap& file, const surfaces::Scan& scan,
                  int first, int count) {
  const std::vector<double> rows = file.rows(first, count);
  const auto width = static_cast<std::size_t>(scan.map.grid.points_x);
  require(rows.size() == width * static_cast<std::size_t>(count),
          "rows have the points of the grid");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t node = static_cast<std::size_t>(first) * width + i;
    const bool is_missing = std::isnan(scan.map.heights[node]);
    require(std::isfinite(rows[i]) != is_missing,
            "the same points are missing");
    require(is_missing || rows[i] == scan.map.heights[node],
            "heights are those of the file as a whole");
  }
}

void compare(const surfaces::OpenMap& file, const surfaces::Scan& scan) {
  require(file.grid == scan.map.grid, "the grid is that of the file");
  require(file.reader == scan.reader, "the reader is the same");
  const int n_rows = file.grid.points_y;
  compare_rows(file, scan, n_rows / 2, 1);
  compare_rows(file, scan, 0, n_rows);
  compare_rows(file, scan, 0, 1);
  compare_rows(file, scan, n_rows - 1, 1);
}

/// Whether no point has a height: the file is then refused as a whole.
bool is_empty(const surfaces::OpenMap& file) {
  for (const double height : file.rows(0, file.grid.points_y))
    if (std::isfinite(height))
      return false;
  return true;
}

void read_as(const std::string& path, mechanics::MapFormat format,
             const surfaces::MapScale& scale) {
  const surfaces::ScanRequest request{format, {}, scale};
  const std::optional<surfaces::Scan> scan = whole(path, request);
  std::optional<surfaces::OpenMap> file;
  try {
    file = surfaces::open_map(path, request);
  } catch (const input::InputError&) {
    require(!scan, "the rows of a file that is a map are read");
    return;
  }
  if (scan)
    compare(*file, *scan);
  else
    require(is_empty(*file), "a file that is no map is refused");
}

} // namespace

/// Damaged HDF5 files end the packaged library, which this project cannot
/// change; the program Gwyddion is no part of it.
void read_input(const std::string& bytes) {
  if (bytes.find("\x89HDF") != std::string::npos ||
      surfaces::recognised_format(bytes) == mechanics::MapFormat::convert)
    return;
  const InputFile file(bytes);
  read_as(file.path(), mechanics::MapFormat::automatic, {});
  read_as(file.path(), mechanics::MapFormat::automatic, {1e-6, 1e-9, {}, {}});
  read_as(file.path(), mechanics::MapFormat::automatic, {{}, 1e-9, {}, 1e-6});
  read_as(file.path(), mechanics::MapFormat::xyz, {{}, 1e-9, {}, 1e-6});
}

} // namespace asperity::fuzz
