#include "reports/pages/paper_json.hpp"

#include "base/json.hpp"
#include "reports/analysis/claims.hpp"
#include "reports/pages/published_json.hpp"

#include <fmt/format.h>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

Json part_json(const PaperPart& part) {
  const Summary& summary = part.entry.summary;
  return {{"name", part.name},
          {"title", summary.case_title},
          {"case_hash", summary.case_hash},
          {"status", summary.status},
          {"all_ok", summary.all_ok()}};
}

/// How many published numbers have each verdict.
Json counts_of(const Json& published) {
  Json counts = {{"numbers", published.size()},
                 {"reproduced", 0},
                 {"inconclusive", 0},
                 {"differs", 0},
                 {"not_reproducible", 0},
                 {"input", 0},
                 {"missing", 0}};
  for (const Json& line : published) {
    Json& count = counts[line["verdict"].get<std::string>()];
    count = count.get<int>() + 1;
  }
  return counts;
}

std::string banner_of(const Json& counts) {
  const auto n = [&](const char* verdict) {
    return counts[verdict].get<int>();
  };
  return fmt::format(
      "Of {} published numbers and claims, each compared with the method that "
      "comes nearest: reproduced {}, inconclusive because our own interval is "
      "too wide {}, different by the amount stated {}, not reproducible for "
      "the reason stated {}, set by the case or fitted to it {}, without a "
      "computed value {}.",
      n("numbers"), n("reproduced"), n("inconclusive"), n("differs"),
      n("not_reproducible"), n("input"), n("missing"));
}

} // namespace

Json paper_json(std::span<const PaperPart> parts, const std::string& title) {
  Json json = {{"format", "asperity-paper"},
               {"format_version", 1},
               {"title", title},
               {"banner", ""},
               {"counts", Json::object()},
               {"parts", Json::array()},
               {"published", Json::array()}};
  for (const PaperPart& part : parts) {
    json["parts"].push_back(part_json(part));
    for (const PublishedValue& published : part.entry.summary.published) {
      Json line = {{"part", part.name}};
      line.update(published_json(published));
      line["meaning"] = meaning_of(published.reference.quantity);
      json["published"].push_back(line);
    }
  }
  json["counts"] = counts_of(json["published"]);
  json["banner"] = banner_of(json["counts"]);
  return json;
}

} // namespace asperity::reports
