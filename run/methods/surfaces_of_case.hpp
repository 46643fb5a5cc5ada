#pragma once

// Builds the surfaces of a case once: heights, statistics, spectrum and the
// input of the theory. Decides whether surfaces are needed at all.

#include "base/ranks/root_work.hpp"
#include "input/types/case.hpp"
#include "results/types/result.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/measured_map.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity::methods {

/// What a surface is built from.
struct SurfaceSource {
  mechanics::SurfaceSpec surface;
  int realization = 0;
  std::optional<double> highest_wavevector = {}; ///< of a magnification [rad/m]
  Grid grid = {};                                ///< then needed
};

/// The surface of one realisation as a method uses it.
struct SurfaceOfCase {
  results::SurfaceRecord record; ///< heights, statistics, C(q)
  mechanics::Scales scales;      ///< scales of this surface
  /// Whether the surface is a single shape, whose middle is that of the map: a
  /// sphere, a punch, roughness on a sphere, or a map without continuation.
  bool has_middle = false;
  std::vector<surfaces::Shell> shells = {};
  /// What was found while a measured map was read.
  std::optional<surfaces::MeasuredMap> map_facts = {};
};

/// Returns the surface of a map with its statistics.
/// @param contact_modulus  E* [Pa]
SurfaceOfCase surface_of_map(const surfaces::HeightMap& map,
                             double contact_modulus);

/// Builds a surface in this process.
/// @param contact_modulus  E* [Pa]
SurfaceOfCase whole_surface(const SurfaceSource& source,
                            double contact_modulus);

/// Returns true if one of the methods needs heights. Only a theory that uses
/// the formula of the spectrum does not.
bool needs_surfaces(const std::vector<cases::MethodSpec>& methods);

/// Returns zeta q_0 [rad/m], above which the surface of the method has no
/// roughness; empty if the method has no magnification.
std::optional<double> highest_wavevector(const cases::Case& contact_case,
                                         const cases::MethodSpec& method);

/// Returns true if a method needs the heights of the mirror images of a
/// measured map, or if the map has none: not if half-spaces press it once and
/// theories use its spectrum, which is that of the images.
bool presses_images(const cases::Case& contact_case,
                    const std::vector<cases::MethodSpec>& methods);

/// Returns the grid of the surface that a method presses.
/// @param grid  of the surface of the case
Grid pressed_grid(const cases::Case& contact_case,
                  const cases::MethodSpec& method, const Grid& grid);

/// Returns the grid of a measured map without its mirror images, if it has any.
/// @param grid  with them
Grid grid_without_images(const cases::Case& contact_case, const Grid& grid);

using BuildSurface = std::function<SurfaceOfCase(const SurfaceSource& source)>;

/// Lets rank 0 build the surfaces and give grid, scales and heights to the
/// others, each of which holds the whole surface.
/// @param contact_modulus  E* [Pa]
BuildSurface surfaces_of_rank_0(RootWork& root, double contact_modulus);

/// The surfaces of a case: one per realisation, one more per realisation for
/// each magnification that a method uses, and the measured map itself if a
/// half-space has free boundaries and another method presses its mirror images.
class CaseSurfaces {
public:
  /// Builds the surfaces that the methods need, possibly none. The case must
  /// outlive this object.
  ///
  /// @param only  builds the surfaces of these realisations only, and those of
  ///              the others have no points; empty: all
  /// @param build  builds a surface; empty: in this process
  /// @throws input::InputError, std::domain_error  the surfaces module rejects
  ///           the surface
  CaseSurfaces(const cases::Case& contact_case,
               const std::vector<cases::MethodSpec>& methods,
               const std::set<int>& only = {}, const BuildSurface& build = {});

  /// Returns the surfaces with full roughness, one per realisation. A measured
  /// map whose mirror images no method presses is without them.
  const std::vector<SurfaceOfCase>& whole() const;

  /// Returns what was found while a measured map was read.
  std::optional<surfaces::MeasuredMap> map_facts() const;

  /// Returns true if the surface of the method is none of whole(): roughness
  /// above a magnification is left out, or a measured map is pressed without
  /// the mirror images that another method presses.
  bool has_own(const cases::MethodSpec& method) const;

  const SurfaceOfCase& of(const cases::MethodSpec& method,
                          int realization) const;

  /// Returns the statistics of the surface of a method. For a theory that uses
  /// the formula, they follow from the formula and there are no heights.
  results::SurfaceRecord record_of(const cases::MethodSpec& method,
                                   int realization) const;

private:
  const cases::Case& case_;
  std::vector<SurfaceOfCase> whole_;
  std::map<double, std::vector<SurfaceOfCase>> magnified_;
  std::optional<SurfaceOfCase> single_map_; ///< without continuation
};

/// Return the height spectrum for a theory: the formula up to the magnification
/// of the method, or the measured spectrum of a surface, as lines or as a
/// density (surfaces::spread_spectrum).
theory::HeightSpectrum formula_of_case(const cases::Case& contact_case,
                                       const cases::MethodSpec& method);
theory::HeightSpectrum spectrum_of(const SurfaceOfCase& surface);
theory::HeightSpectrum spread_spectrum_of(const SurfaceOfCase& surface);

/// Returns the scales of a case that builds no surface. The rms height follows
/// from the formula; the spacing is 0 if the case does not give the number of
/// points.
mechanics::Scales formula_scales(const cases::Case& contact_case,
                                 const theory::HeightSpectrum& spectrum);

} // namespace asperity::methods
