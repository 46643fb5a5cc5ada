#pragma once

// The figures of a report that belong to no study. Each is one object in the
// file that draws it: its names, the part of the page, when it applies, and a
// pure function from results to data and panels, which says title and caption.
// The list of figure_list.cpp gives their order. Equation numbers are those of
// Yang and Persson (2008).

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/figures/series.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::reports {

/// Parts of a page, in their order. `contact` and `studies` are repeated for
/// every result.
enum class FigureSection { curves, contact, studies, differences, cost };

/// What a figure is drawn of.
struct FigureData {
  std::span<const ReportEntry> entries; ///< one in the parts of one result
  std::span<const Series> series = {};  ///< of all results of the page
  FigureScales scales = {};             ///< of all results of the page
};

struct ReportFigure {
  /// Its names; one that ends with "-" is followed by the name of a method.
  std::array<const char*, 2> names{};
  FigureSection section = FigureSection::contact;
  /// No figure: the results do not have what it shows.
  std::vector<Figure> (*draw)(const FigureData& data) = nullptr;
  bool (*applies)(const FigureData& data) = nullptr; ///< null: always
};

/// @name As a list
/// @{
inline std::vector<Figure> as_list(std::vector<Figure> figures) {
  return figures;
}

inline std::vector<Figure> as_list(std::optional<Figure> figure) {
  std::vector<Figure> figures;
  if (figure)
    figures.push_back(std::move(*figure));
  return figures;
}

/// @}

/// ReportFigure::draw by a function of the part of the data that it needs:
/// series with or without scales, the results, or the one result.
template <auto draw>
std::vector<Figure> drawn_by(const FigureData& data) {
  if constexpr (requires { draw(data.series, data.scales); })
    return as_list(draw(data.series, data.scales));
  else if constexpr (requires { draw(data.series); })
    return as_list(draw(data.series));
  else if constexpr (requires { draw(data.entries); })
    return as_list(draw(data.entries));
  else
    return as_list(draw(data.entries.front()));
}

/// @name Conditions
/// @{
/// Whether a surface is rough and a step is pressed, or nothing on the page
/// says why none is.
bool has_rough_contact(const FigureData& data);
bool is_exact(const FigureData& data); ///< the one result has an exact shape
bool is_rough(const FigureData& data); ///< it has none

/// @}

namespace figures {

/// p/E* on a logarithmic axis against u/h_rms for all methods, with the fitted
/// exponential of the first numerical method and all fit windows.
extern const ReportFigure pressure_gap;

/// (u - u_theory)/h_rms against u/h_rms, for a theory and another method.
extern const ReportFigure gap_deviation;

/// A/A_0 against p/E*: the best estimate of the area and the counted area,
/// theory, and the theory multiplied by the area_scale of the first numerical
/// method. The axis of p is logarithmic if the loads are spaced so, and that of
/// A if it then spans more than a factor of 30.
extern const ReportFigure area_pressure;

/// A E* h'/(A_0 p) against A/A_0, that is, the area-load coefficient kappa.
extern const ReportFigure area_coefficient;

/// A of each method against the area of the theory at the same load, with the
/// diagonal, and their ratio; for a theory and another method.
extern const ReportFigure area_theory;

/// Mean gap, contact fraction and their errors with respect to the exact
/// solution.
extern const ReportFigure exact;

/// The height map of realisation 0.
extern const ReportFigure surface;

/// The height maps of two surfaces and their sum, for a result that
/// sum_of_two_surfaces() accepts.
extern const ReportFigure two_faces;

/// C(q) of all realisations with the analytical spectrum, if the case has one.
extern const ReportFigure spectrum;

/// P_h of up to four realisations against h/h_rms, each normalised by its own
/// h_rms, with the Gaussian, as in Figs. 5 and 13. The bins are h_rms/5 wide
/// and contain all heights. Of rough surfaces.
extern const ReportFigure height_distribution;

/// P(sigma) of the saved pressure maps at up to three loads, with Eq. (20)
/// fitted to each and Eq. (1) of the theory: one figure for each method that
/// `maps` includes.
extern const ReportFigure pressure_distribution;

/// P_u of the saved gap maps outside the contact area: one figure per method.
extern const ReportFigure gap_distribution;

/// The area below the hardness and at the hardness against p/E*.
extern const ReportFigure plastic_area;

/// The pressure and gap maps at the saved loads, one figure per method. A
/// variant such as "fem.hard" is omitted if its base method "fem" has a figure.
extern const ReportFigure maps;

/// The subsurface stress: its maxima against the load, and one section per
/// method.
extern const ReportFigure stress;

/// The pressure on approach and retraction of contact with adhesion.
extern const ReportFigure adhesion_loop;

/// The difference of the pressure maps of two methods over p_0 at up to three
/// loads at which both are saved on one grid: every method of the other results
/// beside the first one of the first result that has maps.
extern const ReportFigure pressure_difference;

/// Iterations and CPU time per step against p/E*.
extern const ReportFigure cost;

} // namespace figures

/// The figures in the order of the page.
std::span<const ReportFigure* const> report_figures();

/// A figure that another file adds as the last one of its part of the page,
/// while this object exists; the one made last ends first.
class RegisteredFigure {
public:
  /// @param figure  lives as long
  explicit RegisteredFigure(const ReportFigure& figure);
  RegisteredFigure(const RegisteredFigure&) = delete;
  RegisteredFigure& operator=(const RegisteredFigure&) = delete;
  ~RegisteredFigure();
};

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
