#include "run/mpi_world.hpp"

#include "base/json.hpp"
#include "fem/plugin.hpp"
#include "run/child_run.hpp"
#include "run/run_case.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

namespace asperity::run {
namespace {

/// Reads the environment variables that mpirun sets: the first is that of Open
/// MPI, the second that of MPICH and related implementations.
bool is_one_of_several() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name))
      return std::string(size) != "1";
  return false;
}

nlohmann::ordered_json json_of(const RankedRun& run) {
  std::vector<std::string> logs;
  for (const std::filesystem::path& log : run.logs)
    logs.push_back(log.string());
  return {{"words", run.words}, {"last_words", run.last_words}, {"logs", logs}};
}

/// Runs the command of this rank, if there is one.
void run_own_command(const nlohmann::ordered_json& run) {
  const auto i =
      static_cast<std::size_t>(fem::load_fem_module().rank_group().rank());
  if (i >= run.at("last_words").size())
    return;
  auto words = run.at("words").get<std::vector<std::string>>();
  words.push_back(run.at("last_words")[i].get<std::string>());
  const std::filesystem::path log = run.at("logs")[i].get<std::string>();
  std::filesystem::create_directories(log.parent_path());
  run_self(words, log);
}

/// Rank 0 alone talks to the user, but for failures of one rank.
void silence_standard_output() {
  if (std::freopen("/dev/null", "w", stdout) == nullptr)
    throw std::system_error(errno, std::generic_category(), "/dev/null");
}

/// What rank 0 tells the others is a run of a case or of their commands.
void follow(const std::string& text) {
  silence_standard_output();
  const nlohmann::ordered_json run = json_of_text(text);
  if (run.contains("words"))
    run_own_command(run);
  else
    follow_run(text);
}

} // namespace

bool has_followed_rank_0() {
  return is_one_of_several() && fem::load_fem_module().has_followed(follow);
}

void end_at_once_of_several(int exit_code) {
  if (!is_one_of_several())
    return;
  std::fflush(nullptr);
  std::_Exit(exit_code); // mpirun ends the others
}

int n_mpi_ranks() {
  // Asked once: MPI serves one thread at a time.
  static const int ranks =
      is_one_of_several() ? fem::load_fem_module().ranks() : 1;
  return ranks;
}

int n_ranks_on_machine() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"})
    if (const char* size = std::getenv(name))
      return std::max(1, std::atoi(size));
  return n_mpi_ranks();
}

void run_on_ranks(const RankedRun& run) {
  const nlohmann::ordered_json text = json_of(run);
  fem::load_fem_module().on_all_ranks(text_of_json(text, -1),
                                      [&] { run_own_command(text); });
}

} // namespace asperity::run
