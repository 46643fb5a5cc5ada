#include "results/result_reader.hpp"

#include "base/plain_text.hpp"
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "results/observables/contact_stiffness.hpp"
#include "results/observables/map_sums.hpp"
#include "results/storage/curve_storage.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/storage/hdf5_limits.hpp"
#include "results/storage/map_storage.hpp"
#include "results/storage/result_file.hpp"
#include "results/storage/result_layout.hpp"
#include "results/storage/table_storage.hpp"
#include "results/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity::results {
namespace {

std::string text_or(const Hdf5Group& group, const std::string& name,
                    const std::string& otherwise) {
  return group.has_attribute(name) ? group.text_attribute(name) : otherwise;
}

/// Reads the children of `group` that are named 0, 1, ... into a list at these
/// indices.
template <class Item, class Read>
std::vector<Item> read_indexed(const Hdf5Group& group, Read read) {
  std::vector<Item> items;
  for (const std::string& name : group.children())
    if (const std::optional<int> index = index_of(name)) {
      if (*index >= layout::most_realizations)
        throw input::InputError(
            fmt::format("{} is realisation {}, but must be below {}",
                        group.place(name), *index, layout::most_realizations));
      const auto place = static_cast<std::size_t>(*index);
      items.resize(std::max(items.size(), place + 1));
      items[place] = read(group.open(name), *index);
    }
  return items;
}

/// Checks names that are used in figures, tables and file names.
/// @throws Hdf5Error  a name is not permitted
std::vector<std::string> good_names(std::vector<std::string> names,
                                    const std::string& place) {
  for (const std::string& name : names)
    require_good_name(name, place);
  return names;
}

void require_format(const Hdf5Group& file) {
  const std::string format = text_or(file, "format", "");
  if (format != layout::format)
    throw input::InputError(fmt::format("{} = \"{}\", but must be \"{}\"",
                                        file.place("format"), format,
                                        layout::format));
  const double version = number_or(file, "format_version", not_a_number);
  if (!(version >= 1 && version < layout::format_version + 1))
    throw input::InputError(fmt::format(
        "{} = {}, but must lie between 1 and {}", file.place("format_version"),
        version, layout::format_version));
}

/// Where maps are.
struct Maps {
  const std::filesystem::path& path;
  MapsInFile left;
};

Curve read_curve(const Hdf5Group& group, const Maps& maps) {
  Curve curve;
  curve.setup_cpu_time = number_or(group, "setup_cpu_time", 0.0);
  if (group.has("curve"))
    curve.points = read_points(group.open("curve"));
  if (group.has("fields"))
    curve.fields = read_fields(group.open("fields"), maps.path, maps.left);
  if (group.has(layout::own_surface))
    curve.own_surface =
        read_surface(group.open(layout::own_surface), maps.path, maps.left);
  return curve;
}

MethodRecord read_method(const Hdf5Group& group, const std::string& name,
                         const Maps& maps) {
  MethodRecord method;
  method.name = name;
  method.kind = text_or(group, "kind", name.substr(0, name.find('.')));
  method.description = text_or(group, "description", "");
  method.contact = text_or(group, "contact", method.contact);
  method.realizations =
      read_indexed<Curve>(group, [&](const Hdf5Group& curve, int) {
        return read_curve(curve, maps);
      });
  return method;
}

/// Completes the grid of a map, where the file does not specify it, from the
/// grid of the surface of the realisation.
void complete_grids(Result& result) {
  for (MethodRecord& method : result.methods)
    for (std::size_t r = 0; r < method.realizations.size(); ++r) {
      Curve& curve = method.realizations[r];
      if (!curve.own_surface && r >= result.surfaces.size())
        continue;
      const Grid& below =
          curve.own_surface ? curve.own_surface->grid : result.surfaces[r].grid;
      for (Fields& fields : curve.fields) {
        Grid& grid = fields.grid;
        if (grid.size() == 0 && fields.pressure_map().size() == below.size()) {
          grid.points_x = below.points_x;
          grid.points_y = below.points_y;
        }
        if (!(grid.length_x > 0.0)) {
          grid.length_x = below.length_x;
          grid.length_y = below.length_y;
        }
      }
    }
}

/// The rms of heights, which have no record of it.
double rms_of(const MapView& heights) {
  const double mean = mean_of(heights);
  double squares = 0.0;
  each_piece(heights, [&](std::span<const double> values) {
    for (const double height : values)
      squares += (height - mean) * (height - mean);
  });
  return std::sqrt(squares / static_cast<double>(heights.size()));
}

void complete_rms_height(SurfaceRecord& surface) {
  if (std::isnan(surface.rms_height) && !surface.height_map().empty())
    surface.rms_height = rms_of(surface.height_map());
}

void complete_rms_heights(Result& result) {
  for (SurfaceRecord& surface : result.surfaces)
    complete_rms_height(surface);
  for (MethodRecord& method : result.methods)
    for (Curve& curve : method.realizations)
      if (curve.own_surface)
        complete_rms_height(*curve.own_surface);
}

std::vector<Skipped> read_skipped(const Hdf5Group& group) {
  const std::array<std::string, 2> names{"what", "why"};
  std::vector<Skipped> skipped;
  if (!group.has(names[0]))
    return skipped;
  group.common_length(names);
  const std::vector<std::string> reasons = group.texts(names[1]);
  for (std::string& thing : group.texts(names[0]))
    skipped.push_back({std::move(thing), reasons[skipped.size()]});
  return skipped;
}

Result read_file(const Hdf5File& file, const std::filesystem::path& path,
                 MapsInFile left) {
  require_format(file);
  Result result;
  result.path = path.string();
  result.case_name = text_or(file, "name", printable(path.stem().string()));
  result.case_title = text_or(file, "title", result.case_name);
  result.case_text = text_or(file, "case_text", "");
  result.case_hash = text_or(file, "case_hash", "");
  result.reference = text_or(file, "reference", "");
  result.status = text_or(file, "status", "complete");
  if (!file.has_attribute("contact_modulus"))
    throw input::InputError(
        fmt::format("{} [Pa] is missing", file.place("contact_modulus")));
  result.contact_modulus = file.number_attribute("contact_modulus");
  if (!file.has("methods"))
    throw input::InputError(
        fmt::format("{} is missing", file.place("methods")));

  if (file.has("provenance")) {
    const Hdf5Group provenance = file.open("provenance");
    for (const std::string& name : provenance.attributes()) {
      require_plain(name, provenance.place());
      result.provenance.emplace_back(name, provenance.text_attribute(name));
    }
  }
  if (file.has("surfaces"))
    result.surfaces = read_indexed<SurfaceRecord>(
        file.open("surfaces"), [&](const Hdf5Group& group, int) {
          return read_surface(group, path, left);
        });
  const Hdf5Group methods = file.open("methods");
  for (const std::string& name :
       good_names(methods.children(), methods.place()))
    result.methods.push_back(
        read_method(methods.open(name), name, {path, left}));
  if (file.has(layout::skipped))
    result.skipped = read_skipped(file.open(layout::skipped));
  if (file.has(layout::tables)) {
    const Hdf5Group tables = file.open(layout::tables);
    for (const std::string& name :
         good_names(tables.children(), tables.place()))
      result.tables.push_back(read_table(tables.open(name), name));
  }
  return result;
}

struct FileContent {
  Result result;
  JournalState journal;
};

FileContent read_file(const std::filesystem::path& path, MapsInFile left) {
  const std::lock_guard lock(hdf5_mutex());
  try {
    const Hdf5File file(path, Hdf5File::Mode::read);
    return {read_file(file, path, left), journal_state(file)};
  } catch (const Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

/// Adds the records of the journal that are not yet in the file.
/// @return  false if changes between the two are missing, because a writer has
///          moved them into a newer file since this one was read
bool merge_journal(FileContent& content, const std::filesystem::path& path,
                   MapsInFile left) {
  std::uint64_t last = content.journal.folded;
  bool is_whole = true;
  if (content.journal.identity.empty())
    return is_whole;
  read_journal(journal_of(path), content.journal.identity,
               [&](std::uint64_t number, const FileBytes& record) {
                 is_whole = is_whole && number <= last + 1;
                 if (!is_whole || number <= last)
                   return;
                 merge_change(content.result, change_in(record), left);
                 last = number;
               });
  return is_whole;
}

/// Checks the names of methods and tables, including those from the journal,
/// which are not names of groups in the file.
/// @throws input::InputError  a name is not permitted
void require_good_names(const Result& result) {
  try {
    for (const MethodRecord& method : result.methods)
      require_good_name(method.name, result.path + ": /methods");
    for (const Table& table : result.tables)
      require_good_name(table.name, result.path + ": /tables");
  } catch (const Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

FileContent read_file_and_journal(const std::filesystem::path& path,
                                  MapsInFile left) {
  constexpr int tries = 100; // a writer rarely renames its file
  for (int i = 0; i < tries; ++i) {
    FileContent content = read_file(path, left);
    if (merge_journal(content, path, left))
      return content;
  }
  throw input::InputError(path.string() + " changed while it was being read");
}

} // namespace

std::filesystem::path file_of_result(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? path / layout::file_name : path;
}

Result read_result(const std::filesystem::path& path, MapsInFile left) {
  const std::filesystem::path file_path = file_of_result(path);
  if (!std::filesystem::exists(file_path))
    throw input::InputError(file_path.string() + ": there is no such file");
  Result result = std::move(read_file_and_journal(file_path, left).result);
  require_good_names(result);
  for (MethodRecord& method : result.methods)
    for (Curve& curve : method.realizations)
      fill_contact_stiffness(curve.points);
  complete_grids(result);
  complete_rms_heights(result);
  require_valid(result);
  return result;
}

StepsDone steps_done(const Result& result) {
  StepsDone done;
  for (const MethodRecord& method : result.methods)
    for (std::size_t i = 0; i < method.realizations.size(); ++i)
      for (const CurvePoint& point : method.realizations[i].points)
        done[{method.name, static_cast<int>(i)}].insert(point.step);
  return done;
}

} // namespace asperity::results
