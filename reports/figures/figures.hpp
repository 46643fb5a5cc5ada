#pragma once

// The figures of a report. Each is a pure function from results to data and a
// gnuplot script; this file defines what is plotted against what. Equation
// numbers are those of Yang and Persson (2008).

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/figures/series.hpp"

#include <optional>
#include <span>
#include <vector>

namespace asperity::reports {

/// Plots p/E* on a logarithmic axis against u/h_rms for all methods, with the
/// fitted exponential of the first numerical method and all fit windows.
Figure pressure_gap_figure(std::span<const Series> series,
                           const FigureScales& scales);

/// Plots (u - u_theory)/h_rms against u/h_rms. Nothing is returned unless both
/// a theory and another method are present.
std::optional<Figure> gap_deviation_figure(std::span<const Series> series,
                                           const FigureScales& scales);

/// Plots A/A_0 against p/E*: the best estimate of the area and the counted
/// area, theory, and the theory multiplied by the area_scale of the first
/// numerical method. The axis of p is logarithmic if the loads are spaced so,
/// and that of A if it then spans more than a factor of 30.
Figure area_figure(std::span<const Series> series, const FigureScales& scales);

/// Plots A E* h'/(A_0 p) against A/A_0, that is, the area-load coefficient
/// kappa.
Figure area_coefficient_figure(std::span<const Series> series);

/// Plots the area below the hardness and at the hardness against p/E*. Nothing
/// is returned without a method with a hardness.
std::optional<Figure> plastic_area_figure(const ReportEntry& entry);

/// Plots A of each method against the area of the theory at the same load, with
/// the diagonal, and their ratio. Nothing is returned unless both a theory and
/// another method are present.
std::optional<Figure> area_theory_figure(std::span<const Series> series);

/// Plots P(sigma) of the saved pressure maps at up to three loads, with
/// Eq. (20) fitted to each and Eq. (1) of the theory: one figure per method
/// that map_figures() includes.
std::vector<Figure> pressure_distribution_figures(const ReportEntry& entry);

/// Plots P_u of the saved gap maps outside the contact area: one figure per
/// method.
std::vector<Figure> gap_distribution_figures(const ReportEntry& entry);

/// Show the height map of realisation 0, and C(q) of all realisations together
/// with the analytical spectrum, if the case has one.
std::optional<Figure> surface_figure(const ReportEntry& entry);
std::optional<Figure> spectrum_figure(const ReportEntry& entry);

/// Shows the height maps of two surfaces and their sum, for a result that
/// sum_of_two_surfaces() accepts.
std::optional<Figure> two_faces_figure(const ReportEntry& entry);

/// Shows the pressure and gap maps at the saved loads, one figure per method. A
/// variant such as "fem.hard" is omitted if its base method "fem" has a figure.
std::vector<Figure> map_figures(const ReportEntry& entry);

/// Shows the difference of the pressure maps of two methods over p_0 at up to
/// three loads at which both are saved on one grid: every method of the other
/// results beside the first one of the first result that has maps.
std::vector<Figure> difference_figures(std::span<const ReportEntry> entries);

/// Plots iterations and CPU time per step against p/E*.
std::optional<Figure> cost_figure(std::span<const Series> series,
                                  const FigureScales& scales);

/// Plot mean gap, contact fraction and their errors with respect to the exact
/// solution.
std::vector<Figure> exact_figures(const ReportEntry& entry);

/// Plots the pressure on approach and retraction of contact with adhesion.
/// Nothing is returned if there is none.
std::optional<Figure> adhesion_loop_figure(const ReportEntry& entry);

/// Returns the figures of the subsurface stress: the stress maxima against the
/// load, and one section per method. Nothing is returned if the result has no
/// tables of it.
std::vector<Figure> stress_figures(const ReportEntry& entry);

/// Figures that belong together, and the folder below figures/ in which they
/// are written (empty: figures/ itself).
struct FigureGroup {
  std::string heading;
  std::string folder;
  std::vector<Figure> figures;
};

/// Returns all figures that apply to the results, in the order of the report.
std::vector<FigureGroup> figures_of(std::span<const ReportEntry> entries);

/// The names of all figures that reports can hold; one that ends with "-" is
/// followed by the name of a method or by the number of a load.
std::vector<std::string> figure_names();

/// Whether a figure can have this name: "pressure-gap", "maps-fem".
bool is_figure_name(const std::string& name);

} // namespace asperity::reports
