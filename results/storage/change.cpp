#include "results/storage/change.hpp"

#include "input/input_error.hpp"
#include "results/storage/curve_storage.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/storage/map_storage.hpp"
#include "results/storage/result_layout.hpp"
#include "results/storage/table_storage.hpp"

#include <algorithm>
#include <utility>

namespace asperity::results {
namespace {

/// Returns an empty group of that name and removes an existing one.
Hdf5Group fresh(Hdf5Group& home, const std::string& name) {
  if (home.has(name))
    home.remove(name);
  return home.open_or_create(name);
}

void write_curve(Hdf5Group method, const MethodChange& change) {
  Hdf5Group curve = method.open_or_create(std::to_string(change.realization));
  if (change.setup_cpu_time)
    set_with_unit(curve, "setup_cpu_time", *change.setup_cpu_time, "s");
  if (change.own_surface) {
    Hdf5Group surface = fresh(curve, layout::own_surface);
    write_surface(surface, change.own_surface->record,
                  change.own_surface->heights.rows);
  }
  for (const FieldsChange& fields : change.fields) {
    Hdf5Group maps = curve.open_or_create("fields");
    write_fields(maps, fields);
  }
  if (!change.points.empty()) {
    Hdf5Group rows = curve.open_or_create("curve");
    append_points(rows, change.points);
  }
}

void write_method(Hdf5File& file, const MethodChange& change) {
  Hdf5Group method = file.open_or_create("methods").open_or_create(change.name);
  if (change.kind)
    method.set_attribute("kind", *change.kind);
  if (change.description)
    method.set_attribute("description", *change.description);
  if (change.contact)
    method.set_attribute("contact", *change.contact);
  if (change.realization >= 0)
    write_curve(std::move(method), change);
}

/// Returns the item of that name, which is appended if there is none.
template <class Item>
Item& named(std::vector<Item>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(),
                   [&](const Item& item) { return item.name == name; });
  if (found != items.end())
    return *found;
  items.emplace_back().name = name;
  return items.back();
}

/// Returns the item of that realisation.
/// @throws input::InputError  the index is out of range
template <class Item>
Item& at_index(std::vector<Item>& items, int index) {
  if (index < 0 || index >= layout::most_realizations)
    throw input::InputError(
        "a record of the journal has an invalid realisation index");
  const auto place = static_cast<std::size_t>(index);
  items.resize(std::max(items.size(), place + 1));
  return items[place];
}

/// Reads a map of a record into memory, or leaves it in the file.
void merge_map(const ChangeMap& map, MapsInFile left,
               std::vector<double>& values, StoredMap& stored) {
  const MapView view(map.stored);
  if (left == MapsInFile::large && view.size() >= large_map)
    stored = map.stored;
  else
    values = view.whole();
}

SurfaceRecord merged(SurfaceChange change, MapsInFile left) {
  merge_map(change.heights, left, change.record.heights,
            change.record.stored_heights);
  return std::move(change.record);
}

void merge_fields(std::vector<Fields>& all, const FieldsChange& change,
                  MapsInFile left) {
  std::erase_if(all,
                [&](const Fields& old) { return old.step == change.step; });
  Fields fields{change.step, change.nominal_pressure, {}, {}, change.grid};
  fields.has_double_maps = change.has_double_maps;
  fields.map = change.map;
  merge_map(change.pressure, left, fields.pressure, fields.stored_pressure);
  merge_map(change.gap, left, fields.gap, fields.stored_gap);
  all.push_back(std::move(fields));
  std::sort(all.begin(), all.end(),
            [](const Fields& a, const Fields& b) { return a.step < b.step; });
}

void merge_curve(Curve& curve, MethodChange change, MapsInFile left) {
  if (change.setup_cpu_time)
    curve.setup_cpu_time = *change.setup_cpu_time;
  if (change.own_surface)
    curve.own_surface = merged(std::move(*change.own_surface), left);
  for (const FieldsChange& fields : change.fields)
    merge_fields(curve.fields, fields, left);
  curve.points.insert(curve.points.end(), change.points.begin(),
                      change.points.end());
  std::stable_sort(
      curve.points.begin(), curve.points.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.step < b.step; });
}

void merge_fact(Provenance& facts, std::pair<std::string, std::string> fact) {
  const auto old =
      std::find_if(facts.begin(), facts.end(),
                   [&](const auto& one) { return one.first == fact.first; });
  if (old == facts.end())
    facts.push_back(std::move(fact));
  else
    old->second = std::move(fact.second);
}

} // namespace

void write_change(Hdf5File& file, const Change& change) {
  if (change.status)
    file.set_attribute("status", *change.status);
  Hdf5Group facts = file.open_or_create("provenance");
  for (const auto& [name, fact] : change.provenance)
    facts.set_attribute(name, fact);
  for (const auto& [realization, one] : change.surfaces) {
    Hdf5Group surfaces = file.open_or_create("surfaces");
    Hdf5Group surface = fresh(surfaces, std::to_string(realization));
    write_surface(surface, one.record, one.heights.rows);
  }
  for (const MethodChange& method : change.methods)
    write_method(file, method);
  for (const Table& table : change.tables) {
    Hdf5Group tables = file.open_or_create(layout::tables);
    Hdf5Group group = fresh(tables, table.name);
    write_table(group, table);
  }
  if (change.skipped) {
    Hdf5Group group = fresh(file, layout::skipped);
    std::vector<std::string> things;
    std::vector<std::string> reasons;
    for (const Skipped& one : *change.skipped) {
      things.push_back(one.what);
      reasons.push_back(one.why);
    }
    if (!things.empty()) {
      group.append("what", things);
      group.append("why", reasons);
    }
  }
}

void merge_change(Result& result, Change change, MapsInFile left) {
  if (change.status)
    result.status = *change.status;
  for (auto& fact : change.provenance)
    merge_fact(result.provenance, std::move(fact));
  for (auto& [realization, one] : change.surfaces)
    at_index(result.surfaces, realization) = merged(std::move(one), left);
  for (MethodChange& one : change.methods) {
    MethodRecord& method = named(result.methods, one.name);
    method.kind = one.kind.value_or(method.kind);
    method.description = one.description.value_or(method.description);
    method.contact = one.contact.value_or(method.contact);
    if (one.realization >= 0) {
      Curve& curve = at_index(method.realizations, one.realization);
      merge_curve(curve, std::move(one), left);
    }
  }
  for (Table& table : change.tables)
    named(result.tables, table.name) = std::move(table);
  if (change.skipped)
    result.skipped = std::move(*change.skipped);
}

} // namespace asperity::results
