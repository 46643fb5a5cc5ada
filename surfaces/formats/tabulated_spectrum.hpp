#pragma once

// A height spectrum given as a table, the two-column file format and the
// interpolation between the rows.

#include "surfaces/maps/isotropic_spectrum.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// C(q) through the points (q_i, C_i), interpolated linearly in the logarithms
/// of q and C,
///
///     C(q) = C_i (q/q_i)^s_i,   s_i = ln(C_{i+1}/C_i) / ln(q_{i+1}/q_i)
///
/// and 0 outside [q_first, q_last]; both ends belong to the band (is_in_band).
class TabulatedSpectrum {
public:
  /// @param wavevectors  q_i [rad/m] > 0, ascending, at least two
  /// @param densities    C_i [m^4] > 0, one per wavevector
  /// @throws std::domain_error  an argument is outside its range
  TabulatedSpectrum(std::vector<double> wavevectors,
                    std::vector<double> densities);

  /// C(q) [m^4].
  double operator()(double wavevector) const;

  /// 2 pi int q^(1 + order) C(q) dq, in closed form for each interval: <h^2>
  /// [m^2] for order 0, <|grad h|^2> [1] for 2, <(Laplacian h)^2> [1/m^2] for
  /// 4.
  double moment(int order) const;

  IsotropicSpectrum isotropic() const;

private:
  double exponent(std::size_t piece) const;

  std::vector<double> wavevectors_;
  std::vector<double> densities_;
};

/// Reads the columns q [rad/m] and C [m^4], with comments and separators as in
/// read_number_text.
/// @throws input::InputError  with name:line of the first invalid row
TabulatedSpectrum read_tabulated_spectrum_text(std::string_view text,
                                               const std::string& name);
TabulatedSpectrum read_tabulated_spectrum(const std::string& path);

} // namespace asperity::surfaces
