#include "reports/analysis/verdict.hpp"
#include "reports/numbers/determined.hpp"

#include <fmt/format.h>

namespace asperity::reports {
namespace {

std::string ours_text(const OurValue& ours) {
  return ours.estimate.has_value()
             ? fmt::format("{} {:.4g}", ours.method, ours.estimate.value)
             : fmt::format("{} {} ({})", ours.method, undetermined_word,
                           ours.estimate.remark);
}

} // namespace

std::vector<PublishedValue>
beside_ours(std::span<const cases::ReferenceValue> references,
            std::span<const MethodSummary> methods) {
  std::vector<PublishedValue> published;
  for (const cases::ReferenceValue& reference : references) {
    PublishedValue one{reference, {}};
    for (const MethodSummary& method : methods)
      if (const auto found = method.quantities.find(reference.quantity);
          found != method.quantities.end())
        one.ours.push_back({method.name, found->second});
    published.push_back(std::move(one));
  }
  return published;
}

std::string published_text(const cases::ReferenceValue& reference) {
  std::string text = fmt::format("{:.6g}", reference.value);
  if (reference.uncertainty > 0.0)
    text += fmt::format(" +- {:.2g}", reference.uncertainty);
  return reference.unit == "1" ? text : text + " " + reference.unit;
}

std::string published_line(const PublishedValue& published) {
  const cases::ReferenceValue& reference = published.reference;
  std::string line = fmt::format(
      "{:<9}  {:<20} {}", reference.uncertainty > 0.0 ? "paper" : "exact",
      reference.quantity, published_text(reference));
  for (std::size_t i = 0; i < published.ours.size(); ++i)
    line += (i == 0 ? ": " : ", ") + ours_text(published.ours[i]);
  return published.ours.empty() ? line + ": not computed" : line;
}

} // namespace asperity::reports
