// Maps that are matrices without more: NumPy's .npy files and datasets of HDF5
// files with two dimensions.
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/trial_read.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <fmt/format.h>

#include <numeric>
#include <string>
#include <utility>

namespace asperity::surfaces {
namespace {

/// The map of a matrix, or that of a list x y z if the format is automatic and
/// its three columns are one.
/// @param numbers  [1]; its grid has the points per side
/// @param name     for messages: the path, or the dataset in it
/// @param what     the file in words: "an .npy file"
/// @throws input::InputError  a key of the case is missing, or the columns may
///                            be those of a list
Scan scan_of_matrix(Scan numbers, const std::string& name,
                    const std::string& what, const std::string& format,
                    const MapScale& scale) {
  const Grid points = numbers.map.grid;
  if (format == "auto" && points.points_x <= 3) {
    NumberTable table;
    table.name = name;
    table.columns = static_cast<std::size_t>(points.points_x);
    table.numbers = numbers.map.heights;
    table.lines.resize(static_cast<std::size_t>(points.points_y));
    std::iota(table.lines.begin(), table.lines.end(), 1);
    if (is_regular_list(table)) {
      Scan list = scan_of_list(table, scale);
      list.channel = numbers.channel;
      list.reader = numbers.reader;
      return list;
    }
    refuse_possible_list(name, table.columns, table.rows());
  }
  Scan scan = scan_of_numbers(grid_by_scale(points, name, what, scale),
                              std::move(numbers.map.heights), numbers.reader,
                              {.unit = *scale.height_unit});
  scan.channel = numbers.channel;
  return scan;
}

Scan read_npy_map(const MapBytes& bytes, const ScanRequest& request) {
  Matrix matrix = read_npy_text(bytes.all(), bytes.name());
  require_sound_grid(bytes.name(), static_cast<std::int64_t>(matrix.columns),
                     static_cast<std::int64_t>(matrix.rows), 1.0,
                     matrix.numbers.size());
  const Grid points{static_cast<int>(matrix.columns),
                    static_cast<int>(matrix.rows), 0.0, 0.0};
  Scan scan = scan_of_matrix(
      {{points, std::move(matrix.numbers)}, "", "own reader of .npy"},
      bytes.name(), "an .npy file", request.format, request.scale);
  refuse_channel(request, "", bytes.name());
  return scan;
}

std::vector<ChannelInfo> npy_channels(const MapBytes& bytes) {
  const Matrix matrix = read_npy_text(bytes.all(), bytes.name());
  return {{"", "", static_cast<int>(matrix.columns),
           static_cast<int>(matrix.rows)}};
}

/// Datasets with two dimensions, whose titles are their paths.
struct FoundDatasets {
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
    if (found.infos.size() == most_datasets)
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
    found.infos.push_back(
        {full, unit_attribute(group.open_dataset(child)).value_or(""),
         static_cast<int>(extents[1]), static_cast<int>(extents[0])});
  }
}

/// The dataset that the case names, or the only one.
const ChannelInfo& chosen_dataset(const std::vector<ChannelInfo>& found,
                                  const std::optional<std::string>& wanted,
                                  const std::string& path) {
  if (found.empty())
    throw input::InputError(path + ": has no dataset with two dimensions");
  std::string list;
  for (const ChannelInfo& one : found)
    list += (list.empty() ? "" : ", ") + printable(one.title);
  for (const ChannelInfo& one : found)
    if (wanted && (one.title == *wanted || one.title == "/" + *wanted))
      return one;
  for (std::size_t i = 0; wanted && i < found.size(); ++i)
    if (*wanted == std::to_string(i + 1))
      return found[i];
  if (wanted)
    throw input::InputError(
        fmt::format("surface.channel = \"{}\": {} has no such dataset with two "
                    "dimensions; it has {}",
                    printable(*wanted), path, printable(list, 500)));
  if (found.size() > 1)
    throw input::InputError(fmt::format(
        "surface.channel is missing: {} has several datasets with two "
        "dimensions, {}",
        path, printable(list, 500)));
  return found.front();
}

/// Takes a scale from an attribute unless the case gives it.
void take_attribute(std::optional<double>& given,
                    const results::Hdf5Group& dataset, const char* key,
                    const std::string& path) {
  if (!dataset.has_attribute(key))
    return;
  const std::optional<double> number =
      if_readable([&] { return dataset.number_attribute(key); });
  if (number)
    refuse_given(key, given, path + " gives it as an attribute");
  else if (!given)
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
                    path, printable(text), known_length_units()));
  refuse_given("height_unit", given,
               fmt::format("{} gives the unit '{}'", path, printable(text)));
  given = unit;
}

std::string name_of(const std::string& path, const std::string& dataset) {
  return path + ": " + printable(dataset);
}

std::vector<ChannelInfo> datasets_of(const results::Hdf5File& file) {
  FoundDatasets found;
  find_datasets(file, "", 0, found);
  return std::move(found.infos);
}

/// The numbers of a dataset [1]; takes its attributes as scales.
Scan dataset_of(const results::Hdf5File& file, const std::string& path,
                const std::optional<std::string>& channel, MapScale& scale) {
  const std::vector<ChannelInfo> found = datasets_of(file);
  const ChannelInfo& info = chosen_dataset(found, channel, path);
  const std::string name = name_of(path, info.title);
  const std::size_t end = info.title.rfind('/');
  const results::Hdf5Group group =
      file.open_path(std::string_view(info.title).substr(0, end));
  const std::string child = info.title.substr(end + 1);
  const results::Hdf5Group dataset = group.open_dataset(child);
  take_attribute(scale.length, dataset, "length", name);
  take_attribute(scale.length_y, dataset, "length_y", name);
  take_height_unit(scale.height_unit, dataset, name);
  return {{{info.points_x, info.points_y, 0.0, 0.0},
           group.rows(child, 0, static_cast<std::size_t>(info.points_y))},
          info.title,
          "own reader of HDF5"};
}

Scan read_hdf5_map(const MapBytes& bytes, const ScanRequest& request) {
  require_file(bytes);
  const std::string& path = bytes.name();
  MapScale scale;
  Scan numbers =
      results::read_any_hdf5(path, [&](const results::Hdf5File& file) {
        scale = request.scale;
        return dataset_of(file, path, request.channel, scale);
      });
  const std::string name = name_of(path, numbers.channel);
  return scan_of_matrix(std::move(numbers), name, "an HDF5 dataset",
                        request.format, scale);
}

std::vector<ChannelInfo> hdf5_channels(const MapBytes& bytes) {
  require_file(bytes);
  return results::read_any_hdf5(bytes.name(), datasets_of);
}

} // namespace

MapFormat npy_format() {
  return {"npy",
          {"NumPy", "`\\x93NUMPY`", "`length`, `height_unit`", "NaN", "one"},
          [](std::string_view bytes) { return bytes.starts_with("\x93NUMPY"); },
          read_npy_map,
          npy_channels};
}

MapFormat hdf5_format() {
  return {"hdf5",
          {"a dataset with two dimensions", "`\\x89HDF`",
           "attributes `unit` or `units`, `length`, `length_y` [m], or the "
           "keys of the case",
           "NaN", "paths of datasets"},
          [](std::string_view bytes) {
            return bytes.starts_with("\x89HDF\r\n\x1A\n");
          },
          read_hdf5_map,
          hdf5_channels};
}

} // namespace asperity::surfaces
