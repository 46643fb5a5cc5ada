#pragma once

// The scripts by which Slurm computes the parts of a run as an array of tasks
// and merges them afterwards.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::run {

/// What Slurm is told about a run.
struct SlurmJob {
  std::string case_name;
  std::vector<std::string> words; ///< arguments that run the whole case
  int n_parts = 1;
  std::filesystem::path program; ///< absolute path of asperity
  std::filesystem::path folder;  ///< absolute output folder of the run
  int threads = 1;               ///< of a task
  std::string time;   ///< limit of a task, in a format of Slurm: "1:30:00";
                      ///< empty: that of the partition
  double memory = 0.; ///< of a task [B]
};

/// Returns a word as a POSIX shell reads it: 'it'\''s' for it's.
std::string quoted_word(const std::string& word);

/// Returns the texts of the scripts by their names: parts.sh, the array of
/// tasks; merge.sh, which joins them; and submit.sh, which submits the first
/// and, to begin after it has succeeded, the second. Submitting them again
/// computes only what is missing.
std::map<std::string, std::string> slurm_scripts(const SlurmJob& job);

/// Writes the scripts into folder/slurm, where equal ones may be already.
/// @throws input::InputError  a script is there with another text; nothing is
///                            written
void write_slurm_scripts(const std::map<std::string, std::string>& scripts,
                         const std::filesystem::path& folder);

/// @throws input::InputError  the text is not one of the formats of Slurm's
///                            --time: minutes, minutes:seconds,
///                            hours:minutes:seconds, or days-hours with these
void require_slurm_time(const std::string& text);

} // namespace asperity::run
