#pragma once

// A folder for a report, removed at the end of the test unless
// ASPERITY_KEEP_REPORTS is set.

#include "input/reader/case_text.hpp"
#include "input/text/toml_text.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <unistd.h>
#include <utility>

#include "synthetic.hpp"

namespace asperity::reports {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Gives a case another text, with its keys: what it states besides may differ.
inline void set_text(cases::Case& made, const std::string& text) {
  cases::Node file = cases::parse_toml(
      std::string(cases::without_overrides(text)), "case.toml");
  cases::Mistakes mistakes;
  for (const std::string& one : cases::overrides_in(text))
    cases::apply_override(file, one, mistakes);
  made.text = text;
  made.file = std::make_shared<const cases::Node>(std::move(file));
}

class ReportFolder : public ::testing::Test {
protected:
  ReportFolder() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::temp_directory_path() /
             (std::string("asperity-report-") + info->test_suite_name() + "-" +
              info->name() + "-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
  }

  ~ReportFolder() override {
    std::error_code ignored; // of a browser that is still removing its files
    if (std::getenv("ASPERITY_KEEP_REPORTS") == nullptr)
      std::filesystem::remove_all(folder, ignored);
  }

  std::vector<std::string> write(const results::Result& result,
                                 const std::string& gnuplot = "gnuplot") {
    const ReportEntry entry = entry_of(result, rough);
    return write_report(std::span(&entry, 1), folder, gnuplot);
  }

  cases::Case rough = synthetic::contact_case();
  std::filesystem::path folder;
};

} // namespace asperity::reports
