#include "cli/collection.hpp"

#include "reports/pages/paper_report.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>

namespace asperity::cli {

void write_collection_report(const run::FoundCases& collection,
                             const std::vector<RunPart>& parts,
                             const std::filesystem::path& folder,
                             bool has_pdf) {
  if (parts.empty())
    return;
  std::vector<results::Result> results;
  std::vector<cases::Case> contact_cases;
  for (const RunPart& part : parts) {
    results.push_back(
        results::read_result(part.folder, results::MapsInFile::large));
    contact_cases.push_back(reports::case_of(results.back()));
  }
  std::vector<reports::PaperPart> pages;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::filesystem::path part = parts[i].part.file.parent_path();
    const std::string name = part.filename().string();
    const auto figures = collection.figures.find(name);
    pages.push_back(
        {name, parts[i].folder, run::text_of_file(part / "README.md"),
         figures == collection.figures.end() ? std::vector<std::string>()
                                             : figures->second,
         reports::entry_of(results[i], contact_cases[i])});
  }
  const std::string readme = run::text_of_file(collection.folder / "README.md");
  for (const std::string& failure :
       reports::write_paper_report(pages, readme, folder, {.has_pdf = has_pdf}))
    fmt::print(stderr, "figure not drawn: {}\n", failure);
  fmt::print("report on all parts: {}\n", (folder / "report.html").string());
}

} // namespace asperity::cli
