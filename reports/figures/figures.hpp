#pragma once

// The figures of a report, each a pure function from results to data and
// script. Owns what is plotted against what.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <optional>
#include <span>
#include <vector>

namespace asperity::reports {

/// log10 p/E* against u/h_rms (and nm), all methods, with the fitted
/// exponential of the first numerical method and every fit window.
Figure pressure_gap_figure(std::span<const ReportEntry> entries,
                           std::span<const Series> series);

/// (u - u_theory)/h_rms against u/h_rms. None without a theory and a method.
std::optional<Figure> gap_deviation_figure(std::span<const Series> series);

/// A/A_0 against p/E* up to moderate area: counted, corrected, theory, and the
/// theory times area_scale of the first numerical method.
Figure area_figure(std::span<const Series> series);

/// A E* h'/(A_0 p) against A/A_0: the constant of proportionality itself.
Figure area_coefficient_figure(std::span<const Series> series);

/// A of each method against the theory's at the same load, with the diagonal,
/// and their ratio. None without a theory and a method.
std::optional<Figure> area_theory_figure(std::span<const Series> series);

/// P(sigma) of the kept pressure maps at up to three loads, with (20) fitted
/// to each and the theory's (1): a figure a method, as map_figures has them.
std::vector<Figure> pressure_distribution_figures(const ReportEntry& entry);

/// P_u of the kept gap maps where the faces do not touch: a figure a method.
std::vector<Figure> gap_distribution_figures(const ReportEntry& entry);

/// The height map of realisation 0, and C(q) of all with the formula if any.
std::optional<Figure> surface_figure(const ReportEntry& entry);
std::optional<Figure> spectrum_figure(const ReportEntry& entry);

/// Both maps and their sum, of a result that sum_of_two_faces() takes.
std::optional<Figure> two_faces_figure(const ReportEntry& entry);

/// Pressure and gap maps of the kept loads, a figure a method; a variant such
/// as "fem.hard" has none if its "fem" has.
std::vector<Figure> map_figures(const ReportEntry& entry);

/// Iterations and CPU time a step against p/E*.
std::optional<Figure> cost_figure(std::span<const Series> series);

/// Mean gap, contact fraction and their errors against the exact solution.
std::vector<Figure> exact_figures(const ReportEntry& entry);

/// Of the study of magnifications, as the paper has them: u against zeta; A,
/// h_rms and u; u and u_1 with A, and any leaks in its caption; the density of
/// (27) beside P_u of kept maps at a load near its own. None without tables.
std::vector<Figure> magnification_figures(const ReportEntry& entry);

/// Of the study of adhesion: both branches, equilibrium, and the binding energy
/// against h_rms. None without its table.
std::vector<Figure> adhesion_figures(const ReportEntry& entry);

/// The stress below the face: strongest points against the load, and a section
/// a method. None without tables.
std::vector<Figure> stress_figures(const ReportEntry& entry);

/// Figures that belong together, and the folder below figures/ they go to
/// (empty: figures/ itself).
struct FigureGroup {
  std::string heading;
  std::string folder;
  std::vector<Figure> figures;
};

/// All that apply, in the order of the report.
std::vector<FigureGroup> figures_of(std::span<const ReportEntry> entries);

} // namespace asperity::reports
