#include "app/methods/cached_step.hpp"

#include "results/types/curve_columns.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>

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

/// Packs a map in single precision, as in a result file.
Json packed_map(const std::vector<double>& map) {
  std::vector<float> numbers;
  numbers.reserve(map.size());
  for (const double value : map)
    numbers.push_back(static_cast<float>(value));
  Bytes bytes(numbers.size() * sizeof(float));
  if (!numbers.empty())
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

std::vector<double> unpacked_map(const Json& json) {
  const Bytes& bytes = json.get_binary();
  std::vector<float> numbers(bytes.size() / sizeof(float));
  if (!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(float));
  return {numbers.begin(), numbers.end()};
}

std::string cbor(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

/// Applies `take` to the decoded bytes. Returns nothing if the bytes have
/// another format.
template <class Kept, class Take>
std::optional<Kept> from_cbor(std::string_view bytes, Take take) {
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

std::string bytes_of(const CachedStep& step) {
  const Grid& grid = step.answer.grid;
  return cbor(
      {{"row", packed(row_numbers(step.answer.row))},
       {"note", step.answer.row.note},
       {"points", {grid.points_x, grid.points_y}},
       {"length", packed({grid.length_x, grid.length_y})},
       {"pressure", packed_map(step.answer.pressure)},
       {"gap", packed_map(step.answer.gap)},
       {"section",
        step.answer.section ? table_json(*step.answer.section) : Json()},
       {"setup", packed({step.setup_cpu_time})},
       {"found", step.found_at_setup}});
}

std::string bytes_of(const results::Table& table) {
  return cbor(table_json(table));
}

std::string bytes_of(const std::vector<double>& numbers) {
  return cbor(packed(numbers));
}

std::optional<CachedStep> cached_step(std::string_view bytes) {
  return from_cbor<CachedStep>(bytes, [](const Json& json) {
    CachedStep step;
    StepAnswer& answer = step.answer;
    answer.row = row_of(unpacked(json.at("row")));
    answer.row.note = json.at("note").get<std::string>();
    const std::vector<double> length = unpacked(json.at("length"));
    answer.grid = {json.at("points").at(0).get<int>(),
                   json.at("points").at(1).get<int>(), length.at(0),
                   length.at(1)};
    answer.pressure = unpacked_map(json.at("pressure"));
    answer.gap = unpacked_map(json.at("gap"));
    if (!json.at("section").is_null())
      answer.section = table_in(json.at("section"));
    step.setup_cpu_time = unpacked(json.at("setup")).at(0);
    step.found_at_setup = json.at("found").get<std::string>();
    return step;
  });
}

std::optional<results::Table> kept_table(std::string_view bytes) {
  return from_cbor<results::Table>(bytes, table_in);
}

std::optional<std::vector<double>> kept_numbers(std::string_view bytes) {
  return from_cbor<std::vector<double>>(
      bytes, [](const Json& json) { return unpacked(json); });
}

} // namespace asperity::app
