#include "base/json.hpp"
#include "reports/pages/paper_table.hpp"
#include "reports/pages/published_json.hpp"

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const PaperCounts& counts) {
  return {{"numbers", counts.numbers},
          {"reproduced", counts.reproduced},
          {"inconclusive", counts.inconclusive},
          {"differs", counts.differs},
          {"not_reproducible", counts.not_reproducible},
          {"input", counts.input},
          {"missing", counts.missing}};
}

Json to_json(const PaperPart& part) {
  const Summary& summary = part.entry.summary;
  return {{"name", part.name},
          {"title", summary.case_title},
          {"case_hash", summary.case_hash},
          {"status", summary.status},
          {"all_ok", summary.all_ok()}};
}

} // namespace

std::string paper_json(std::span<const PaperPart> parts,
                       const PaperTable& table, const std::string& title) {
  Json json = {{"format", "asperity-paper"},
               {"format_version", 1},
               {"title", title},
               {"banner", table.banner()},
               {"counts", to_json(table.counts())},
               {"parts", Json::array()},
               {"published", Json::array()}};
  for (const PaperPart& part : parts) {
    json["parts"].push_back(to_json(part));
    for (const PublishedValue& published : part.entry.summary.published) {
      Json line = {{"part", part.name}};
      line.update(published_json(published));
      json["published"].push_back(line);
    }
  }
  return text_of_json(json, 2) + "\n";
}

} // namespace asperity::reports
