#pragma once

// Evaluates Persson's theory for the actual surface on which a method ran, for
// the fit of gamma, and passes heights on to the functions of surfaces/.
// Equation numbers are those of Yang and Persson (2008).

#include "input/types/case.hpp"
#include "reports/numbers/fits.hpp"
#include "results/types/result.hpp"
#include "surfaces/analysis/reliable_range.hpp"
#include "surfaces/maps/height_map.hpp"
#include "theory/persson/persson.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <thread>

namespace asperity::reports {

/// The part of the theory of one surface that the fits need. An empty `gap`
/// means that there is no theory of this surface.
struct SurfaceTheory {
  TheoryParts gap;    ///< u(p) of Eq. (14) [m]
  TheoryParts energy; ///< U_el/A_0 of Eq. (9) [J/m^2]
  /// u_0 of Eq. (18) at gamma = 1 [m]; u_0 is proportional to gamma
  double decay_length = not_a_number;
  std::shared_ptr<const theory::PerssonContact> contact; ///< at gamma = 1
};

/// The theories of the surfaces of one result, each computed once, because
/// several methods run on the same surface. The result must outlive it. The
/// first call of of() computes those of all realisations, on all cores.
class SurfaceTheories {
public:
  explicit SurfaceTheories(const results::Result& result) : result_(result) {}

  /// Uses the spectrum of the heights, with one shell per wavevector magnitude;
  /// magnitudes within a relative 1e-6 of each other are equal. The theory is
  /// empty if the heights were not saved.
  /// @param surface  one that the result contains
  /// @throws std::domain_error  the surface has no theory
  const SurfaceTheory& of(const results::SurfaceRecord& surface);

private:
  void compute_realizations();

  const results::Result& result_;
  bool is_computed_ = false;
  std::map<const results::SurfaceRecord*, SurfaceTheory> known_;
};

/// Uses the analytical spectrum of a self-affine case, including roughness up
/// to `highest` [rad/m] if that is given. The result is empty for other kinds
/// of surface.
SurfaceTheory theory_of_formula(const mechanics::SurfaceSpec& surface,
                                double contact_modulus,
                                std::optional<double> highest = {});

/// The heights of a record, which must outlive the result.
inline surfaces::HeightRows height_rows(const results::SurfaceRecord& surface) {
  return [&surface](const auto& take) {
    results::each_piece(surface.height_map(), take);
  };
}

/// Whether the slope and the spectrum of a record are those of its map with
/// mirror images, as of a map with free edges that was pressed alone: the
/// longest wave of the spectrum is then longer than the map.
bool has_spectrum_of_images(const results::SurfaceRecord& surface);

/// The heights whose spectrum a record has, on the grid of that spectrum. The
/// record must outlive the result.
struct SpectrumRows {
  Grid grid;
  surfaces::HeightRows heights;
};

SpectrumRows spectrum_rows(const results::SurfaceRecord& surface);

/// Threads of a transform: all cores.
inline int report_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The spectrum of a record as rings with the number of modes in a map of this
/// area [m^2].
std::vector<surfaces::SpectrumRing>
spectrum_rings(const results::SurfaceRecord& surface, double area);

/// The noise floor of such a map; twice its longest wave and the sampling bound
/// its reliable range, as in surfaces::estimate_spectrum().
std::optional<surfaces::NoiseFloor>
noise_floor_of(const std::vector<surfaces::SpectrumRing>& rings,
               const Grid& grid, double area);

} // namespace asperity::reports
