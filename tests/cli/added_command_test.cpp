// A command is one function that describes it and does its work: its help,
// manual page and completion follow.
#include "run/cli/command_line.hpp"
#include "run/cli/manual/command_model.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace asperity::cli::added_command_test {

struct Polish {
  std::string word;
  int strokes = 1;
};

Polish last; // what the command was given

run::ExitCode polish(const Polish& command) {
  last = command;
  return run::exit_not_converged;
}

void add_polish(CommandLine& line) {
  auto [command, options] =
      line.add<Polish>("polish", "Polish a case.", polish);
  command->add_option("case", options.word, "what is polished")->required();
  command->add_option("--strokes", options.strokes, "number of strokes")
      ->type_name("N");
  line.on_cases.insert("polish");
  add_example(command, "polish hertz");
}

/// The program with all of its commands and one more.
class AddedCommand : public ::testing::Test {
protected:
  AddedCommand() {
    line.program.require_subcommand(1);
    for (const AddCommand add : all_commands)
      add(line);
    add_polish(line);
  }

  ProgramModel model() const { return model_of(line.program, line.on_cases); }

  CommandLine line{CLI::App("Asperity")};
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(AddedCommand, IsParsedAndDone) {
  line.program.parse("polish hertz --strokes 3");

  EXPECT_EQ(line.action(), run::exit_not_converged);
  EXPECT_EQ(last.word, "hertz");
  EXPECT_EQ(last.strokes, 3);
}

TEST_F(AddedCommand, HasHelpManualAndCompletion) {
  const std::string page = manual_page(model(), "polish");
  const std::string bash = completion_script(model(), "bash");
  const std::string fish = completion_script(model(), "fish");

  EXPECT_TRUE(contains(line.program.help(), "Polish a case."));
  EXPECT_TRUE(contains(page, "Polish a case.")) << page;
  EXPECT_TRUE(contains(page, "Number of strokes.")) << page;
  EXPECT_TRUE(contains(page, "asperity polish hertz")) << page;
  EXPECT_TRUE(
      contains(bash, "polish) options=\"-h --help --strokes\" words=$cases"))
      << bash;
  EXPECT_TRUE(contains(fish, "-a polish -d 'Polish a case.'"));
}

TEST_F(AddedCommand, HasANameOfItsOwn) {
  std::set<std::string> names;
  for (const CommandModel& command : model().commands)
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
  EXPECT_GE(names.size(), 19U);
}

} // namespace asperity::cli::added_command_test
