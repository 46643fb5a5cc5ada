#include "surfaces/formats/tabulated_spectrum.hpp"

#include "base/require.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::surfaces {
namespace {

TabulatedSpectrum from_table(const NumberTable& table) {
  if (table.columns != 2)
    refuse_line(table.name, table.lines.front(),
                fmt::format("{} columns, but must be 2: q [1/m] and C [m^4]",
                            table.columns));
  std::vector<double> wavevectors;
  std::vector<double> densities;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double wavevector = table.number(row, 0);
    const double density = table.number(row, 1);
    const double above = row == 0 ? 0.0 : wavevectors.back();
    if (!(wavevector > above))
      refuse_line(table.name, table.lines[row],
                  fmt::format("q = {:.6g}, but must be > {:.6g} [1/m]: "
                              "wavevectors must increase from row to row",
                              wavevector, above));
    if (!(density > 0.0))
      refuse_line(table.name, table.lines[row],
                  fmt::format("C = {:.6g}, but must be > 0 [m^4]; leave out "
                              "rows without power",
                              density));
    wavevectors.push_back(wavevector);
    densities.push_back(density);
  }
  if (table.rows() < 2)
    refuse_line(table.name, table.lines.front(),
                "one row, but a spectrum must have at least two");
  return {std::move(wavevectors), std::move(densities)};
}

} // namespace

TabulatedSpectrum::TabulatedSpectrum(std::vector<double> wavevectors,
                                     std::vector<double> densities)
    : wavevectors_(std::move(wavevectors)), densities_(std::move(densities)) {
  if (wavevectors_.size() < 2)
    refuse_argument("wavevectors.size()",
                    static_cast<double>(wavevectors_.size()), ">= 2");
  if (densities_.size() != wavevectors_.size())
    refuse_argument("densities.size()", static_cast<double>(densities_.size()),
                    "the number of wavevectors");
  for (std::size_t i = 0; i < wavevectors_.size(); ++i) {
    require_positive("wavevectors", wavevectors_[i], "rad/m");
    require_positive("densities", densities_[i], "m^4");
    if (i > 0 && wavevectors_[i] <= wavevectors_[i - 1])
      refuse_argument("wavevectors", wavevectors_[i], "ascending");
  }
}

double TabulatedSpectrum::exponent(std::size_t piece) const {
  return std::log(densities_[piece + 1] / densities_[piece]) /
         std::log(wavevectors_[piece + 1] / wavevectors_[piece]);
}

double TabulatedSpectrum::operator()(double wavevector) const {
  if (!is_in_band(wavevector, wavevectors_.front(), wavevectors_.back()))
    return 0.0;
  const auto above = std::upper_bound(wavevectors_.begin() + 1,
                                      wavevectors_.end() - 1, wavevector);
  const auto piece = static_cast<std::size_t>(above - wavevectors_.begin()) - 1;
  return densities_[piece] *
         std::pow(wavevector / wavevectors_[piece], exponent(piece));
}

double TabulatedSpectrum::moment(int order) const {
  double sum = 0.0;
  for (std::size_t piece = 0; piece + 1 < wavevectors_.size(); ++piece)
    sum += densities_[piece] * power_law_integral(order, exponent(piece),
                                                  wavevectors_[piece],
                                                  wavevectors_[piece + 1]);
  return 2.0 * std::numbers::pi * sum;
}

IsotropicSpectrum TabulatedSpectrum::isotropic() const {
  return {*this, wavevectors_, moment(0), moment(2)};
}

TabulatedSpectrum read_tabulated_spectrum_text(std::string_view text,
                                               const std::string& name) {
  return from_table(read_number_text(text, name));
}

TabulatedSpectrum read_tabulated_spectrum(const std::string& path) {
  return from_table(read_number_file(path));
}

} // namespace asperity::surfaces
