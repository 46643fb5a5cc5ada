#include "cli/board_command.hpp"

#include "exchange/board/board_site.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace asperity::cli {

run::ExitCode build_board(const BoardCommand& command) {
  const std::filesystem::path site =
      command.out.empty() ? std::filesystem::path("out/board-site")
                          : std::filesystem::path(command.out);
  const run::OutputFolder lock(site, "board " + command.folder,
                               {"index.html", "board.json", "figures/"});
  const std::vector<exchange::BoardProblem> board =
      exchange::read_board(command.folder, site);
  exchange::write_site(board, exchange::open_problems(command.folder, board),
                       site);
  fmt::print("board: {}\n", (site / "index.html").string());
  if (run::wants_json())
    run::emit_answer(run::json_of_file(site / "board.json"));
  const bool has_failed =
      std::ranges::any_of(board, [](const exchange::BoardProblem& problem) {
        return std::ranges::any_of(
            problem.entries, [](const exchange::BoardEntry& entry) {
              return entry.state == exchange::BoardEntry::State::failed;
            });
      });
  return has_failed ? run::exit_expectation_failed : run::exit_good;
}

} // namespace asperity::cli
