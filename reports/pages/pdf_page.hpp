#pragma once

// Prints a page to PDF with a program that is installed, as a child process.

#include <filesystem>
#include <string>

namespace asperity::reports {

/// Returns the path of the program that prints pages: chromium,
/// chromium-browser, google-chrome or weasyprint, whichever comes first and is
/// on PATH; empty if none is.
std::filesystem::path pdf_program();

/// Prints a page, which must need no other file, as `pdf`. The page is written
/// to a folder beside it for this time, which is removed at the end. The
/// program is terminated after five minutes.
/// @param html     text of the page
/// @param program  see pdf_program()
/// @return         why it was not printed; empty if it was
/// @throws std::system_error  the folder of `pdf` cannot be written
std::string print_page(const std::string& html,
                       const std::filesystem::path& pdf,
                       const std::filesystem::path& program);

/// Prints the page of a report as folder/report.pdf, by pdf_program().
/// @return  "report.pdf: " and why it was not printed; empty if it was
std::string print_report(const std::string& html,
                         const std::filesystem::path& folder);

/// What to say where pdf_program() is empty.
extern const char* const no_pdf_program;

} // namespace asperity::reports
