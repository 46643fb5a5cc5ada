#include "suite/robustness/matrix.hpp"

#include "base/json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace asperity::robustness {
namespace {

using nlohmann::json;

std::string quoted_field(std::string text) {
  std::ranges::replace(text, '"', '\'');
  std::ranges::replace(text, '\n', ' ');
  return '"' + text + '"';
}

std::string outcome_text(const InstanceReport& report) {
  return name_of(report.outcome) +
         (report.check.empty() ? "" : ": " + report.check);
}

json counts_json(const Counts& counts) {
  json object;
  for (int i = 0; i < n_outcomes; ++i)
    object[name_of(static_cast<Outcome>(i))] =
        counts.of(static_cast<Outcome>(i));
  return object;
}

} // namespace

int Counts::all() const {
  return std::accumulate(by_outcome.begin(), by_outcome.end(), 0);
}

int Counts::others() const {
  return all() - of(Outcome::verified) - of(Outcome::refused);
}

void Matrix::add(const InstanceResult& result) {
  const auto& [instance, report] = result;
  const auto outcome = static_cast<std::size_t>(report.outcome);
  ++total_.by_outcome[outcome];
  seconds_ += report.seconds;
  for (const auto& bin : instance.labels)
    ++bins_[bin].by_outcome[outcome];
  if (!is_good(report.outcome))
    others_.push_back(result);
  if (!report.has_pair)
    return;
  RelationCounts& pair = relations_[instance.label("metamorphic pair")];
  ++pair.pairs;
  pair.same_bits += report.has_same_bits ? 1 : 0;
  pair.largest_difference =
      std::max(pair.largest_difference, report.pair_difference);
}

Counts Matrix::of(const std::string& axis, const std::string& label) const {
  const auto found = bins_.find({axis, label});
  return found == bins_.end() ? Counts{} : found->second;
}

std::string csv_header() {
  std::string line =
      "seed,instance,outcome,check,reason,iterations,area fraction [1],"
      "mean gap [h_rms],pair same bits,pair difference [tolerance],"
      "CPU time [s]";
  for (const Axis& axis : axes())
    line += "," + axis.name;
  return line + ",case\n";
}

std::string csv_line(const InstanceResult& result) {
  const auto& [instance, report] = result;
  const std::string pair_bits =
      report.has_pair ? (report.has_same_bits ? "yes" : "no") : "";
  std::string line = fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{:.3f}", instance.seed, instance.index,
      name_of(report.outcome), report.check, quoted_field(report.reason),
      report.iterations, report.area, report.reduced_gap, pair_bits,
      report.pair_difference, report.seconds);
  for (const Axis& axis : axes())
    line += "," + instance.label(axis.name);
  return line + "," +
         quoted_field(fmt::format(
             "{} {}", instance.file.empty() ? instance.text : instance.file,
             fmt::join(instance.overrides, "; "))) +
         "\n";
}

std::string json_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking) {
  json root;
  root["command"] = run.rerun;
  root["commit"] = run.commit;
  root["machine"] = run.machine;
  root["seed"] = run.seed;
  root["wall_seconds"] = run.wall_seconds;
  root["cpu_seconds"] = matrix.seconds();
  root["instances"] = matrix.total().all();
  root["anything_else"] = matrix.total().others();
  root["outcomes"] = counts_json(matrix.total());
  for (const Axis& axis : axes())
    for (const std::string& label : axis.labels)
      if (const Counts counts = matrix.of(axis.name, label); counts.all() > 0)
        root["axes"][axis.name][label] = counts_json(counts);
  root["others"] = json::array();
  for (const auto& [instance, report] : matrix.others())
    root["others"].push_back({{"instance", instance.index},
                              {"outcome", name_of(report.outcome)},
                              {"check", report.check},
                              {"reason", report.reason},
                              {"words", text_of(instance)}});
  for (const auto& [pair, counts] : matrix.relations())
    root["metamorphic_pairs"][pair] = {
        {"pairs", counts.pairs},
        {"same_bits", counts.same_bits},
        {"largest_difference_over_tolerance", counts.largest_difference}};
  for (const LockingRow& row : locking)
    root["locking"].push_back({{"poisson_ratio", row.poisson_ratio},
                               {"thickness", row.thickness},
                               {"waves", row.waves},
                               {"q1", row.q1},
                               {"q2", row.q2}});
  return text_of_json(root, 2) + "\n";
}

std::string text_of(const Matrix& matrix, const RunDescription& run) {
  std::string text = fmt::format("{:14}{:>10}{:>10}{:>10}\n", "family",
                                 "verified", "refused", "other");
  for (const std::string& family : axes().front().labels)
    if (const Counts counts = matrix.of("family", family); counts.all() > 0)
      text += fmt::format("{:14}{:10}{:10}{:10}\n", family,
                          counts.of(Outcome::verified),
                          counts.of(Outcome::refused), counts.others());
  for (const auto& [pair, counts] : matrix.relations())
    text += fmt::format("metamorphic pairs, {}: {}, {} with the same bits, "
                        "mean gaps at most {:.2g} tolerances apart\n",
                        pair, counts.pairs, counts.same_bits,
                        counts.largest_difference);
  for (const auto& [instance, report] : matrix.others())
    text += fmt::format("{} --instance {}: {} {}\n", run.rerun, instance.index,
                        outcome_text(report), report.reason);
  return text;
}

} // namespace asperity::robustness
