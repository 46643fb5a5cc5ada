#include "md/lammps/lammps_contact.hpp"

#include "base/atomic_file.hpp"
#include "base/require.hpp"
#include "md/contact/request_parts.hpp"
#include "md/contact/step_reading.hpp"
#include "md/lammps/lammps_answer.hpp"
#include "md/lammps/lammps_block.hpp"
#include "md/lammps/lammps_input.hpp"
#include "md/lammps/lammps_run.hpp"
#include "md/lattice/slab_symbol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace asperity::md {
namespace {

using mechanics::Control;

double height_above(const LammpsBlock& block) {
  return *std::max_element(block.heights.begin(), block.heights.end()) +
         start_clearance;
}

/// Lateral displacements from the lattice sites, and heights.
struct Layer {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;

  LayerView view() const { return {x, y, z}; }
};

Layer lowest_layer(const LammpsBlock& block, const BlockVectors& positions) {
  const BlockVectors sites = undeformed(block, 0.0);
  Layer layer;
  for (std::size_t i = 0; i < block.layer.size(); ++i) {
    layer.x.push_back(positions[i][0] - sites[i][0]);
    layer.y.push_back(positions[i][1] - sites[i][1]);
    layer.z.push_back(positions[i][2]);
  }
  return layer;
}

double norm(const BlockVectors& vectors) {
  double sum = 0.0;
  for (const auto& [x, y, z] : vectors)
    sum += x * x + y * y + z * z;
  return std::sqrt(sum);
}

class LammpsContact final : public AtomicContact {
public:
  explicit LammpsContact(AtomRequest request);

  AtomStep solve(const mechanics::LoadTarget& target, int step,
                 const Watch& watch) override;
  std::string description() const override;
  double effective_contact_modulus() const override;

private:
  void write_inputs(const mechanics::LoadTarget& target) const;
  bool go_on(const std::string& log, const Watch& watch) const;
  void fill(const LammpsAnswer& answer, Control control,
            AtomStep& result) const;
  void set_convergence(AtomStep& result) const;

  AtomRequest request_;
  LammpsBlock block_;
  Interface interface_;
  std::filesystem::path folder_;
  LammpsProgram program_;
  BlockVectors start_; ///< initial state of the next step: the block above the
                       ///< substrate, then the last valid solution
};

LammpsContact::LammpsContact(AtomRequest request)
    : request_(std::move(request)),
      block_(lammps_block(request_)),
      interface_(block_.interaction, block_.layer, block_.substrate,
                 block_.heights, request_.threads),
      folder_(request_.scratch / "lammps"),
      program_(find_lammps(request_.settings.ranks, folder_)),
      start_(undeformed(block_, height_above(block_))) {
  write_file_atomically(folder_ / lammps_file::block,
                        data_file(block_, height_above(block_)));
  write_file_atomically(folder_ / lammps_file::table,
                        pair_table(block_.interaction));
}

AtomStep LammpsContact::solve(const mechanics::LoadTarget& target, int step,
                              const Watch& watch) {
  if (target.control == Control::nominal_pressure)
    require_positive("nominal pressure", target.amount, "Pa");
  write_inputs(target);

  const std::string log = fmt::format("step-{:04}.log", step);
  const LammpsRun run = run_lammps(
      program_, folder_, lammps_file::input, log,
      [&](const std::string& so_far) { return go_on(so_far, watch); });
  AtomStep result;
  result.evaluations = evaluations_in(file_text(folder_ / log));
  result.note = run.note;
  if (!run.finished)
    return result;
  try {
    LammpsAnswer answer = read_answer(block_, folder_);
    fill(answer, target.control, result);
    set_convergence(result);
    if (invalidity_reason(result.inspection, block_.layer.size()).empty())
      start_ = std::move(answer.positions);
    if (request_.settings.dump)
      std::filesystem::rename(folder_ / lammps_file::answer,
                              folder_ / fmt::format("step-{:04}.dump", step));
  } catch (const std::runtime_error& error) {
    result.note =
        fmt::format("{} (see {})", error.what(), (folder_ / log).string());
  }
  return result;
}

/// Writes the input files and removes the output of the previous step, so that
/// it cannot be mistaken for the result of this step.
void LammpsContact::write_inputs(const mechanics::LoadTarget& target) const {
  const mechanics::MdSettings& settings = request_.settings;
  LammpsTask task;
  task.control = target.control;
  task.amount = target.control == Control::mean_gap
                    ? target.amount + settings.contact_distance
                    : target.amount;
  task.start_height = mean_height(block_, start_);
  task.tolerance = settings.tolerance;
  task.max_evaluations = settings.max_evaluations;
  write_file_atomically(folder_ / lammps_file::start,
                        positions_file(block_, start_));
  write_file_atomically(folder_ / lammps_file::input,
                        input_script(block_, task));
  for (const char* name :
       {lammps_file::answer, lammps_file::contact, lammps_file::energies})
    std::filesystem::remove(folder_ / name);
}

bool LammpsContact::go_on(const std::string& log, const Watch& watch) const {
  if (!watch)
    return true;
  const std::optional<LammpsProgress> progress = progress_in(log);
  if (!progress)
    return watch({0, 0.0, std::numeric_limits<double>::infinity()});
  return watch(
      {progress->iterations, progress->energy,
       residual(block_, progress->force_norm, std::abs(progress->push))});
}

void LammpsContact::fill(const LammpsAnswer& answer, Control control,
                         AtomStep& result) const {
  const std::size_t n = block_.layer.size();
  const double area = block_.layer.area();
  const Layer layer = lowest_layer(block_, answer.positions);
  std::vector<double> forces;
  for (std::size_t i = 0; i < n; ++i)
    forces.push_back(answer.contact[i][2]);
  read_maps(
      interface_, block_.layer, layer.view(), forces,
      {request_.settings.contact_distance, close_distance(request_.settings)},
      result);
  result.mean_gap = mean_height(block_, answer.positions) -
                    request_.settings.contact_distance;
  // |sum r| <= sqrt(M) |r| of the M atoms that move, see residual().
  result.pressure_tolerance =
      request_.settings.tolerance * mean_size(result.pressure) *
      std::sqrt(static_cast<double>(answer.positions.size()) /
                static_cast<double>(n));
  result.gap_tolerance = gap_accuracy * request_.settings.contact_distance;
  result.elastic_energy = answer.bond_energy / area;
  result.interface_energy = answer.pair_energy / area;
  // Under a prescribed height, a block beyond the range of the interaction is
  // in equilibrium. Under a prescribed pressure it is not, because nothing
  // supports the load.
  const bool is_free = control == Control::mean_gap &&
                       std::isinf(result.inspection.shortest_distance);
  result.residual = is_free
                        ? 0.0
                        : residual(block_, norm(answer.forces),
                                   mean_size(forces) * static_cast<double>(n));
}

void LammpsContact::set_convergence(AtomStep& result) const {
  const double tolerance = request_.settings.tolerance;
  result.note = invalidity_reason(result.inspection, block_.layer.size());
  if (result.note.empty() && !(result.residual <= tolerance))
    result.note = fmt::format("residual {} after {} evaluations, but must "
                              "be at most {}",
                              number_text(result.residual, tolerance, 3),
                              result.evaluations,
                              number_text(tolerance, result.residual, 3));
  result.converged = result.note.empty();
}

std::string LammpsContact::description() const {
  return fmt::format("central lattice {0} x {0} x {1} by LAMMPS {2}, {3}, "
                     "effective E* at q a = 0.1: {4:.5g} Pa",
                     block_.layer.points_x, block_.cells + 1, program_.version,
                     program_.ranks == 1
                         ? "one process"
                         : fmt::format("{} processes", program_.ranks),
                     effective_contact_modulus());
}

double LammpsContact::effective_contact_modulus() const {
  constexpr double angle = 0.1;
  return SlabSymbol(block_.crystal).contact_modulus(angle, 0.0, block_.cells);
}

} // namespace

std::unique_ptr<AtomicContact> make_lammps_contact(AtomRequest request) {
  return std::make_unique<LammpsContact>(std::move(request));
}

} // namespace asperity::md
