#include "results/result_writer.hpp"

#include "base/cpu_clock.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "results/storage/curve_storage.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/storage/map_storage.hpp"
#include "results/storage/result_layout.hpp"
#include "results/storage/table_storage.hpp"
#include "results/types/map_size.hpp"
#include "results/types/result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::results {

struct CaseInfo;

namespace {

/// Returns a text such as `line 12 of the case is "points = 64", but was
/// "points = 128"`.
std::string first_difference(const std::string& now,
                             const std::string& before) {
  std::istringstream new_text(now);
  std::istringstream old_text(before);
  for (int number = 1; new_text || old_text; ++number) {
    std::string new_line;
    std::string old_line;
    std::getline(new_text, new_line);
    std::getline(old_text, old_line);
    if (new_line != old_line)
      return fmt::format("line {} of the case is \"{}\", but was \"{}\"",
                         number, new_line, old_line);
  }
  return "";
}

std::string short_hash(const Inputs& inputs, const std::string& name) {
  const auto found = inputs.find(name);
  constexpr std::size_t digits = 12;
  return found == inputs.end() ? "none" : found->second.substr(0, digits);
}

std::string input_difference(const Inputs& now, const Inputs& before,
                             const std::string& name) {
  return fmt::format(
      "{} (SHA-256 {}, but was {})",
      name == "program"
          ? "the program was built from different sources or tools"
          : "the file given by " + name + " has different content",
      short_hash(now, name), short_hash(before, name));
}

} // namespace

Inputs inputs_of(const Result& result) {
  Inputs inputs;
  for (const auto& [name, fact] : result.provenance)
    if (name.starts_with(layout::input))
      inputs[name.substr(layout::input.size())] = fact;
  return inputs;
}

/// Checks that the result belongs to the same case.
/// @throws input::InputError  the result was computed from another case, from
///                            other input files or by another program; the
///                            message names every difference
void require_same_case(const Result& old, const CaseInfo& info) {
  const Inputs before = inputs_of(old);
  std::vector<std::string> differences;
  if (old.case_hash != info.hash) {
    const std::string line = first_difference(info.text, old.case_text);
    differences.push_back(
        line.empty() ? fmt::format("case_hash is \"{}\", but was \"{}\"",
                                   info.hash, old.case_hash)
                     : line);
  }
  std::set<std::string> names;
  for (const Inputs& inputs : {info.inputs, before})
    for (const auto& [name, hash] : inputs)
      names.insert(name);
  for (const std::string& name : names)
    if (!info.inputs.contains(name) || !before.contains(name) ||
        info.inputs.at(name) != before.at(name))
      differences.push_back(input_difference(info.inputs, before, name));
  if (!differences.empty())
    throw input::InputError(fmt::format("{} cannot be resumed: {}; run without "
                                        "--resume, or choose another --out",
                                        old.path,
                                        fmt::join(differences, "; ")));
}

namespace {

void require_index(const char* name, int index) {
  require_between(name, index, 0, layout::highest_index - 1, "1");
}

/// The maps of `fields`, which must outlive the result.
FieldsChange change_of(const Grid& grid, const Fields& fields) {
  require_index("fields.step", fields.step);
  require_size("fields.pressure", fields.pressure_map().size(), grid.size());
  require_size("fields.gap", fields.gap_map().size(), grid.size());
  return {fields.step,
          fields.nominal_pressure,
          grid,
          {rows_of_map(fields.pressure_map())},
          {rows_of_map(fields.gap_map())},
          fields.has_double_maps,
          fields.map};
}

/// @param surface  must outlive the result
SurfaceChange change_of(const SurfaceRecord& surface) {
  SurfaceChange change{surface, {}};
  change.record.heights.clear();
  const MapView own = surface.height_map();
  if (own.empty())
    return change;
  require_size("surface.heights", own.size(), surface.grid.size());
  change.heights.rows = rows_of_map(own);
  return change;
}

/// Writes the contents of a new file.
void write_case(Hdf5File& file, const CaseInfo& info) {
  file.set_attribute("format", layout::format);
  file.set_attribute("format_version", layout::format_version);
  file.set_attribute("name", info.name);
  file.set_attribute("title", info.title);
  file.set_attribute("case_text", info.text);
  file.set_attribute("case_hash", info.hash);
  file.set_attribute("reference", info.reference);
  set_with_unit(file, "contact_modulus", info.contact_modulus, "Pa");
  file.set_attribute("status", "running");
  Hdf5Group facts = file.open_or_create("provenance");
  for (const auto& [name, hash] : info.inputs)
    facts.set_attribute(layout::input + name, hash);
  for (const char* group : {"surfaces", "methods"})
    file.open_or_create(group);
}

Hdf5Group curve_group(const Hdf5File& file, const std::string& method,
                      int realization) {
  return file.open("methods").open(method).open(std::to_string(realization));
}

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / layout::file_name;
}

ResultFile file_for(const std::filesystem::path& folder, const CaseInfo& info,
                    ResultWriter::Mode mode) {
  require_positive("contact_modulus", info.contact_modulus, "Pa");
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = file_in(folder);
  if (mode != ResultWriter::Mode::resume || !std::filesystem::exists(path))
    return ResultFile::created(
        path, [&info](Hdf5File& file) { write_case(file, info); });
  require_same_case(read_result(path, MapsInFile::large), info);
  return ResultFile::opened(path, [&info](Hdf5File& file) {
    file.set_attribute("status", "running");
    file.set_attribute("reference", info.reference);
  });
}

} // namespace

ResultWriter::ResultWriter(const std::filesystem::path& folder,
                           const CaseInfo& info, Mode mode)
    : file_(file_for(folder, info, mode)) {
  if (mode != Mode::resume)
    return;
  const Result old = read_result(path(), MapsInFile::large);
  steps_ = steps_done(old);
  for (const MethodRecord& method : old.methods)
    methods_.insert(method.name);
  for (const Table& table : old.tables)
    tables_.insert(table.name);
}

void ResultWriter::record(Change change) {
  const CpuClock clock;
  file_.append(std::move(change));
  cpu_time_ += clock.seconds();
}

void ResultWriter::require_begun(const std::string& method,
                                 int realization) const {
  require_index("realization", realization);
  if (!methods_.contains(method))
    throw std::domain_error("method = \"" + method +
                            "\", but must be a method that has been started");
}

void ResultWriter::require_new(const std::string& method, int realization,
                               std::span<const CurvePoint> points) const {
  require_begun(method, realization);
  const auto found = steps_.find({method, realization});
  std::set<int> known = found == steps_.end() ? std::set<int>{} : found->second;
  for (const CurvePoint& point : points) {
    require_index("point.step", point.step);
    if (!known.insert(point.step).second)
      refuse_argument(
          "point.step", point.step,
          fmt::format("a new step of {}, realization {}", method, realization));
  }
}

void ResultWriter::record_provenance(const Provenance& facts) {
  const std::lock_guard lock(mutex_);
  record({.provenance = facts});
}

void ResultWriter::record_surface(int realization,
                                  const SurfaceRecord& surface) {
  require_index("realization", realization);
  const std::lock_guard lock(mutex_);
  record({.surfaces = {{realization, change_of(surface)}}});
}

void ResultWriter::begin_method(const std::string& name,
                                const std::string& kind,
                                const std::string& description,
                                const std::string& contact) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos)
    throw std::domain_error("name = \"" + name +
                            "\", but must be a name without '/'");
  const std::lock_guard lock(mutex_);
  record({.methods = {{.name = name,
                       .kind = kind,
                       .description = description,
                       .contact = contact}}});
  methods_.insert(name);
}

void ResultWriter::record_setup_time(const std::string& method, int realization,
                                     double cpu_time) {
  require_not_negative("cpu_time", cpu_time, "s");
  const std::lock_guard lock(mutex_);
  require_begun(method, realization);
  record({.methods = {{.name = method,
                       .realization = realization,
                       .setup_cpu_time = cpu_time}}});
}

void ResultWriter::record_own_surface(const std::string& method,
                                      int realization,
                                      const SurfaceRecord& surface) {
  const std::lock_guard lock(mutex_);
  require_begun(method, realization);
  record({.methods = {{.name = method,
                       .realization = realization,
                       .own_surface = change_of(surface)}}});
}

void ResultWriter::append(const Change& change) {
  for (const Table& table : change.tables)
    require_table(table);
  const std::lock_guard lock(mutex_);
  for (const MethodChange& method : change.methods) {
    require_new(method.name, method.realization, method.points);
    for (const FieldsChange& fields : method.fields)
      require_index("fields.step", fields.step);
  }
  record(change);
  for (const MethodChange& method : change.methods)
    for (const CurvePoint& point : method.points)
      steps_[{method.name, method.realization}].insert(point.step);
  for (const Table& table : change.tables)
    tables_.insert(table.name);
}

void ResultWriter::append_step(const std::string& method, int realization,
                               const CurvePoint& point) {
  append_steps(method, realization, {&point, 1});
}

void ResultWriter::append_steps(const std::string& method, int realization,
                                std::span<const CurvePoint> points) {
  if (!points.empty())
    append({.methods = {{.name = method,
                         .realization = realization,
                         .points = {points.begin(), points.end()}}}});
}

void ResultWriter::append_step_with_fields(const std::string& method,
                                           int realization,
                                           const CurvePoint& point,
                                           const Grid& grid,
                                           const Fields& fields) {
  if (fields.step != point.step)
    refuse_argument("fields.step", fields.step,
                    fmt::format("equal to point.step = {}", point.step));
  append({.methods = {{.name = method,
                       .realization = realization,
                       .fields = {change_of(grid, fields)},
                       .points = {point}}}});
}

void ResultWriter::append_fields(const std::string& method, int realization,
                                 const Grid& grid, const Fields& fields) {
  append({.methods = {{.name = method,
                       .realization = realization,
                       .fields = {change_of(grid, fields)}}}});
}

bool ResultWriter::has_step(const std::string& method, int realization,
                            int step) const {
  const std::lock_guard lock(mutex_);
  const auto found = steps_.find({method, realization});
  return found != steps_.end() && found->second.contains(step);
}

void ResultWriter::record_table(const Table& table) {
  append({.tables = {table}});
}

bool ResultWriter::has_table(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return tables_.contains(name);
}

void ResultWriter::record_skipped(std::span<const Skipped> skipped) {
  const std::lock_guard lock(mutex_);
  record({.skipped = std::vector(skipped.begin(), skipped.end())});
}

void ResultWriter::finish(const std::string& status) {
  if (status != "complete" && status != "interrupted")
    throw std::domain_error("status = \"" + status +
                            "\", but must be complete or interrupted");
  const std::lock_guard lock(mutex_);
  file_.fold([&](Hdf5File& file) {
    file.set_attribute("status", status);
    if (status != "complete")
      return; // a resumed curve will be extended and its ends are not final
    for (const auto& [curve_of, steps] : steps_) {
      Hdf5Group curve =
          curve_group(file, curve_of.first, curve_of.second).open("curve");
      complete_rows(curve);
    }
  });
}

void settle_result(const std::filesystem::path& folder) {
  if (std::filesystem::exists(journal_of(file_in(folder))) &&
      std::filesystem::exists(file_in(folder)))
    ResultFile::opened(file_in(folder));
}

} // namespace asperity::results
