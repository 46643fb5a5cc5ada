#include "results/result_writer.hpp"

#include "base/cpu_clock.hpp"
#include "base/require.hpp"
#include "cases/case_error.hpp"
#include "results/curve_storage.hpp"
#include "results/hdf5_file.hpp"
#include "results/map_size.hpp"
#include "results/map_storage.hpp"
#include "results/result_layout.hpp"
#include "results/skipped_storage.hpp"
#include "results/table_storage.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace asperity::results {
namespace {

void require_index(const char* name, int index) {
  require_between(name, index, 0, layout::most_realizations - 1, "1");
}

Hdf5Group curve_home(Hdf5Group& file, const std::string& method,
                     int realization) {
  return file.open("methods").open(method).open_or_create(
      std::to_string(realization));
}

void require_maps(const Grid& grid, const Fields& fields) {
  require_index("fields.step", fields.step);
  require_size("fields.pressure", fields.pressure.size(), grid.size());
  require_size("fields.gap", fields.gap.size(), grid.size());
}

void require_heights(const SurfaceRecord& surface) {
  if (!surface.heights.empty())
    require_size("surface.heights", surface.heights.size(),
                 surface.grid.size());
}

/// An empty group of that name, whatever was there.
Hdf5Group fresh(Hdf5Group& home, const std::string& name) {
  if (home.has(name))
    home.remove(name);
  return home.open_or_create(name);
}

} // namespace

ResultWriter::ResultWriter(const std::filesystem::path& folder,
                           const CaseInfo& info, Mode mode)
    : path_(folder / layout::file_name),
      part_(folder / fmt::format(".{}.part", layout::file_name)) {
  require_positive("contact_modulus", info.contact_modulus, "Pa");
  std::filesystem::create_directories(folder);
  if (mode == Mode::resume && std::filesystem::exists(path_))
    adopt(info);
  else
    create(info);
}

void ResultWriter::create(const CaseInfo& info) {
  const std::lock_guard lock(hdf5_mutex());
  Hdf5File file(part_, Hdf5File::Mode::create);
  file.set_attribute("format", layout::format);
  file.set_attribute("format_version", layout::format_version);
  file.set_attribute("name", info.name);
  file.set_attribute("title", info.title);
  file.set_attribute("case_text", info.text);
  file.set_attribute("case_hash", info.hash);
  file.set_attribute("reference", info.reference);
  set_with_unit(file, "contact_modulus", info.contact_modulus, "Pa");
  file.set_attribute("status", "running");
  for (const char* room : {"provenance", "surfaces", "methods"})
    file.open_or_create(room);
  file.close();
  std::filesystem::rename(part_, path_);
}

void ResultWriter::adopt(const CaseInfo& info) {
  const Result old = read_result(path_);
  if (old.case_hash != info.hash)
    throw cases::CaseError(
        fmt::format("{}: case_hash = \"{}\", but the case to resume has \"{}\"",
                    path_.string(), old.case_hash, info.hash));
  steps_ = steps_done(old);
  for (const MethodRecord& method : old.methods)
    methods_.insert(method.name);
  for (const Table& table : old.tables)
    tables_.insert(table.name);
  const std::lock_guard lock(hdf5_mutex());
  update([&info](Hdf5File& file) {
    file.set_attribute("status", "running");
    file.set_attribute("reference", info.reference);
  });
}

void ResultWriter::update(const Change& change) {
  const CpuClock clock;
  try {
    std::filesystem::copy_file(
        path_, part_, std::filesystem::copy_options::overwrite_existing);
    Hdf5File file(part_, Hdf5File::Mode::read_write);
    change(file);
    file.close();
    std::filesystem::rename(part_, path_);
    cpu_time_ += clock.seconds();
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    throw;
  }
}

void ResultWriter::require_begun(const std::string& method,
                                 int realization) const {
  require_index("realization", realization);
  if (!methods_.contains(method))
    throw std::domain_error("method = \"" + method +
                            "\", but must be one that was begun");
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
          fmt::format("new to {} realization {}", method, realization));
  }
}

void ResultWriter::record_provenance(const Provenance& facts) {
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    Hdf5Group group = file.open_or_create("provenance");
    for (const auto& [name, fact] : facts)
      group.set_attribute(name, fact);
  });
}

void ResultWriter::record_surface(int realization,
                                  const SurfaceRecord& surface) {
  require_index("realization", realization);
  require_heights(surface);
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    Hdf5Group surfaces = file.open_or_create("surfaces");
    Hdf5Group group = fresh(surfaces, std::to_string(realization));
    write_surface(group, surface);
  });
}

void ResultWriter::begin_method(const std::string& name,
                                const std::string& kind,
                                const std::string& description) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos)
    throw std::domain_error("name = \"" + name +
                            "\", but must be a name without '/'");
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    Hdf5Group group = file.open_or_create("methods").open_or_create(name);
    group.set_attribute("kind", kind);
    group.set_attribute("description", description);
  });
  methods_.insert(name);
}

void ResultWriter::record_setup_time(const std::string& method, int realization,
                                     double cpu_time) {
  require_not_negative("cpu_time", cpu_time, "s");
  const std::lock_guard lock(hdf5_mutex());
  require_begun(method, realization);
  update([&](Hdf5File& file) {
    Hdf5Group home = curve_home(file, method, realization);
    set_with_unit(home, "setup_cpu_time", cpu_time, "s");
  });
}

void ResultWriter::record_own_surface(const std::string& method,
                                      int realization,
                                      const SurfaceRecord& surface) {
  require_heights(surface);
  const std::lock_guard lock(hdf5_mutex());
  require_begun(method, realization);
  update([&](Hdf5File& file) {
    Hdf5Group home = curve_home(file, method, realization);
    Hdf5Group group = fresh(home, layout::own_surface);
    write_surface(group, surface);
  });
}

void ResultWriter::append_step(const std::string& method, int realization,
                               const CurvePoint& point) {
  append_steps(method, realization, {&point, 1});
}

void ResultWriter::append_steps(const std::string& method, int realization,
                                std::span<const CurvePoint> points) {
  const std::lock_guard lock(hdf5_mutex());
  require_new(method, realization, points);
  if (points.empty())
    return;
  update([&](Hdf5File& file) {
    Hdf5Group curve =
        curve_home(file, method, realization).open_or_create("curve");
    append_points(curve, points);
  });
  for (const CurvePoint& point : points)
    steps_[{method, realization}].insert(point.step);
}

void ResultWriter::append_step_with_fields(const std::string& method,
                                           int realization,
                                           const CurvePoint& point,
                                           const Grid& grid,
                                           const Fields& fields) {
  require_maps(grid, fields);
  if (fields.step != point.step)
    refuse_argument("fields.step", fields.step,
                    fmt::format("equal to point.step = {}", point.step));
  const std::lock_guard lock(hdf5_mutex());
  require_new(method, realization, {&point, 1});
  update([&](Hdf5File& file) {
    Hdf5Group home = curve_home(file, method, realization);
    Hdf5Group maps = home.open_or_create("fields");
    write_fields(maps, grid, fields);
    Hdf5Group curve = home.open_or_create("curve");
    append_points(curve, {&point, 1});
  });
  steps_[{method, realization}].insert(point.step);
}

void ResultWriter::append_fields(const std::string& method, int realization,
                                 const Grid& grid, const Fields& fields) {
  require_maps(grid, fields);
  const std::lock_guard lock(hdf5_mutex());
  require_begun(method, realization);
  update([&](Hdf5File& file) {
    Hdf5Group maps =
        curve_home(file, method, realization).open_or_create("fields");
    write_fields(maps, grid, fields);
  });
}

bool ResultWriter::has_step(const std::string& method, int realization,
                            int step) const {
  const std::lock_guard lock(hdf5_mutex());
  const auto found = steps_.find({method, realization});
  return found != steps_.end() && found->second.contains(step);
}

void ResultWriter::record_table(const Table& table) {
  require_table(table);
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    Hdf5Group tables = file.open_or_create(layout::tables);
    Hdf5Group group = fresh(tables, table.name);
    write_table(group, table);
  });
  tables_.insert(table.name);
}

bool ResultWriter::has_table(const std::string& name) const {
  const std::lock_guard lock(hdf5_mutex());
  return tables_.contains(name);
}

void ResultWriter::record_skipped(std::span<const Skipped> skipped) {
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    Hdf5Group group = fresh(file, layout::skipped);
    if (!skipped.empty())
      write_skipped(group, skipped);
  });
}

void ResultWriter::finish(const std::string& status) {
  if (status != "complete" && status != "interrupted")
    throw std::domain_error("status = \"" + status +
                            "\", but must be complete or interrupted");
  const std::lock_guard lock(hdf5_mutex());
  update([&](Hdf5File& file) {
    file.set_attribute("status", status);
    if (status != "complete")
      return; // a resumed curve goes on: its ends are not yet ends
    for (const auto& [curve_of, steps] : steps_) {
      Hdf5Group curve = curve_home(file, curve_of.first, curve_of.second)
                            .open_or_create("curve");
      fill_stored_stiffness(curve);
    }
  });
}

} // namespace asperity::results
