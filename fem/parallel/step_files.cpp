#include "fem/parallel/step_files.hpp"

#include "base/atomic_file.hpp"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace asperity::fem {
namespace {

namespace mpi = dealii::Utilities::MPI;
namespace fs = std::filesystem;

/// Runs an action that may fail on one rank only, so that no rank waits
/// forever.
/// @throws std::runtime_error  on every rank, with the message of the first
///                             rank that failed
void all_or_none(const std::function<void()>& action) {
  std::string complaint;
  try {
    action();
  } catch (const std::exception& error) {
    complaint = error.what();
  }
  for (const std::string& one : mpi::all_gather(MPI_COMM_WORLD, complaint))
    if (!one.empty())
      throw std::runtime_error(one);
}

std::string printed(const std::function<void(std::ostream&)>& print) {
  std::ostringstream text;
  print(text);
  return text.str();
}

std::string step_name(const std::string& stem, std::size_t step) {
  return fmt::format("{}_{:04}", stem, step);
}

std::string part_name(const std::string& stem, std::size_t step,
                      unsigned int rank) {
  return fmt::format("{}.{:04}.vtu", step_name(stem, step), rank);
}

void write_list_of_parts(const fs::path& folder, const StepSeries& series,
                         std::size_t step) {
  std::vector<std::string> parts;
  for (unsigned int r = 0; r < mpi::n_mpi_processes(MPI_COMM_WORLD); ++r)
    parts.push_back(part_name(series.stem, step, r));
  write_file_atomically(
      folder / (step_name(series.stem, step) + ".pvtu"),
      printed([&](std::ostream& to) { series.list(to, parts); }));
}

void write_list_of_steps(const fs::path& folder, const std::string& stem,
                         const std::vector<double>& times) {
  std::vector<std::pair<double, std::string>> steps;
  for (std::size_t step = 0; step < times.size(); ++step)
    steps.emplace_back(times[step], step_name(stem, step) + ".pvtu");
  write_file_atomically(folder / (stem + ".pvd"),
                        printed([&](std::ostream& to) {
                          dealii::DataOutBase::write_pvd_record(to, steps);
                        }));
}

} // namespace

std::vector<double> times_of(const std::vector<double>& nominal_pressures) {
  const bool grows =
      std::adjacent_find(nominal_pressures.begin(), nominal_pressures.end(),
                         std::greater_equal<>()) == nominal_pressures.end();
  if (grows)
    return nominal_pressures;
  std::vector<double> numbers(nominal_pressures.size());
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return numbers;
}

void write_step(const fs::path& folder, const std::vector<StepSeries>& series,
                const std::vector<double>& nominal_pressures) {
  const std::size_t step = nominal_pressures.size() - 1;
  const unsigned int rank = mpi::this_mpi_process(MPI_COMM_WORLD);
  all_or_none([&] {
    if (!folder.empty())
      fs::create_directories(folder);
    for (const StepSeries& one : series)
      write_file_atomically(folder / part_name(one.stem, step, rank),
                            printed(one.part));
  });
  all_or_none([&] {
    if (rank != 0)
      return;
    for (const StepSeries& one : series)
      write_list_of_parts(folder, one, step);
    for (const StepSeries& one : series)
      write_list_of_steps(folder, one.stem, times_of(nominal_pressures));
  });
}

} // namespace asperity::fem
