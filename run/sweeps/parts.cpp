#include "run/sweeps/parts.hpp"

#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "input/sweeps/sweep.hpp"
#include "reports/pages/report.hpp"
#include "results/joined_result.hpp"
#include "results/provenance.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "run/new_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

/// Reads "3/8" or, with another separator, "3-of-8".
std::optional<Part> part_in(std::string_view text, std::string_view between) {
  const std::size_t middle = text.find(between);
  if (middle == text.npos)
    return std::nullopt;
  Part part;
  const auto read = [](std::string_view word, int& number) {
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc{} && end == word.data() + word.size() &&
           number >= 1;
  };
  return read(text.substr(0, middle), part.number) &&
                 read(text.substr(middle + between.size()), part.count) &&
                 part.number <= part.count
             ? std::optional(part)
             : std::nullopt;
}

/// The parts of a case in the folder of a run.
std::vector<Part> parts_in(const fs::path& folder) {
  std::vector<Part> parts;
  std::error_code none; // no folder of parts
  for (const auto& entry : fs::directory_iterator(folder / "parts", none))
    if (const auto part = part_in(entry.path().filename().string(), "-of-"))
      parts.push_back(*part);
  return parts;
}

bool has_result(const fs::path& folder, const Part& part) {
  return fs::exists(folder / part_folder(part) / "result.h5");
}

/// The number of parts in the folder of a run.
int count_of_parts(const fs::path& folder) {
  std::vector<Part> parts = parts_in(folder);
  std::erase_if(parts,
                [&](const Part& part) { return !has_result(folder, part); });
  if (parts.empty())
    throw input::InputError(fmt::format(
        "{}: has no parts; asperity run CASE --out {} --part I/N computes one",
        folder.string(), folder.string()));
  const Part& first = parts.front();
  for (const Part& part : parts)
    if (first.count != part.count)
      throw input::InputError(fmt::format(
          "{} is one of {} parts, but {} is one of {}; remove the folders that "
          "are not to be merged",
          (folder / part_folder(first)).string(), first.count,
          (folder / part_folder(part)).string(), part.count));
  return first.count;
}

/// What a result lacks of the part of its case that this part computes; empty:
/// nothing.
std::string lack_of(const fs::path& place, const Part& part) {
  if (!fs::exists(place / "result.h5"))
    return "has no result.h5";
  const results::Result result =
      results::read_result(place, results::MapsInFile::large);
  const cases::Case contact_case = reports::case_of(result);
  const results::StepsDone done = results::steps_done(result);
  std::size_t n_done = 0;
  std::size_t n_needed = 0;
  for (const cases::MethodSpec& method : contact_case.methods) {
    if (result.method(method.name) == nullptr)
      continue;
    for (int r = part.number - 1;
         r < methods::n_realizations(contact_case, method); r += part.count) {
      n_needed += contact_case.load.targets.size();
      if (const auto found = done.find({method.name, r}); found != done.end())
        n_done += found->second.size();
    }
  }
  if (n_done == n_needed && result.status == "complete")
    return "";
  return fmt::format(
      "{}has {} of {} load steps",
      result.status == "complete" ? "" : "is " + result.status + " and ",
      n_done, n_needed);
}

void require_all_complete(const fs::path& folder, int count) {
  std::string text;
  int n_lacking = 0;
  for (Part part{1, count}; part.number <= count; ++part.number)
    if (const std::string lack = lack_of(folder / part_folder(part), part);
        !lack.empty()) {
      ++n_lacking;
      text += fmt::format("\n  --part {}: {} {}", part_text(part),
                          part_folder(part).string(), lack);
    }
  if (n_lacking > 0)
    throw input::InputError(fmt::format(
        "{}: {} of {} parts {} missing or incomplete; run the same case with{}",
        folder.string(), n_lacking, count, n_lacking == 1 ? "is" : "are",
        text));
}

/// Whether the result of a folder was joined from these parts as they are.
bool is_joined(const fs::path& folder, const std::vector<fs::path>& parts) {
  const fs::path whole = folder / "result.h5";
  if (!fs::exists(whole))
    return false;
  const fs::file_time_type time = fs::last_write_time(whole);
  const results::Provenance facts =
      results::read_result(whole, results::MapsInFile::large).provenance;
  return std::ranges::find(facts, std::pair<std::string, std::string>(
                                      "parts", std::to_string(parts.size()))) !=
             facts.end() &&
         std::ranges::all_of(parts, [&](const fs::path& part) {
           return fs::last_write_time(part / "result.h5") <= time;
         });
}

/// Copies what the methods wrote beside the result of a part, such as
/// "fem-3/block.vtu".
void copy_files_of_methods(const fs::path& part, const fs::path& place) {
  for (const auto& entry : fs::directory_iterator(part))
    if (entry.is_directory() && entry.path().filename() != "figures" &&
        !entry.path().filename().string().starts_with('.'))
      fs::copy(entry.path(), place / entry.path().filename(),
               fs::copy_options::recursive |
                   fs::copy_options::overwrite_existing);
}

} // namespace

Part read_part(const std::string& text) {
  if (const auto part = part_in(text, "/"))
    return *part;
  throw input::InputError(fmt::format(
      "--part {}: must be I/N with integers 1 <= I <= N, for example 3/8",
      text));
}

std::string part_text(const Part& part) {
  return fmt::format("{}/{}", part.number, part.count);
}

std::size_t n_members(const NamedCases& named) {
  if (named.sweep)
    return named.sweep->sweep.points.size();
  const cases::Case& contact_case = named.cases.front().contact_case;
  return methods::needs_surfaces(contact_case.methods)
             ? static_cast<std::size_t>(contact_case.surface.realizations)
             : 1U;
}

std::vector<std::size_t> members_of(const NamedCases& named, const Part& part) {
  const std::size_t all = n_members(named);
  const auto count = static_cast<std::size_t>(part.count);
  if (count > all)
    throw input::InputError(fmt::format(
        "{} parts: {} has {} {}, so that the number of parts must lie between "
        "1 and {}",
        count, output_name(named), all,
        named.sweep ? "points" : "realisation(s)", all));
  std::vector<std::size_t> members;
  for (auto i = static_cast<std::size_t>(part.number) - 1; i < all; i += count)
    members.push_back(i);
  return members;
}

fs::path part_folder(const Part& part) {
  return fs::path("parts") / fmt::format("{}-of-{}", part.number, part.count);
}

bool has_parts_of_case(const fs::path& folder) {
  return std::ranges::any_of(parts_in(folder), [&](const Part& part) {
    return has_result(folder, part);
  });
}

void remove_parts(const fs::path& folder) {
  for (const Part& part : parts_in(folder))
    remove_run(folder / part_folder(part));
}

void merge_realizations(const fs::path& folder) {
  const int count = count_of_parts(folder);
  require_all_complete(folder, count);
  std::vector<fs::path> parts;
  for (Part part{1, count}; part.number <= count; ++part.number)
    parts.push_back(folder / part_folder(part));
  if (is_joined(folder, parts))
    return;
  const fs::path joined = folder / "parts" / "joined";
  fs::remove_all(joined);
  results::join_results(parts, joined);
  NewOutput output(folder, false);
  for (const fs::path& part : parts)
    copy_files_of_methods(part, output.place());
  fs::rename(joined / "result.h5", output.place() / "result.h5");
  fs::remove_all(joined);
  output.replace();
}

bool all_converged(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (const results::CurvePoint& point : method.rows())
      if (point.status == results::StepStatus::not_converged)
        return false;
  return true;
}

EarlierRun earlier_run(const cases::Case& contact_case,
                       const std::vector<cases::MethodSpec>& methods,
                       const std::filesystem::path& folder,
                       const std::set<int>& only) {
  if (!std::filesystem::exists(folder / "result.h5"))
    return {};
  try {
    const results::Result result =
        results::read_result(folder, results::MapsInFile::large);
    results::Inputs inputs = methods::input_hashes(contact_case);
    inputs["program"] = results::build_stamp();
    if (cases::point_content(result.case_text) !=
            cases::point_content(contact_case.text) ||
        results::inputs_of(result) != inputs)
      return {};
    const results::StepsDone done = results::steps_done(result);
    bool has_all = result.status == "complete";
    for (const cases::MethodSpec& method : methods)
      for (const int r : methods::realizations_of(contact_case, method, only)) {
        const auto found = done.find({method.name, r});
        has_all = has_all && found != done.end() &&
                  found->second.size() == contact_case.load.targets.size();
      }
    if (has_all)
      return {RunState::complete, result.case_hash};
    if (result.case_hash == cases::case_hash(contact_case))
      return {RunState::to_resume, result.case_hash};
  } catch (const input::InputError&) { // damaged: it is computed again
  }
  return {};
}

} // namespace asperity::run
