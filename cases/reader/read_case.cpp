#include "cases/reader/read_case.hpp"

#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "cases/reader/base_case.hpp"
#include "cases/reader/case_text.hpp"
#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"
#include "cases/text/toml_limits.hpp"
#include "cases/text/toml_text.hpp"
#include "input/input_file.hpp"

#include <algorithm>
#include <filesystem>

namespace asperity::cases {
namespace {

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const Table& table : vocabulary())
    if (!table.name.empty() && table.name.find('.') == std::string::npos)
      names.push_back(table.name);
  return names;
}

// Returns the table of that name. If it is missing, returns an empty node, and
// reports a mistake if the table is required.
Node table_called(const Node& file, const std::string& name, bool is_needed,
                  Mistakes& mistakes) {
  const Node* const found = file.find(name);
  if (found && found->is_table())
    return *found;
  if (found)
    mistakes.add(found->place, name + " = " + written(*found) +
                                   ", but must be a table: [" + name + "]");
  else if (is_needed)
    mistakes.add(file.place, "the table [" + name + "] is missing");
  Node empty;
  empty.type = NodeType::other; // marks that its keys must not be read
  empty.path = name;
  empty.place = file.place;
  return empty;
}

mechanics::SurfaceKind kind_of(const Node& surface) {
  const Key& key = vocabulary_key(vocabulary_table("surface"), "kind");
  const Node* const found = surface.find("kind");
  const auto match =
      found ? std::find(key.words.begin(), key.words.end(), found->text)
            : key.words.end();
  return match == key.words.end()
             ? mechanics::SurfaceKind::self_affine
             : static_cast<mechanics::SurfaceKind>(match - key.words.begin());
}

void read_top(const Node& file, Case& read, Mistakes& mistakes) {
  TableReader top(file, vocabulary_table(""), mistakes);
  top.refuse_unknown(table_names());
  if (const Node* const base = file.find("base"))
    mistakes.add(base->place,
                 "base = " + written(*base) +
                     ", but only a case file can have a base case");
  top.integer("schema");
  read.title = top.has("title") ? top.text("title") : read.name;
}

void read_studies(const Node& file, Case& read, Mistakes& mistakes) {
  const Node magnification =
      table_called(file, "magnification", false, mistakes);
  if (magnification.is_table())
    read.magnification_study =
        read_magnification_study(magnification, read, mistakes);
  const Node adhesion = table_called(file, "adhesion", false, mistakes);
  if (adhesion.is_table())
    read.adhesion_study = read_adhesion_study(adhesion, read, mistakes);
}

void read_tables(const Node& file, Case& read, Mistakes& mistakes) {
  const Node surface = table_called(file, "surface", true, mistakes);
  const mechanics::SurfaceKind kind = kind_of(surface);
  read.methods = read_methods(file, kind, mistakes);
  const Demands demands = demands_of(read.methods);
  const std::string folder =
      std::filesystem::path(read.path).parent_path().string();
  if (surface.is_table())
    read.surface =
        read_surface(surface, folder, demands.is_surface_built, mistakes);
  const Node material = table_called(file, "material", true, mistakes);
  if (material.is_table())
    read.material =
        read_material(material, folder, demands.is_poisson_needed, mistakes);
  const Node mesh = table_called(file, "mesh", false, mistakes);
  if (mesh.is_table())
    read.mesh = read_mesh(mesh, folder, read, mistakes);
  const Node load = table_called(file, "load", true, mistakes);
  if (load.is_table())
    read.load = read_load(load, mistakes);
  read_studies(file, read, mistakes);
  const Node report = table_called(file, "report", false, mistakes);
  if (report.is_table())
    read.report = read_report(report, mistakes);
  if (read.report.stress_inside && material.is_table() &&
      !read.material.poisson_ratio)
    mistakes.add(report.find("stress_inside")->place,
                 "report.stress_inside needs material.poisson_ratio, which is "
                 "missing");
  const Node expect = table_called(file, "expect", false, mistakes);
  if (expect.is_table())
    read.expectations = read_expectations(expect, kind, read, mistakes);
  check_together(file, read, mistakes);
}

/// @param table  that has the key "file", or null
void require_file(const Node* table, const std::string& key,
                  const std::string& file) {
  if (file.empty())
    return;
  const Place& place = table->find("file")->place;
  if (!std::filesystem::exists(file))
    input::throw_mistake(
        place,
        key + ": there is no file " + file +
            " (a relative path is resolved from the case file's folder)");
  try {
    require_regular_file(file, input::largest_number_file);
  } catch (const FileError& error) {
    input::throw_mistake(place, key + ": " + error.what());
  }
}

void require_files(const Node& file, const Case& read) {
  require_file(file.find("surface"), "surface.file", read.surface.file);
  require_file(file.find("mesh"), "mesh.file", read.mesh.file);
  if (read.material.variation)
    require_file(file.find("material")->find("variation"),
                 "material.variation.file", read.material.variation->file);
}

enum class FilesOfCase { required, not_looked_for };

Case read_text(const StackedText& stacked, const std::string& path,
               FilesOfCase files) {
  Case read;
  read.path = path;
  read.name = case_name(path);
  std::vector<std::string> entries;
  for (const LaidOver& over : stacked.overrides)
    entries.push_back(over.entry);
  read.text = text_with_overrides(stacked.text, entries);

  Node file = parse_toml(stacked.text, stacked.path);
  Mistakes mistakes;
  const std::vector<std::string> own = overrides_in(stacked.text);
  if (own.size() + entries.size() > most_overrides)
    input::throw_mistake({path, 0},
                         "has more than " + std::to_string(most_overrides) +
                             " overridden keys (by --set or over a base case)");
  for (const std::string& entry : own)
    apply_override(file, entry, mistakes);
  for (const LaidOver& over : stacked.overrides)
    apply_override(file, over.entry, mistakes, over.place);

  if (const Node* const sweep = file.find("sweep"))
    mistakes.add(sweep->place,
                 "[sweep] describes many cases, but one case is needed here: "
                 "--set sweep= removes the table");
  read_top(file, read, mistakes);
  read_tables(file, read, mistakes);
  mistakes.throw_if_any();
  if (files == FilesOfCase::required)
    require_files(file, read);
  return read;
}

void add(StackedText& stacked, const std::vector<std::string>& overrides) {
  for (const std::string& entry : overrides)
    stacked.overrides.push_back({entry, {"--set", 0}});
}

} // namespace

std::string case_name(const std::filesystem::path& path) {
  const std::filesystem::path named =
      path.filename() != "case.toml"
          ? path.stem()
          : std::filesystem::absolute(path).parent_path().filename();
  return printable(named.string(), longest_name);
}

Case read_stacked_case(const StackedText& stacked, const std::string& path) {
  return read_text(stacked, path, FilesOfCase::required);
}

Case read_case(const std::string& path,
               const std::vector<std::string>& overrides) {
  StackedText stacked = read_stacked(path);
  add(stacked, overrides);
  return read_stacked_case(stacked, path);
}

Case read_case_text(const std::string& text, const std::string& path,
                    const std::vector<std::string>& overrides) {
  StackedText stacked{text, path, {}};
  add(stacked, overrides);
  return read_text(stacked, path, FilesOfCase::not_looked_for);
}

} // namespace asperity::cases
