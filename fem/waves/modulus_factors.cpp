#include "base/require.hpp"
#include "fem/waves/moduli_field.hpp"
#include "input/expression.hpp"
#include "mechanics/limits.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::fem {
namespace {

/// The counter word of a coordinate: its value in eighths of the spacing.
std::uint32_t eighths(double place, double spacing) {
  return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::lround(8.0 * place / spacing)));
}

/// The counter word of a coordinate: the number of its cube.
std::uint32_t cube_of(double place, double edge) {
  return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::floor(place / edge)));
}

/// A factor uniform in 1 - spread..1 + spread from three words.
/// @param kind  a word that separates independent streams
double draw_factor(double spread, std::uint64_t seed,
                   const std::array<std::uint32_t, 3>& words,
                   std::uint32_t kind) {
  const r123::Philox4x32::ctr_type counter = {
      {words[0], words[1], words[2], kind}};
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(seed),
       static_cast<std::uint32_t>(seed >> 32)}};
  const double uniform = (r123::Philox4x32()(counter, key)[0] + 0.5) * 0x1p-32;
  return 1.0 + spread * (2.0 * uniform - 1.0);
}

constexpr std::uint32_t of_cells = 0, of_cubes = 1;

} // namespace

ModulusFactor expression_factor(const std::string& expression, double length) {
  require_positive("length", length, "m");
  return [factor = input::Expression(expression),
          length](const meshes::Place& place) {
    return factor.at({place[0] / length, place[1] / length, place[2] / length});
  };
}

ModulusFactor random_factor(double spread, std::uint64_t seed, double spacing) {
  require_between("spread", spread, 0.0, mechanics::largest_spread, "1");
  require_positive("spacing", spacing, "m");
  return [=](const meshes::Place& place) {
    return draw_factor(spread, seed,
                       {eighths(place[0], spacing), eighths(place[1], spacing),
                        eighths(place[2], spacing)},
                       of_cells);
  };
}

ModulusFactor random_cubes(double spread, std::uint64_t seed, double edge) {
  require_between("spread", spread, 0.0, mechanics::largest_spread, "1");
  require_positive("edge", edge, "m");
  return [=](const meshes::Place& place) {
    return draw_factor(spread, seed,
                       {cube_of(place[0], edge), cube_of(place[1], edge),
                        cube_of(place[2], edge)},
                       of_cubes);
  };
}

ModulusFactor table_factor(FactorTable table) {
  std::size_t expected = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    require_between("boxes", table.boxes[i], 1.0, 1e5, "1");
    require_positive("length", table.lengths[i], "m");
    expected *= static_cast<std::size_t>(table.boxes[i]);
  }
  if (table.factors.size() != expected)
    refuse_argument("number of factors",
                    static_cast<double>(table.factors.size()),
                    std::to_string(expected));
  for (const double factor : table.factors)
    require_positive("factor of the modulus", factor, "1");
  return [table = std::move(table)](const meshes::Place& place) {
    std::array<std::size_t, 3> box{};
    for (std::size_t i = 0; i < 3; ++i)
      box[i] = static_cast<std::size_t>(
          std::clamp(static_cast<int>(std::floor(place[i] / table.lengths[i] *
                                                 table.boxes[i])),
                     0, table.boxes[i] - 1));
    const auto nx = static_cast<std::size_t>(table.boxes[0]);
    const auto ny = static_cast<std::size_t>(table.boxes[1]);
    return table.factors[(box[2] * ny + box[1]) * nx + box[0]];
  };
}

} // namespace asperity::fem
