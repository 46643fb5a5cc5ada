#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/trial_read.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/text/list_points.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <fmt/format.h>

#include <mutex>
#include <numeric>

namespace asperity::surfaces {
namespace {

constexpr const char* npy_words = "an .npy file";
constexpr const char* npy_reader = "own reader of .npy";
constexpr const char* hdf5_words = "an HDF5 dataset";
constexpr const char* hdf5_reader = "own reader of HDF5";

/// Takes a matrix whose file has no sizes or units, unless it is a list x y z.
Scan scan_of_matrix(Matrix matrix, const std::string& name,
                    const std::string& what, const ScanRequest& request) {
  require_sound_grid(name, static_cast<std::int64_t>(matrix.columns),
                     static_cast<std::int64_t>(matrix.rows), 1.0,
                     matrix.numbers.size());
  if (request.format == mechanics::MapFormat::automatic &&
      matrix.columns <= 3) {
    NumberTable table;
    table.name = name;
    table.columns = matrix.columns;
    table.numbers = matrix.numbers;
    table.lines.resize(matrix.rows);
    std::iota(table.lines.begin(), table.lines.end(), 1);
    if (is_regular_list(table))
      return scan_of_list(table, request.scale);
    refuse_possible_list(table.name, table.columns, table.rows());
  }
  const Grid points{static_cast<int>(matrix.columns),
                    static_cast<int>(matrix.rows), 0.0, 0.0};
  return scan_by_scale(points, std::move(matrix.numbers), name, what,
                       request.scale);
}

/// Datasets with two dimensions, by their paths.
struct FoundDatasets {
  std::vector<std::string> paths;
  std::vector<ChannelInfo> infos;
  int groups = 0; ///< visited; links may form cycles
};

/// What read() finds in an attribute; empty if it is of another kind, such as a
/// list of units.
template <class Read>
auto if_readable(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const results::Hdf5Error&) {
    return std::nullopt;
  }
}

/// The unit of a dataset that has one; empty if it is no single text.
std::optional<std::string> unit_attribute(const results::Hdf5Group& dataset) {
  for (const char* const name : {"unit", "units"})
    if (dataset.has_attribute(name))
      return if_readable([&] { return dataset.text_attribute(name); });
  return "";
}

constexpr int deepest_group = 16;
constexpr int most_groups = 10000;
constexpr std::size_t most_datasets = 1000;

void find_datasets(const results::Hdf5Group& group, const std::string& path,
                   int depth, FoundDatasets& found) {
  if (depth > deepest_group || ++found.groups > most_groups)
    return;
  for (const std::string& child : group.children()) {
    if (found.paths.size() == most_datasets)
      return;
    const std::string full = path + "/" + child;
    if (!group.is_dataset(child)) {
      if (group.is_group(child))
        find_datasets(group.open(child), full, depth + 1, found);
      continue;
    }
    const std::vector<std::size_t> extents = group.extents(child);
    if (extents.size() != 2 || extents[0] < 2 || extents[1] < 2 ||
        extents[0] > 1 << 20 || extents[1] > 1 << 20)
      continue;
    found.paths.push_back(full);
    found.infos.push_back(
        {full, unit_attribute(group.open_dataset(child)).value_or(""),
         static_cast<int>(extents[1]), static_cast<int>(extents[0])});
  }
}

/// The index of the dataset that the case names, or of the only one.
std::size_t chosen_dataset(const FoundDatasets& found,
                           const std::optional<std::string>& wanted,
                           const std::string& path) {
  std::string list;
  for (const std::string& one : found.paths)
    list += (list.empty() ? "" : ", ") + printable(one);
  if (found.paths.empty())
    throw input::InputError(path + ": has no dataset with two dimensions");
  for (std::size_t i = 0; wanted && i < found.paths.size(); ++i)
    if (found.paths[i] == *wanted || found.paths[i] == "/" + *wanted)
      return i;
  for (std::size_t i = 0; wanted && i < found.paths.size(); ++i)
    if (*wanted == std::to_string(i + 1))
      return i;
  if (wanted)
    throw input::InputError(
        fmt::format("surface.channel = \"{}\": {} has no such dataset with two "
                    "dimensions; it has {}",
                    printable(*wanted), path, printable(list, 500)));
  if (found.paths.size() > 1)
    throw input::InputError(fmt::format(
        "surface.channel is missing: {} has several datasets with two "
        "dimensions, {}",
        path, printable(list, 500)));
  return 0;
}

/// Takes a scale from an attribute unless the case gives it.
void take_attribute(std::optional<double>& given,
                    const results::Hdf5Group& dataset, const char* key,
                    const std::string& path) {
  if (!dataset.has_attribute(key))
    return;
  const std::optional<double> number =
      if_readable([&] { return dataset.number_attribute(key); });
  if (given && number)
    throw input::InputError(fmt::format(
        "surface.{} = {:.6g} m, but must be left out: {} gives it as an "
        "attribute",
        key, *given, path));
  if (!given && !number)
    throw input::InputError(
        fmt::format("surface.{0} is missing: the attribute {0} of {1} is not "
                    "one number",
                    key, path));
  if (number)
    given = number;
}

void take_height_unit(std::optional<double>& given,
                      const results::Hdf5Group& dataset,
                      const std::string& path) {
  const std::optional<std::string> found = unit_attribute(dataset);
  if (!found && !given)
    throw input::InputError(
        fmt::format("surface.height_unit is missing: the unit of {} is not one "
                    "text",
                    path));
  const std::string text = found.value_or("");
  if (text.empty())
    return;
  const std::optional<double> unit = length_unit(text);
  if (!unit)
    throw input::InputError(
        fmt::format("{}: the dataset is in '{}', but heights must be in one of "
                    "{}",
                    path, printable(text), known_length_units));
  if (given)
    throw input::InputError(fmt::format(
        "surface.height_unit = {:.6g} m, but must be left out: {} gives the "
        "unit '{}'",
        *given, path, printable(text)));
  given = unit;
}

/// Calls use(group, name) with the group and the name of a dataset.
template <class Use>
auto with_dataset(const results::Hdf5File& file, const std::string& dataset,
                  const Use& use) {
  const std::size_t end = dataset.rfind('/');
  return use(file.open_path(std::string_view(dataset).substr(0, end)),
             dataset.substr(end + 1));
}

void take_attributes(const results::Hdf5Group& attributes,
                     const std::string& name, MapScale& scale) {
  take_attribute(scale.length, attributes, "length", name);
  take_attribute(scale.length_y, attributes, "length_y", name);
  take_height_unit(scale.height_unit, attributes, name);
}

std::string name_of(const std::string& path, const std::string& dataset) {
  return path + ": " + printable(dataset);
}

Scan scan_of_dataset(const results::Hdf5File& file, const std::string& dataset,
                     const std::string& path, ScanRequest request) {
  const std::string name = name_of(path, dataset);
  Scan scan = with_dataset(
      file, dataset,
      [&](const results::Hdf5Group& group, const std::string& child) {
        const std::vector<std::size_t> extents = group.extents(child);
        take_attributes(group.open_dataset(child), name, request.scale);
        return scan_of_matrix({extents[0], extents[1], group.numbers(child)},
                              name, hdf5_words, request);
      });
  scan.channel = dataset;
  scan.reader = hdf5_reader;
  return scan;
}

std::vector<double> dataset_rows(const std::string& path,
                                 const std::string& dataset, int first,
                                 int count) {
  const std::lock_guard lock(results::hdf5_mutex());
  const results::Hdf5File file(path, results::Hdf5File::Mode::read);
  return with_dataset(
      file, dataset,
      [&](const results::Hdf5Group& group, const std::string& child) {
        return group.rows(child, static_cast<std::size_t>(first),
                          static_cast<std::size_t>(count));
      });
}

/// The rows of a dataset [height_unit].
std::vector<double> readable_rows(const std::string& path,
                                  const std::string& dataset, int first,
                                  int count) {
  // The packaged library has memory errors that a damaged file can trigger.
  results::require_readable(
      path, [&] { (void)dataset_rows(path, dataset, first, count); });
  return dataset_rows(path, dataset, first, count);
}

/// What is known of a dataset without its values.
struct DescribedDataset {
  RowFile numbers; ///< without the sides of the grid; the unit is 1
  MapScale scale;  ///< of the case and the attributes
};

DescribedDataset described_dataset(const std::string& path,
                                   ScanRequest request) {
  const std::lock_guard lock(results::hdf5_mutex());
  const results::Hdf5File file(path, results::Hdf5File::Mode::read);
  FoundDatasets found;
  find_datasets(file, "", 0, found);
  const std::string dataset =
      found.paths[chosen_dataset(found, request.channel, path)];
  const std::string name = name_of(path, dataset);
  RowFile rows;
  rows.channel = dataset;
  rows.reader = hdf5_reader;
  with_dataset(file, dataset,
               [&](const results::Hdf5Group& group, const std::string& child) {
                 const std::vector<std::size_t> extents = group.extents(child);
                 rows.grid.points_x = static_cast<int>(extents[1]);
                 rows.grid.points_y = static_cast<int>(extents[0]);
                 take_attributes(group.open_dataset(child), name,
                                 request.scale);
               });
  rows.rows = [path, dataset](int first, int count) {
    return readable_rows(path, dataset, first, count);
  };
  return {std::move(rows), request.scale};
}

/// The map of a matrix whose file has no sizes or units, unless it is a list
/// x y z: as scan_of_matrix(), by rows.
RowFile rows_of_matrix(RowFile numbers, const std::string& path,
                       const std::string& name, const std::string& what,
                       mechanics::MapFormat format, const MapScale& scale) {
  if (format == mechanics::MapFormat::automatic && numbers.grid.points_x <= 3)
    if (auto list = list_in_matrix(path, name, numbers, scale)) {
      list->channel = numbers.channel;
      if (!numbers.reader.empty())
        list->reader = numbers.reader;
      return *list;
    }
  RowFile file = std::move(numbers);
  file.grid = grid_by_scale(file.grid, name, what, scale);
  file.numbers.unit = *scale.height_unit;
  file.rows = [rows = std::move(file.rows),
               unit = *scale.height_unit](int first, int count) {
    std::vector<double> heights = rows(first, count);
    for (double& height : heights)
      height *= unit;
    return heights;
  };
  return file;
}

} // namespace

Scan read_npy_scan(std::string_view bytes, const std::string& name,
                   const ScanRequest& request) {
  Scan scan =
      scan_of_matrix(read_npy_text(bytes, name), name, npy_words, request);
  scan.reader = npy_reader;
  return scan;
}

ChannelInfo npy_channel(std::string_view bytes, const std::string& name) {
  const Matrix matrix = read_npy_text(bytes, name);
  return {"", "", static_cast<int>(matrix.columns),
          static_cast<int>(matrix.rows)};
}

RowFile npy_row_file(const std::string& path, RowFile numbers,
                     const ScanRequest& request) {
  RowFile file = rows_of_matrix(std::move(numbers), path, path, npy_words,
                                request.format, request.scale);
  file.reader = npy_reader;
  return file;
}

std::optional<RowFile> hdf5_row_file(const std::string& path,
                                     const ScanRequest& request) {
  results::require_readable(path,
                            [&] { (void)described_dataset(path, request); });
  try {
    const DescribedDataset found = described_dataset(path, request);
    return rows_of_matrix(found.numbers, path,
                          name_of(path, found.numbers.channel), hdf5_words,
                          request.format, found.scale);
  } catch (const results::Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

FileContent read_hdf5_file(const std::string& path, const ScanRequest& request,
                           Asked asked) {
  try {
    const std::lock_guard lock(results::hdf5_mutex());
    const results::Hdf5File file(path, results::Hdf5File::Mode::read);
    FoundDatasets found;
    find_datasets(file, "", 0, found);
    FileContent content{found.infos, {}};
    if (asked == Asked::scan)
      content.scan = scan_of_dataset(
          file, found.paths[chosen_dataset(found, request.channel, path)], path,
          request);
    return content;
  } catch (const results::Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

} // namespace asperity::surfaces
