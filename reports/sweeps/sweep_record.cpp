#include "reports/sweeps/sweep_record.hpp"

#include "base/json.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <fmt/format.h>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

const char* combine_word(cases::Combine combine) {
  return combine == cases::Combine::zip ? "zip" : "product";
}

/// Throws unless the record is one that a sweep can have.
void require_consistent(const SweepRecord& record, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    throw input::InputError(file + ": " + what);
  };
  if (record.keys.empty() || record.points.empty())
    refuse("has no swept key or no point");
  if (record.points.size() > cases::most_sweep_points)
    refuse(fmt::format("has more than {} points", cases::most_sweep_points));
  for (const PointRecord& point : record.points) {
    if (point.choice.size() != record.keys.size())
      refuse("choice of a point must have one number per swept key");
    for (std::size_t k = 0; k < record.keys.size(); ++k)
      if (point.choice[k] >= record.keys[k].values.size())
        refuse(fmt::format("choice of a point names value {} of {}, which has "
                           "{} values",
                           point.choice[k], record.keys[k].key,
                           record.keys[k].values.size()));
  }
}

SweepRecord record_in(const Json& json) {
  SweepRecord record;
  record.case_name = json.at("case").get<std::string>();
  record.title = json.at("title").get<std::string>();
  record.combine = json.at("combine").get<std::string>() == "zip"
                       ? cases::Combine::zip
                       : cases::Combine::product;
  for (const Json& key : json.at("keys"))
    record.keys.push_back({key.at("key").get<std::string>(),
                           key.at("values").get<std::vector<std::string>>()});
  for (const Json& point : json.at("points"))
    record.points.push_back({point.at("choice").get<std::vector<std::size_t>>(),
                             point.at("case_hash").get<std::string>(),
                             point.at("problem").get<std::string>()});
  return record;
}

} // namespace

std::string SweepRecord::label(std::size_t point) const {
  return cases::point_label(keys, points[point].choice);
}

std::string value_label(const std::string& value) {
  if (value.empty())
    return "none";
  const bool is_quoted =
      value.size() >= 2 && value.front() == '"' && value.back() == '"';
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

std::filesystem::path point_folder(std::size_t point) {
  return std::filesystem::path("points") / fmt::format("{:03}", point);
}

Json record_json(const SweepRecord& record) {
  Json json = {{"format", "asperity-sweep"},
               {"format_version", 1},
               {"case", record.case_name},
               {"title", record.title},
               {"combine", combine_word(record.combine)},
               {"keys", Json::array()},
               {"points", Json::array()}};
  for (const cases::SweptKey& key : record.keys)
    json["keys"].push_back({{"key", key.key}, {"values", key.values}});
  for (std::size_t i = 0; i < record.points.size(); ++i)
    json["points"].push_back({{"point", i},
                              {"folder", point_folder(i).string()},
                              {"label", record.label(i)},
                              {"choice", record.points[i].choice},
                              {"case_hash", record.points[i].case_hash},
                              {"problem", record.points[i].problem}});
  return json;
}

SweepRecord read_sweep_record(const std::filesystem::path& folder) {
  const std::string file = (folder / sweep_file).string();
  const std::string text =
      input::read_input_file(file, input::largest_number_file);
  SweepRecord record;
  try {
    const Json json = json_of_text(text);
    if (json.at("format") != "asperity-sweep" || json.at("format_version") != 1)
      throw input::InputError(file + ": is not a sweep.json of this version");
    record = record_in(json);
  } catch (const Json::exception& error) {
    throw input::InputError(file + ": is not a sweep.json: " + error.what());
  }
  require_consistent(record, file);
  return record;
}

} // namespace asperity::reports
