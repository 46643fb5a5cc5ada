#include "reports/pages/drawn_groups.hpp"

#include "base/parallel_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <thread>

namespace asperity::reports {
namespace {

/// Returns a folder in which no figure of `taken` has that name. This is needed
/// because the names of two methods can be converted to the same file name.
std::filesystem::path own_folder(const std::filesystem::path& folder,
                                 const std::string& name,
                                 std::set<std::filesystem::path>& taken) {
  std::filesystem::path own = folder;
  for (int i = 2; !taken.insert(own / name).second; ++i)
    own = folder / std::to_string(i);
  return own;
}

/// A figure to draw, with its place among the groups.
struct FigureTurn {
  const Figure& figure;
  std::size_t group; ///< of those that are drawn
  std::size_t place;
  std::filesystem::path folder;
  std::string journal_problem = {};
};

} // namespace

std::vector<DrawnGroup> drawn_groups_of(std::span<const FigureGroup> groups,
                                        const std::filesystem::path& folder,
                                        const std::string& gnuplot,
                                        const JournalFormat& journal,
                                        std::vector<std::string>& problems) {
  const std::filesystem::path journal_folder = folder / "journal";
  const bool has_journal = !journal.endings.empty();
  if (has_journal)
    keep_edited(journal_folder, folder);
  std::vector<DrawnGroup> drawn;
  std::vector<FigureTurn> turns;
  std::set<std::filesystem::path> taken;
  for (const auto& [heading, own, figures] : groups) {
    if (figures.empty())
      continue;
    for (std::size_t f = 0; f < figures.size(); ++f)
      turns.push_back(
          {figures[f], drawn.size(), f,
           own_folder(folder / "figures" / own, figures[f].name, taken)});
    drawn.push_back({heading, std::vector<DrawnFigure>(figures.size())});
  }
  const int threads =
      std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  parallel_rows(static_cast<int>(turns.size()), threads, [&](int i) {
    FigureTurn& turn = turns[static_cast<std::size_t>(i)];
    drawn[turn.group].figures[turn.place] =
        draw(turn.figure, turn.folder, gnuplot);
    if (has_journal)
      turn.journal_problem = draw_for_journal(
          turn.figure, journal,
          journal_folder /
              std::filesystem::relative(turn.folder, folder / "figures"),
          gnuplot);
  });
  const auto report = [&problems](const std::string& name,
                                  const std::string& problem) {
    if (!problem.empty())
      problems.push_back(fmt::format("{}: {}", name, problem));
  };
  for (const FigureTurn& turn : turns) {
    const DrawnFigure& figure = drawn[turn.group].figures[turn.place];
    report(figure.name, figure.problem);
    report("journal/" + figure.name, turn.journal_problem);
  }
  if (has_journal)
    record_drawn(journal_folder);
  return drawn;
}

} // namespace asperity::reports
