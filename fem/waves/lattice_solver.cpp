#include "fem/waves/lattice_solver.hpp"

#include "base/parallel_rows.hpp"
#include "base/require.hpp"
#include "fem/waves/spring_face.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

namespace asperity::fem {
namespace {

using Modes = std::span<std::complex<double>>;

/// Converts the columns of u_x and u_y to those of w, with u = i w, or back.
/// w_y changes its sign with jy.
void turn(std::size_t component, bool is_back, SimdBatch* column) {
  if (component == 2)
    return;
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = (is_back != (component == 1 && side == 1)) ? -1.0 : 1.0;
    SimdBatch* const value = column + 2 * side;
    const SimdBatch real = value[0];
    value[0] = sign * value[1];
    value[1] = -sign * real;
  }
}

/// The part of a solve that a sweep over the wavevectors performs.
enum class Sweep { whole, down_to_face, up_from_face };

} // namespace

struct LatticeSolver::Parts {
  NodeLattice lattice;
  mechanics::FarBoundary far_boundary;
  int threads;
  NodeClassSpectra spectra;
  LatticeShare share;
  std::unique_ptr<const LatticeFactors> factors;
  SpringFace face;
  std::vector<std::complex<double>> modes;      ///< of every field
  std::vector<std::complex<double>> face_modes; ///< of one field
  std::vector<double> face_field, forces;
  std::vector<std::vector<double>> scratch;   ///< one per thread
  std::vector<std::vector<SimdBatch>> values; ///< a batch per thread

  Parts(const Grid& grid, int degree, const LayeredBlock& block, int n_threads,
        Among among)
      : lattice{grid, degree,
                block.layers.size() * static_cast<std::size_t>(degree) + 1},
        far_boundary(block.far_boundary),
        threads(n_threads),
        spectra(grid, degree),
        share(spectra, 3 * lattice.planes, among),
        factors(make_lattice_factors(spectra, degree, block, share.rows(),
                                     n_threads)),
        face(spectra, *factors, share,
             far_boundary == mechanics::FarBoundary::pressure, n_threads),
        modes(3 * lattice.planes * spectra.size()),
        face_modes(spectra.size()),
        face_field(grid.size()),
        forces(grid.size()),
        scratch(static_cast<std::size_t>(n_threads)),
        values(static_cast<std::size_t>(n_threads)) {
    for (std::vector<SimdBatch>& batch : values)
      batch.resize(lattice.planes * 3 * spectra.node_classes() * wave_columns);
  }

  bool is_held(std::size_t field) const {
    return field / 3 + 1 == lattice.planes && holds(far_boundary, field % 3);
  }

  Modes field_modes(std::size_t field) {
    return Modes(modes).subspan(field * spectra.size(), spectra.size());
  }

  /// The first value of a field in a batch; its node classes are 3 rows apart.
  std::size_t first_value(std::size_t field) const {
    return (field / 3 * 3 * spectra.node_classes() + field % 3) * wave_columns;
  }

  template <class DoField>
  void each_field(const DoField& do_field); ///< visits the own fields, with
                                            ///< scratch memory
  double total_force(std::span<const double> force) const; ///< in z [N]
  void transform(std::span<const double> force);
  void transform_back(std::span<double> displacement, double shift);
  void load(const WaveBatch& batch, SimdBatch* batch_values);
  void store(const WaveBatch& batch, SimdBatch* batch_values);
  void sweep(Sweep part);
  void sweep_batch(Sweep part, const WaveBatch& batch, SimdBatch* batch_values);
};

template <class DoField>
void LatticeSolver::Parts::each_field(const DoField& do_field) {
  const Range own = share.fields();
  parallel_turns(static_cast<int>(own.size()), threads,
                 [&](int turn, int worker) {
                   do_field(own.begin + static_cast<std::size_t>(turn),
                            scratch[static_cast<std::size_t>(worker)]);
                 });
}

double LatticeSolver::Parts::total_force(std::span<const double> force) const {
  std::vector<double> of_planes(lattice.planes, 0.0);
  for (std::size_t plane = 0; plane < lattice.planes; ++plane)
    if (const std::size_t field = 3 * plane + 2;
        share.fields().contains(field)) {
      const auto force_of_plane =
          force.subspan(field * lattice.grid.size(), lattice.grid.size());
      of_planes[plane] =
          std::accumulate(force_of_plane.begin(), force_of_plane.end(), 0.0);
    }
  share.add_up(of_planes);
  return std::accumulate(of_planes.begin(), of_planes.end(), 0.0);
}

void LatticeSolver::Parts::transform(std::span<const double> force) {
  each_field([&](std::size_t field, std::vector<double>& own_scratch) {
    if (!is_held(field))
      spectra.forward(
          force.subspan(field * lattice.grid.size(), lattice.grid.size()),
          field_modes(field), own_scratch);
  });
  share.fields_to_rows(modes);
}

void LatticeSolver::Parts::transform_back(std::span<double> displacement,
                                          double shift) {
  share.rows_to_fields(modes);
  each_field([&](std::size_t field, std::vector<double>& own_scratch) {
    const std::span<double> answer =
        displacement.subspan(field * lattice.grid.size(), lattice.grid.size());
    if (is_held(field)) {
      std::fill(answer.begin(), answer.end(), 0.0);
      return;
    }
    spectra.backward(field_modes(field), answer, own_scratch);
    if (shift != 0.0 && field % 3 == 2)
      for (double& value : answer)
        value += shift;
  });
}

void LatticeSolver::Parts::load(const WaveBatch& batch,
                                SimdBatch* batch_values) {
  for (std::size_t field = 0; field < 3 * lattice.planes; ++field) {
    SimdBatch* const first = batch_values + first_value(field);
    if (!is_held(field))
      spectra.load(field_modes(field), batch, 3, first);
    for (std::size_t node_class = 0; node_class < spectra.node_classes();
         ++node_class) {
      SimdBatch* const column = first + 3 * node_class * wave_columns;
      if (is_held(field))
        std::fill_n(column, wave_columns, SimdBatch{});
      turn(field % 3, false, column);
    }
  }
}

void LatticeSolver::Parts::store(const WaveBatch& batch,
                                 SimdBatch* batch_values) {
  for (std::size_t field = 0; field < 3 * lattice.planes; ++field) {
    if (is_held(field))
      continue;
    SimdBatch* const first = batch_values + first_value(field);
    for (std::size_t node_class = 0; node_class < spectra.node_classes();
         ++node_class)
      turn(field % 3, true, first + 3 * node_class * wave_columns);
    spectra.store(first, batch, 3, field_modes(field));
  }
}

void LatticeSolver::Parts::sweep(Sweep part) {
  const Range own = share.rows();
  parallel_turns(
      static_cast<int>(own.size()), threads, [&](int turn, int worker) {
        const std::size_t row = own.begin + static_cast<std::size_t>(turn);
        for (std::size_t i = 0; i < spectra.batches(); ++i)
          sweep_batch(part, spectra.batch(row, i),
                      values[static_cast<std::size_t>(worker)].data());
      });
}

void LatticeSolver::Parts::sweep_batch(Sweep part, const WaveBatch& batch,
                                       SimdBatch* batch_values) {
  const std::size_t n_classes = spectra.node_classes();
  const std::size_t face_packs = 3 * n_classes * wave_columns;
  constexpr std::size_t u_z = 2 * wave_columns;
  load(batch, batch_values);
  if (part != Sweep::up_from_face)
    factors->go_down(batch, batch_values);
  if (part == Sweep::down_to_face) {
    std::array<SimdBatch, 12 * wave_columns> face_values;
    std::copy_n(batch_values, face_packs, face_values.data());
    factors->solve_face(batch, face_values.data());
    spectra.store(&face_values[u_z], batch, 3, face_modes);
  }
  if (part == Sweep::up_from_face) { // subtracts the forces of the springs
    std::array<SimdBatch, 4 * wave_columns> borne;
    spectra.load(face_modes, batch, 1, borne.data());
    for (std::size_t node_class = 0; node_class < n_classes; ++node_class)
      for (std::size_t j = 0; j < wave_columns; ++j)
        batch_values[3 * node_class * wave_columns + u_z + j] -=
            borne[node_class * wave_columns + j];
  }
  if (part != Sweep::down_to_face) {
    factors->solve_face(batch, batch_values);
    factors->go_up(batch, batch_values);
  }
  store(batch, batch_values);
}

LatticeSolver::LatticeSolver(const Grid& grid, int degree,
                             const LayeredBlock& block, int threads,
                             Among among) {
  if (degree != 1 && degree != 2)
    refuse_argument("degree", degree, "1 or 2");
  if (threads < 1)
    refuse_argument("threads", threads, "at least 1");
  require_cells(grid, degree);
  require_block(block);
  parts_ = std::make_unique<Parts>(grid, degree, block, threads, among);
}

LatticeSolver::~LatticeSolver() = default;

const NodeLattice& LatticeSolver::lattice() const {
  return parts_->lattice;
}

const LatticeShare& LatticeSolver::share() const {
  return parts_->share;
}

std::size_t LatticeSolver::bytes() const {
  return parts_->factors->bytes() + parts_->face.bytes() +
         parts_->modes.size() * sizeof(parts_->modes[0]);
}

void LatticeSolver::solve(std::span<const double> force,
                          std::span<double> displacement) {
  if (force.size() != lattice().size() || displacement.size() != force.size())
    refuse_argument("size", static_cast<double>(force.size()),
                    "the number of unknowns of the node grid");
  parts_->transform(force);
  parts_->sweep(Sweep::whole);
  parts_->transform_back(displacement, 0.0);
}

void LatticeSolver::set_springs(std::span<const double> springs) {
  if (springs.size() != lattice().grid.size())
    refuse_argument("springs.size()", static_cast<double>(springs.size()),
                    "the number of surface nodes");
  for (const double spring : springs)
    if (!(spring >= 0.0))
      refuse_argument("spring", spring, ">= 0 [N/m]");
  parts_->face.set_springs(springs);
}

SpringSolve LatticeSolver::solve_with_springs(std::span<const double> force,
                                              std::span<double> displacement,
                                              double tolerance) {
  require_positive("tolerance", tolerance, "1");
  Parts& parts = *parts_;
  if (parts.face.is_empty()) {
    solve(force, displacement);
    return {};
  }
  if (force.size() != lattice().size() || displacement.size() != force.size())
    refuse_argument("size", static_cast<double>(force.size()),
                    "the number of unknowns of the node grid");
  const double total_force = parts.total_force(force);
  parts.transform(force);
  parts.sweep(Sweep::down_to_face);
  parts.share.rows_to_all(parts.face_modes);
  parts.spectra.backward(parts.face_modes, parts.face_field, parts.scratch[0]);
  double shift = 0.0;
  const SpringSolve answer = parts.face.solve(parts.face_field, total_force,
                                              tolerance, parts.forces, shift);
  parts.spectra.forward(parts.forces, parts.face_modes, parts.scratch[0]);
  parts.sweep(Sweep::up_from_face);
  parts.transform_back(displacement, shift);
  return answer;
}

} // namespace asperity::fem
