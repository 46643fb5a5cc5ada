#include "run/plan/preparation.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "contact/operators/halfspace.hpp"
#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_parts.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/node.hpp"
#include "mechanics/adhesion_scales.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "meshes/layers/halvable_layers.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "run/plan/needs.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace asperity::run {
namespace {

using cases::MethodSpec;
using cases::Node;
using mechanics::FemSettings;
using mechanics::MeshKind;

/// The factor on E is examined at so many places.
constexpr double most_places = 1e6;

/// Largest surface that is built to be examined.
constexpr std::size_t most_nodes = std::size_t{1} << 20;

class Preparation {
public:
  Preparation(const cases::Case& contact_case, const Grid& grid)
      : case_(contact_case), grid_(grid) {}

  void examine(const MethodSpec& method) {
    method_ = &method;
    pressed_ = methods::pressed_grid(case_, method, grid_);
    scales_ = {};
    scales_.contact_modulus = case_.material.contact_modulus;
    scales_.length = pressed_.length_x;
    scales_.spacing = pressed_.spacing_x();
    std::visit([&](const auto& settings) { examine(settings); },
               method.settings);
  }

  /// The spectrum of a random surface, whose waves the grid must resolve.
  void examine_spectrum() {
    try {
      if (surfaces::is_random(case_.surface.kind))
        surfaces::require_resolved(case_.surface);
    } catch (const input::InputError& error) {
      const std::string what = error.what();
      if (!what.starts_with("surface."))
        throw; // names a file and its line
      mistakes_.add(nearest_node(what.substr(0, what.find(' '))).place, what);
    } catch (const std::domain_error& error) {
      mistakes_.add(nearest_node("surface").place,
                    std::string("surface: ") + error.what());
    }
  }

  /// Whether a linear solver serves a block of so many unknowns. Reads the mesh
  /// of a file.
  void examine_linear_solver(const MethodSpec& method) {
    method_ = &method;
    const Grid pressed = methods::pressed_grid(case_, method, grid_);
    const auto* const fem = method.as<mechanics::FemSettings>();
    if (fem != nullptr && fem->solver == mechanics::FemSolver::full)
      attempt([&] { fem::solver_of(block_of(case_, method, pressed, 1)); });
  }

  void throw_mistakes() const { mistakes_.throw_if_any(); }

private:
  void examine(const mechanics::TheorySettings& theory) {
    attempt([&] { require_hard_enough(theory.hardness); });
  }

  void examine(const mechanics::WinklerSettings&) {}

  void examine(const mechanics::HalfspaceSettings& half) {
    if (mechanics::is_adhesive(half.contact.law))
      attempt([&] { require_resolved(half.contact); });
    attempt([&] { require_hard_enough(half.contact.hardness); });
    if (!half.has_free_boundaries && case_.material.poisson_ratio)
      attempt([&] {
        contact::compliance_function(
            methods::continuum_of(*method_, case_.material, scales_));
      });
  }

  /// Whether the surface can carry the loads. Units of the slope are compared
  /// with each other only: it is that of the realisation.
  void require_hard_enough(
      const std::optional<mechanics::Quantity>& hardness) const {
    constexpr auto by_slope =
        mechanics::ReferenceUnit::contact_modulus_times_slope;
    if (!hardness || case_.load.control != mechanics::Control::nominal_pressure)
      return;
    mechanics::Scales scales = scales_;
    scales.rms_slope = 1.0;
    const double largest = hardness->in_si(scales);
    for (const mechanics::Quantity& load : case_.load.targets)
      if ((load.reference == by_slope) == (hardness->reference == by_slope) &&
          load.in_si(scales) > largest)
        refuse_argument(
            "hardness", largest,
            fmt::format("at least the largest nominal pressure, {:g}{}, "
                        "because no contact pressure exceeds it",
                        load.in_si(scales),
                        load.reference == by_slope ? " h' Pa" : " Pa"));
  }

  /// Whether the grid resolves the range of an adhesion.
  void require_resolved(const mechanics::ContactSettings& settings) const {
    constexpr double largest = mechanics::largest_grid_number;
    const mechanics::Scales scales =
        mechanics::adhesion_scales(scales_, pressed_);
    const mechanics::ContactInterface contact = settings.in_si(scales);
    const double step =
        contact.grid_number(scales.contact_modulus, scales.spacing);
    if (step <= largest)
      return;
    const double factor = step / largest;
    const std::string finer =
        case_.surface.kind == mechanics::SurfaceKind::measured
            ? fmt::format("a map with a spacing of at most {:.3g} m",
                          scales.spacing / factor)
            : fmt::format("surface.points at least {}",
                          static_cast<long long>(
                              std::ceil(pressed_.points_x * factor)));
    refuse_argument(
        "range", contact.adhesion_range,
        fmt::format("at least {:.3g} m with this spacing, or {} with this "
                    "range: s^2 h/(w E*) = {:.3g}, with the largest tension s "
                    "of the law, must be at most {:g}",
                    contact.adhesion_range * std::sqrt(factor), finer, step,
                    largest));
  }

  void examine(const FemSettings& fem) {
    const bool is_full = fem.solver == mechanics::FemSolver::full;
    attempt([&] { examine_mesh(fem, is_full && fem.full.uses_case_mesh); });
    if (mechanics::is_adhesive(fem.contact.law))
      attempt([&] { require_resolved(fem.contact); });
    if (!is_full)
      return;
    attempt([&] { examine_moduli(fem); });
    if (fem.full.bodies == 2 && case_.mesh.counter)
      cases::check_counter_body(*case_.file, case_, fem, pressed_, mistakes_);
  }

  void examine(const mechanics::MdSettings& md) {
    attempt([&] {
      if (!pressed_.is_square())
        throw std::domain_error(fmt::format(
            "needs a square surface, but this one is {:g} m by {:g} m, {} by "
            "{} points",
            pressed_.length_x, pressed_.length_y, pressed_.points_x,
            pressed_.points_y));
      if (2.0 * md.cutoff > pressed_.length_x)
        refuse_argument("cutoff", md.cutoff,
                        fmt::format("at most half of the side length, {} m",
                                    number_text(0.5 * pressed_.length_x)));
      const int atoms = md.atoms.value_or(pressed_.points_x);
      const int coarsest = 1 << (md.levels - 1);
      if (md.bulk == mechanics::AtomBulk::explicit_layers &&
          atoms % coarsest != 0)
        refuse_argument(
            Argument{"atoms per side", "method.atoms"}, atoms,
            fmt::format("a multiple of {} for {} levels", coarsest, md.levels));
    });
  }

  void examine_mesh(const FemSettings& fem, bool uses_case_mesh) const {
    const int degree = degree_of(fem.block.element);
    const double depth = fem.block.depth.in_si(scales_);
    const std::vector<double> interfaces =
        meshes::interfaces_of(case_.material.layers, scales_);
    const mechanics::MeshSpec& mesh = case_.mesh;
    const MeshKind kind = uses_case_mesh ? mesh.kind : MeshKind::layers;
    if (kind == MeshKind::adaptive) {
      const Grid columns =
          meshes::halvable_columns(pressed_, degree, mesh.halvings);
      if (!interfaces.empty())
        meshes::halvable_layers(0.5 *
                                    (columns.spacing_x() + columns.spacing_y()),
                                mesh.halvings, interfaces, depth);
    } else if (kind == MeshKind::gmsh) {
      if (mesh.geometry != mechanics::MeshGeometry::file)
        meshes::require_gmsh_block(meshes::gmsh_parameters(
            mesh, case_.material, depth, pressed_, scales_));
    } else {
      fem::require_cells(pressed_, degree);
      if (kind == MeshKind::hanging)
        meshes::hanging_nodes({pressed_.points_x / degree,
                               pressed_.points_y / degree, pressed_.length_x,
                               pressed_.length_y},
                              depth, mesh.cells_a_level, degree);
      else
        meshes::layers_of_block(fem.block, interfaces, scales_.spacing, depth);
    }
  }

  /// The moduli of the cells, and the factor on E at places that are spread
  /// over the block like the centres of its cells.
  void examine_moduli(const FemSettings& fem) const {
    const double depth = fem.block.depth.in_si(scales_);
    const fem::ModuliField moduli = fem::moduli_field(
        case_.material, scales_,
        fem::own_moduli(case_.material, fem.full.bodies), pressed_, depth);
    if (!moduli.has_factor())
      return;
    const double cells_down = std::max(1.0, depth / scales_.spacing);
    const double coarser =
        std::max(1.0, std::cbrt(static_cast<double>(pressed_.size()) *
                                cells_down / most_places));
    const auto count = [&](double cells) {
      return std::max(1, static_cast<int>(cells / coarser));
    };
    const int n_x = count(pressed_.points_x);
    const int n_y = count(pressed_.points_y);
    const int n_z = count(cells_down);
    for (int k = 0; k < n_z; ++k)
      for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i)
          static_cast<void>(moduli.factor({(i + 0.5) / n_x * pressed_.length_x,
                                           (j + 0.5) / n_y * pressed_.length_y,
                                           (k + 0.5) / n_z * depth}));
  }

  /// Collects the mistake that a builder finds.
  template <class Build>
  void attempt(const Build& build) {
    try {
      build();
    } catch (const RefusedArgument& refused) {
      add(refused);
    } catch (const std::domain_error& error) {
      const Node& table = cases::entry_of(*case_.file, method_->name, "");
      mistakes_.add(table.place, method_->name + ": " + error.what());
    }
  }

  /// The key that gives an argument: the one that the builder names, a key of
  /// the method with the name of the argument, or the name itself.
  std::string key_of(const RefusedArgument& refused) const {
    if (!refused.key.empty())
      return refused.key;
    const std::string name = refused.name.substr(0, refused.name.find(':'));
    const std::string kind = cases::kind_of_method(method_->name);
    return cases::find_key(kind, name) != nullptr ? "method." + name : name;
  }

  void add(const RefusedArgument& refused) {
    std::string path = key_of(refused);
    if (path == "surface.points" &&
        case_.surface.kind == mechanics::SurfaceKind::measured)
      path = "surface.file"; // determines the points
    const std::string of_method = "method.";
    const bool is_of_method = path.starts_with(of_method);
    const Node& node = is_of_method
                           ? cases::entry_of(*case_.file, method_->name,
                                             path.substr(of_method.size()))
                           : nearest_node(path);
    if (is_of_method)
      path.replace(0, of_method.size(), method_->name + ".");
    const bool is_own = path.ends_with("." + refused.name);
    const std::string value = number_text(refused.value);
    const std::string found = node.is_table()
                                  ? fmt::format("{} is not given", path)
                                  : fmt::format("{} = {}", path, written(node));
    const std::string is =
        is_own && !node.is_table() && written(node) == value ? ""
        : is_own
            ? fmt::format("{} {}", node.is_table() ? " and is" : ", which is",
                          value)
            : fmt::format(": {}{} = {}",
                          path.starts_with(method_->name + ".")
                              ? ""
                              : method_->name + ": ",
                          refused.name, value);
    mistakes_.add(node.place, fmt::format("{}{}, but must be {}", found, is,
                                          refused.range));
  }

  /// The node of a path, or the last table on the way to it.
  const Node& nearest_node(const std::string& path) const {
    const Node* node = case_.file.get();
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      const Node* const next = node->find(path.substr(begin, end - begin));
      if (next == nullptr)
        break;
      node = next;
      begin = end + 1;
    }
    return *node;
  }

  const cases::Case& case_;
  Grid grid_;
  const MethodSpec* method_ = nullptr; ///< that is examined
  Grid pressed_;                       ///< by it
  mechanics::Scales scales_;           ///< without those of the heights
  input::Mistakes mistakes_;
};

} // namespace

void require_computable(const cases::Case& contact_case,
                        const std::vector<MethodSpec>& methods,
                        const Grid& grid) {
  if (grid.points_x < 1)
    return;
  Preparation preparation(contact_case, grid);
  if (methods::needs_surfaces(methods))
    preparation.examine_spectrum();
  for (const MethodSpec& method : methods)
    preparation.examine(method);
  preparation.throw_mistakes();
  for (const MethodSpec& method : methods)
    preparation.examine_linear_solver(method);
  preparation.throw_mistakes();
}

void require_surface(const cases::Case& contact_case,
                     const std::vector<MethodSpec>& methods, const Grid& grid) {
  if (methods::needs_surfaces(methods) && grid.size() <= most_nodes)
    methods::CaseSurfaces(contact_case, methods, {0});
}

} // namespace asperity::run
