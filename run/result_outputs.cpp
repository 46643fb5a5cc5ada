#include "run/result_outputs.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/pages/report.hpp"
#include "results/csv.hpp"
#include "results/result_reader.hpp"
#include "run/output.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

} // namespace

bool is_result(const fs::path& path) {
  return path.extension() == ".h5" || fs::exists(path / "result.h5");
}

reports::Summary summary_of(const results::Result& result) {
  const cases::Case contact_case = reports::case_of(result);
  fmt::print("{}", reports::warning_lines(result, contact_case));
  return reports::summarize(result, contact_case);
}

reports::Summary write_outputs(const fs::path& folder, bool has_pdf,
                               bool has_run) {
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  const cases::Case contact_case = reports::case_of(result);
  reports::ReportEntry entry = reports::entry_of(result, contact_case);
  write_file_atomically(folder / "curves.csv", results::curves_csv(result));
  write_file_atomically(folder / "times.csv", results::times_csv(result));
  print_undrawn(reports::write_report({&entry, 1}, folder, "gnuplot",
                                      {.has_pdf = has_pdf}));
  fmt::print("{}", reports::warning_lines(result, contact_case, has_run));
  return entry.summary;
}

void print_undrawn(const std::vector<std::string>& figures) {
  for (const std::string& figure : figures)
    fmt::print(stderr, "figure not drawn: {}\n", figure);
}

void JsonAnswer::add(const std::string& name, const fs::path& folder,
                     ExitCode exit_code, const reports::Summary* summary,
                     const std::string& problem) {
  OrderedJson entry = {{"case", name},
                       {"folder", folder.string()},
                       {"exit_code", static_cast<int>(exit_code)}};
  entry["summary"] = summary == nullptr
                         ? OrderedJson(nullptr)
                         : json_of_text(reports::summary_json(*summary));
  if (!problem.empty())
    entry["problem"] = problem;
  entries_.push_back(text_of_json(entry, 2));
}

void JsonAnswer::print(ExitCode exit_code) const {
  if (!wants_json())
    return;
  OrderedJson answer = {{"format", format_},
                        {"format_version", 1},
                        {"exit_code", static_cast<int>(exit_code)},
                        {"results", OrderedJson::array()}};
  for (const std::string& entry : entries_)
    answer["results"].push_back(json_of_text(entry));
  emit_answer(text_of_json(answer, 2) + "\n");
}

} // namespace asperity::run
