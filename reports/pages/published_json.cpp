#include "reports/pages/published_json.hpp"

#include "base/json.hpp"
#include "reports/analysis/judgement.hpp"

#include <algorithm>
#include <vector>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

// Returns the verdict of the method that agrees best; a number that no method
// provides also has a verdict.
Reproduction best_of(const PublishedValue& published,
                     const std::vector<Judgement>& judgements) {
  if (judgements.empty())
    return compare_with_published(published.reference, {}).reproduction;
  return std::min_element(judgements.begin(), judgements.end(),
                          [](const Judgement& a, const Judgement& b) {
                            return a.reproduction < b.reproduction;
                          })
      ->reproduction;
}

Json our_json(const OurValue& ours, const Judgement& judgement) {
  return {{"method", ours.method},
          {"value", ours.estimate.value},
          {"half_width_95", ours.estimate.half_width},
          {"realizations", ours.estimate.realizations},
          {"remark", ours.estimate.remark},
          {"verdict", reproduction_word(judgement.reproduction)},
          {"words", judgement.words}};
}

} // namespace

Json published_json(const PublishedValue& published) {
  const cases::ReferenceValue& reference = published.reference;
  std::vector<Judgement> judgements;
  for (const OurValue& ours : published.ours)
    judgements.push_back(compare_with_published(reference, ours.estimate));
  Json json = {{"quantity", reference.quantity},
               {"value", reference.value},
               {"unit", reference.unit},
               {"uncertainty", reference.uncertainty},
               {"source", reference.source},
               {"why", reference.why},
               {"input", reference.input},
               {"line", published_line(published)},
               {"verdict", reproduction_word(best_of(published, judgements))},
               {"ours", Json::array()}};
  for (std::size_t i = 0; i < judgements.size(); ++i)
    json["ours"].push_back(our_json(published.ours[i], judgements[i]));
  return json;
}

} // namespace asperity::reports
