#include "run/arguments/named_cases.hpp"

#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "input/reader/base_case.hpp"
#include "input/reader/read_case.hpp"
#include "input/refusals.hpp"
#include "input/text/toml_text.hpp"
#include "reports/pages/paper_report.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/arguments/map_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
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

bool has_loads(const std::vector<std::string>& entries) {
  return std::ranges::any_of(entries, [](const std::string& entry) {
    return entry.starts_with("load=") || entry.starts_with("load.mean_gap=") ||
           entry.starts_with("load.nominal_pressure");
  });
}

void throw_if_any(const input::Refusals& refusals, const CaseOptions& options,
                  bool has_hints) {
  if (!refusals.empty())
    throw input::InputError(options.with_options(refusals.text(), has_hints));
}

/// The entries of the case of maps that stand for options, with loads.
/// @param made  path of the case that is made, for refusals
std::vector<std::string>
entries_of_maps(NamedMaps& maps, const std::vector<std::string>& overrides,
                const CaseOptions& options, const std::filesystem::path& made) {
  constexpr double lightest = 0.01;     // p/(E* h') of 1.6 % contact area
  constexpr double largest = 0.8;       // p/(E* h') of 89 %
  constexpr double largest_share = 0.9; // of the hardness
  const bool has_free_edges =
      std::ranges::any_of(overrides, [](const std::string& entry) {
        return entry == "surface.edges=free" ||
               entry == "surface.edges=\"free\"";
      });
  input::Refusals refusals;
  std::vector<std::string> entries = options.overrides(
      {.are_maps = true, .has_free_edges = has_free_edges}, refusals);
  cases::Case first;
  std::pair<double, double> slopes;
  std::optional<mechanics::SurfaceSpec> surface;
  try {
    surface = map_surface(maps.files.front().string(), options, overrides);
  } catch (const input::InputError&) { // refused above or below
  }
  refusals.of([&] {
    first = without_lines_of(made, [&] {
      return cases::read_case_text(map_case_text(maps.files.front(), entries),
                                   made.string(), overrides);
    });
  });
  if (surface)
    refusals.of([&] { slopes = examine_maps(maps, *surface); });
  throw_if_any(refusals, options, true);
  const double modulus = first.material.contact_modulus;
  if (maps.files.size() > 1 && has_free_edges && !has_loads(overrides) &&
      options.has("--work-of-adhesion") && !options.has("--pressure"))
    entries.push_back("load.nominal_pressure=" +
                      adhesive_loads(modulus * slopes.second));
  if (has_loads(overrides) || has_loads(entries))
    return entries;
  double highest = std::numeric_limits<double>::infinity();
  const mechanics::Scales scales{.contact_modulus = modulus,
                                 .rms_slope = slopes.second};
  for (const cases::MethodSpec& method : first.methods)
    if (const auto hardness = method.hardness())
      highest = std::min(highest, largest_share * hardness->in_si(scales));
  const double heaviest = std::min(largest * modulus * slopes.second, highest);
  entries.push_back("load.nominal_pressure=" +
                    round_loads(std::min(lightest * modulus * slopes.first,
                                         lightest * heaviest),
                                heaviest, highest));
  return entries;
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

std::vector<std::string>
with_overrides_of(const CaseOptions& options,
                  const std::vector<std::string>& overrides,
                  input::Refusals& refusals) {
  std::vector<std::string> all = options.overrides({}, refusals);
  all.insert(all.end(), overrides.begin(), overrides.end());
  return all;
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

/// An override "key=value" as a line of TOML, in which a word that is no TOML
/// value is a text.
std::string toml_entry(const std::string& entry) {
  const std::size_t equals = entry.find('=');
  const std::string value = entry.substr(equals + 1);
  if (value.empty())
    return entry;
  try {
    cases::parse_toml_value(value, {}, entry.substr(0, equals));
    return entry;
  } catch (const input::InputError&) {
    return entry.substr(0, equals + 1) + cases::toml_value(value);
  }
}

void rename_case(NamedCases& named, const std::string& name) {
  named.found.cases.front().name = name;
  if (named.sweep)
    named.sweep->sweep.name = name;
  for (ReadCase& read : named.cases)
    read.found.name = read.contact_case.name = name;
}

} // namespace

NamedCases read_maps(NamedMaps& maps, const std::vector<std::string>& overrides,
                     const CaseOptions& options,
                     const std::filesystem::path& folder) {
  const bool is_one = maps.folders.empty() && maps.files.size() == 1;
  const std::filesystem::path made =
      is_one ? std::filesystem::path(maps.files.front()).replace_extension()
             : folder / reports::maps_file;
  const std::vector<std::string> entries =
      entries_of_maps(maps, overrides, options, made);
  NamedCases named;
  if (is_one) {
    named.cases.push_back(
        {{{}, made.filename().string()},
         without_lines_of(made,
                          [&] {
                            return cases::read_case_text(
                                maps.origin +
                                    map_case_text(maps.files.front(), entries),
                                made.string(), overrides);
                          }),
         "",
         overrides});
    named.found.cases.push_back(named.cases.front().found);
    return named;
  }
  NamedSweep sweep{{made, name_of_folder(folder)}, {}, overrides};
  sweep.text = maps_sweep_text(maps.files, entries);
  sweep.sweep = without_lines_of(made, [&] {
    return cases::read_sweep({sweep.text, made.string(), {}}, overrides);
  });
  sweep.sweep.name = sweep.found.name;
  named.found.cases.push_back(sweep.found);
  named.sweep = std::move(sweep);
  return named;
}

std::string text_of_map(const std::string& file, const CaseOptions& options,
                        const std::vector<std::string>& overrides,
                        const std::filesystem::path& path) {
  NamedMaps maps{{path_of_map(file)}, {}, {}};
  std::vector<std::string> entries =
      entries_of_maps(maps, overrides, options, path);
  std::ranges::transform(overrides, std::back_inserter(entries), toml_entry);
  return map_case_text(path_of_map(file, path.parent_path().string()), entries);
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
                                     const CaseOptions& options) {
  if (is_map_file(word))
    return read_named_cases(word, overrides, is_quick, options);
  FoundCases found = find_cases(word);
  input::Refusals refusals;
  const std::vector<std::string> all =
      with_overrides_of(options, overrides, refusals);
  if (!found.collection.empty() ||
      !cases::is_sweep(found.cases.front().file.string(), all))
    return read_named_cases(word, overrides, is_quick, options);
  NamedSweep sweep;
  refusals.of(
      [&] { sweep = read_sweep_called(found.cases.front(), all, is_quick); });
  throw_if_any(refusals, options, false);
  return {std::move(found), {}, std::move(sweep)};
}

NamedCases read_named_cases(const std::string& word,
                            const std::vector<std::string>& overrides,
                            bool is_quick, const CaseOptions& options) {
  if (is_map_file(word)) {
    NamedMaps map{{path_of_map(word)}, {}, {}};
    return read_maps(map, overrides, options);
  }
  NamedCases named{find_cases(word), {}};
  input::Refusals refusals;
  const std::vector<std::string> all =
      with_overrides_of(options, overrides, refusals);
  refusals.of([&] {
    for (const FoundCase& found : named.found.cases)
      named.cases.push_back(read_with_reference(found, all, is_quick));
  });
  throw_if_any(refusals, options, false);
  return named;
}

} // namespace asperity::run
