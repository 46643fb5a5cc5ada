// The answer of the resistances of the contact.
#include "base/shown_number.hpp"
#include "studies/answers.hpp"
#include "studies/resistance/resistance.hpp"

#include <fmt/format.h>

namespace asperity::studies {
namespace {

std::string sentence(const reports::ReportEntry& entry, const char* what,
                     const results::CurveColumn& column, const char* unit) {
  const AnsweredLoad answer = answered_load(entry, column);
  return answer.method == nullptr
             ? ""
             : fmt::format("{} resistance {} {} {}.", what,
                           digits_text(answer.median(column), 3), unit,
                           answer.place(entry));
}

std::string resistance_answer(const reports::ReportEntry& entry) {
  const std::string heat =
      sentence(entry, "Thermal", columns::thermal_resistance, "m² K/W");
  const std::string current =
      sentence(entry, "Electrical", columns::electrical_resistance, "Ω m²");
  return heat + (heat.empty() || current.empty() ? "" : " ") + current;
}

std::vector<reports::AnswerColumn> resistances(const cases::Case&) {
  return {{&columns::thermal_resistance, "Thermal resistance"},
          {&columns::electrical_resistance, "Electrical resistance"}};
}

} // namespace

const reports::StudyPages& resistance_pages() {
  static const reports::StudyPages pages{.name = "resistance",
                                         .answer = resistance_answer,
                                         .answer_columns = resistances};
  return pages;
}

} // namespace asperity::studies
