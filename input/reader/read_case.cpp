#include "input/reader/read_case.hpp"

#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/input_file.hpp"
#include "input/reader/base_case.hpp"
#include "input/reader/case_text.hpp"
#include "input/reader/read_parts.hpp"
#include "input/reader/study_keys.hpp"
#include "input/text/toml_limits.hpp"
#include "input/text/toml_text.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

namespace asperity::cases {
namespace {

// Returns the table of that name, null if there is none, and reports a mistake
// if it is required.
const Node* table_called(TableReader& file, const std::string& name,
                         bool is_needed, Mistakes& mistakes) {
  if (is_needed && !file.has(name))
    mistakes.add(file.node().place, "the table [" + name + "] is missing");
  return file.sub_table(name);
}

mechanics::SurfaceKind kind_of(const Node* surface) {
  const Key& key = vocabulary_key(vocabulary_table("surface"), "kind");
  const Node* const found = surface ? surface->find("kind") : nullptr;
  const auto match =
      found ? std::find(key.words.begin(), key.words.end(), found->text)
            : key.words.end();
  return match == key.words.end()
             ? mechanics::SurfaceKind::self_affine
             : static_cast<mechanics::SurfaceKind>(match - key.words.begin());
}

void read_top(TableReader& top, Case& read) {
  top.refuse_unknown();
  if (top.has("base"))
    top.complain(top.said_by("base"), "= " + written(top.said_by("base")) +
                                          ", but only a case file can have a "
                                          "base case");
  top.integer("schema");
  read.title = read.name;
  top.read(read);
}

void read_tables(TableReader& file, Case& read, Mistakes& mistakes) {
  const auto table = [&](const char* name, bool is_needed = false) {
    return table_called(file, name, is_needed, mistakes);
  };
  const auto part = [&](const Node& node) {
    return file.part(node, node.path);
  };
  const Node* const surface = table("surface", true);
  const mechanics::SurfaceKind kind = kind_of(surface);
  read.methods = read_methods(file, kind, mistakes);
  const Demands demands = demands_of(read.methods);
  if (surface != nullptr)
    read.surface = read_surface(part(*surface), demands.is_surface_built);
  const Node* const material = table("material", true);
  if (material != nullptr)
    read.material = read_material(part(*material), demands.is_poisson_needed);
  if (const Node* const mesh = table("mesh"))
    read.mesh = read_mesh(part(*mesh), read);
  if (const Node* const load = table("load", true))
    read.load = read_load(part(*load), read.methods);
  for (const StudyKeys* const study : known_studies())
    if (const Node* const asked =
            study->tables.empty() ? nullptr : table(study->name().c_str()))
      study->read(part(*asked), read);
  if (const Node* const report = table("report"))
    part(*report).read(read.report);
  if (read.report.stress_inside && material != nullptr &&
      !read.material.poisson_ratio)
    mistakes.add(file.node().at("report.stress_inside")->place,
                 "report.stress_inside needs material.poisson_ratio, which is "
                 "missing");
  if (const Node* const expect = table("expect"))
    read.expectations = read_expectations(*expect, kind, read, mistakes);
  check_together(file.node(), read, mistakes);
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
    require_file(file.at("material.variation"), "material.variation.file",
                 read.material.variation->file);
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

  Node file = parsed_file(stacked.text, stacked.path);
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
  const std::string folder =
      std::filesystem::path(read.path).parent_path().string();
  TableReader whole(file, vocabulary_table(""), mistakes, folder);
  read_top(whole, read);
  read_tables(whole, read, mistakes);
  mistakes.throw_if_any();
  if (files == FilesOfCase::required)
    require_files(file, read);
  read.file = std::make_shared<const Node>(std::move(file));
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
