#pragma once

// A height spectrum given as a table. Owns the two-column file and what lies
// between its rows.

#include "surfaces/maps/isotropic_spectrum.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// C(q) through the points (q_i, C_i), straight in a log-log plot between
/// them,
///
///     C(q) = C_i (q/q_i)^s_i,   s_i = ln(C_{i+1}/C_i) / ln(q_{i+1}/q_i)
///
/// and 0 outside [q_first, q_last], whose ends belong to it (is_in_band).
class TabulatedSpectrum {
public:
  /// @param wavevectors  q_i [rad/m] > 0, ascending, two at least
  /// @param densities    C_i [m^4] > 0, as many
  /// @throws std::domain_error  an argument is outside its range
  TabulatedSpectrum(std::vector<double> wavevectors,
                    std::vector<double> densities);

  /// C(q) [m^4].
  double operator()(double wavevector) const;

  /// 2 pi int q^(1 + order) C(q) dq, closed form piece by piece: <h^2> [m^2]
  /// for 0, <|grad h|^2> [1] for 2, <(Laplacian h)^2> [1/m^2] for 4.
  double moment(int order) const;

  IsotropicSpectrum isotropic() const;

private:
  double exponent(std::size_t piece) const;

  std::vector<double> wavevectors_;
  std::vector<double> densities_;
};

/// Reads the columns q [rad/m] and C [m^4]; comments and separators as
/// read_number_text takes them.
/// @throws cases::CaseError  with name:line of the first row that is wrong
TabulatedSpectrum read_tabulated_spectrum_text(std::string_view text,
                                               const std::string& name);
TabulatedSpectrum read_tabulated_spectrum(const std::string& path);

} // namespace asperity::surfaces
