#include "app/cli/board_command.hpp"

#include "app/board/board_site.hpp"
#include "app/run/output.hpp"
#include "app/run/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace asperity::app {

ExitCode build_board(const BoardCommand& command) {
  const std::filesystem::path site =
      command.out.empty() ? std::filesystem::path("out/board-site")
                          : std::filesystem::path(command.out);
  const OutputFolder lock(site, "board " + command.folder,
                          {"index.html", "board.json", "figures/"});
  const std::vector<BoardProblem> board = read_board(command.folder, site);
  write_site(board, site);
  fmt::print("board: {}\n", (site / "index.html").string());
  if (wants_json())
    emit_answer(json_of_file(site / "board.json"));
  const bool has_failed =
      std::ranges::any_of(board, [](const BoardProblem& problem) {
        return std::ranges::any_of(
            problem.entries, [](const BoardEntry& entry) {
              return entry.state == BoardEntry::State::failed;
            });
      });
  return has_failed ? exit_expectation_failed : exit_good;
}

} // namespace asperity::app
