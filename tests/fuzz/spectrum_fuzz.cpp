// Reads any bytes as a tabulated spectrum: the result is one that can be
// evaluated, or an InputError.
#include "input/input_error.hpp"
#include "surfaces/formats/tabulated_spectrum.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace asperity::fuzz {

void read_input(const std::string& bytes) {
  try {
    const surfaces::TabulatedSpectrum spectrum =
        surfaces::read_tabulated_spectrum_text(bytes, "spectrum.csv");
    for (const double wavevector : spectrum.isotropic().kinks)
      require(spectrum(wavevector) >= 0.0, "the density is not negative");
  } catch (const input::InputError&) {
  }
}

} // namespace asperity::fuzz
