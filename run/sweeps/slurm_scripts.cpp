#include "run/sweeps/slurm_scripts.hpp"

#include "base/atomic_file.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <vector>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_mib = 1024.0 * 1024.0;

/// Returns the lines that both kinds of tasks begin with. The log is a name in
/// the folder that submit.sh submits from, because Slurm would replace a % in
/// the path of a folder and has no way to write a quote.
std::string head_of_script(const SlurmJob& job, const std::string& name,
                           const std::string& log) {
  return fmt::format("#!/bin/sh\n"
                     "#SBATCH --job-name=\"{}\"\n"
                     "{}"
                     "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={}\n"
                     "#SBATCH --mem={:.0f}M\n"
                     "#SBATCH --output={} --open-mode=append\n",
                     good_name(name),
                     job.time.empty() ? ""
                                      : "#SBATCH --time=" + job.time + "\n",
                     job.threads, std::ceil(job.memory / bytes_per_mib), log);
}

std::string run_command(const SlurmJob& job) {
  std::string command = quoted_word(job.program.string());
  for (const std::string& word : job.words)
    command += " " + quoted_word(word);
  return command;
}

std::string parts_script(const SlurmJob& job) {
  return head_of_script(job, job.case_name, "part-%a.log") +
         fmt::format(
             "#SBATCH --array=1-{} --requeue\n"
             "# Computes one part. A part that is complete ends at once, and "
             "one\n"
             "# that was killed continues after its last load step.\n"
             "{} --threads {} --part \"$SLURM_ARRAY_TASK_ID/{}\"\n"
             "code=$?\n"
             "# 3: a load step did not converge, which the report will say.\n"
             "test $code -eq 3 && exit 0\n"
             "exit $code\n",
             job.n_parts, run_command(job), job.threads, job.n_parts);
}

std::string merge_script(const SlurmJob& job) {
  return head_of_script(job, "merge " + job.case_name, "merge.log") +
         fmt::format("# Joins the parts and writes the report.\n"
                     "exec {} merge {}\n",
                     quoted_word(job.program.string()),
                     quoted_word(job.folder.string()));
}

std::string submit_script(const SlurmJob& job) {
  return fmt::format(
      "#!/bin/sh\n"
      "# Submits all parts and, to begin when all of them have succeeded, "
      "their\n"
      "# merge. Submitted again after a failure, it computes what is missing.\n"
      "set -e\n"
      "cd {}\n"
      "parts=$(sbatch --parsable parts.sh)\n"
      "merge=$(sbatch --parsable --dependency=afterok:\"${{parts%%;*}}\" \\\n"
      "  --kill-on-invalid-dep=yes merge.sh)\n"
      "echo \"parts: job ${{parts%%;*}}, merge: job ${{merge%%;*}}\"\n",
      quoted_word((job.folder / "slurm").string()));
}

} // namespace

std::string quoted_word(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyz"
                                "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  std::string quoted = "'";
  for (const char letter : word)
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::map<std::string, std::string> slurm_scripts(const SlurmJob& job) {
  std::vector<std::string> words = job.words;
  words.push_back(job.program.string());
  words.push_back(job.folder.string());
  for (const std::string& word : words)
    if (std::ranges::any_of(
            word, [](unsigned char c) { return std::iscntrl(c) != 0; }))
      throw input::InputError(fmt::format(
          "{}: has a control character, such as a line end, which must not "
          "stand in a script; rename the file or folder",
          printable(word, longest_line)));
  return {{"parts.sh", parts_script(job)},
          {"merge.sh", merge_script(job)},
          {"submit.sh", submit_script(job)}};
}

void write_slurm_scripts(const std::map<std::string, std::string>& scripts,
                         const fs::path& folder) {
  const fs::path home = folder / "slurm";
  for (const auto& [name, text] : scripts)
    if (fs::exists(home / name) &&
        input::read_input_file(home / name, input::largest_text_file) != text)
      throw input::InputError(
          fmt::format("{} is there already, with another text; remove it, or "
                      "choose another --out",
                      (home / name).string()));
  fs::create_directories(home);
  for (const auto& [name, text] : scripts)
    if (!fs::exists(home / name))
      write_file_atomically(home / name, text);
}

void require_slurm_time(const std::string& text) {
  static const std::regex formats(
      "[0-9]+(:[0-9]{1,2}){0,2}|[0-9]+-[0-9]{1,2}(:[0-9]{1,2}){0,2}");
  if (!std::regex_match(text, formats))
    throw input::InputError(fmt::format(
        "--time {}: must be minutes, minutes:seconds, hours:minutes:seconds or "
        "days-hours, for example 90 or 1:30:00 or 2-12",
        text));
}

} // namespace asperity::run
