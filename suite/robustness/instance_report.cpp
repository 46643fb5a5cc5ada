#include "suite/robustness/instance_report.hpp"

#include "base/json.hpp"

#include <array>

namespace asperity::robustness {

bool is_good(Outcome outcome) {
  return outcome == Outcome::verified || outcome == Outcome::refused;
}

std::string name_of(Outcome outcome) {
  constexpr std::array<const char*, n_outcomes> names{
      "verified", "refused",   "check failed", "did not converge",
      "threw",    "timed out", "crashed"};
  return names.at(static_cast<std::size_t>(outcome));
}

Outcome outcome_of_note(
    std::string& note,
    const std::function<std::optional<std::string>()>& solve_directly) {
  if (note.find("must be \"direct\"") != std::string::npos) {
    const std::optional<std::string> failure = solve_directly();
    if (failure)
      note += "; but the direct solver: " + *failure;
    return failure ? Outcome::not_converged : Outcome::refused;
  }
  return note.find("must be") != std::string::npos ? Outcome::refused
                                                   : Outcome::not_converged;
}

std::string to_line(const InstanceReport& report) {
  return text_of_json(
      nlohmann::ordered_json::array(
          {report.index, static_cast<int>(report.outcome), report.check,
           report.reason, report.iterations, report.area, report.reduced_gap,
           report.has_pair, report.has_same_bits, report.pair_difference,
           report.seconds}),
      -1);
}

InstanceReport from_line(const std::string& line) {
  const nlohmann::ordered_json fields = json_of_text(line);
  // JSON represents a number that is not finite as null.
  const auto number = [&](std::size_t i) {
    return fields.at(i).is_null() ? 0.0 : fields.at(i).get<double>();
  };
  InstanceReport report;
  report.index = fields.at(0).get<int>();
  report.outcome = static_cast<Outcome>(fields.at(1).get<int>());
  report.check = fields.at(2).get<std::string>();
  report.reason = fields.at(3).get<std::string>();
  report.iterations = fields.at(4).get<int>();
  report.area = number(5);
  report.reduced_gap = number(6);
  report.has_pair = fields.at(7).get<bool>();
  report.has_same_bits = fields.at(8).get<bool>();
  report.pair_difference = number(9);
  report.seconds = number(10);
  return report;
}

} // namespace asperity::robustness
