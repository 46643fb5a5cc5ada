#include "run/distributed/merge.hpp"

#include "input/input_error.hpp"
#include "methods/chosen.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "results/joined_result.hpp"
#include "run/last_run.hpp"
#include "run/sweeps/earlier_run.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

/// Refuses parts of different cases or different numbers of parts.
void require_one_run(const std::vector<PartRecord>& records,
                     const fs::path& folder) {
  const auto place = [&](const PartRecord& record) {
    return (folder / part_folder(record.part)).string();
  };
  const PartRecord& first = records.front();
  for (const PartRecord& record : records) {
    const bool is_same_case = record.request == first.request &&
                              record.is_sweep == first.is_sweep &&
                              record.case_hashes == first.case_hashes;
    if (!is_same_case)
      throw input::InputError(fmt::format(
          "{} is a part of another case or of other options than {}; run the "
          "one that is out of date again, or remove its folder:\n  {}\n  {}",
          place(record), place(first), part_command(record, folder),
          part_command(first, folder)));
    if (record.part.count != first.part.count)
      throw input::InputError(fmt::format(
          "{} is one of {} parts, but {} is one of {}; remove the folders that "
          "are not to be merged",
          place(first), first.part.count, place(record), record.part.count));
  }
}

/// Reads the case again and divides it as each part has done.
WholeRun run_of(const PartRecord& record, const fs::path& folder) {
  const PartRequest& request = record.request;
  WholeRun run;
  run.named = read_named_cases_or_sweep(request.case_file, request.overrides,
                                        false, request.contact_modulus);
  run.parts = part_records(run.named, request, record.part.count);
  if (run.parts.front().case_hashes != record.case_hashes)
    throw input::InputError(fmt::format(
        "{} has changed since the parts in {} were computed; run them again",
        request.case_file, folder.string()));
  return run;
}

std::set<int> realizations_in(const PartRecord& record) {
  std::set<int> members;
  for (const std::size_t member : record.members)
    members.insert(static_cast<int>(member));
  return members;
}

/// Returns why a part is not complete; empty if it is.
std::string lack_of(const PartRecord& record, const NamedCases& named,
                    const fs::path& folder) {
  const PartRequest& request = record.request;
  const auto lack = [&](const cases::Case& contact_case, const fs::path& place,
                        const std::set<int>& only) {
    const EarlierRun found =
        earlier_run(contact_case,
                    methods::chosen_methods(contact_case, request.methods,
                                            request.is_exact),
                    folder / place, only);
    if (found.state != RunState::complete)
      return fmt::format("{} {}", place.string(), found.why);
    if (!named.sweep && found.case_hash != record.case_hashes.front())
      return place.string() + " has a case that is written differently";
    return std::string();
  };
  if (!named.sweep)
    return lack(named.cases.front().contact_case, part_folder(record.part),
                realizations_in(record));
  for (const std::size_t point : record.members)
    if (std::string text = lack(named.sweep->sweep.points[point].contact_case,
                                reports::point_folder(point), {});
        !text.empty())
      return text;
  return "";
}

void require_all_complete(const WholeRun& run, const fs::path& folder) {
  std::string text;
  int n_lacking = 0;
  for (const PartRecord& record : run.parts)
    if (const std::string lack = lack_of(record, run.named, folder);
        !lack.empty()) {
      ++n_lacking;
      text += fmt::format("\npart {}: {}\n  {}", part_text(record.part), lack,
                          part_command(record, folder));
    }
  if (n_lacking > 0)
    throw input::InputError(fmt::format(
        "{}: {} of {} parts {} missing or incomplete; run{}", folder.string(),
        n_lacking, run.parts.size(), n_lacking == 1 ? "is" : "are", text));
}

/// Copies what the methods wrote beside the result of a part, such as
/// "fem-3/block.vtu".
void copy_files_of_methods(const std::vector<cases::MethodSpec>& methods,
                           const PartRecord& record, const fs::path& folder) {
  for (const cases::MethodSpec& method : methods)
    for (const std::size_t r : record.members) {
      const std::string name = fmt::format("{}-{}", method.name, r);
      const fs::path source = folder / part_folder(record.part) / name;
      if (fs::exists(source))
        fs::copy(source, folder / name,
                 fs::copy_options::recursive |
                     fs::copy_options::overwrite_existing);
    }
}

} // namespace

WholeRun read_whole_run(const fs::path& folder) {
  const std::vector<PartRecord> records = read_part_records(folder);
  if (records.empty())
    throw input::InputError(fmt::format(
        "{}: has no parts; asperity run CASE --out {} --part I/N computes one",
        folder.string(), folder.string()));
  require_one_run(records, folder);
  WholeRun run = run_of(records.front(), folder);
  require_all_complete(run, folder);
  return run;
}

void merge_realizations(const WholeRun& run, const fs::path& folder) {
  const cases::Case& contact_case = run.named.cases.front().contact_case;
  const PartRequest& request = run.parts.front().request;
  const std::vector<cases::MethodSpec> methods =
      methods::chosen_methods(contact_case, request.methods, request.is_exact);
  if (const EarlierRun whole = earlier_run(contact_case, methods, folder);
      whole.state == RunState::complete &&
      whole.case_hash == run.parts.front().case_hashes.front())
    return;
  const fs::path joined = folder / "parts" / "joined";
  fs::remove_all(joined);
  std::vector<fs::path> parts;
  for (const PartRecord& record : run.parts)
    parts.push_back(folder / part_folder(record.part));
  results::join_results(parts, joined);
  put_last_run_aside(folder);
  for (const PartRecord& record : run.parts)
    copy_files_of_methods(methods, record, folder);
  fs::rename(joined / "result.h5", folder / "result.h5");
  fs::remove_all(joined);
}

} // namespace asperity::run
