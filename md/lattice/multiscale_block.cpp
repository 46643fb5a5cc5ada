#include "md/lattice/multiscale_block.hpp"

#include "base/parallel_rows.hpp"
#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "md/lattice/level_transfer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace asperity::md {
namespace {

void require(const BlockShape& shape, double spacing) {
  if (shape.levels < 1 || shape.levels > 20)
    refuse_argument("levels", shape.levels, "between 1 and 20");
  if (shape.layers < 1)
    refuse_argument("layers", shape.layers, ">= 1");
  const int side = 1 << (shape.levels - 1);
  for (const int points : {shape.layer.points_x, shape.layer.points_y})
    if (points < side || points % side != 0)
      refuse_argument(Argument{"atoms per side", "method.atoms"}, points,
                      "a multiple of 2^(levels - 1)");
  for (const double length : {shape.layer.spacing_x(), shape.layer.spacing_y()})
    if (!(std::abs(length - spacing) <= 1e-9 * spacing))
      refuse_argument("spacing of the layer", length,
                      "the crystal's spacing [m]");
}

/// Returns 2^level, the scale factor of lengths and stiffnesses.
double scale_of(int level) {
  return std::ldexp(1.0, level);
}

} // namespace

MultiscaleBlock::MultiscaleBlock(const Crystal& crystal,
                                 const BlockShape& shape, int threads)
    : shape_(shape), threads_(threads) {
  const CellStiffness cell = cell_stiffness(crystal);
  require(shape, crystal.spacing);
  size_ = begin_of(shape.levels, 0) + 1;
  for (int level = 0; level < shape.levels; ++level) {
    couplings_.push_back(slab_couplings(cell, scale_of(level)));
    const bool is_last = level + 1 == shape.levels;
    for (int layer = 0; layer < shape.layers + (is_last ? 0 : 1); ++layer)
      for (int row = 0; row < level_grid(level).points_y; ++row)
        rows_.push_back({level, layer, row});
  }
  plate_stiffness_ = -couplings_.back().to_upper.symbol(0.0, 0.0)[8];
}

Grid MultiscaleBlock::level_grid(int level) const {
  Grid grid = shape_.layer;
  grid.points_x >>= level;
  grid.points_y >>= level;
  return grid;
}

std::size_t MultiscaleBlock::begin_of(int level, int layer) const {
  const auto layers = static_cast<std::size_t>(shape_.layers);
  std::size_t begin = 0;
  for (int below = 0; below < level; ++below)
    begin += 3 * layers * level_grid(below).size();
  return begin + 3 * static_cast<std::size_t>(layer) * level_grid(level).size();
}

double MultiscaleBlock::height_of(int level, int layer) const {
  const double below = shape_.layers * (scale_of(level) - 1.0);
  return (below + layer * scale_of(level)) * shape_.layer.spacing_x();
}

template <class Number>
AtomPlane<Number> MultiscaleBlock::plane_of(std::span<Number> unknowns,
                                            int level, int layer) const {
  const Grid grid = level_grid(level);
  return {unknowns.data() + begin_of(level, layer), grid.points_x,
          grid.points_y};
}

AtomPlane<const double> MultiscaleBlock::hanging_plane(const Hanging& hanging,
                                                       int level) const {
  const Grid grid = level_grid(level);
  return {hanging.displacements.data(), grid.points_x, grid.points_y};
}

std::vector<MultiscaleBlock::Hanging>
MultiscaleBlock::hanging_layers(std::span<const double> state) const {
  std::vector<Hanging> hanging(static_cast<std::size_t>(shape_.levels - 1));
  parallel_rows(shape_.levels - 1, threads_, [&](int level) {
    const Grid grid = level_grid(level);
    Hanging& here = hanging[static_cast<std::size_t>(level)];
    here.displacements.resize(3 * grid.size());
    here.forces.assign(3 * grid.size(), 0.0);
    interpolate(plane_of(state, level + 1, 0),
                {here.displacements.data(), grid.points_x, grid.points_y});
  });
  return hanging;
}

void MultiscaleBlock::compute_row(std::span<const double> state,
                                  std::vector<Hanging>& hanging,
                                  std::size_t job,
                                  std::span<double> forces) const {
  const auto [level, layer, row] = rows_[job];
  const SlabCouplings& slab = couplings(level);
  const bool is_hanging = layer == shape_.layers;
  if (is_hanging) {
    Hanging& here = hanging[static_cast<std::size_t>(level)];
    const AtomPlane<const double> atoms = hanging_plane(here, level);
    const AtomPlane<double> out{here.forces.data(), atoms.n_x, atoms.n_y};
    slab.within_upper.add_forces(atoms, row, out);
    slab.to_upper.add_forces(plane_of(state, level, layer - 1), row, out);
    return;
  }

  const AtomPlane<double> out = plane_of(forces, level, layer);
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::fill_n(out.row(axis, row), out.n_x, 0.0);
  const LayerCoupling& own = layer == 0 ? slab.within_lower : slab.inside;
  own.add_forces(plane_of(state, level, layer), row, out);
  if (layer > 0)
    slab.to_upper.add_forces(plane_of(state, level, layer - 1), row, out);
  if (layer + 1 < shape_.layers)
    slab.to_lower.add_forces(plane_of(state, level, layer + 1), row, out);
  else if (level + 1 < shape_.levels)
    slab.to_lower.add_forces(
        hanging_plane(hanging[static_cast<std::size_t>(level)], level), row,
        out);
}

void MultiscaleBlock::add_plate(std::span<const double> state,
                                std::span<double> forces) const {
  const int level = shape_.levels - 1;
  const AtomPlane<const double> under =
      plane_of(state, level, shape_.layers - 1);
  const AtomPlane<double> out = plane_of(forces, level, shape_.layers - 1);
  const double height = state[plate()];
  double stretch = 0.0; // of the last cell layer, summed over its atoms
  for (int row = 0; row < under.n_y; ++row) {
    for (int i = 0; i < under.n_x; ++i) {
      out.row(2, row)[i] += plate_stiffness_ * height;
      stretch += height - under.row(2, row)[i];
    }
  }
  forces[plate()] = -plate_stiffness_ * stretch;
}

double MultiscaleBlock::energy_and_forces(std::span<const double> state,
                                          std::span<double> forces) const {
  assert(state.size() == size_ && forces.size() == size_);
  std::vector<Hanging> hanging = hanging_layers(state);
  parallel_rows(static_cast<int>(rows_.size()), threads_, [&](int job) {
    compute_row(state, hanging, static_cast<std::size_t>(job), forces);
  });
  parallel_rows(shape_.levels - 1, threads_, [&](int level) {
    const Grid grid = level_grid(level);
    add_restricted({hanging[static_cast<std::size_t>(level)].forces.data(),
                    grid.points_x, grid.points_y},
                   plane_of(forces, level + 1, 0));
  });
  add_plate(state, forces);

  // The energy is -f . u / 2 with heights relative to the plate, summed layer
  // by layer.
  const double height = state[plate()];
  std::vector<double> works(
      static_cast<std::size_t>(shape_.levels * shape_.layers));
  parallel_rows(static_cast<int>(works.size()), threads_, [&](int layer) {
    const AtomPlane<const double> atoms =
        plane_of(state, layer / shape_.layers, layer % shape_.layers);
    const double* const out = forces.data() + (atoms.values - state.data());
    double work = 0.0;
    for (std::size_t i = 0; i < 2 * atoms.size(); ++i)
      work += out[i] * atoms.values[i];
    for (std::size_t i = 2 * atoms.size(); i < 3 * atoms.size(); ++i)
      work += out[i] * (atoms.values[i] - height);
    works[static_cast<std::size_t>(layer)] = work;
  });
  double energy = 0.0;
  for (const double work : works)
    energy -= 0.5 * work;
  return energy;
}

double MultiscaleBlock::energy_of_waves(std::span<const double> state) const {
  std::vector<double> waves(state.begin(), state.end());
  for (int level = 0; level < shape_.levels; ++level) {
    for (int layer = 0; layer < shape_.layers; ++layer) {
      const AtomPlane<double> atoms =
          plane_of(std::span<double>(waves), level, layer);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double* const begin = atoms.row(axis, 0);
        double sum = 0.0;
        for (std::size_t i = 0; i < atoms.size(); ++i)
          sum += begin[i];
        for (std::size_t i = 0; i < atoms.size(); ++i)
          begin[i] -= sum / static_cast<double>(atoms.size());
      }
    }
  }
  waves[plate()] = 0.0;
  std::vector<double> forces(size_);
  return energy_and_forces(waves, forces);
}

std::vector<double> MultiscaleBlock::masses(double atom_mass) const {
  require_positive("atom_mass", atom_mass, "kg");
  std::vector<double> masses(size_);
  for (int level = 0; level < shape_.levels; ++level) {
    const double mass = atom_mass * std::ldexp(1.0, 3 * level);
    for (int layer = 0; layer < shape_.layers; ++layer) {
      // A coarse boundary atom (1/2) also carries the half fine layer below it,
      // which has 4 atoms of 1/8 of the mass: 1/2 + 1/2 * 4/8 = 0.75.
      const double share = layer > 0 ? 1.0 : level > 0 ? 0.75 : 0.5;
      std::fill_n(masses.begin() +
                      static_cast<std::ptrdiff_t>(begin_of(level, layer)),
                  3 * level_grid(level).size(), share * mass);
    }
  }
  const int last = shape_.levels - 1;
  masses[plate()] = 0.5 * atom_mass * std::ldexp(1.0, 3 * last) *
                    static_cast<double>(level_grid(last).size());
  return masses;
}

} // namespace asperity::md
