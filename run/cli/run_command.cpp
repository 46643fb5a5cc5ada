#include "run/cli/run_command.hpp"

#include "input/input_error.hpp"
#include "reports/pages/paper_report.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "run/arguments/case_library.hpp"
#include "run/arguments/map_case.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/case_run.hpp"
#include "run/cli/checks.hpp"
#include "run/cli/part_commands.hpp"
#include "run/cli/sweep_commands.hpp"
#include "run/interrupt.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/chosen.hpp"
#include "run/mpi_world.hpp"
#include "run/new_output.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"
#include "run/plan/description.hpp"
#include "run/plan/plan.hpp"
#include "run/plan/preparation.hpp"
#include "run/plan/skipped.hpp"
#include "run/result_outputs.hpp"
#include "suite/bench/runs/bench.hpp"
#include "suite/bench/runs/target_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <optional>

namespace asperity::cli {
run::RunOptions options_of(const run::ReadCase& read,
                           const std::filesystem::path& folder,
                           const RunCommand& command, methods::Cache& cache) {
  run::RunOptions options{folder,          command.methods, command.resume,
                          command.threads, read.reference,  &cache};
  options.has_report = !command.no_report;
  options.ranks = run::n_mpi_ranks();
  options.ranks_on_machine = run::n_ranks_on_machine();
  return options;
}

namespace {

namespace fs = std::filesystem;

/// Runs a case at the setting chosen for the target error, then verifies the
/// error.
run::ExitCode run_to_target(const run::ReadCase& read,
                            const RunCommand& command,
                            const run::RunOptions& options) {
  if (read.found.file.empty())
    throw input::InputError("--target-error needs a case file: asperity new "
                            "NAME --map FILE writes one");
  cases::Case named = read.contact_case;
  named.methods = methods::chosen_methods(named, options.methods);
  bench::TargetRun target(named, read.found.file, read.overrides,
                          options.folder,
                          bench::read_target_error(command.target_error));
  if (!target.is_chosen())
    return run::exit_not_converged;
  run::ExitCode end = run::exit_good;
  do {
    const cases::Case chosen = target.chosen_case();
    end = run_one(chosen, options, {.is_omitted = true});
    if (run::is_interrupted())
      return end;
    if (target.verify(chosen, options.folder))
      break;
    end = worse(end, run::exit_expectation_failed);
  } while (target.choose_again());
  target.record(options.folder);
  return command.no_report
             ? end
             : worse(end,
                     print_findings(run::write_outputs(options.folder,
                                                       command.has_pdf, true),
                                    options.folder));
}

/// A folder of maps is read as a whole, so that nothing is written into it.
void require_other_folder(const run::NamedMaps& maps, const fs::path& output) {
  for (const std::string& folder : maps.folders) {
    std::error_code error;
    if (fs::equivalent(folder, output, error))
      throw input::InputError(fmt::format(
          "{}: is the folder of the maps, but the output folder must be "
          "another one; please name it by --out",
          output.string()));
  }
}

/// out/NAME with the name of the folder of the maps.
fs::path folder_of_maps(const std::vector<fs::path>& maps,
                        const std::string& out) {
  const fs::path of_first = maps.front().parent_path();
  const bool is_common = std::ranges::all_of(
      maps, [&](const fs::path& map) { return map.parent_path() == of_first; });
  return folder_of(is_common && !of_first.filename().empty()
                       ? of_first.filename().string()
                       : "maps",
                   out, 1);
}

run::ExitCode print_plans(const std::vector<run::NamedCases>& all,
                          const RunCommand& command, methods::Cache& cache) {
  std::string json;
  for (const run::NamedCases& named : all) {
    if (named.sweep)
      print_sweep_plan(*named.sweep, command);
    for (const run::ReadCase& read : named.cases) {
      run::RunOptions options = options_of(read, {}, command, cache);
      if (is_for_ranks(named, command)) // each works on other parts of the run
        options.ranks = options.ranks_on_machine = 1;
      const run::Plan plan = run::make_plan(read.contact_case, options);
      const std::vector<cases::MethodSpec> methods =
          methods::chosen_methods(read.contact_case, options.methods);
      run::require_surface(read.contact_case, methods,
                           run::grid_of_case(read.contact_case, methods));
      fmt::print("{}{}", run::plan_text(plan, read.contact_case),
                 run::shared_rows_text(plan));
      json +=
          (json.empty() ? "" : ",\n") + run::plan_json(plan, read.contact_case);
    }
  }
  if (run::wants_json())
    run::emit_answer("[" + json + "]\n");
  return run::exit_good;
}

/// A part of a collection that has a result.
struct RunPart {
  run::FoundCase part;
  std::filesystem::path folder; ///< folder of the result
};

/// Writes folder/report.html and the files that belong to it. Does nothing if
/// no part has run.
/// @param has_pdf  also print the report to report.pdf
void write_collection_report(const run::FoundCases& collection,
                             const std::vector<RunPart>& parts,
                             const std::filesystem::path& folder,
                             bool has_pdf) {
  if (parts.empty())
    return;
  std::vector<results::Result> results;
  std::vector<cases::Case> contact_cases;
  for (const RunPart& part : parts) {
    results.push_back(
        results::read_result(part.folder, results::MapsInFile::large));
    contact_cases.push_back(reports::case_of(results.back()));
  }
  std::vector<reports::PaperPart> pages;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::filesystem::path part = parts[i].part.file.parent_path();
    const std::string name = part.filename().string();
    const auto figures = collection.figures.find(name);
    pages.push_back(
        {name, parts[i].folder, run::text_of_file(part / "README.md"),
         figures == collection.figures.end() ? std::vector<std::string>()
                                             : figures->second,
         reports::entry_of(results[i], contact_cases[i])});
  }
  const std::string readme = run::text_of_file(collection.folder / "README.md");
  run::print_undrawn(
      reports::write_paper_report(pages, readme, folder, {.has_pdf = has_pdf}));
  fmt::print("report on all parts: {}\n", (folder / "report.html").string());
}

/// A sweep, or what the ranks of mpirun share.
run::ExitCode run_apart(const run::NamedCases& named, const RunCommand& command,
                        run::JsonAnswer& answer) {
  const std::string& name =
      named.sweep ? named.sweep->sweep.name : named.cases.front().found.name;
  const fs::path folder =
      named.sweep && !named.sweep->text.empty() // of several maps
          ? named.sweep->found.file.parent_path()
          : folder_of(name, command.out, command.cases.size());
  const run::ExitCode ended =
      is_for_ranks(named, command)
          ? run_over_ranks(named, command, folder)
          : run_named_sweep(*named.sweep, command, folder);
  add_answer(answer, name, run::latest_output(folder), ended);
  return ended;
}

run::ExitCode run_asked(const run::NamedCases& named, const RunCommand& command,
                        methods::Cache& cache, run::JsonAnswer& answer) {
  if (named.sweep || is_for_ranks(named, command))
    return run_apart(named, command, answer);
  const bool is_collection = !named.found.collection.empty();
  const std::size_t n_targets = command.cases.size();
  run::ExitCode end = run::exit_good;
  std::vector<RunPart> parts;
  const fs::path collection =
      folder_of(named.found.collection, command.out, n_targets);
  std::optional<run::OutputFolder> collection_lock;
  if (is_collection) {
    collection_lock.emplace(collection, "run " + named.found.collection,
                            run::report_outputs());
    run::remove_output(collection); // belongs to the parts of the last run
  }
  for (const run::ReadCase& read : named.cases) {
    const fs::path folder = folder_of_part(named, read, command.out, n_targets);
    const run::OutputFolder lock(folder, "run " + read.found.name,
                                 run::run_outputs(read.contact_case),
                                 run::input_files(read.contact_case));
    const run::RunOptions options = options_of(read, folder, command, cache);
    const run::ExitCode ended =
        command.target_error.empty()
            ? run_one(read.contact_case, options,
                      {command.no_report, command.has_pdf})
            : run_to_target(read, command, options);
    end = worse(end, ended);
    add_answer(answer, read.found.name, run::latest_output(folder), ended);
    parts.push_back({read.found, run::latest_output(folder)});
    if (run::is_interrupted())
      break;
  }
  if (is_collection && !command.no_report)
    write_collection_report(named.found, parts, collection, command.has_pdf);
  return end;
}

} // namespace

void add_answer(run::JsonAnswer& answer, const std::string& name,
                const fs::path& folder, run::ExitCode exit_code) {
  if (!run::wants_json())
    return;
  if (is_sweep_folder(folder)) {
    add_sweep_answer(answer, folder, exit_code);
    return;
  }
  if (!run::is_result(folder)) {
    answer.add(name, folder, exit_code, nullptr, "there is no result");
    return;
  }
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  const cases::Case contact_case = reports::case_of(result);
  const reports::Summary summary =
      reports::entry_of(result, contact_case).summary;
  answer.add(name, folder, exit_code, &summary);
}

fs::path folder_of(const std::string& name, const std::string& out,
                   std::size_t n_targets) {
  if (out.empty())
    return fs::path("out") / name;
  return n_targets == 1 ? fs::path(out) : fs::path(out) / name;
}

fs::path folder_of_part(const run::NamedCases& named, const run::ReadCase& part,
                        const std::string& out, std::size_t n_targets) {
  const std::string& collection = named.found.collection;
  return collection.empty() ? folder_of(part.found.name, out, n_targets)
                            : folder_of(collection, out, n_targets) /
                                  part.found.file.parent_path().filename();
}

std::vector<run::NamedCases> read_asked(const RunCommand& command) {
  if (!command.against.empty())
    return {read_faces(command)};
  run::NamedMaps maps = run::maps_among(command.cases);
  if (!maps.folders.empty() || maps.files.size() > 1) {
    const fs::path folder = folder_of_maps(maps.files, command.out);
    require_other_folder(maps, folder);
    std::vector<run::NamedCases> of_maps{
        run::read_maps(maps, command.overrides, command.options, folder)};
    run::print_left_out(maps);
    return of_maps;
  }
  std::vector<run::NamedCases> all;
  for (const std::string& word : command.cases)
    all.push_back(run::read_named_cases_or_sweep(
        word, command.overrides, command.is_quick, command.options));
  run::name_apart(all, command.cases);
  return all;
}

namespace {

run::ExitCode run_read_cases(const std::vector<run::NamedCases>& all,
                             const RunCommand& command) {
  run::catch_interrupts();
  methods::Cache cache(methods::cache_folder(),
                       command.uses_cache ? methods::cache_size() : 0);
  if (command.is_dry)
    return print_plans(all, command, cache);
  if (!command.part.empty())
    return run_part(all, command, cache);
  run::JsonAnswer answer("asperity-run");
  run::ExitCode end = run::exit_good;
  for (const run::NamedCases& named : all) {
    end = worse(end, run_asked(named, command, cache, answer));
    if (run::is_interrupted())
      break;
  }
  answer.print(end);
  return end;
}

} // namespace

run::ExitCode run_cases(const RunCommand& command) {
  if (command.has_pdf)
    require_pdf_program();
  const std::vector<run::NamedCases> all = read_asked(command);
  return run::without_lines_of(run::made_case_of(all.front()),
                               [&] { return run_read_cases(all, command); });
}

void add_run(CommandLine& line) {
  auto [command, run] =
      line.add<RunCommand>("run",
                           "Run cases; write result, tables and report\n"
                           "of each.",
                           run_cases);
  command
      ->add_option("case", run.cases,
                   "case files, their folders, shipped cases or\n"
                   "collections (see 'asperity list'), measured maps or\n"
                   "folders of maps")
      ->required();
  add_methods(command, run.methods.names);
  add_case_options(command, run.options);
  add_overrides(command, run.overrides);
  CLI::Option* against =
      command->add_option("--against", run.against,
                          "map of the face that lies on the one map, turned\n"
                          "over along x: two rough faces on each other");
  command->add_option("--out", run.out, "output folder (default: out/<case>)");
  command->add_flag("--resume", run.resume,
                    "compute the steps missing from an earlier run");
  add_quick(command, run.is_quick);
  CLI::Option* target =
      command->add_option("--target-error", run.target_error,
                          "use the cheapest setting whose predicted error is\n"
                          "smaller, e.g. 1%; a finer run verifies the error");
  command->add_flag("--exactly", run.methods.is_exact,
                    "--methods gives full names only: fem does not\n"
                    "include fem.hard");
  command->add_flag("--no-report", run.no_report, "write result.h5 only");
  CLI::Option* pdf =
      command->add_flag("--pdf", run.has_pdf,
                        "also print the report to report.pdf, by chromium\n"
                        "or weasyprint");
  command
      ->add_flag("--dry-run", run.is_dry,
                 "print the plan, the predicted memory and what is\n"
                 "skipped; write nothing")
      ->excludes(against);
  command->add_flag("!--no-cache", run.uses_cache,
                    "compute every step; do not read or write the cache");
  command
      ->add_option("--part", run.part,
                   "compute one of N shares of the realisations or\n"
                   "points, I/N as in 3/8; 'asperity merge' joins them")
      ->excludes(target)
      ->excludes(pdf)
      ->excludes(against);
  add_threads(command, run.threads);
  add_quiet(command, line.output);
  add_json(command, line.output, "the summaries, or the plans,");
  line.on_cases.insert("run");
  add_example(command, "run polymer --methods fem,theory --set "
                       "surface.points=128");
}

} // namespace asperity::cli
