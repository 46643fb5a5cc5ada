#include "studies/magnification/magnification.hpp"

#include "input/reader/bound_key.hpp"
#include "studies/key_checks.hpp"
#include "studies/magnification/magnification_tables.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <utility>

namespace asperity::studies {
namespace {

using cases::at_least;
using cases::between;
using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::inside;
using cases::key;
using cases::needed;
using cases::Node;
using cases::positive;
using cases::TableReader;
using Contacts = std::vector<theory::MagnifiedContact>;
using Leak = LeakStudy;
using Magnification = MagnificationStudy;

/// The contacts at the loads of the study, which are found once, when the first
/// table asks for them.
std::function<const Contacts&()>
contacts_of(const MagnificationStudy& study,
            const theory::PerssonContact& contact) {
  return [&study, contact,
          found = std::make_shared<Contacts>()]() -> const Contacts& {
    if (found->empty())
      *found = magnified_contacts(contact, study);
    return *found;
  };
}

std::vector<AskedTable>
tables_of_magnification(const cases::Case& contact_case,
                        const theory::PerssonContact& contact) {
  const auto& study = *contact_case.study<MagnificationStudy>();
  const auto contacts = contacts_of(study, contact);
  std::vector<AskedTable> tables{
      {"magnification", [=] { return loads_table(contacts()); }}};
  for (std::size_t i = 0; i < study.nominal_pressures.size(); ++i) {
    const std::string seen = fmt::format("magnification-{}", i + 1);
    const std::string gaps = fmt::format("gap-distribution-{}", i + 1);
    tables.push_back({seen, [=, &study] {
                        return magnification_table(seen, contacts()[i], study);
                      }});
    tables.push_back(
        {gaps, [=] { return gap_distribution_table(gaps, contacts()[i]); }});
  }
  if (study.leak)
    tables.push_back(
        {"leak", [=, &study] { return leak_table(contacts(), *study.leak); }});
  return tables;
}

constexpr const char* for_theory_or_map =
    "Optional; needs a [theory] whose spectrum is the formula, or a measured "
    "map.";

cases::Table keys_of_magnification() {
  return {
      .name = "magnification",
      .when = for_theory_or_map,
      .description = "The contact at magnifications zeta = q/q_ref, Eqs. (23) "
                     "to (28) of Yang and Persson (2008): area, separation, "
                     "and the separation where contact is lost.",
      .keys = {
          key<&Magnification::nominal_pressures>(
              "nominal_pressure",
              {Dimension::pressure,
               positive(),
               {mechanics::ReferenceUnit::contact_modulus}},
              "Loads at which the contact is evaluated.",
              needed("[\"1 MPa\", \"10 MPa\"]")),
          key<&Magnification::from>("from", positive(), "Lowest magnification.",
                                    needed("1.0")),
          key<&Magnification::to>("to", positive(), "Highest magnification.",
                                  needed("100.0")),
          key<&Magnification::points>(
              "points", between(2, 10000),
              "Number of magnifications, at equal ratios.", needed("120")),
          key<&Magnification::reference_wavevector>(
              "reference_wavevector", Dimension::wavevector,
              "q_ref, the wavevector at which zeta = 1.",
              eg("6.283e5", "default: the roll-off of a self-affine surface; "
                            "needed for other kinds, or reference_wavelength")),
          key("reference_wavelength",
              {Dimension::length,
               positive(),
               {mechanics::ReferenceUnit::length}},
              "Reference wavelength 2 pi/q_ref.",
              eg("1 length", "instead of reference_wavevector")),
      }};
}

cases::Table keys_of_leak() {
  return {
      .name = "magnification.leak",
      .when = "Optional.",
      .description = "Leakage of a sealed fluid, an estimate: the flow through "
                     "the one pore at which the open area percolates.",
      .keys = {
          key<&Leak::density>("density", {Dimension::density, at_least(0.0)},
                              "Density of the fluid.", needed("1000 kg/m^3")),
          key<&Leak::viscosity>("viscosity", Dimension::viscosity,
                                "Viscosity of the fluid.", needed("1 mPa s")),
          key<&Leak::pressure_drop>(
              "pressure_drop", {Dimension::pressure, at_least(0.0)},
              "Pressure drop across the seal.", needed("10 kPa")),
          key<&Leak::critical_area>(
              "critical_area", inside(0.0, 1.0),
              "A/A_0 at which the open area percolates.",
              eg("0.42", "default: 1 minus the threshold of site percolation "
                         "on the square lattice")),
      }};
}

/// Returns 2 pi over the wavelength given by that key [rad/m]; 0 after
/// reporting a mistake.
double wavevector_of(TableReader& table, const std::string& key,
                     const mechanics::SurfaceSpec& surface) {
  const mechanics::Quantity wavelength = table.quantity(key);
  if (wavelength.reference == mechanics::ReferenceUnit::length &&
      !surface.length) {
    table.refuse(table.said_by(key),
                 "surface.length is missing, which its unit needs");
    return 0.0;
  }
  const double metres =
      wavelength.in_si({0.0, surface.length.value_or(0.0), 0.0, 0.0});
  return metres > 0.0 ? 2.0 * std::numbers::pi / metres : 0.0;
}

double read_reference_wavevector(TableReader& table,
                                 const mechanics::SurfaceSpec& surface,
                                 const MagnificationStudy& study) {
  const std::string direct = "reference_wavevector";
  const std::string inverse = "reference_wavelength";
  if (table.has(direct) && table.has(inverse))
    table.refuse_both(direct, inverse);
  if (table.has(direct))
    return study.reference_wavevector;
  if (table.has(inverse))
    return wavevector_of(table, inverse, surface);
  if (surface.kind != mechanics::SurfaceKind::self_affine)
    table.complain_missing(
        direct, " (or " + inverse +
                    "), because the surface has no roll-off wavevector");
  return surface.wavevector_roll_off;
}

void read_magnification(TableReader table, Case& read) {
  check_theory(table, read, true);
  MagnificationStudy study;
  table.read(study);
  check_ends(table, study.from, study.to);
  study.reference_wavevector =
      read_reference_wavevector(table, read.surface, study);
  if (const Node* const leak = table.sub_table("leak"))
    table.part(*leak, "magnification.leak").read(study.leak.emplace());
  read.studies.ask(std::move(study));
}

const cases::StudyKeys& magnification_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_magnification(), keys_of_leak()},
      .read = read_magnification,
      .is_asked = asks<MagnificationStudy>,
      .questions = {
          {"[magnification]", {}, asks<MagnificationStudy>, nullptr}}};
  return keys;
}

} // namespace

const Study magnification_study{.keys = magnification_keys,
                                .pages = magnification_pages,
                                .theory_tables = tables_of_magnification};

} // namespace asperity::studies
