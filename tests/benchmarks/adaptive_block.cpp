// What the mesh that follows the contact (fem/adaptive) costs and loses,
// compared with uniform blocks on the same grid, in hard contact. One row per
// block and load: contact area by points, mean gap over h_rms, their relative
// differences from the first block, unknowns, Newton steps, CPU seconds.
//
//     bench_adaptive_block [points] [halvings] [surface] [degree]
//                          [blocks] [loads...]
//
// nodes per side (32); halvings of the coarsest cells (2); rough for a
// self-affine surface, H = 0.8, with eight nodes on its shortest wave and rms
// slope 0.1, or sphere for one of ten sides radius, each with -coated (ten
// times stiffer down to 0.05 sides), -ball (twenty times stiffer, radius 0.15,
// depth 0.3), -graded (E grows e-fold over half the depth) or -cubes (random
// cubes of 1/8 side, E within 50 %); order of the elements (2); blocks as
// letters (ua): c for the finest cubes everywhere, u for layers growing by 1.2,
// h for cubes with hanging nodes, four cells per level, a for adaptive, 0 to 4
// for adaptive with that number of halvings at interfaces; nominal pressures
// over E* (0.001 and 0.003, some 2 and 5 % of contact if rough).
#include "fem/adaptive/adaptive_block.hpp"

#include "base/cpu_clock.hpp"
#include "base/field_sums.hpp"
#include "fem/block/full_block.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "meshes/layers/halvable_layers.hpp"
#include "tests/fem/rough_surface.hpp"
#include "theory/exact/hertz.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace asperity::fem {
namespace {

constexpr double side = 1e-6;                 // m, of the block and its depth
constexpr double sphere_radius = 10.0 * side; // m
constexpr mechanics::BodyModuli body{2e9, 0.3};
const double contact_modulus = body.youngs_modulus / (1.0 - 0.3 * 0.3);

std::vector<double> sphere(const Grid& grid) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] =
          -0.5 / sphere_radius *
          (std::pow(ix * grid.spacing_x() - 0.5 * side, 2) +
           std::pow(iy * grid.spacing_y() - 0.5 * side, 2));
  return heights;
}

/// The moduli that a surface is named after.
ModuliField moduli_named(const std::string& surface) {
  const auto is = [&](const char* name) {
    return surface.find(name) != std::string::npos;
  };
  ModuliField field(moduli(body));
  if (is("-coated"))
    field.add_layer(0.05 * side, moduli({10.0 * body.youngs_modulus, 0.2}));
  if (is("-ball"))
    field.set_sphere({0.5 * side, 0.5 * side, 0.3 * side}, 0.15 * side,
                     moduli({20.0 * body.youngs_modulus, 0.3}));
  if (is("-graded"))
    field.set_factor([](const meshes::Place& place) {
      return std::exp(2.0 * place[2] / side);
    });
  if (is("-cubes"))
    field.set_factor(random_cubes(0.5, 3, side / 8.0), side / 8.0);
  return field;
}

std::unique_ptr<FullBlock> block_of(char letter, const Grid& grid, int degree,
                                    int halvings, const ModuliField& field) {
  const Grid cells{grid.points_x / degree, grid.points_y / degree, side, side};
  BlockProblem problem{grid, {}, degree, field};
  const std::vector<double> interfaces = field.interfaces();
  const auto layers = [&](int times) {
    const Grid columns{cells.points_x >> times, cells.points_y >> times, side,
                       side};
    return meshes::layered_mesh(
        columns,
        meshes::halvable_layers(columns.spacing_x(), times, interfaces, side));
  };
  if (letter == 'a' || std::isdigit(static_cast<unsigned char>(letter)) != 0) {
    problem.mesh = layers(halvings);
    problem.adaptive = AdaptiveMesh{halvings};
    if (letter != 'a')
      problem.adaptive->interface_halvings = letter - '0';
    return make_adaptive_block(problem);
  }
  problem.mesh =
      letter == 'h' ? meshes::hanging_mesh(cells, side, 4)
      : letter == 'c'
          ? layers(0)
          : meshes::layered_mesh(cells,
                                 meshes::graded_layers_with_interfaces(
                                     cells.spacing_x(), 1.2, interfaces, side));
  return make_full_block(problem);
}

/// The mean difference of the pressure from that of Hertz for a single contact,
/// over the mean pressure.
double hertz_error(const Grid& grid, const std::vector<double>& pressure,
                   double load) {
  const theory::HertzContact hertz = theory::hertz_contact(
      load * contact_modulus * side * side, sphere_radius, contact_modulus);
  double difference = 0.0;
  double sum = 0.0;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double expected = theory::hertz_pressure(
          hertz, std::hypot(ix * grid.spacing_x() - 0.5 * side,
                            iy * grid.spacing_y() - 0.5 * side));
      difference += std::abs(pressure[grid.index(ix, iy)] - expected);
      sum += expected;
    }
  return difference / sum;
}

struct Row {
  double area = 0.0;
  double gap = 0.0;
  std::vector<double> pressure;
};

/// The mean difference of the pressure from that of the first block, over the
/// mean pressure.
double difference(const std::vector<double>& pressure,
                  const std::vector<double>& reference) {
  double apart = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    apart += std::abs(pressure[i] - reference[i]);
    sum += reference[i];
  }
  return apart / sum;
}

int run(const Grid& grid, int halvings, int degree, const std::string& surface,
        const std::string& letters, const std::vector<double>& loads) {
  const bool is_rough = surface.starts_with("rough");
  const ModuliField field = moduli_named(surface);
  const std::vector<double> heights =
      is_rough ? self_affine_heights(grid) : sphere(grid);
  std::vector<Row> first;
  bool has_converged = true;
  for (const char letter : letters) {
    const CpuClock building(2);
    const auto block = block_of(letter, grid, degree, halvings, field);
    std::printf("%c: built in %.2f s CPU\n", letter, building.seconds());
    std::vector<Row> rows;
    for (const double load : loads) {
      const CpuClock solving(2);
      const BlockSolution found = block->solve(
          heights,
          {mechanics::Control::nominal_pressure, load * contact_modulus},
          {mechanics::ContactLaw::hard,
           1e3 * contact_modulus / grid.spacing_x(), 1e-6, 200});
      rows.push_back({found.area_by_points, found.mean_gap, found.pressure});
      const Row& reference =
          first.empty() ? rows.back() : first[rows.size() - 1];
      std::printf("  p/E* %.4g: area %.5f (%+.2f %%), gap/h %.5f (%+.2f %%), "
                  "%zu unknowns, %d steps, %d iterations, %.2f s CPU %s\n",
                  load, found.area_by_points,
                  100.0 * (found.area_by_points / reference.area - 1.0),
                  found.mean_gap / rms_height(heights),
                  100.0 * (found.mean_gap / reference.gap - 1.0),
                  block->unknowns(), found.iterations, found.linear_iterations,
                  solving.seconds(), found.note.c_str());
      std::printf("    pressure off by %.5f of the first block's\n",
                  difference(found.pressure, reference.pressure));
      if (surface == "sphere")
        std::printf("    pressure off by %.4f of Hertz\n",
                    hertz_error(grid, found.pressure, load));
      has_converged = has_converged && found.converged;
    }
    if (first.empty())
      first = rows;
  }
  return has_converged ? 0 : 3;
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  asperity::fem::start_mpi();
  const auto number = [&](int i, int otherwise) {
    return n_arguments > i ? std::atoi(arguments[i]) : otherwise;
  };
  const int points = number(1, 32);
  std::vector<double> loads;
  for (int i = 6; i < n_arguments; ++i)
    loads.push_back(std::atof(arguments[i]));
  if (loads.empty())
    loads = {0.001, 0.003};
  return asperity::fem::run(
      {points, points, asperity::fem::side, asperity::fem::side}, number(2, 2),
      number(4, 2), n_arguments > 3 ? arguments[3] : "rough",
      n_arguments > 5 ? arguments[5] : "ua", loads);
}
