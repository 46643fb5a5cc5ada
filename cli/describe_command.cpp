#include "cli/describe_command.hpp"

#include "methods/cache/cache.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/output.hpp"
#include "run/plan/description.hpp"

#include <fmt/format.h>

namespace asperity::cli {

run::ExitCode describe_cases(const DescribeCommand& command) {
  const run::NamedCases named =
      run::read_named_cases(command.contact_case, command.overrides,
                            command.is_quick, command.contact_modulus);
  methods::Cache cache(methods::cache_folder(), methods::cache_size());
  std::string json;
  std::string text;
  for (const run::ReadCase& read : named.cases) {
    run::RunOptions options{{}, command.methods, false, command.threads, ""};
    options.cache = &cache;
    const run::CaseDescription description =
        run::describe_case(read.contact_case, options);
    json += (json.empty() ? "" : ",\n") +
            run::description_json(description, read.contact_case);
    text += (text.empty() ? "" : "\n") +
            run::description_text(description, read.contact_case);
  }
  if (run::wants_json())
    run::emit_answer(named.found.collection.empty() ? json
                                                    : "[" + json + "]\n");
  else
    fmt::print("{}", text);
  return run::exit_good;
}

} // namespace asperity::cli
