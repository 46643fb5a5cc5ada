#include "md/contact/step_reading.hpp"

#include "base/field_sums.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::md {

void read_maps(const Interface& interface, const Grid& layer,
               const LayerView& atoms, std::span<const double> normal_forces,
               const ReadingDistances& distances, AtomStep& step) {
  const std::vector<double> surface = interface.heights_below(atoms);
  step.pressure.resize(layer.size());
  step.gap.resize(layer.size());
  for (std::size_t i = 0; i < layer.size(); ++i) {
    step.pressure[i] = normal_forces[i] / layer.cell_area();
    step.gap[i] = atoms.z[i] - surface[i] - distances.contact;
  }
  step.nominal_pressure = mean(step.pressure);
  step.inspection =
      interface.inspect(atoms, distances.close, distances.contact);
  step.contact_count =
      step.inspection.in_contact / static_cast<double>(layer.size());
}

void read_step(const System& system, std::span<const double> state,
               std::span<const double> normal_forces,
               const ReadingDistances& distances, AtomStep& step) {
  const Grid& layer = system.layer();
  const LayerView atoms = layer_of(system, state);
  read_maps(system.interface(), layer, atoms, normal_forces, distances, step);
  step.mean_gap = mean(atoms.z) - distances.contact;
  step.elastic_energy = system.elastic_energy(state) / layer.area();

  std::vector<double> forces(3 * layer.size());
  const std::span all(forces);
  step.interface_energy = system.interface().energy_and_forces(
                              atoms, {all.subspan(0, layer.size()),
                                      all.subspan(layer.size(), layer.size()),
                                      all.subspan(2 * layer.size())}) /
                          layer.area();
}

double mean_size(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values)
    sum += std::abs(value);
  return sum / static_cast<double>(values.size());
}

std::string invalidity_reason(const Inspection& inspection, std::size_t atoms) {
  const double share =
      100.0 * inspection.below_substrate / static_cast<double>(atoms);
  if (inspection.below_substrate > 0)
    return fmt::format(
        "{:.3g} % of the atoms are below the substrate, and {} pairs are too "
        "close: atoms have penetrated the substrate",
        share, inspection.close_pairs);
  if (inspection.close_pairs > 0)
    return fmt::format("{} pairs are too close, the closest at {:.3g} m: atoms "
                       "are penetrating the substrate",
                       inspection.close_pairs, inspection.shortest_distance);
  return "";
}

} // namespace asperity::md
