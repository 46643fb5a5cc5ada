#include "exchange/board/board_tables.hpp"

#include "base/content_hash.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {
namespace {

/// One row of the ranking: the answers of a code at each accuracy.
struct RankedAnswers {
  const BoardEntry* at_default = nullptr;
  const BoardEntry* at_best = nullptr;

  const BoardEntry& any() const {
    return at_default != nullptr ? *at_default : *at_best;
  }

  const BoardEntry*& at(const std::string& accuracy) {
    return accuracy == "best" ? at_best : at_default;
  }
};

/// The rows of ranking().
std::vector<RankedAnswers> ranked_answers(const BoardProblem& problem) {
  std::vector<RankedAnswers> rows;
  for (const BoardEntry& entry : problem.entries) {
    if (entry.state != BoardEntry::State::certified)
      continue;
    const auto found = std::ranges::find_if(rows, [&](RankedAnswers& row) {
      return row.any().code == entry.code &&
             row.any().version == entry.version &&
             row.any().missing_loads == entry.missing_loads &&
             row.at(entry.accuracy) == nullptr;
    });
    RankedAnswers& row = found == rows.end() ? rows.emplace_back() : *found;
    row.at(entry.accuracy) = &entry;
  }
  return rows;
}

std::string method_words(const RankedAnswers& row) {
  std::string words = row.any().method;
  if (row.at_default != nullptr && row.at_best != nullptr &&
      row.at_best->method != words)
    words += " (default); " + row.at_best->method + " (best)";
  if (row.any().missing_loads > 0)
    words += fmt::format("; {} of {} loads", row.any().loads,
                         row.any().loads + row.any().missing_loads);
  return words;
}

} // namespace

std::string problem_page_name(const std::string& problem) {
  return "problem-" + reports::file_word(problem) + ".html";
}

/// Two codes may have one file word, so a name that differs from its own has a
/// part of its hash.
std::string code_page_name(const std::string& code) {
  const std::string word = reports::file_word(code);
  return "code-" + word +
         (word == code ? "" : "-" + content_hash(code).substr(0, 8)) + ".html";
}

BoardCell head(const std::string& text, const std::string& small,
               bool is_number) {
  return {text, "", "", small, is_number};
}

BoardCell error_cell(double error) {
  return number_cell(error, "{:.1e}");
}

BoardCell time_cell(const BoardEntry& entry) {
  BoardCell cell = number_cell(entry.cpu_time, "{:.3g}");
  if (!entry.timing)
    cell.small = std::isnan(entry.cpu_time) ? "" : "as submitted";
  else
    cell.small = (std::isnan(entry.cpu_time_low + entry.cpu_time_high)
                      ? std::string()
                      : fmt::format("{:.3g} to {:.3g}; ", entry.cpu_time_low,
                                    entry.cpu_time_high)) +
                 fmt::format("run {}, {} pairs, {} thread{}", entry.timing->run,
                             entry.timing->pairs, entry.timing->threads,
                             entry.timing->threads == 1 ? "" : "s");
  return cell;
}

BoardCell memory_cell(const BoardEntry& entry) {
  return number_cell(1e-6 * entry.peak_memory, "{:.0f}");
}

std::string accuracy_word(const BoardEntry& entry) {
  return entry.accuracy.empty() ? "–" : entry.accuracy;
}

BoardTable ranking(const BoardProblem& problem) {
  BoardTable table;
  table.heads = {head("Code", "", false),
                 head("Default: |u-u*|", "bound [h_rms]"),
                 head("|p-p*|/|p|", "bound"),
                 head("CPU time", "s"),
                 head("Memory", "MB"),
                 head("Iterations"),
                 head("Best: |u-u*|", "bound [h_rms]"),
                 head("|p-p*|/|p|", "bound"),
                 head("CPU time", "s"),
                 head("Memory", "MB"),
                 head("Iterations")};
  const BoardEntry none;
  for (const RankedAnswers& answers : ranked_answers(problem)) {
    const BoardEntry& any = answers.any();
    std::vector<BoardCell> row{{any.code + " " + any.version, "",
                                code_page_name(any.code),
                                method_words(answers)}};
    for (const BoardEntry* answer : {answers.at_default, answers.at_best}) {
      const BoardEntry& entry = answer == nullptr ? none : *answer;
      row.push_back(error_cell(entry.gap_error));
      row.push_back(error_cell(entry.pressure_error));
      row.push_back(time_cell(entry));
      row.push_back(memory_cell(entry));
      row.push_back(number_cell(
          entry.iterations > 0 ? entry.iterations : not_a_number, "{:.0f}"));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

BoardTable mesh_table(const BoardProblem& problem) {
  BoardTable table;
  table.heads = {head("Code", "", false),
                 head("Elements", "", false),
                 head("Accuracy", "", false),
                 head("|u-u*|", "bound, this mesh [h_rms]"),
                 head("|u - continuum|", "[h_rms]"),
                 head("CPU time", "s"),
                 head("Memory", "MB"),
                 head("Iterations")};
  bool has_mesh = false;
  for (const BoardEntry& entry : problem.entries) {
    if (entry.state != BoardEntry::State::certified)
      continue;
    has_mesh = has_mesh || !entry.element.empty();
    BoardCell distance = number_cell(entry.continuum_error, "{:.2e}");
    if (std::isfinite(entry.continuum_uncertainty))
      distance.small = fmt::format("± {:.1e}", entry.continuum_uncertainty);
    table.rows.push_back(
        {{entry.code + " " + entry.version, "", code_page_name(entry.code),
          entry.method},
         {entry.element.empty() ? "–" : entry.element},
         {accuracy_word(entry)},
         error_cell(entry.mesh_error),
         distance,
         time_cell(entry),
         memory_cell(entry),
         number_cell(entry.iterations > 0 ? entry.iterations : not_a_number,
                     "{:.0f}")});
  }
  if (!has_mesh)
    table.rows.clear();
  return table;
}

BoardTable unranked(const BoardProblem& problem, BoardEntry::State state) {
  BoardTable table;
  table.heads = {head("Submission", "", false), head("Accuracy", "", false),
                 head("Reason", "", false)};
  for (const BoardEntry& entry : problem.entries)
    if (entry.state == state)
      table.rows.push_back(
          {{entry.folder, "", "", entry.code + " " + entry.version},
           {accuracy_word(entry)},
           {state == BoardEntry::State::as_submitted
                ? std::string("a curve without pressure fields, as submitted")
                : fmt::format("{}", fmt::join(entry.reasons, "; "))}});
  return table;
}

BoardTable reference_table(const BoardProblem& problem) {
  const double height = problem.problem.rms_height;
  BoardTable table;
  table.heads = {head("p_0", "Pa"),
                 head("u", "this grid [h_rms]"),
                 head("Bound", "[h_rms]"),
                 head("A/A_0", "this grid"),
                 head("u", "continuum [h_rms]"),
                 head("Error", "estimated"),
                 head("A/A_0", "continuum"),
                 head("Error", "estimated")};
  for (std::size_t i = 0; i < problem.answers.size(); ++i) {
    const exchange::ProblemAnswer& answer = problem.answers[i];
    const exchange::ContinuumAnswer limit = i < problem.continuum.size()
                                                ? problem.continuum[i]
                                                : exchange::ContinuumAnswer{};
    table.rows.push_back({number_cell(answer.nominal_pressure, "{:.6g}"),
                          number_cell(answer.mean_gap / height, "{:.7f}"),
                          error_cell(answer.mean_gap_error / height),
                          number_cell(answer.area_fraction, "{:.5f}"),
                          number_cell(limit.mean_gap / height, "{:.6f}"),
                          error_cell(limit.mean_gap_error / height),
                          number_cell(limit.area_fraction, "{:.5f}"),
                          error_cell(limit.area_fraction_error)});
  }
  return table;
}

} // namespace asperity::exchange
