#include "suite/exchange/answers/certified_field.hpp"

#include "base/json.hpp"
#include "base/shown_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {

CertifiedField certified(contact::SurfaceOperator& elasticity,
                         const contact::SubmittedField& submitted,
                         double rms_height, double claimed_error) {
  CertifiedField field;
  field.nominal_pressure = submitted.nominal_pressure;
  field.rms_height = rms_height;
  field.check = contact::check_field(elasticity, submitted);
  field.bounds = contact::bound_separation(elasticity, submitted);
  field.mean_gap = std::isfinite(submitted.mean_gap) ? submitted.mean_gap
                                                     : field.check.mean_gap;
  const auto claim = [&](const char* which, double error) {
    field.claims.push_back(
        {fmt::format("the mean gap{} is within {:g} h_rms of the exact one "
                     "(bound {:.2g} h_rms)",
                     which, claimed_error, error / rms_height),
         error <= claimed_error * rms_height});
  };
  claim("", field.bounds.error);
  if (std::isfinite(submitted.mean_gap))
    claim(" that follows from the field", field.error_of_field());
  return field;
}

void add_claims(double area_fraction, double elastic_energy,
                CertifiedField& field) {
  const auto add = [&](const char* name, double claimed, double found,
                       double allowed) {
    if (std::isfinite(claimed))
      field.claims.push_back(
          {fmt::format("the {} is {:.6g} (from the field {:.6g})", name,
                       claimed, found),
           std::abs(claimed - found) <= allowed * found});
  };
  add("contact area fraction", area_fraction, field.check.area_fraction, 1e-2);
  add("elastic energy [J/m^2]", elastic_energy, field.check.elastic_energy,
      1e-3);
}

void add_load_claim(CertifiedField& field) {
  field.claims.push_back(
      {fmt::format("the nominal pressure is {:.6g} Pa (from the field {:.6g} "
                   "Pa)",
                   field.nominal_pressure,
                   field.nominal_pressure * (1.0 + field.check.load_error)),
       std::abs(field.check.load_error) <= claimed_load_error});
}

double CertifiedField::error_of_field() const {
  return std::max(std::abs(check.mean_gap - bounds.low),
                  std::abs(bounds.high - check.mean_gap));
}

std::string certificate_head(std::size_t width) {
  return fmt::format(
      "Lengths in h_rms. G/p_0, |p-p*|/|p| and |u-u*| are upper bounds; p* and "
      "u* are\nthe exact answer on this grid (docs/numerics/certificate.md).\n"
      "  {:<{}} {:>4} {:>11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} "
      "{:>9}\n",
      "method", width, "step", "p_0/E*", "load err", "tension", "overlap",
      "<p,|g|>", "G/p_0", "|p-p*|/|p|", "u", "|u-u*|");
}

std::string certificate_line(const CertifiedField& field, std::size_t width) {
  const contact::FieldCheck& check = field.check;
  const double height = field.rms_height;
  const double load = field.nominal_pressure;
  return fmt::format(
      "  {:<{}} {:>4} {:>11.4e} {:>+9.1e} {:>9.1e} {:>9.1e} {:>9.1e} {:>9.1e} "
      "{:>10.1e} {:>+10.6f} {:>9.1e}\n",
      field.method, width, field.step, load / field.contact_modulus,
      Shown{check.load_error}, check.largest_tension / load,
      check.largest_penetration / height, check.complementarity / height,
      check.duality_gap / load / height, check.pressure_error,
      Shown{field.mean_gap / height}, field.bounds.error / height);
}

std::string broken_claims(const CertifiedField& field) {
  std::string text;
  for (const Claim& claim : field.claims)
    if (!claim.holds)
      text += fmt::format("  {} step {}: does not hold: {}\n", field.method,
                          field.step, claim.text);
  return text;
}

bool all_hold(const CertifiedField& field) {
  return std::ranges::all_of(field.claims, &Claim::holds);
}

nlohmann::ordered_json claims_json(const CertifiedField& field) {
  nlohmann::ordered_json claims = nlohmann::ordered_json::array();
  for (const Claim& claim : field.claims)
    claims.push_back({{"claim", claim.text}, {"holds", claim.holds}});
  return claims;
}

nlohmann::ordered_json certificate_json(const CertifiedField& field) {
  const contact::FieldCheck& check = field.check;
  const contact::SeparationBounds& bounds = field.bounds;
  return {{"method", field.method},
          {"realization", field.realization},
          {"step", field.step},
          {"nominal_pressure [Pa]", field.nominal_pressure},
          {"rms_height [m]", field.rms_height},
          {"load_error [1]", check.load_error},
          {"largest_tension [Pa]", check.largest_tension},
          {"nodes_in_tension", check.nodes_in_tension},
          {"largest_penetration [m]", check.largest_penetration},
          {"rms_penetration [m]", check.rms_penetration},
          {"complementarity [m]", check.complementarity},
          {"area_fraction [1]", check.area_fraction},
          {"elastic_energy [J/m^2]", check.elastic_energy},
          {"duality_gap [J/m^2]", check.duality_gap},
          {"pressure_error [1]", check.pressure_error},
          {"mean_gap [m]", field.mean_gap},
          {"mean_gap_low [m]", bounds.low},
          {"mean_gap_high [m]", bounds.high},
          {"mean_gap_error [m]", bounds.error},
          {"mean_gap_of_field [m]", check.mean_gap},
          {"error_of_field [m]", field.error_of_field()},
          {"claims", claims_json(field)}};
}

} // namespace asperity::exchange
