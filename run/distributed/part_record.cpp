#include "run/distributed/part_record.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "cases/reader/case_hash.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "methods/chosen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;
using PartJson = nlohmann::ordered_json;

constexpr const char* part_file = "part.json";

PartRecord part_record_in(const PartJson& json) {
  PartRecord record;
  record.case_name = json.at("case").get<std::string>();
  const PartJson& request = json.at("request");
  record.request = {
      request.at("case_file").get<std::string>(),
      request.at("set").get<std::vector<std::string>>(),
      request.at("methods").get<std::vector<std::string>>(),
      request.at("exactly").get<bool>(),
      request.at("contact_modulus").get<std::string>(),
  };
  record.is_sweep = json.at("members_are").get<std::string>() == "points";
  record.case_hashes = json.at("case_hashes").get<std::vector<std::string>>();
  record.part = {json.at("part").get<int>(), json.at("parts").get<int>()};
  record.members = json.at("members").get<std::vector<std::size_t>>();
  return record;
}

PartRecord read_part_record(const fs::path& path) {
  const std::string text =
      input::read_input_file(path, input::largest_text_file);
  try {
    const PartJson json = json_of_text(text);
    if (json.at("format") != "asperity-part" || json.at("format_version") != 1)
      throw input::InputError(path.string() +
                              ": is not a part.json of this version");
    return part_record_in(json);
  } catch (const PartJson::exception& error) {
    throw input::InputError(path.string() +
                            ": is not a part.json: " + error.what());
  }
}

} // namespace

std::vector<PartRecord> part_records(const NamedCases& named,
                                     const PartRequest& request, int n_parts) {
  PartRecord record;
  record.request = request;
  record.is_sweep = named.sweep.has_value();
  std::vector<double> costs;
  if (named.sweep) {
    record.case_name = named.sweep->sweep.name;
    for (const cases::SweptPoint& point : named.sweep->sweep.points)
      record.case_hashes.push_back(cases::case_hash(point.contact_case));
    costs = point_costs(named.sweep->sweep, request.methods, request.is_exact);
  } else {
    const cases::Case& contact_case = named.cases.front().contact_case;
    record.case_name = named.cases.front().found.name;
    record.case_hashes = {cases::case_hash(contact_case)};
    costs = realization_costs(
        contact_case, methods::chosen_methods(contact_case, request.methods,
                                              request.is_exact));
  }
  if (n_parts == 0)
    n_parts = static_cast<int>(costs.size());
  if (static_cast<std::size_t>(n_parts) > costs.size())
    throw input::InputError(fmt::format(
        "{} parts: {} has {} {}, so that the number of parts must lie between "
        "1 and {}",
        n_parts, record.case_name, costs.size(),
        record.is_sweep ? "points" : "realisation(s)", costs.size()));
  std::vector<PartRecord> records;
  for (std::vector<std::size_t>& members : shares(costs, n_parts)) {
    record.part = {static_cast<int>(records.size()) + 1, n_parts};
    record.members = std::move(members);
    records.push_back(record);
  }
  return records;
}

fs::path part_folder(const Part& part) {
  return fs::path("parts") / fmt::format("{}-of-{}", part.number, part.count);
}

std::string quoted_word(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyz"
                                "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  std::string quoted = "'";
  for (const char letter : word)
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::vector<std::string> run_arguments(const PartRecord& record,
                                       const fs::path& folder) {
  const PartRequest& request = record.request;
  std::vector<std::string> words{"run", request.case_file};
  const auto add = [&](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  for (const std::string& entry : request.overrides)
    add({"--set", entry});
  for (const std::string& method : request.methods)
    add({"--methods", method});
  if (request.is_exact)
    add({"--exactly"});
  if (!request.contact_modulus.empty())
    add({"--contact-modulus", request.contact_modulus});
  add({"--out", folder.string()});
  return words;
}

std::string run_command(const PartRecord& record, const fs::path& program,
                        const fs::path& folder) {
  std::string command = quoted_word(program.string());
  for (const std::string& word : run_arguments(record, folder))
    command += " " + quoted_word(word);
  return command;
}

std::string part_command(const PartRecord& record, const fs::path& folder) {
  return run_command(record, "asperity", folder) + " --part " +
         part_text(record.part);
}

bool write_part_record(const PartRecord& record, const fs::path& folder) {
  const PartRequest& request = record.request;
  const PartJson json = {
      {"format", "asperity-part"},
      {"format_version", 1},
      {"case", record.case_name},
      {"part", record.part.number},
      {"parts", record.part.count},
      {"members_are", record.is_sweep ? "points" : "realizations"},
      {"members", record.members},
      {"case_hashes", record.case_hashes},
      {"request",
       {{"case_file", request.case_file},
        {"set", request.overrides},
        {"methods", request.methods},
        {"exactly", request.is_exact},
        {"contact_modulus", request.contact_modulus}}},
  };
  const fs::path file = folder / part_folder(record.part) / part_file;
  const bool is_new = !fs::exists(file);
  write_file_atomically(file, text_of_json(json, 2) + "\n");
  return is_new;
}

void remove_part_record(const PartRecord& record, const fs::path& folder) {
  fs::remove(folder / part_folder(record.part) / part_file);
}

std::vector<PartRecord> read_part_records(const fs::path& folder) {
  std::vector<PartRecord> records;
  std::error_code none; // no folder of parts
  for (const auto& entry : fs::directory_iterator(folder / "parts", none))
    if (fs::exists(entry.path() / part_file))
      records.push_back(read_part_record(entry.path() / part_file));
  std::ranges::sort(records, {}, [](const PartRecord& record) {
    return std::tuple(record.part.count, record.part.number);
  });
  return records;
}

} // namespace asperity::run
