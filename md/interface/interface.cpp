#include "md/interface/interface.hpp"

#include "base/parallel_rows.hpp"
#include "base/require.hpp"
#include "base/special_numbers.hpp"
#include "md/interface/interface_kernel.hpp"
#include "md/interface/substrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace asperity::md {
namespace {

/// Returns the positions of the lattice sites along one side of the layer in
/// substrate spacings. Site i is at i n_s / n_l, split into integers to avoid
/// roundoff.
std::vector<double> sites_of(int layer_points, int substrate_points) {
  std::vector<double> sites;
  for (std::int64_t i = 0; i < layer_points; ++i) {
    const std::int64_t product = i * substrate_points;
    const std::int64_t whole = product / layer_points;
    const std::int64_t rest = product % layer_points;
    sites.push_back(static_cast<double>(whole) +
                    static_cast<double>(rest) / layer_points);
  }
  return sites;
}

/// Maps a coordinate periodically to 0 <= c < points.
double wrapped(double coordinate, int points) {
  if (coordinate >= 0.0 && coordinate < points)
    return coordinate;
  const double inside = coordinate - points * std::floor(coordinate / points);
  return inside < points ? std::max(inside, 0.0) : 0.0;
}

bool is_finite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

void require_length(const char* name, std::size_t size, std::size_t expected) {
  if (size != expected)
    refuse_argument(fmt::format("size of {}", name), static_cast<double>(size),
                    fmt::format("{}, one value per site", expected));
}

template <class Planes>
void require_planes(const char* name, const Planes& planes, const Grid& grid) {
  for (const auto size : {planes.x.size(), planes.y.size(), planes.z.size()})
    require_length(name, size, grid.size());
}

void require_square(const char* name, const Grid& grid) {
  require_positive(name, grid.length_x, "m");
  if (grid.points_x < 1 || !grid.is_square())
    refuse_argument(
        name, grid.length_y,
        fmt::format("a square lattice: {} m and {} atoms in both directions",
                    number_text(grid.length_x), grid.points_x));
}

} // namespace

struct Interface::Kernel {
  Interaction interaction;
  Grid layer;
  Grid substrate_grid;
  int threads = 1;
  ReducedLaw law;
  Substrate substrate;

  std::vector<double> sites; ///< along one side, in substrate spacings
  double per_substrate_spacing = 1.0 / substrate_grid.spacing_x();
  double per_distance = 1.0 / interaction.distance;

  LatticePoint point(const LayerView& atoms, int ix, int iy) const {
    const int points = substrate_grid.points_x;
    const std::size_t i = layer.index(ix, iy);
    const auto coordinate = [&](int site, double displacement) {
      return wrapped(sites[static_cast<std::size_t>(site)] +
                         displacement * per_substrate_spacing,
                     points);
    };
    return {coordinate(ix, atoms.x[i]), coordinate(iy, atoms.y[i])};
  }

  std::vector<Window> windows_of_row(const LayerView& atoms, int iy) const;
  double sum_of_row(const LayerView& atoms, const LayerForces& forces,
                    int iy) const;
  void second_derivatives_of_row(const LayerView& atoms,
                                 std::span<SymmetricBlock> blocks,
                                 int iy) const;
  Inspection inspect_row(const LayerView& atoms, int iy, double close_distance,
                         double contact_distance) const;
};

/// The window of an atom whose position is not finite has no tiles and the
/// height NaN.
std::vector<Window> Interface::Kernel::windows_of_row(const LayerView& atoms,
                                                      int iy) const {
  std::vector<Window> windows(static_cast<std::size_t>(layer.points_x));
  for (int ix = 0; ix < layer.points_x; ++ix) {
    const std::size_t i = layer.index(ix, iy);
    Window& window = windows[static_cast<std::size_t>(ix)];
    if (is_finite(atoms.x[i], atoms.y[i], atoms.z[i]))
      window =
          substrate.window(point(atoms, ix, iy), atoms.z[i] * per_distance);
    else
      window.z = not_a_number;
  }
  return windows;
}

double Interface::Kernel::sum_of_row(const LayerView& atoms,
                                     const LayerForces& forces, int iy) const {
  const double unit = 12.0 * interaction.energy / interaction.distance;
  const std::vector<Window> windows = windows_of_row(atoms, iy);
  std::vector<AtomForce> sums(windows.size());
  double energy = sum_windows(law, windows, substrate.spacing(), sums);
  for (std::size_t ix = 0; ix < windows.size(); ++ix) {
    const std::size_t i = layer.index(static_cast<int>(ix), iy);
    // NaN if the position is not finite
    const double invalid = 0.0 * windows[ix].z;
    forces.x[i] = unit * sums[ix].x + invalid;
    forces.y[i] = unit * sums[ix].y + invalid;
    forces.z[i] = unit * sums[ix].z + invalid;
    energy += invalid;
  }
  return interaction.energy * energy;
}

void Interface::Kernel::second_derivatives_of_row(
    const LayerView& atoms, std::span<SymmetricBlock> blocks, int iy) const {
  const double unit =
      12.0 * interaction.energy / (interaction.distance * interaction.distance);
  const std::vector<Window> windows = windows_of_row(atoms, iy);
  const auto row = blocks.subspan(layer.index(0, iy), windows.size());
  sum_second_derivatives(law, windows, substrate.spacing(), row);
  for (std::size_t ix = 0; ix < windows.size(); ++ix) {
    SymmetricBlock& block = row[ix];
    block =
        std::isnan(windows[ix].z)
            ? SymmetricBlock{not_a_number, not_a_number, not_a_number,
                             not_a_number, not_a_number, not_a_number}
            : SymmetricBlock{unit * block.xx, unit * block.yy, unit * block.zz,
                             unit * block.xy, unit * block.xz, unit * block.yz};
  }
}

Inspection Interface::Kernel::inspect_row(const LayerView& atoms, int iy,
                                          double close_distance,
                                          double contact_distance) const {
  Inspection found{.shortest_distance =
                       std::numeric_limits<double>::infinity()};
  for (int ix = 0; ix < layer.points_x; ++ix) {
    const std::size_t i = layer.index(ix, iy);
    if (!is_finite(atoms.x[i], atoms.y[i], atoms.z[i])) {
      ++found.below_substrate;
      continue;
    }
    const double z = atoms.z[i] * per_distance;
    const LatticePoint under = point(atoms, ix, iy);
    found.below_substrate += z < substrate.height_at(under) ? 1 : 0;

    const Window window = substrate.window(under, z);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Tile& tile : window.tiles)
      for (int lane = 0; lane < tile_columns * tile_rows; ++lane) {
        const int column = lane / tile_rows;
        const int row = lane % tile_rows;
        const double distance =
            interaction.distance *
            std::hypot(window.x - tile.x - column * substrate.spacing(),
                       window.y - tile.y - row * substrate.spacing(),
                       z - window.heights[tile.height + lane]);
        found.close_pairs += distance < close_distance ? 1 : 0;
        shortest = std::min(shortest, distance);
      }
    found.in_contact += shortest < contact_distance ? 1 : 0;
    if (shortest < interaction.cutoff)
      found.shortest_distance = std::min(found.shortest_distance, shortest);
  }
  return found;
}

Interface::Interface(const Interaction& interaction, const Grid& layer,
                     const Grid& substrate, std::span<const double> heights,
                     int threads) {
  require_interaction(interaction);
  require_square("layer", layer);
  require_square("substrate", substrate);
  if (!is_same_length(substrate.length_x, layer.length_x))
    refuse_argument("length of the substrate", substrate.length_x,
                    fmt::format("{} m, the length of the layer",
                                number_text(layer.length_x)));
  require_length("heights", heights.size(), substrate.size());
  for (const double height : heights)
    require_between("a height", height, -std::numeric_limits<double>::max(),
                    std::numeric_limits<double>::max(), "m");
  if (2.0 * interaction.cutoff > layer.length_x)
    refuse_argument("cutoff", interaction.cutoff,
                    fmt::format("at most half of the period {} m",
                                number_text(layer.length_x)));
  require_positive("threads", threads, "1");
  kernel_ = std::make_unique<Kernel>(Kernel{
      interaction, layer, substrate, threads, reduced(interaction),
      Substrate(substrate, heights, interaction.cutoff, interaction.distance),
      sites_of(layer.points_x, substrate.points_x)});
}

Interface::~Interface() = default;
Interface::Interface(Interface&&) noexcept = default;

const Grid& Interface::layer() const {
  return kernel_->layer;
}

const Interaction& Interface::interaction() const {
  return kernel_->interaction;
}

double Interface::energy_and_forces(const LayerView& atoms,
                                    const LayerForces& forces) const {
  require_planes("atoms", atoms, kernel_->layer);
  require_planes("forces", forces, kernel_->layer);
  const int n_rows = kernel_->layer.points_y;
  std::vector<double> row_energies(static_cast<std::size_t>(n_rows));
  parallel_rows(n_rows, kernel_->threads, [&](int iy) {
    row_energies[static_cast<std::size_t>(iy)] =
        kernel_->sum_of_row(atoms, forces, iy);
  });
  double energy = 0.0;
  for (const double row_energy : row_energies)
    energy += row_energy;
  return energy;
}

void Interface::second_derivatives(const LayerView& atoms,
                                   std::span<SymmetricBlock> blocks) const {
  require_planes("atoms", atoms, kernel_->layer);
  require_length("blocks", blocks.size(), kernel_->layer.size());
  parallel_rows(kernel_->layer.points_y, kernel_->threads, [&](int iy) {
    kernel_->second_derivatives_of_row(atoms, blocks, iy);
  });
}

Inspection Interface::inspect(const LayerView& atoms, double close_distance,
                              double contact_distance) const {
  require_planes("atoms", atoms, kernel_->layer);
  const double cutoff = kernel_->interaction.cutoff;
  require_between("close_distance", close_distance, 0.0, cutoff, "m");
  require_between("contact_distance", contact_distance, 0.0, cutoff, "m");
  const int n_rows = kernel_->layer.points_y;
  std::vector<Inspection> rows(static_cast<std::size_t>(n_rows));
  parallel_rows(n_rows, kernel_->threads, [&](int iy) {
    rows[static_cast<std::size_t>(iy)] =
        kernel_->inspect_row(atoms, iy, close_distance, contact_distance);
  });

  Inspection sum{.shortest_distance = std::numeric_limits<double>::infinity()};
  for (const Inspection& row : rows) {
    sum.below_substrate += row.below_substrate;
    sum.close_pairs += row.close_pairs;
    sum.in_contact += row.in_contact;
    sum.shortest_distance =
        std::min(sum.shortest_distance, row.shortest_distance);
  }
  return sum;
}

std::vector<double> Interface::heights_below(const LayerView& atoms) const {
  require_planes("atoms", atoms, kernel_->layer);
  const Grid& layer = kernel_->layer;
  std::vector<double> heights;
  heights.reserve(layer.size());
  for (int iy = 0; iy < layer.points_y; ++iy)
    for (int ix = 0; ix < layer.points_x; ++ix)
      heights.push_back(
          kernel_->interaction.distance *
          kernel_->substrate.height_at(kernel_->point(atoms, ix, iy)));
  return heights;
}

} // namespace asperity::md
