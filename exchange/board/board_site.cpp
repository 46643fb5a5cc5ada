#include "exchange/board/board_site.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "exchange/board/board_figures.hpp"
#include "exchange/board/board_tables.hpp"
#include "reports/pages/published_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;

/// The certified entry of least error with this accuracy, or null.
const BoardEntry* leading(const BoardProblem& problem,
                          const std::string& accuracy) {
  for (const BoardEntry& entry : problem.entries)
    if (entry.state == BoardEntry::State::certified &&
        entry.missing_loads == 0 && entry.accuracy == accuracy)
      return &entry;
  return nullptr;
}

std::string body_words(const mechanics::ElasticBlock& body) {
  std::string words = fmt::format("E* = {:.4g} Pa", body.contact_modulus);
  words += std::isinf(body.thickness)
               ? ", half-space"
               : fmt::format(", block of {:.4g} m", body.thickness);
  if (!body.layers.empty())
    words += fmt::format(" with {} bonded layer(s)", body.layers.size());
  return words;
}

constexpr const char* mesh_note =
    "The problem has a mesh for finite-element codes. An answer on it is "
    "certified twice: above against the continuum's compliance, here against "
    "that of the same mesh, which leaves out the error of the elements. |u - "
    "continuum| is the distance of the mean gap that the code states from the "
    "continuum's, with the uncertainty of the latter: the error that a user "
    "of these elements has. Same order as above.";

BoardSection mesh_section(const BoardProblem& problem,
                          const fs::path& figures) {
  BoardSection meshed{"On the mesh", mesh_note, mesh_table(problem)};
  if (!meshed.table.rows.empty())
    for (const MeshCost cost : {MeshCost::time, MeshCost::memory})
      meshed.figures.push_back(
          reports::draw(mesh_figure(problem, cost), figures));
  return meshed;
}

BoardPage problem_page(const BoardProblem& problem, const fs::path& figures) {
  const std::string folder = "problems/" + problem.problem.name + "/";
  BoardPage page;
  page.title = problem.problem.title;
  page.lead = fmt::format(
      "{}: {} by {} nodes, {} load(s), {}; frictionless, non-adhesive, hard "
      "contact {}.",
      problem.problem.name, problem.problem.grid.points_x,
      problem.problem.grid.points_y, problem.problem.loads.size(),
      body_words(problem.problem.body),
      problem.problem.is_periodic ? "on a periodic cell"
                                  : "with free boundaries");
  page.home = "index.html";
  BoardSection ranked{
      "Certified answers",
      "Largest bounds over all loads. A row is a version of a code; rows are "
      "sorted by the smaller |u-u*| of the two accuracies, answers to a part "
      "of the loads last; a click on the head of a column sorts by it. Bounds "
      "follow from the submitted pressure fields alone, as does the mean gap "
      "u. Differences between bounds below some "
      "1e-6 h_rms say more about the bounds than about the answers. CPU times, "
      "memory and iterations are those that the authors state; times and "
      "iterations are summed over the loads. Times compare only within one "
      "run, in which the codes were computed in alternation, and between "
      "answers to the same loads; a time without a run is as submitted and in "
      "no figure.",
      ranking(problem)};
  ranked.figures.push_back(reports::draw(error_figure(problem), figures));
  page.sections.push_back(std::move(ranked));
  BoardSection meshed = mesh_section(problem, figures);
  if (!meshed.table.rows.empty())
    page.sections.push_back(std::move(meshed));
  BoardSection failed{"Answers that are not certified",
                      "A mistake was recognised, a claim does not hold, or the "
                      "submission cannot be read.",
                      unranked(problem, BoardEntry::State::failed)};
  if (!failed.table.rows.empty())
    page.sections.push_back(std::move(failed));
  BoardSection curves{"As submitted",
                      "Nothing bounds the error of a curve without fields.",
                      unranked(problem, BoardEntry::State::as_submitted)};
  if (!curves.table.rows.empty())
    page.sections.push_back(std::move(curves));
  page.sections.push_back(
      {"Reference",
       "On this grid: rigorous bounds. Continuum: estimates from finer grids, "
       "or an exact solution (error 0).",
       reference_table(problem),
       {reports::draw(surface_figure(problem.problem), figures)}});
  BoardTable files;
  files.heads = {head("File", "", false)};
  for (const char* file :
       {"README.md", "problem.json", "heights.npy", "heights.h5", "heights.txt",
        "heights.gwy", "reference.json", "SHA256SUMS"})
    files.rows.push_back({{file, "", folder + file}});
  page.sections.push_back(
      {"Files", "Everything that another program needs.", files});
  return page;
}

BoardPage code_page(const std::string& code,
                    const std::vector<BoardProblem>& board) {
  BoardPage page;
  page.title = code;
  page.lead = "All answers of this code.";
  page.home = "index.html";
  BoardTable table;
  table.heads = {head("Problem", "", false),      head("Version", "", false),
                 head("Accuracy", "", false),     head("State", "", false),
                 head("|u-u*|", "bound [h_rms]"), head("|p-p*|/|p|", "bound"),
                 head("CPU time", "s"),           head("Credit", "", false)};
  for (const BoardProblem& problem : board)
    for (const BoardEntry& entry : problem.entries)
      if (entry.code == code)
        table.rows.push_back(
            {{entry.problem, "", problem_page_name(entry.problem)},
             {entry.version, "", "", entry.method},
             {accuracy_word(entry)},
             {entry.state == BoardEntry::State::certified      ? "certified"
              : entry.state == BoardEntry::State::as_submitted ? "as submitted"
                                                               : "failed"},
             error_cell(entry.gap_error),
             error_cell(entry.pressure_error),
             time_cell(entry),
             {entry.credit, "", "", entry.machine}});
  page.sections.push_back({"Answers", "", table});
  return page;
}

constexpr const char* problems_note = "Sorted by name; a click on the head of "
                                      "a column sorts by it. Least |u-u*|: "
                                      "of the certified answers to all loads.";

constexpr const char* submit_note =
    "Every problem can be answered, by any code. asperity problem writes the "
    "files of a problem, which its page offers as well. An answer is a folder "
    "with one pressure field per load and submission.toml; asperity import "
    "certifies it. Put it into submissions/<problem>/<code>/<version> beside "
    "the problems, and open a pull request: docs/submit.md leads through it.";

/// Adds problems without an answer and sorts all by name.
void add_open_problems(const std::vector<std::string>& open,
                       BoardTable& problems) {
  for (const std::string& name : open)
    problems.rows.push_back({{name, "", "", "no answer yet"},
                             number_cell(not_a_number, ""),
                             number_cell(0.0, "{:.0f}"),
                             number_cell(0.0, "{:.0f}"),
                             error_cell(not_a_number),
                             error_cell(not_a_number)});
  std::ranges::sort(problems.rows, {}, [](const std::vector<BoardCell>& row) {
    return row.front().text;
  });
}

BoardPage front_page(const std::vector<BoardProblem>& board,
                     const std::vector<std::string>& open) {
  BoardPage page;
  page.title = "Rough contact: certified answers";
  page.lead =
      "Contact problems, and the answers of many codes. A submission is a "
      "pressure field; every error shown is a bound that follows from it, so "
      "that nobody has to be trusted.";
  BoardTable problems;
  problems.heads = {head("Problem", "", false),
                    head("Nodes"),
                    head("Answers"),
                    head("Certified"),
                    head("Least |u-u*|, default", "bound [h_rms]"),
                    head("Least |u-u*|, best", "bound [h_rms]")};
  std::map<std::string, std::pair<int, int>> codes; // answers, certified
  for (const BoardProblem& problem : board) {
    int certified = 0;
    for (const BoardEntry& entry : problem.entries) {
      const bool holds = entry.state == BoardEntry::State::certified;
      certified += holds ? 1 : 0;
      ++codes[entry.code].first;
      codes[entry.code].second += holds ? 1 : 0;
    }
    const auto least = [&](const char* accuracy) {
      const BoardEntry* const entry = leading(problem, accuracy);
      BoardCell cell =
          error_cell(entry == nullptr ? not_a_number : entry->gap_error);
      if (entry != nullptr)
        cell.small = entry->code;
      return cell;
    };
    problems.rows.push_back(
        {{problem.problem.name, "", problem_page_name(problem.problem.name),
          problem.problem.title},
         number_cell(static_cast<double>(problem.problem.grid.size()),
                     "{:.0f}"),
         number_cell(static_cast<double>(problem.entries.size()), "{:.0f}"),
         number_cell(certified, "{:.0f}"),
         least("default"),
         least("best")});
  }
  add_open_problems(open, problems);
  page.sections.push_back({"Problems", problems_note, problems});
  BoardTable list;
  list.heads = {head("Code", "", false), head("Answers"), head("Certified")};
  for (const auto& [code, counts] : codes)
    list.rows.push_back({{code, "", code_page_name(code)},
                         number_cell(counts.first, "{:.0f}"),
                         number_cell(counts.second, "{:.0f}")});
  page.sections.push_back({"Codes", "", list});
  page.sections.push_back({"Submit an answer", submit_note, {}});
  return page;
}

std::string json_text(const std::vector<BoardProblem>& board) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const BoardProblem& problem : board)
    for (const BoardEntry& entry : problem.entries)
      list.push_back(
          {{"problem", entry.problem},
           {"folder", entry.folder},
           {"code", entry.code},
           {"version", entry.version},
           {"method", entry.method},
           {"accuracy", entry.accuracy},
           {"element", entry.element},
           {"is_certified", entry.state == BoardEntry::State::certified},
           {"is_as_submitted", entry.state == BoardEntry::State::as_submitted},
           {"reasons", entry.reasons},
           {"loads", entry.loads},
           {"missing_loads", entry.missing_loads},
           {"gap_error [h_rms]", reports::json_number(entry.gap_error)},
           {"pressure_error [1]", reports::json_number(entry.pressure_error)},
           {"mesh_error [h_rms]", reports::json_number(entry.mesh_error)},
           {"continuum_error [h_rms]",
            reports::json_number(entry.continuum_error)},
           {"cpu_time [s]", reports::json_number(entry.cpu_time)},
           {"cpu_time_low [s]", reports::json_number(entry.cpu_time_low)},
           {"cpu_time_high [s]", reports::json_number(entry.cpu_time_high)},
           {"timing_run", entry.timing ? Json(entry.timing->run) : Json()},
           {"peak_memory [B]", reports::json_number(entry.peak_memory)},
           {"iterations", entry.iterations}});
  return text_of_json(list, 2) + "\n";
}

} // namespace

void write_site(const std::vector<BoardProblem>& board,
                const std::vector<std::string>& open, const fs::path& site) {
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file_atomically(site / name, text);
  };
  fs::create_directories(site / "figures");
  write("board.json", json_text(board));
  std::set<std::string> codes;
  for (const BoardProblem& problem : board) {
    write(problem_page_name(problem.problem.name),
          html_of(problem_page(problem, site / "figures")));
    for (const BoardEntry& entry : problem.entries)
      codes.insert(entry.code);
  }
  for (const std::string& code : codes)
    write(code_page_name(code), html_of(code_page(code, board)));
  write("index.html", html_of(front_page(board, open)));
}

} // namespace asperity::exchange
