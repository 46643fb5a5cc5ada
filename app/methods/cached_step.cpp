#include "app/methods/cached_step.hpp"

#include "results/types/curve_columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

namespace asperity::app {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

/// Packs numbers as raw bytes instead of a list, because a map has a million of
/// them.
Json packed(const std::vector<double>& numbers) {
  Bytes bytes(numbers.size() * sizeof(double));
  if (!numbers.empty())
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

std::vector<double> unpacked(const Json& json) {
  const Bytes& bytes = json.get_binary();
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

/// Values of maps that are converted at a time.
constexpr std::size_t piece_values = std::size_t{1} << 18;

/// Maps with at least so many nodes are read from an entry by rows. Smaller
/// ones are written to the journal of a result, which is faster.
constexpr std::size_t least_nodes_by_rows = std::size_t{1} << 20;

template <class Number>
std::string_view bytes_of_numbers(std::span<const Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

template <class Number>
std::span<char> bytes_to_fill(std::span<Number> numbers) {
  return {reinterpret_cast<char*>(numbers.data()), numbers.size_bytes()};
}

/// Passes a map in single precision.
void pass_map(const results::MapRows& map, const TakeBytes& take) {
  std::vector<float> numbers;
  map([&](std::span<const double> values) {
    for (std::size_t at = 0; at < values.size(); at += piece_values) {
      const auto piece =
          values.subspan(at, std::min(piece_values, values.size() - at));
      numbers.assign(piece.size(), 0.0F);
      std::ranges::transform(piece, numbers.begin(), [](double value) {
        return static_cast<float>(value);
      });
      take(bytes_of_numbers(std::span<const float>(numbers)));
    }
  });
}

/// A map of an entry, which stays open until it is read.
results::MapRows map_in(const std::shared_ptr<CacheEntry>& entry,
                        std::uintmax_t begin, std::size_t nodes) {
  return [entry, begin, nodes](const results::TakeValues& take) {
    entry->go_to(begin);
    std::vector<float> numbers;
    std::vector<double> values;
    for (std::size_t at = 0; at < nodes; at += piece_values) {
      numbers.resize(std::min(piece_values, nodes - at));
      entry->read(bytes_to_fill(std::span(numbers)));
      values.assign(numbers.begin(), numbers.end());
      take(values);
    }
  };
}

std::vector<double> whole_map(const results::MapRows& rows, std::size_t nodes) {
  std::vector<double> map;
  map.reserve(nodes);
  rows([&](std::span<const double> values) {
    map.insert(map.end(), values.begin(), values.end());
  });
  return map;
}

/// Gives the maps of an entry to a step whose grid is known.
void take_maps(CacheEntry entry, std::uintmax_t begin, StepAnswer& answer) {
  const std::size_t nodes = answer.grid.size();
  const auto kept = std::make_shared<CacheEntry>(std::move(entry));
  const results::MapRows pressure = map_in(kept, begin, nodes);
  const results::MapRows gap =
      map_in(kept, begin + nodes * sizeof(float), nodes);
  if (nodes >= least_nodes_by_rows) {
    answer.rows = {answer.row.step, answer.row.nominal_pressure, pressure, gap};
    return;
  }
  answer.pressure = whole_map(pressure, nodes);
  answer.gap = whole_map(gap, nodes);
}

std::string cbor(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

/// Applies `take` to the decoded bytes. Returns nothing if the bytes have
/// another format.
template <class Kept, class Take>
std::optional<Kept> from_cbor(std::string_view bytes, const Take& take) {
  try {
    return take(Json::from_cbor(bytes.begin(), bytes.end()));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::vector<double> row_numbers(const results::CurvePoint& row) {
  std::vector<double> numbers;
  for (const results::CurveColumn& column : results::curve_columns())
    numbers.push_back(column.get(row));
  return numbers;
}

results::CurvePoint row_of(const std::vector<double>& numbers) {
  results::CurvePoint row;
  std::size_t place = 0;
  for (const results::CurveColumn& column : results::curve_columns())
    if (place < numbers.size())
      column.set(row, numbers[place++]);
  return row;
}

Json table_json(const results::Table& table) {
  Json columns = Json::array();
  for (const results::Column& column : table.columns)
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"values", packed(column.values)}});
  return {{"name", table.name}, {"title", table.title}, {"columns", columns}};
}

results::Table table_in(const Json& json) {
  results::Table table;
  table.name = json.at("name").get<std::string>();
  table.title = json.at("title").get<std::string>();
  for (const Json& column : json.at("columns"))
    table.columns.push_back({column.at("name").get<std::string>(),
                             column.at("unit").get<std::string>(),
                             unpacked(column.at("values"))});
  return table;
}

} // namespace

StepEntry entry_of(const CachedStep& step) {
  const StepAnswer& answer = step.answer;
  const Grid& grid = answer.grid;
  std::string head =
      cbor({{"row", packed(row_numbers(answer.row))},
            {"note", answer.row.note},
            {"points", {grid.points_x, grid.points_y}},
            {"length", packed({grid.length_x, grid.length_y})},
            {"maps", step.has_maps()},
            {"section", answer.section ? table_json(*answer.section) : Json()},
            {"setup", packed({step.setup_cpu_time})},
            {"found", step.found_at_setup}});
  std::string size(sizeof(std::uint64_t), '\0');
  const std::uint64_t length = head.size();
  std::memcpy(size.data(), &length, size.size());
  head.insert(0, size);
  const std::size_t nodes = step.has_maps() ? grid.size() : 0;
  return {head.size() + 2 * sizeof(float) * nodes,
          [head, &answer, nodes](const TakeBytes& take) {
            take(head);
            if (nodes == 0)
              return;
            pass_map(answer.rows ? answer.rows->pressure
                                 : results::rows_of_map(answer.pressure),
                     take);
            pass_map(answer.rows ? answer.rows->gap
                                 : results::rows_of_map(answer.gap),
                     take);
          }};
}

std::string bytes_of(const results::Table& table) {
  return cbor(table_json(table));
}

StepEntry entry_of(const SavedState& state) {
  return {state.count * sizeof(double), [&state](const TakeBytes& take) {
            state.numbers([&](std::span<const double> numbers) {
              take(bytes_of_numbers(numbers));
            });
          }};
}

std::optional<CachedStep> cached_step(CacheEntry entry) {
  std::uint64_t length = 0;
  constexpr std::uintmax_t before = sizeof(length);
  if (entry.size() < before)
    return std::nullopt;
  entry.read(bytes_to_fill(std::span(&length, 1)));
  if (length > entry.size() - before)
    return std::nullopt;
  std::string head(length, '\0');
  entry.read(head);
  return from_cbor<CachedStep>(head, [&](const Json& json) {
    CachedStep step;
    StepAnswer& answer = step.answer;
    answer.row = row_of(unpacked(json.at("row")));
    answer.row.note = json.at("note").get<std::string>();
    const std::vector<double> sides = unpacked(json.at("length"));
    answer.grid = {json.at("points").at(0).get<int>(),
                   json.at("points").at(1).get<int>(), sides.at(0),
                   sides.at(1)};
    if (!json.at("section").is_null())
      answer.section = table_in(json.at("section"));
    step.setup_cpu_time = unpacked(json.at("setup")).at(0);
    step.found_at_setup = json.at("found").get<std::string>();
    const std::uintmax_t maps = entry.size() - before - length;
    const bool has_maps = json.at("maps");
    if (maps != (has_maps ? 2 * sizeof(float) * answer.grid.size() : 0))
      return std::optional<CachedStep>();
    if (has_maps)
      take_maps(std::move(entry), before + length, answer);
    return std::optional(std::move(step));
  });
}

std::optional<results::Table> kept_table(std::string_view bytes) {
  return from_cbor<results::Table>(bytes, table_in);
}

std::optional<StateReader> kept_state(CacheEntry entry) {
  if (entry.size() % sizeof(double) != 0)
    return std::nullopt;
  const std::size_t count = entry.size() / sizeof(double);
  return StateReader{
      count, [kept = std::make_shared<CacheEntry>(std::move(entry))](
                 std::span<double> next) { kept->read(bytes_to_fill(next)); }};
}

} // namespace asperity::app
