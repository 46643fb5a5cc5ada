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

#include <mutex>
#include <numeric>
#include <string>
#include <utility>

namespace asperity::surfaces {

/// The map of a matrix, or that of a list x y z if the format is automatic and
/// its three columns are one.
/// @param numbers  rows of the file [1]; its grid has the points per side
/// @param name     for messages: the path, or the dataset in it
/// @param what     the file in words: "an .npy file"
/// @throws input::InputError  a key of the case is missing, or the columns may
///                            be those of a list
OpenMap map_of_matrix(OpenMap numbers, const std::string& name,
                      const std::string& what, mechanics::MapFormat format,
                      const MapScale& scale) {
  const Grid points = numbers.grid;
  if (format == mechanics::MapFormat::automatic && points.points_x <= 3) {
    NumberTable table;
    table.name = name;
    table.columns = static_cast<std::size_t>(points.points_x);
    table.numbers = numbers.rows(0, points.points_y);
    table.lines.resize(static_cast<std::size_t>(points.points_y));
    std::iota(table.lines.begin(), table.lines.end(), 1);
    if (is_regular_list(table)) {
      OpenMap list = map_of_list(table, scale);
      list.channel = numbers.channel;
      list.reader = numbers.reader;
      return list;
    }
    refuse_possible_list(name, table.columns, table.rows());
  }
  numbers.grid = grid_by_scale(points, name, what, scale);
  numbers.numbers.unit = *scale.height_unit;
  numbers.rows = [rows = std::move(numbers.rows),
                  unit = *scale.height_unit](int first, int count) {
    std::vector<double> heights = rows(first, count);
    for (double& height : heights)
      height *= unit;
    return heights;
  };
  return numbers;
}

OpenMap open_npy(const MapBytes& bytes, const ScanRequest& request) {
  const NpyLayout layout = npy_layout(bytes);
  require_sound_grid(bytes.name(), static_cast<std::int64_t>(layout.columns),
                     static_cast<std::int64_t>(layout.rows), 1.0,
                     layout.rows * layout.columns);
  const Grid points{static_cast<int>(layout.columns),
                    static_cast<int>(layout.rows), 0.0, 0.0};
  OpenMap map = map_of_matrix({points, "", "own reader of .npy",
                               [bytes, layout](int first, int count) {
                                 return npy_rows(bytes, layout, first, count);
                               }},
                              bytes.name(), "an .npy file", request.format,
                              request.scale);
  refuse_channel(request, "", bytes.name());
  return map;
}

std::vector<ChannelInfo> npy_channels(const MapBytes& bytes) {
  const NpyLayout layout = npy_layout(bytes);
  return {{"", "", static_cast<int>(layout.columns),
           static_cast<int>(layout.rows)}};
}

namespace {

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
                    path, printable(text), known_length_units()));
  if (given)
    throw input::InputError(fmt::format(
        "surface.height_unit = {:.6g} m, but must be left out: {} gives the "
        "unit '{}'",
        *given, path, printable(text)));
  given = unit;
}

std::string name_of(const std::string& path, const std::string& dataset) {
  return path + ": " + printable(dataset);
}

/// Calls use(group, name) with the group and the name of a dataset.
template <class Use>
auto with_dataset(const results::Hdf5File& file, const std::string& dataset,
                  const Use& use) {
  const std::size_t end = dataset.rfind('/');
  return use(file.open_path(std::string_view(dataset).substr(0, end)),
             dataset.substr(end + 1));
}

/// Returns read(file), after a trial in a child process: the packaged library
/// has memory errors that a damaged file can trigger.
template <class Read>
auto read_safely(const std::string& path, const Read& read) {
  const auto read_file = [&] {
    const std::lock_guard lock(results::hdf5_mutex());
    return read(results::Hdf5File(path, results::Hdf5File::Mode::read));
  };
  results::require_readable(path, [&] { (void)read_file(); });
  try {
    return read_file();
  } catch (const results::Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

std::vector<ChannelInfo> datasets_of(const results::Hdf5File& file) {
  FoundDatasets found;
  find_datasets(file, "", 0, found);
  return std::move(found.infos);
}

/// The name and the sizes of a dataset; takes its attributes as scales.
OpenMap described_dataset(const results::Hdf5File& file,
                          const std::string& path,
                          const std::optional<std::string>& channel,
                          MapScale& scale) {
  const std::vector<ChannelInfo> found = datasets_of(file);
  const ChannelInfo& info = chosen_dataset(found, channel, path);
  const std::string name = name_of(path, info.title);
  with_dataset(file, info.title,
               [&](const results::Hdf5Group& group, const std::string& child) {
                 const results::Hdf5Group dataset = group.open_dataset(child);
                 take_attribute(scale.length, dataset, "length", name);
                 take_attribute(scale.length_y, dataset, "length_y", name);
                 take_height_unit(scale.height_unit, dataset, name);
               });
  return {{info.points_x, info.points_y, 0.0, 0.0},
          info.title,
          "own reader of HDF5",
          {}};
}

} // namespace

OpenMap open_hdf5(const MapBytes& bytes, const ScanRequest& request) {
  require_file(bytes);
  const std::string& path = bytes.name();
  MapScale scale;
  OpenMap numbers = read_safely(path, [&](const results::Hdf5File& file) {
    scale = request.scale;
    return described_dataset(file, path, request.channel, scale);
  });
  numbers.rows = [path, dataset = numbers.channel](int first, int count) {
    return read_safely(path, [&](const results::Hdf5File& file) {
      return with_dataset(
          file, dataset,
          [&](const results::Hdf5Group& group, const std::string& child) {
            return group.rows(child, static_cast<std::size_t>(first),
                              static_cast<std::size_t>(count));
          });
    });
  };
  const std::string name = name_of(path, numbers.channel);
  return map_of_matrix(std::move(numbers), name, "an HDF5 dataset",
                       request.format, scale);
}

std::vector<ChannelInfo> hdf5_channels(const MapBytes& bytes) {
  require_file(bytes);
  return read_safely(bytes.name(), datasets_of);
}

} // namespace asperity::surfaces
