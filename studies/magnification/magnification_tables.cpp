#include "studies/magnification/magnification_tables.hpp"

#include "base/special_numbers.hpp"
#include "theory/persson/gap_distribution.hpp"
#include "theory/persson/leakage.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace asperity::studies {
namespace {

using results::Column;
using results::Table;
using theory::MagnifiedContact;

constexpr int n_quantiles = 200;

/// Returns the k-th of n values in geometric progression. Both ends are exact.
double in_equal_ratios(double from, double to, int k, int n) {
  if (k + 1 == n)
    return to;
  return from * std::pow(to / from, static_cast<double>(k) / (n - 1));
}

std::string load_text(const MagnifiedContact& contact) {
  return fmt::format("p = {:.6g} Pa", contact.nominal_pressure());
}

double contact_weight(const MagnifiedContact& contact) {
  return contact.area_fraction(contact.highest_magnification());
}

} // namespace

std::vector<MagnifiedContact>
magnified_contacts(const theory::PerssonContact& contact,
                   const MagnificationStudy& study) {
  const mechanics::Scales scales{contact.contact_modulus(), 0.0, 0.0, 0.0};
  std::vector<MagnifiedContact> contacts;
  for (const mechanics::Quantity& pressure : study.nominal_pressures)
    contacts.emplace_back(contact, pressure.in_si(scales),
                          study.reference_wavevector);
  return contacts;
}

Table loads_table(std::span<const MagnifiedContact> contacts) {
  Column pressure{"nominal_pressure", "Pa", {}};
  Column weight{"contact_weight", "1", {}};
  Column gap{"mean_gap", "m", {}};
  Column height{"rms_height", "m", {}};
  Column lowest{"lowest_magnification", "1", {}};
  Column highest{"highest_magnification", "1", {}};
  for (const MagnifiedContact& contact : contacts) {
    pressure.values.push_back(contact.nominal_pressure());
    weight.values.push_back(contact_weight(contact));
    gap.values.push_back(contact.mean_gap(contact.lowest_magnification()));
    height.values.push_back(contact.contact().spectrum().rms_height());
    lowest.values.push_back(contact.lowest_magnification());
    highest.values.push_back(contact.highest_magnification());
  }
  return {"magnification",
          "Loads of the magnification study",
          {pressure, weight, gap, height, lowest, highest}};
}

Table magnification_table(const std::string& name,
                          const MagnifiedContact& contact,
                          const MagnificationStudy& study) {
  Column magnification{"magnification", "1", {}};
  Column area{"area_fraction", "1", {}};
  Column height{"rms_height", "m", {}};
  Column gap{"mean_gap", "m", {}};
  Column printed{"mean_gap_as_printed", "m", {}};
  Column opening{"opening_gap", "m", {}};
  Column density{"gap_density", "1/m", {}};
  for (int k = 0; k < study.points; ++k) {
    const double zeta = in_equal_ratios(study.from, study.to, k, study.points);
    const bool opens = zeta > contact.lowest_magnification() &&
                       zeta < contact.highest_magnification();
    magnification.values.push_back(zeta);
    area.values.push_back(contact.area_fraction(zeta));
    height.values.push_back(contact.rms_height(zeta));
    gap.values.push_back(contact.mean_gap(zeta));
    printed.values.push_back(contact.mean_gap_as_printed(zeta));
    opening.values.push_back(contact.opening_gap(zeta));
    density.values.push_back(opens ? contact.gap_density(zeta) : not_a_number);
  }
  return {name,
          "A, h_rms, u, u_1 and the density of Eq. (27) of Yang and Persson "
          "(2008) against zeta, " +
              load_text(contact),
          {magnification, area, height, gap, printed, opening, density}};
}

Table gap_distribution_table(const std::string& name,
                             const MagnifiedContact& contact) {
  Column cumulative{"cumulative", "1", {}};
  Column gap{"gap", "m", {}};
  Column density{"density", "1/m", {}};
  const double weight = contact_weight(contact);
  for (int k = 1; k < n_quantiles; ++k) {
    const double part =
        0.5 * (1.0 - std::cos(std::numbers::pi * k / n_quantiles));
    const double area = weight + (1.0 - weight) * part;
    const auto zeta = contact.magnification_of_area(area);
    if (!zeta || !(*zeta < contact.highest_magnification()))
      continue;
    cumulative.values.push_back(area);
    gap.values.push_back(contact.opening_gap(*zeta));
    density.values.push_back(contact.gap_density(*zeta));
  }
  return {name,
          fmt::format("Distribution of u_1 by Eq. (27) of Yang and Persson "
                      "(2008), {}, with the weight {:.4g} at u = 0",
                      load_text(contact), weight),
          {cumulative, gap, density}};
}

Table leak_table(std::span<const MagnifiedContact> contacts,
                 const LeakStudy& study) {
  Column pressure{"nominal_pressure", "Pa", {}};
  Column magnification{"magnification", "1", {}};
  Column size{"pore_size", "m", {}};
  Column gap{"pore_gap", "m", {}};
  Column flow{"mass_flow", "kg/s", {}};
  const double critical =
      study.critical_area.value_or(theory::square_lattice_critical_area);
  for (const MagnifiedContact& contact : contacts) {
    const theory::Leak leak =
        theory::leakage(contact, {study.density, study.viscosity},
                        study.pressure_drop, critical);
    pressure.values.push_back(contact.nominal_pressure());
    magnification.values.push_back(leak.percolates ? leak.magnification
                                                   : not_a_number);
    size.values.push_back(leak.percolates ? leak.pore_size : not_a_number);
    gap.values.push_back(leak.percolates ? leak.pore_gap : not_a_number);
    flow.values.push_back(leak.percolates ? leak.mass_flow : not_a_number);
  }
  return {"leak",
          fmt::format("The pore at which the open area percolates, A/A_0 = "
                      "{:.4g}",
                      critical),
          {pressure, magnification, size, gap, flow}};
}

} // namespace asperity::studies
