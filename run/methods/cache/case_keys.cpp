#include "run/methods/cache/case_keys.hpp"

#include "base/content_hash.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/reader/study_keys.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"
#include "md/engines.hpp"
#include "results/provenance.hpp"
#include "run/methods/cache/file_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace asperity::methods {
namespace {

using cases::Node;
using cases::NodeEntry;

constexpr const char* surface_file = "surface.file";
constexpr const char* variation_file = "material.variation.file";
constexpr const char* mesh_file = "mesh.file";

/// Returns a value as text, with the keys of tables in alphabetical order.
std::string canonical(const Node& node) {
  if (!node.is_table())
    return cases::toml_value(node);
  std::vector<std::string> lines;
  for (const NodeEntry& entry : node.entries)
    lines.push_back(cases::toml_key(entry.key) + "=" + canonical(entry.node));
  std::sort(lines.begin(), lines.end());
  return fmt::format("{{{}}}", fmt::join(lines, "\n"));
}

std::string text_of(const Node& file, const std::string& table) {
  const Node* const found = file.find(table);
  return found == nullptr ? "" : canonical(*found);
}

/// The content_hash() of the bytes of a file, which is read by pieces.
std::string hash_of_input(const std::filesystem::path& path) {
  try {
    require_regular_file(path, input::largest_number_file);
  } catch (const FileError& error) {
    throw input::InputError(error.what());
  }
  std::ifstream stream(path, std::ios::binary);
  ContentHash hash;
  std::string piece(std::size_t{1} << 20, '\0');
  while (
      stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) ||
      stream.gcount() > 0)
    hash.add(std::string_view(piece).substr(
        0, static_cast<std::size_t>(stream.gcount())));
  if (!stream.eof())
    throw input::InputError(path.string() + ": cannot be read");
  return hash.text();
}

/// Returns "" if the case names no such file.
std::string hash_in(const std::map<std::string, std::string>& inputs,
                    const std::string& key) {
  const auto found = inputs.find(key);
  return found == inputs.end() ? "" : found->second;
}

/// Returns the text that determines a surface. A realisation depends on the
/// seed but not on the number of realisations, and a height map on the contents
/// of its file but not on its path.
std::string surface_text(const Node& file) {
  Node table = *file.find("surface");
  std::erase_if(table.entries, [](const NodeEntry& entry) {
    return entry.key == "realizations" || entry.key == "file";
  });
  return canonical(table);
}

std::string load_text(const mechanics::LoadingPath& load, std::size_t step) {
  const mechanics::Quantity& target = load.targets[step];
  std::string text =
      fmt::format("{} {} {}", static_cast<int>(load.control), target.value,
                  static_cast<int>(target.reference));
  if (load.spring)
    text += fmt::format(" {} {}", load.spring->value,
                        static_cast<int>(load.spring->reference));
  return text;
}

} // namespace

CaseKeys::CaseKeys(const cases::Case& contact_case, std::string program)
    : CaseKeys(contact_case, std::move(program), input_hashes(contact_case)) {}

CaseKeys::CaseKeys(const cases::Case& contact_case, std::string program,
                   std::map<std::string, std::string> inputs)
    : case_(contact_case),
      program_(std::move(program)),
      inputs_(std::move(inputs)),
      problem_text_(fmt::format(
          "{}\n{}{}\n{}{}", program_, surface_text(*case_.file),
          hash_in(inputs_, surface_file), text_of(*case_.file, "material"),
          hash_in(inputs_, variation_file))) {}

Node CaseKeys::table_of(const cases::MethodSpec& method) const {
  const std::size_t dot = method.name.find('.');
  const std::string kind = method.name.substr(0, dot);
  const Node& base = *case_.file->find(kind);
  return cases::method_table(base, kind,
                             dot == std::string::npos
                                 ? nullptr
                                 : base.find(method.name.substr(dot + 1)));
}

std::string CaseKeys::method_text(const cases::MethodSpec& method) const {
  // A step does not depend on the number of realisations.
  Node table = table_of(method);
  std::erase_if(table.entries, [](const NodeEntry& entry) {
    return entry.key == "realizations";
  });
  std::string text = cases::kind_of_method(method.name) + canonical(table);
  if (const auto* md = method.as<mechanics::MdSettings>())
    text += md::engine_identity(*md);
  if (const auto* fem = method.as<mechanics::FemSettings>();
      fem != nullptr && fem->full.uses_case_mesh)
    text += text_of(*case_.file, "mesh") + hash_in(inputs_, mesh_file);
  return text;
}

std::vector<std::string> CaseKeys::steps(const cases::MethodSpec& method,
                                         int realization) const {
  std::string asked;
  for (const cases::StudyKeys* const study : cases::known_studies())
    if (study->step_key != nullptr && study->is_asked(case_))
      asked += study->step_key(case_);
  std::string key = content_hash(fmt::format(
      "{}\n{}\n{}{}", problem_text_, method_text(method), realization, asked));
  std::vector<std::string> keys;
  for (std::size_t step = 0; step < case_.load.targets.size(); ++step) {
    key = content_hash(key + load_text(case_.load, step));
    keys.push_back(key);
  }
  return keys;
}

std::string CaseKeys::table(const cases::MethodSpec& theory,
                            const std::string& name) const {
  return content_hash(fmt::format("{}\n{}\n{}\n{}\n{}", problem_text_,
                                  method_text(theory),
                                  text_of(*case_.file, "magnification"),
                                  text_of(*case_.file, "adhesion"), name));
}

std::string CaseKeys::operator_text(const cases::MethodSpec& method,
                                    const Grid& grid) const {
  Node table = table_of(method);
  std::erase_if(table.entries, [](const NodeEntry& entry) {
    return entry.key == "contact" || entry.key == "penalty" ||
           entry.key == "work_of_adhesion" || entry.key == "range" ||
           entry.key == "hardness" || entry.key == "tolerance" ||
           entry.key == "max_iterations" || entry.key == "magnification" ||
           entry.key == "realizations";
  });
  return fmt::format("{} {} {} {}\n{}\n{} {}", grid.points_x, grid.points_y,
                     grid.length_x, grid.length_y,
                     text_of(*case_.file, "material"),
                     cases::kind_of_method(method.name), canonical(table));
}

std::string CaseKeys::of_operator(const std::string& text) const {
  return content_hash(program_ + "\n" + text);
}

std::map<std::string, std::string>
input_hashes(const cases::Case& contact_case) {
  std::map<std::string, std::string> inputs;
  const auto add = [&](const char* key, const std::string& path) {
    if (!path.empty())
      inputs[key] = hash_of_input(path);
  };
  add(surface_file, contact_case.surface.file);
  if (contact_case.material.variation)
    add(variation_file, contact_case.material.variation->file);
  if (!contact_case.mesh.file.empty())
    inputs[mesh_file] = hash_of_mesh(contact_case);
  return inputs;
}

std::string program_identity() {
  return results::build_stamp() + " " + results::processor_name();
}

} // namespace asperity::methods
