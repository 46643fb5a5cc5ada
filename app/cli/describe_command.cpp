#include "app/cli/describe_command.hpp"

#include "app/asked/asked_cases.hpp"
#include "app/cache/cache.hpp"
#include "app/plan/description.hpp"
#include "app/run/output.hpp"

#include <fmt/format.h>

namespace asperity::app {

ExitCode describe_cases(const DescribeCommand& command) {
  const Asked asked = read_asked(command.contact_case, command.overrides,
                                 command.is_quick, command.contact_modulus);
  Cache cache(cache_folder(), cache_size());
  std::string json;
  std::string text;
  for (const ReadCase& read : asked.cases) {
    RunOptions options{{}, command.methods, false, command.threads, ""};
    options.cache = &cache;
    const CaseDescription description =
        describe_case(read.contact_case, options);
    json += (json.empty() ? "" : ",\n") +
            description_json(description, read.contact_case);
    text += (text.empty() ? "" : "\n") +
            description_text(description, read.contact_case);
  }
  if (wants_json())
    emit_answer(asked.found.collection.empty() ? json : "[" + json + "]\n");
  else
    fmt::print("{}", text);
  return exit_good;
}

} // namespace asperity::app
