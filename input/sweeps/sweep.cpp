#include "input/sweeps/sweep.hpp"

#include "input/reader/base_case.hpp"
#include "input/reader/read_case.hpp"
#include "input/reader/table_reader.hpp"
#include "input/sweeps/sweep_keys.hpp"
#include "input/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace asperity::cases {
namespace {

StackedText stacked_with(StackedText stacked,
                         const std::vector<std::string>& overrides) {
  for (const std::string& entry : overrides)
    stacked.overrides.push_back({entry, {"--set", 0}});
  return stacked;
}

std::vector<std::vector<std::size_t>>
choices_of(const std::vector<WrittenKey>& keys, Combine combine) {
  std::vector<std::vector<std::size_t>> choices(n_points(keys, combine));
  for (std::size_t point = 0; point < choices.size(); ++point) {
    std::size_t rest = point;
    choices[point].assign(keys.size(), point);
    if (combine == Combine::product)
      for (std::size_t k = keys.size(); k-- > 0;
           rest /= keys[k].values.size() == 0 ? 1 : keys[k].values.size())
        choices[point][k] = rest % keys[k].values.size();
  }
  return choices;
}

/// The words of an error after its first line, "1 mistake in the case file:".
std::string mistakes_in(const input::InputError& error) {
  const std::string whole = error.what();
  const std::size_t end = whole.find('\n');
  return end == std::string::npos ? whole : whole.substr(end + 1);
}

/// Reads the points. The mistakes of the first point that is no valid case are
/// reported, and how many others there are.
class PointReader {
public:
  PointReader(CaseSweep& sweep, const std::vector<WrittenKey>& written_keys,
              const StackedText& stacked)
      : sweep_(sweep), written_(written_keys), stacked_(stacked) {}

  void read() {
    const auto choices = choices_of(written_, sweep_.combine);
    for (const std::vector<std::size_t>& choice : choices)
      read_point(choice);
    if (bad_points_ > 0)
      throw input::InputError(fmt::format(
          "{}: {} of the {} points of [sweep] {}\n{}", sweep_.path, bad_points_,
          choices.size(),
          bad_points_ == 1 ? "is not a valid case" : "are not valid cases",
          first_mistake_));
  }

private:
  void read_point(const std::vector<std::size_t>& choice) {
    SweptPoint point{choice, {}, {}};
    StackedText whole = stacked_;
    const auto add = [&](const std::string& entry, const Place& place) {
      whole.overrides.push_back({entry, place});
      point.overrides.push_back(entry);
    };
    add("sweep=", {sweep_.path, 0});
    for (std::size_t k = 0; k < written_.size(); ++k)
      add(sweep_.keys[k].key + "=" + sweep_.keys[k].values[choice[k]],
          written_[k].values[choice[k]].place);
    const std::string label = point_label(sweep_.keys, choice);
    add("title=" + toml_value(sweep_.title + ": " + label), {sweep_.path, 0});
    try {
      point.contact_case = read_stacked_case(whole, sweep_.path);
    } catch (const input::InputError& error) {
      if (bad_points_++ == 0)
        first_mistake_ = fmt::format("Point {}, {}:\n{}", sweep_.points.size(),
                                     label, mistakes_in(error));
    }
    sweep_.points.push_back(std::move(point));
  }

  CaseSweep& sweep_;
  const std::vector<WrittenKey>& written_;
  const StackedText& stacked_;
  std::size_t bad_points_ = 0;
  std::string first_mistake_;
};

Combine read_combine(const Node& table, Mistakes& mistakes) {
  Node own =
      table; // without the swept keys, which the vocabulary does not list
  std::erase_if(own.entries,
                [](const NodeEntry& entry) { return entry.key != "combine"; });
  TableReader reader(own, vocabulary_table("sweep"), mistakes);
  return reader.choice("combine", Combine::product);
}

} // namespace

std::string point_label(const std::vector<SweptKey>& keys,
                        const std::vector<std::size_t>& choice) {
  std::string label;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::string& value = keys[k].values[choice[k]];
    label += fmt::format("{}{} {}", k == 0 ? "" : ", ", keys[k].key,
                         value.empty() ? "removed" : "= " + value);
  }
  return label;
}

std::string point_content(const std::string& text) {
  Node file = parsed({text, "point", {}});
  std::erase_if(file.entries,
                [](const NodeEntry& entry) { return entry.key == "sweep"; });
  return toml_value(file);
}

bool is_sweep(const std::string& path,
              const std::vector<std::string>& overrides) {
  return parsed(stacked_with(read_stacked(path), overrides)).find("sweep") !=
         nullptr;
}

CaseSweep read_sweep(const std::string& path,
                     const std::vector<std::string>& overrides) {
  return read_sweep(read_stacked(path), overrides);
}

CaseSweep read_sweep(StackedText file_text,
                     const std::vector<std::string>& overrides) {
  const StackedText stacked = stacked_with(std::move(file_text), overrides);
  const std::string& path = stacked.path;
  const Node file = parsed(stacked);
  const Node* const table = file.find("sweep");
  if (table == nullptr)
    input::throw_mistake({path, 0}, "the table [sweep] is missing");
  if (!table->is_table())
    input::throw_mistake(table->place, "sweep = " + written(*table) +
                                           ", but must be a table: [sweep]");
  Mistakes mistakes;
  CaseSweep sweep;
  sweep.path = path;
  sweep.name = case_name(path);
  const Node* const title = file.find("title");
  sweep.title = title != nullptr && title->type == NodeType::text ? title->text
                                                                  : sweep.name;
  sweep.combine = read_combine(*table, mistakes);
  const std::vector<WrittenKey> keys = read_swept_keys(*table, mistakes);
  mistakes.throw_if_any();
  check_swept_keys(*table, keys, sweep.combine, overrides, mistakes);
  mistakes.throw_if_any();
  for (const WrittenKey& key : keys) {
    sweep.keys.push_back({key.key, {}});
    for (const Node& value : key.values)
      sweep.keys.back().values.push_back(value_text(value));
  }
  PointReader(sweep, keys, stacked).read();
  return sweep;
}

} // namespace asperity::cases
