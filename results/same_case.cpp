#include "results/same_case.hpp"

#include "input/input_error.hpp"
#include "results/result_writer.hpp"
#include "results/storage/result_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::results {
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

} // namespace asperity::results
