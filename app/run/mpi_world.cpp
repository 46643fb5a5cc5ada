#include "app/run/mpi_world.hpp"

#include "app/methods/shared_load_steps.hpp"
#include "app/methods/shared_surface.hpp"
#include "app/run/child_run.hpp"
#include "app/run/shared_stress.hpp"
#include "base/peak_memory.hpp"
#include "fem/plugin.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "ranks/rank_sums.hpp"

namespace asperity::app {
namespace {

/// Reads the environment variables that mpirun sets: the first is that of Open
/// MPI, the second that of MPICH and related implementations.
bool is_one_of_several() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name))
      return std::string(size) != "1";
  return false;
}

nlohmann::json json_of(const RankedRun& run) {
  std::vector<std::string> logs;
  for (const std::filesystem::path& log : run.logs)
    logs.push_back(log.string());
  return {{"words", run.words}, {"last_words", run.last_words}, {"logs", logs}};
}

constexpr const char* memory_key = "largest peak memory";

/// The largest peak memory of the ranks [B]. Collective.
double peak_memory_of_ranks() {
  return rank_max(&fem::load_fem_module().rank_group(), peak_memory());
}

void run_own_share(const std::string& text, int rank) {
  if (is_for_shared_steps(text)) {
    follow_shared_steps(text);
    return;
  }
  if (is_for_shared_surface(text)) {
    follow_shared_surface(text);
    return;
  }
  if (is_for_shared_stress(text)) {
    follow_shared_stress(text);
    return;
  }
  const nlohmann::json run = nlohmann::json::parse(text);
  if (run.contains(memory_key)) {
    static_cast<void>(peak_memory_of_ranks());
    return;
  }
  const auto i = static_cast<std::size_t>(rank);
  if (i >= run.at("last_words").size())
    return;
  auto words = run.at("words").get<std::vector<std::string>>();
  words.push_back(run.at("last_words")[i].get<std::string>());
  const std::filesystem::path log = run.at("logs")[i].get<std::string>();
  std::filesystem::create_directories(log.parent_path());
  run_self(words, log);
}

} // namespace

bool has_followed_rank_0() {
  return is_one_of_several() &&
         fem::load_fem_module().has_followed(run_own_share);
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

double largest_peak_memory() {
  if (n_mpi_ranks() == 1)
    return peak_memory();
  double largest = 0.0;
  fem::load_fem_module().on_all_ranks(
      nlohmann::json{{memory_key, true}}.dump(),
      [&](const std::string&, int) { largest = peak_memory_of_ranks(); });
  return largest;
}

void run_on_ranks(const RankedRun& run) {
  fem::load_fem_module().on_all_ranks(json_of(run).dump(), run_own_share);
}

} // namespace asperity::app
