#pragma once

// What is certified about one pressure field, as a line of a table and as JSON.

#include "contact/certificate/certificate.hpp"
#include "results/types/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace asperity::exchange {

/// A statement about a field, and whether it is true.
struct Claim {
  std::string text; ///< sentence with the numbers
  bool holds = true;
};

/// A field with its bounds. Lengths are printed relative to rms_height.
struct CertifiedField {
  std::string method;
  int realization = 0;
  int step = 0;
  double nominal_pressure = 0.0; ///< p_0 [Pa]
  double contact_modulus = 0.0;  ///< E* [Pa]
  double rms_height = 0.0;       ///< [m]
  double mean_gap = 0.0;         ///< as submitted, or that of the pressure [m]
  contact::FieldCheck check;
  contact::SeparationBounds bounds;
  std::vector<Claim> claims;

  /// A bound of the error of the mean gap that follows from the pressure [m],
  /// whatever mean gap is submitted with it.
  double error_of_field() const;
};

/// Certifies a field, and claims that its mean gap is within claimed_error
/// h_rms of the exact one: the submitted one, and that which follows from the
/// pressure, so that a right number does not hide a wrong field.
/// @throws std::domain_error  the field has no pressure > 0, for example
CertifiedField certified(contact::SurfaceOperator& elasticity,
                         const contact::SubmittedField& submitted,
                         double rms_height, double claimed_error);

/// The largest relative difference of the mean pressure from the load.
inline constexpr double claimed_load_error = 1e-3;

/// Adds claims about numbers that somebody states and that follow from the
/// field: area fraction to 1 %, elastic energy to 0.1 %. NaN: not stated.
void add_claims(double area_fraction, double elastic_energy,
                CertifiedField& field);

/// Adds the claim that the mean pressure is the load.
void add_load_claim(CertifiedField& field);

/// The lines above the table.
/// @param width  of the column of method names
std::string certificate_head(std::size_t width);

std::string certificate_line(const CertifiedField& field, std::size_t width);

/// The claims that do not hold, one line each.
std::string broken_claims(const CertifiedField& field);

bool all_hold(const CertifiedField& field);

/// A list of all claims.
nlohmann::ordered_json claims_json(const CertifiedField& field);

nlohmann::ordered_json certificate_json(const CertifiedField& field);

} // namespace asperity::exchange
