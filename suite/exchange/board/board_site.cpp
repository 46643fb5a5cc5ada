#include "suite/exchange/board/board_site.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/json.hpp"
#include "base/shown_number.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/pages/page_data.hpp"
#include "suite/exchange/board/board_figures.hpp"
#include "suite/exchange/board/board_template.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

/// The certified entry of least error with this accuracy, or null.
const BoardEntry* leading(const BoardProblem& problem,
                          const std::string& accuracy) {
  for (const BoardEntry& entry : problem.entries)
    if (entry.state == BoardEntry::State::certified &&
        entry.missing_loads == 0 && entry.answer.accuracy == accuracy)
      return &entry;
  return nullptr;
}

std::string body_words(const mechanics::ElasticBlock& body) {
  std::string words = "E* = " + quantity_text(body.contact_modulus, "Pa");
  words += body.is_infinite()
               ? ", half-space"
               : ", block of " + quantity_text(body.thickness, "m");
  if (!body.layers.empty())
    words += fmt::format(" with {} bonded layer(s)", body.layers.size());
  return words;
}

std::string contact_words(const Problem& problem) {
  if (!problem.adhesion)
    return "frictionless, non-adhesive, hard contact";
  return fmt::format("frictionless contact with a hard wall and exponential "
                     "attraction of {} over {}",
                     quantity_text(problem.adhesion->work_of_adhesion, "J/m^2"),
                     quantity_text(problem.adhesion->adhesion_range, "m"));
}

/// An entry as board.json has it.
Json entry_json(const BoardEntry& entry) {
  return {{"problem", entry.answer.problem},
          {"folder", entry.folder},
          {"code", entry.answer.code},
          {"version", entry.answer.version},
          {"method", entry.answer.method},
          {"accuracy", entry.answer.accuracy},
          {"element", entry.answer.element},
          {"is_certified", entry.state == BoardEntry::State::certified},
          {"is_as_submitted", entry.state == BoardEntry::State::as_submitted},
          {"reasons", entry.reasons},
          {"loads", entry.loads},
          {"missing_loads", entry.missing_loads},
          {"gap_error [h_rms]", entry.gap_error},
          {"pressure_error [1]", entry.pressure_error},
          {"distance [h_rms]", entry.distance},
          {"energy_above [w]", entry.energy_above},
          {"lowest_loads", entry.lowest_loads},
          {"reference_loads", entry.reference_loads},
          {"mesh_error [h_rms]", entry.mesh_error},
          {"continuum_error [h_rms]", entry.continuum_error},
          {"cpu_time [s]", entry.cpu_time},
          {"cpu_time_low [s]", entry.cpu_time_low},
          {"cpu_time_high [s]", entry.cpu_time_high},
          {"timing_run",
           entry.answer.timing ? Json(entry.answer.timing->run) : Json()},
          {"peak_memory [B]", entry.peak_memory},
          {"iterations", entry.iterations}};
}

/// The interval of a CPU time and the run that it belongs to, or "as submitted"
/// if nothing says how it was measured.
std::string time_note(const BoardEntry& entry) {
  if (!entry.answer.timing)
    return std::isnan(entry.cpu_time) ? "" : "as submitted";
  return (std::isnan(entry.cpu_time_low + entry.cpu_time_high)
              ? std::string()
              : fmt::format("{:.3g} to {:.3g}; ", entry.cpu_time_low,
                            entry.cpu_time_high)) +
         fmt::format("run {}, {} pairs, {} thread{}", entry.answer.timing->run,
                     entry.answer.timing->pairs, entry.answer.timing->threads,
                     entry.answer.timing->threads == 1 ? "" : "s");
}

/// An entry of board.json with what the tables of the pages show beside it.
Json row_of(const BoardEntry& entry) {
  Json row = entry_json(entry);
  row["title"] = entry.answer.code + " " + entry.answer.version;
  row["is_named"] = entry.is_named;
  row["code_page"] = code_page_name(entry.answer.code);
  row["problem_page"] = problem_page_name(entry.answer.problem);
  row["accuracy_word"] =
      entry.answer.accuracy.empty() ? "–" : entry.answer.accuracy;
  const bool is_adhesive = !entry.energies.empty();
  row["first"] = is_adhesive ? entry.energy_above : entry.gap_error;
  row["second"] = is_adhesive ? entry.distance : entry.pressure_error;
  row["first_note"] =
      is_adhesive
          ? fmt::format("{} of {} lowest, {} as the reference",
                        entry.lowest_loads, entry.loads, entry.reference_loads)
          : "";
  row["continuum_uncertainty [h_rms]"] = entry.continuum_uncertainty;
  row["time_note"] = time_note(entry);
  row["credit"] =
      entry.answer.authors.empty()
          ? ""
          : fmt::format("{}, {}", fmt::join(entry.answer.authors, ", "),
                        entry.answer.licence);
  row["machine"] = entry.answer.machine;
  row["state"] = entry.state == BoardEntry::State::certified ? "certified"
                 : entry.state == BoardEntry::State::as_submitted
                     ? "as submitted"
                     : "failed";
  row["reason"] = entry.state == BoardEntry::State::as_submitted
                      ? "a curve without pressure fields, as submitted"
                      : fmt::format("{}", fmt::join(entry.reasons, "; "));
  if (entry.iterations == 0) // not stated
    row["iterations"] = nullptr;
  return row;
}

/// A table, with a field to filter it if it is long.
Json table_of(Json rows) {
  const bool has_filter = rows.size() > 5;
  return {{"rows", std::move(rows)}, {"has_filter", has_filter}};
}

/// The entries in one state, in their order.
Json rows_in(const BoardProblem& problem, BoardEntry::State state) {
  Json rows = Json::array();
  for (const BoardEntry& entry : problem.entries)
    if (entry.state == state)
      rows.push_back(row_of(entry));
  return rows;
}

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

/// Certified entries in their order. Answers of one version of a code to the
/// same number of loads share a row, if their accuracies differ.
std::vector<RankedAnswers> ranked_answers(const BoardProblem& problem) {
  std::vector<RankedAnswers> rows;
  for (const BoardEntry& entry : problem.entries) {
    if (entry.state != BoardEntry::State::certified)
      continue;
    const auto found = std::ranges::find_if(rows, [&](RankedAnswers& row) {
      return row.any().answer.code == entry.answer.code &&
             row.any().answer.version == entry.answer.version &&
             row.any().is_named == entry.is_named &&
             row.any().missing_loads == entry.missing_loads &&
             row.at(entry.answer.accuracy) == nullptr;
    });
    RankedAnswers& row = found == rows.end() ? rows.emplace_back() : *found;
    row.at(entry.answer.accuracy) = &entry;
  }
  return rows;
}

std::string method_words(const RankedAnswers& row) {
  std::string words = row.any().answer.method;
  if (row.at_default != nullptr && row.at_best != nullptr &&
      row.at_best->answer.method != words)
    words += " (default); " + row.at_best->answer.method + " (best)";
  if (row.any().missing_loads > 0)
    words += fmt::format("; {} of {} loads", row.any().loads,
                         row.any().loads + row.any().missing_loads);
  return words;
}

Json ranking(const BoardProblem& problem) {
  Json rows = Json::array();
  for (const RankedAnswers& answers : ranked_answers(problem)) {
    Json row = row_of(answers.any());
    row["small"] = method_words(answers);
    row["answers"] = Json::array();
    for (const BoardEntry* answer : {answers.at_default, answers.at_best})
      row["answers"].push_back(
          row_of(answer == nullptr ? BoardEntry() : *answer));
    rows.push_back(std::move(row));
  }
  return table_of(std::move(rows));
}

/// The states of our path.
Json path_table(const BoardProblem& problem) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < problem.answers.size(); ++i) {
    const ProblemAnswer& answer = problem.answers[i];
    rows.push_back(
        {{"step", i},
         {"gap", answer.mean_gap / problem.problem.rms_height},
         {"pressure", answer.nominal_pressure},
         {"area", answer.area_fraction},
         {"energy",
          answer.energy / problem.problem.adhesion->work_of_adhesion}});
  }
  return table_of(std::move(rows));
}

/// Reference answers on this grid and in the continuum.
Json reference_table(const BoardProblem& problem) {
  const double height = problem.problem.rms_height;
  Json rows = Json::array();
  for (std::size_t i = 0; i < problem.answers.size(); ++i) {
    const ProblemAnswer& answer = problem.answers[i];
    const ContinuumAnswer limit =
        i < problem.continuum.size() ? problem.continuum[i] : ContinuumAnswer{};
    rows.push_back({{"pressure", answer.nominal_pressure},
                    {"gap", answer.mean_gap / height},
                    {"gap_error", answer.mean_gap_error / height},
                    {"area", answer.area_fraction},
                    {"limit_gap", limit.mean_gap / height},
                    {"limit_gap_error", limit.mean_gap_error / height},
                    {"limit_area", limit.area_fraction},
                    {"limit_area_error", limit.area_fraction_error}});
  }
  return table_of(std::move(rows));
}

/// Entries that are not ranked, by state; none if there are none.
Json unranked_tables(const BoardProblem& problem) {
  Json tables = Json::array();
  const auto add = [&](BoardEntry::State state, const char* heading,
                       const char* note) {
    Json table = table_of(rows_in(problem, state));
    table["heading"] = heading;
    table["note"] = note;
    if (!table["rows"].empty())
      tables.push_back(std::move(table));
  };
  add(BoardEntry::State::failed, "Answers that are not certified",
      "A mistake was recognised, a claim does not hold, or the submission "
      "cannot be read.");
  add(BoardEntry::State::as_submitted, "As submitted",
      "Nothing bounds the error of a curve without fields.");
  return tables;
}

std::string html_of(Json page,
                    const std::vector<reports::DrawnFigure>& figures) {
  const reports::DrawnGroup group{"", figures};
  page["page_title"] = page["title"];
  return reports::page_text(board_template, std::move(page), {&group, 1}, false,
                            std::string(board_script));
}

std::string problem_page(const BoardProblem& problem, const fs::path& folder) {
  std::vector<reports::DrawnFigure> drawn;
  /// Draws figures and adds them to a table.
  const auto add = [&](const std::vector<reports::Figure>& figures,
                       Json& table) {
    reports::DrawnGroup group;
    for (const reports::Figure& figure : figures) {
      drawn.push_back(reports::draw(figure, folder));
      group.figures.push_back(drawn.back());
    }
    table["figures"] = reports::group_data({&group, 1}).front()["figures"];
  };
  Json page = {
      {"title", problem.problem.title},
      {"lead",
       fmt::format("{}: {} × {} nodes, {} load{}, {}; {} {}.",
                   problem.problem.name, problem.problem.grid.points_x,
                   problem.problem.grid.points_y, problem.problem.loads.size(),
                   problem.problem.loads.size() == 1 ? "" : "s",
                   body_words(problem.problem.body),
                   contact_words(problem.problem),
                   problem.problem.is_periodic() ? "on a periodic cell"
                                                 : "with free boundaries")},
      {"ranked", ranking(problem)},
      {"unranked", unranked_tables(problem)},
      {"is_adhesive", problem.problem.adhesion.has_value()},
      {"reference", problem.problem.adhesion ? path_table(problem)
                                             : reference_table(problem)},
      {"problem_files", "problems/" + problem.problem.name + "/"},
      {"files",
       {"README.md", "problem.json", "heights.npy", "heights.h5", "heights.txt",
        "heights.gwy", "reference.json", "SHA256SUMS"}}};
  if (reports::Figure errors = error_figure(problem); errors.problem.empty())
    add({std::move(errors)}, page["ranked"]);
  if (std::ranges::any_of(problem.entries, [](const BoardEntry& entry) {
        return entry.state == BoardEntry::State::certified &&
               !entry.answer.element.empty();
      })) {
    page["meshed"] = table_of(rows_in(problem, BoardEntry::State::certified));
    add({mesh_figure(problem, MeshCost::time),
         mesh_figure(problem, MeshCost::memory)},
        page["meshed"]);
  }
  add({surface_figure(problem.problem)}, page["reference"]);
  return html_of(std::move(page), drawn);
}

std::string code_page(const std::string& code,
                      const std::vector<BoardProblem>& board) {
  Json rows = Json::array();
  for (const BoardProblem& problem : board)
    for (const BoardEntry& entry : problem.entries)
      if (entry.answer.code == code)
        rows.push_back(row_of(entry));
  return html_of({{"title", code},
                  {"lead", "All answers of this code."},
                  {"code_answers", table_of(std::move(rows))}},
                 {});
}

/// Answers and certified ones of each code.
using Counts = std::map<std::string, std::pair<int, int>>;

std::string front_page(const std::vector<BoardProblem>& board,
                       const Counts& counts) {
  Json problems = Json::array();
  // Energies do not belong into the column of bounds.
  const auto least = [](const BoardEntry* entry) {
    return row_of(entry == nullptr || !entry->energies.empty() ? BoardEntry()
                                                               : *entry);
  };
  for (const BoardProblem& problem : board)
    problems.push_back(
        {{"name", problem.problem.name},
         {"page", problem_page_name(problem.problem.name)},
         {"small", problem.problem.title},
         {"nodes", problem.problem.grid.size()},
         {"answers", problem.entries.size()},
         {"certified", rows_in(problem, BoardEntry::State::certified).size()},
         {"default", least(leading(problem, "default"))},
         {"best", least(leading(problem, "best"))}});
  Json codes = Json::array();
  for (const auto& [code, of_code] : counts)
    codes.push_back({{"code", code},
                     {"code_page", code_page_name(code)},
                     {"answers", of_code.first},
                     {"certified", of_code.second}});
  return html_of(
      {{"is_front", true},
       {"title", "Rough contact: certified answers"},
       {"lead",
        "Contact problems, and the answers of many codes. A submission is a "
        "pressure field; every error shown is a bound that follows from it, so "
        "that nobody has to be trusted."},
       {"problems", table_of(std::move(problems))},
       {"codes", table_of(std::move(codes))}},
      {});
}

} // namespace

void write_site(const std::vector<BoardProblem>& board, const fs::path& site) {
  fs::create_directories(site / "figures");
  Json list = Json::array();
  Counts codes;
  for (const BoardProblem& problem : board) {
    write_file_atomically(site / problem_page_name(problem.problem.name),
                          problem_page(problem, site / "figures"));
    for (const BoardEntry& entry : problem.entries) {
      list.push_back(entry_json(entry));
      ++codes[entry.answer.code].first;
      codes[entry.answer.code].second +=
          entry.state == BoardEntry::State::certified;
    }
  }
  write_file_atomically(site / "board.json", text_of_json(list, 2) + "\n");
  for (const auto& [code, counts] : codes)
    write_file_atomically(site / code_page_name(code), code_page(code, board));
  write_file_atomically(site / "index.html", front_page(board, codes));
}

} // namespace asperity::exchange
