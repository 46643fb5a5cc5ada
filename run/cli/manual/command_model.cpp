#include "run/cli/manual/command_model.hpp"

#include <algorithm>
#include <map>

namespace asperity::cli {
namespace {

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

OptionModel model_of_option(const CLI::Option& option) {
  OptionModel model;
  for (const std::string& name : option.get_snames())
    model.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    model.names.push_back("--" + name);
  model.is_argument = option.get_positional();
  if (model.is_argument)
    model.names.push_back(option.get_name());
  if (option.get_items_expected_max() > 0)
    model.value = option.get_type_name();
  // Without the range that the parser appends.
  model.value = model.value.substr(0, model.value.find(':'));
  model.description = on_one_line(option.get_description());
  model.is_needed = option.get_required();
  return model;
}

/// Returns the example line that add_example() put into the footer.
std::string example_of(const CLI::App& command) {
  const std::string mark = "example:\n  asperity ";
  const std::string footer = command.get_footer();
  const std::size_t begin = footer.find(mark);
  if (begin == std::string::npos)
    return "";
  const std::size_t end = footer.find('\n', begin + mark.size());
  return footer.substr(begin + mark.size(), end - begin - mark.size());
}

CommandModel model_of_command(const CLI::App& command) {
  CommandModel model{command.get_name(),
                     on_one_line(command.get_description()),
                     example_of(command),
                     {},
                     false};
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty())
      model.options.push_back(model_of_option(*option));
  return model;
}

} // namespace

ProgramModel model_of(const CLI::App& program,
                      const std::set<std::string>& on_cases) {
  ProgramModel model{model_of_command(program), program.version(), {}};
  for (const CLI::App* command : program.get_subcommands(
           [](const CLI::App* one) { return !one->get_group().empty(); })) {
    model.commands.push_back(model_of_command(*command));
    model.commands.back().is_on_cases = on_cases.contains(command->get_name());
  }
  return model;
}

void name_values(CLI::App& program) {
  const std::map<std::string, std::string> values{
      {"--out", "DIR"},        {"--problem", "DIR"},    {"--junit", "FILE"},
      {"--set", "KEY=VALUE"},  {"--methods", "NAMES"},  {"--method", "NAME"},
      {"--target-error", "E"}, {"--threads", "N"},      {"--instances", "N"},
      {"--instance", "N"},     {"--first", "INDEX"},    {"--seed", "N"},
      {"--repeats", "N"},      {"--realizations", "N"}, {"--budget", "SECONDS"},
      {"--tolerance", "X"},    {"--map", "FILE"},       {"--part", "I/N"},
      {"--parts", "N"},        {"--time", "T"}};
  for (CLI::App* command :
       program.get_subcommands([](CLI::App*) { return true; }))
    for (const auto& [name, value] : values)
      if (CLI::Option* option = command->get_option_no_throw(name))
        option->type_name(value);
}

} // namespace asperity::cli
