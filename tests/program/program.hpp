#pragma once

// Runs the built program as a user would, in a temporary folder.

#include "tests/folder.hpp"
#include "tests/rough_case.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace asperity::program {

struct Ended {
  int exit_code = -1; ///< 128 + signal if it was killed
  std::string output; ///< standard output and error together
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The columns of curves.csv of one method.
inline std::map<std::string, std::vector<std::string>>
columns_of(const std::string& csv, const std::string& method) {
  std::map<std::string, std::vector<std::string>> columns;
  std::vector<std::string> names;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');)
      cells.push_back(cell);
    if (names.empty())
      names = cells;
    else if (cells.front() == method)
      for (std::size_t i = 0; i < cells.size(); ++i)
        columns[names[i]].push_back(cells[i]);
  }
  return columns;
}

class ProgramTest : public tests::FolderTest {
protected:
  /// `before` precedes the program: environment, or "timeout -s KILL 1".
  Ended run(const std::string& arguments,
            const std::string& before = "") const {
    const std::filesystem::path log = folder / "log.txt";
    const std::string command =
        "cd " + folder.string() + " && ASPERITY_CACHE=cache " + before +
        " " ASPERITY_PROGRAM " " + arguments + " > " + log.string() + " 2>&1";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            text_of(log)};
  }

  /// The same, with one SIGINT as from Ctrl-C as soon as `file` exists. The
  /// program runs in the background, because timeout(1) may send the signal
  /// twice.
  Ended interrupt(const std::string& arguments, const std::string& file) const {
    write("interrupt.sh", "\"$@\" &\n"
                          "until test -e " +
                              file +
                              " || ! kill -0 $! 2>&-; do\n"
                              "  sleep 0.01\n"
                              "done\n"
                              "kill -INT $! && wait $!\n");
    return run(arguments, "sh interrupt.sh");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }
};

/// A case that takes seconds: every method, two realisations, four loads.
inline const std::string small_case = tests::rough_case(
    "small", 64,
    R"({ from = "1e-3 E*", to = "5e-2 E*", steps = 4, spacing = "log" })",
    R"([halfspace]
contact = "hard"
[fem]
contact = "penalty"
penalty = "100 E*/h"
)");

/// A sphere that leaves an imprint, in steps of a tenth of a second.
inline std::string imprint_case(int steps) {
  return R"(schema = 1
title = "imprint"
[surface]
kind = "sphere"
length = "1 um"
points = 16
radius = "5 length"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = { from = "1e-3 E*", to = "4e-3 E*", spacing = "linear", steps = )" +
         std::to_string(steps) + R"( }
[fem]
element = "Q2"
contact = "hard"
solver = "full"
yield_stress = "0.01 E*"
[report]
fields = 1
)";
}

} // namespace asperity::program
