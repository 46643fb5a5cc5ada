#include "studies/magnification/magnification_tables.hpp"

#include "base/shown_number.hpp"
#include "base/special_numbers.hpp"
#include "theory/persson/gap_distribution.hpp"
#include "theory/persson/leakage.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace asperity::studies {
namespace {

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
  return "p = " + quantity_text(contact.nominal_pressure(), "Pa");
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
  Table table{"magnification",
              "Loads of the magnification study",
              {{"nominal_pressure", "Pa"},
               {"contact_weight", "1"},
               {"mean_gap", "m"},
               {"rms_height", "m"},
               {"lowest_magnification", "1"},
               {"highest_magnification", "1"}}};
  for (const MagnifiedContact& contact : contacts)
    table.add({contact.nominal_pressure(), contact_weight(contact),
               contact.mean_gap(contact.lowest_magnification()),
               contact.contact().spectrum().rms_height(),
               contact.lowest_magnification(),
               contact.highest_magnification()});
  return table;
}

Table magnification_table(const std::string& name,
                          const MagnifiedContact& contact,
                          const MagnificationStudy& study) {
  Table table{name,
              "A, h_rms, u, u_1 and the density of Eq. (27) of Yang and "
              "Persson (2008) against zeta, " +
                  load_text(contact),
              {{"magnification", "1"},
               {"area_fraction", "1"},
               {"rms_height", "m"},
               {"mean_gap", "m"},
               {"mean_gap_as_printed", "m"},
               {"opening_gap", "m"},
               {"gap_density", "1/m"}}};
  for (int k = 0; k < study.points; ++k) {
    const double zeta = in_equal_ratios(study.from, study.to, k, study.points);
    const bool opens = zeta > contact.lowest_magnification() &&
                       zeta < contact.highest_magnification();
    table.add({zeta, contact.area_fraction(zeta), contact.rms_height(zeta),
               contact.mean_gap(zeta), contact.mean_gap_as_printed(zeta),
               contact.opening_gap(zeta),
               opens ? contact.gap_density(zeta) : not_a_number});
  }
  return table;
}

Table gap_distribution_table(const std::string& name,
                             const MagnifiedContact& contact) {
  const double weight = contact_weight(contact);
  Table table{name,
              fmt::format("Distribution of u_1 by Eq. (27) of Yang and Persson "
                          "(2008), {}, with the weight {:.4g} at u = 0",
                          load_text(contact), weight),
              {{"cumulative", "1"}, {"gap", "m"}, {"density", "1/m"}}};
  for (int k = 1; k < n_quantiles; ++k) {
    const double part =
        0.5 * (1.0 - std::cos(std::numbers::pi * k / n_quantiles));
    const double area = weight + (1.0 - weight) * part;
    const auto zeta = contact.magnification_of_area(area);
    if (!zeta || !(*zeta < contact.highest_magnification()))
      continue;
    table.add({area, contact.opening_gap(*zeta), contact.gap_density(*zeta)});
  }
  return table;
}

Table leak_table(std::span<const MagnifiedContact> contacts,
                 const LeakStudy& study) {
  const double critical =
      study.critical_area.value_or(theory::square_lattice_critical_area);
  Table table{"leak",
              fmt::format("The pore at which the open area percolates, A/A_0 = "
                          "{:.4g}",
                          critical),
              {{"nominal_pressure", "Pa"},
               {"magnification", "1"},
               {"pore_size", "m"},
               {"pore_gap", "m"},
               {"mass_flow", "kg/s"}}};
  for (const MagnifiedContact& contact : contacts) {
    const theory::Leak leak =
        theory::leakage(contact, {study.density, study.viscosity},
                        study.pressure_drop, critical);
    const double load = contact.nominal_pressure();
    if (leak.percolates)
      table.add({load, leak.magnification, leak.pore_size, leak.pore_gap,
                 leak.mass_flow});
    else
      table.add({load, not_a_number, not_a_number, not_a_number, not_a_number});
  }
  return table;
}

} // namespace asperity::studies
