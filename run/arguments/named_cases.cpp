#include "run/arguments/named_cases.hpp"

#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "input/reader/base_case.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_text.hpp"
#include "reports/pages/paper_report.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/arguments/map_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace asperity::run {
namespace {

/// Adds the overrides of quick.set before the others, and a title that says so.
/// @param title  of the whole case
void add_quick(std::vector<std::string>& overrides, const FoundCase& found,
               const std::string& name, const char* what,
               const std::string& title) {
  std::vector<std::string> quick = quick_overrides(found.file);
  if (quick.empty())
    fmt::print("{}: there is no quick.set next to the case file; the full {} "
               "runs\n",
               name, what);
  else
    quick.push_back("title=" + cases::toml_value(title + reports::quick_mark));
  overrides.insert(overrides.begin(), quick.begin(), quick.end());
}

ReadCase read_with_reference(const FoundCase& found,
                             std::vector<std::string> overrides,
                             bool is_quick) {
  const std::string file = found.file.string();
  if (is_quick) {
    const cases::Case whole = cases::read_case(file);
    add_quick(overrides, found, whole.name, "case", whole.title);
  }
  ReadCase read{found, cases::read_case(file, overrides), "", overrides};
  read.reference = reference_text_of(read.contact_case);
  if (read.found.name.empty())
    read.found.name = read.contact_case.name;
  return read;
}

std::string name_of_folder(const std::filesystem::path& folder) {
  const std::filesystem::path path =
      std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename();
}

/// The case of a map, which has no case file.
NamedCases asked_map(const MapOfCase& map,
                     const std::vector<std::string>& overrides) {
  const std::filesystem::path file =
      std::filesystem::path(map.file).replace_extension();
  NamedCases named;
  const auto read = [&] {
    return cases::read_case_text(map_case_text(map), file.string(), overrides);
  };
  named.cases.push_back({{{}, file.filename().string()},
                         without_lines_of(file, read),
                         "",
                         overrides});
  named.found.cases.push_back(named.cases.front().found);
  return named;
}

NamedSweep read_sweep_called(const FoundCase& found,
                             std::vector<std::string> overrides,
                             bool is_quick) {
  const std::string file = found.file.string();
  if (is_quick)
    add_quick(overrides, found, file, "sweep", cases::read_sweep(file).title);
  NamedSweep named{found, cases::read_sweep(file, overrides), overrides};
  if (is_of_maps(named))
    named.sweep.name = name_of_folder(found.file.parent_path());
  (void)reference_text_of(named.sweep.points.front().contact_case); // mistakes
  return named;
}

/// The file that an argument stands for, however it is written.
std::filesystem::path file_of(const NamedCases& named,
                              const std::string& word) {
  const std::filesystem::path& file = named.found.cases.front().file;
  return std::filesystem::weakly_canonical(
      file.empty() ? std::filesystem::path(word) : file);
}

/// The last two folders of a path that ends with the name of a case or map.
std::string name_with_folder(std::filesystem::path file,
                             const std::string& name) {
  if (file.filename() == "case.toml")
    file = file.parent_path();
  return file.parent_path().filename().string() + "-" + name;
}

void rename_case(NamedCases& named, const std::string& name) {
  named.found.cases.front().name = name;
  if (named.sweep)
    named.sweep->sweep.name = name;
  for (ReadCase& read : named.cases)
    read.found.name = read.contact_case.name = name;
}

} // namespace

NamedCases read_maps(const std::vector<std::filesystem::path>& files,
                     const std::vector<std::string>& overrides,
                     const std::string& contact_modulus,
                     const std::filesystem::path& folder) {
  NamedSweep named{
      {folder / reports::maps_file, name_of_folder(folder)}, {}, overrides};
  named.text = maps_sweep_text(files, contact_modulus);
  named.sweep = without_lines_of(named.found.file, [&] {
    return cases::read_sweep({named.text, named.found.file.string(), {}},
                             overrides);
  });
  named.sweep.name = named.found.name;
  NamedCases maps;
  maps.found.cases.push_back(named.found);
  maps.sweep = std::move(named);
  return maps;
}

bool is_of_maps(const NamedSweep& sweep) {
  return sweep.found.file.filename() == reports::maps_file;
}

std::filesystem::path made_case_of(const NamedCases& named) {
  if (named.sweep)
    return named.sweep->text.empty() ? std::filesystem::path()
                                     : named.sweep->found.file;
  const ReadCase& first = named.cases.front();
  return first.found.file.empty()
             ? std::filesystem::path(first.contact_case.path)
             : std::filesystem::path();
}

OutputNames outputs_of(const NamedSweep& sweep) {
  OutputNames names = sweep_outputs();
  if (!sweep.text.empty())
    names.emplace_back(reports::maps_file);
  return names;
}

void write_made_case(const NamedSweep& sweep) {
  if (!sweep.text.empty())
    write_file_atomically(sweep.found.file, sweep.text);
}

std::string output_name(const NamedCases& named) {
  return !named.found.collection.empty() ? named.found.collection
         : named.sweep                   ? named.sweep->sweep.name
                                         : named.cases.front().found.name;
}

void name_apart(std::vector<NamedCases>& all,
                const std::vector<std::string>& words) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const NamedCases& named : all)
    names.push_back(output_name(named));
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::filesystem::path file = file_of(all[i], words[i]);
    const auto is_other = [&](std::size_t j) {
      return names[j] == names[i] && file_of(all[j], words[j]) != file;
    };
    bool is_ambiguous = false;
    for (std::size_t j = 0; j < all.size(); ++j)
      is_ambiguous = is_ambiguous || is_other(j);
    if (is_ambiguous && all[i].found.collection.empty())
      rename_case(all[i], name_with_folder(file, names[i]));
    const auto [first, is_new] = taken.emplace(output_name(all[i]), i);
    if (!is_new && file_of(all[first->second], words[first->second]) != file)
      throw input::InputError(fmt::format(
          "{} and {} would be written into one folder, {}; please run them one "
          "by one, with --out",
          words[first->second], words[i], first->first));
  }
}

NamedCases read_named_cases_or_sweep(const std::string& word,
                                     const std::vector<std::string>& overrides,
                                     bool is_quick,
                                     const std::string& contact_modulus) {
  if (is_map_file(word) || !contact_modulus.empty())
    return read_named_cases(word, overrides, is_quick, contact_modulus);
  FoundCases found = find_cases(word);
  if (!found.collection.empty() ||
      !cases::is_sweep(found.cases.front().file.string(), overrides))
    return read_named_cases(word, overrides, is_quick);
  NamedSweep sweep =
      read_sweep_called(found.cases.front(), overrides, is_quick);
  return {std::move(found), {}, std::move(sweep)};
}

NamedCases read_named_cases(const std::string& word,
                            const std::vector<std::string>& overrides,
                            bool is_quick, const std::string& contact_modulus) {
  if (is_map_file(word))
    return asked_map({word, contact_modulus}, overrides);
  NamedCases named{find_cases(word), {}};
  if (!contact_modulus.empty())
    throw input::InputError(
        fmt::format("--contact-modulus applies only to a measured map, but {} "
                    "is a case: please use --set material.contact_modulus=...",
                    word));
  for (const FoundCase& found : named.found.cases)
    named.cases.push_back(read_with_reference(found, overrides, is_quick));
  return named;
}

} // namespace asperity::run
