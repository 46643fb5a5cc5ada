#include "app/cli/certify_command.hpp"

#include "app/cache/cache.hpp"
#include "app/cache/case_keys.hpp"
#include "app/methods/chosen.hpp"
#include "app/methods/elastic_method.hpp"
#include "cases/reader/read_case.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/operators/halfspace.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

namespace asperity::app {
namespace {

using results::Result;

/// What a field is certified against.
struct Model {
  std::unique_ptr<contact::SurfaceOperator> elasticity;
  double local_compliance = 0.0; ///< [m/Pa]
};

/// The contact law of a method whose answer is that of one surface operator.
const cases::ContactSettings* contact_of(const cases::MethodSpec& method) {
  if (const auto* half =
          std::get_if<cases::HalfspaceSettings>(&method.settings))
    return &half->contact;
  const auto* fem = std::get_if<cases::FemSettings>(&method.settings);
  return fem != nullptr && !is_whole_block(method) ? &fem->contact : nullptr;
}

/// Certifies the fields of one result.
class Certifier {
public:
  explicit Certifier(const Result& result) : result_(result) {
    if (!result.case_text.empty())
      case_ = cases::read_case_text(result.case_text, result.path);
  }

  /// Returns the number of fields with bounds.
  int run() {
    fmt::print("{}: {}\n", result_.path, result_.case_name);
    int certified = 0;
    for (const results::MethodRecord& method : result_.methods)
      for (std::size_t r = 0; r < method.realizations.size(); ++r)
        certified += certify(method, r);
    return certified;
  }

private:
  int certify(const results::MethodRecord& method, std::size_t realization) {
    const results::Curve& curve = method.realizations[realization];
    if (curve.fields.empty()) {
      if (realization == 0)
        as_submitted(method, "no pressure field is saved");
      return 0;
    }
    const results::SurfaceRecord* surface =
        curve.own_surface                       ? &*curve.own_surface
        : realization < result_.surfaces.size() ? &result_.surfaces[realization]
                                                : nullptr;
    if (surface == nullptr || surface->heights.size() != surface->grid.size() ||
        !(curve.fields.front().grid == surface->grid)) {
      as_submitted(method, "no heights are saved on the grid of its fields");
      return 0;
    }
    const SurfaceOfCase on{*surface,
                           {result_.contact_modulus, surface->grid.length_x,
                            surface->grid.spacing_x(), surface->rms_height}};
    const std::optional<Model> model = model_of(method, on);
    if (!model)
      return 0;
    int certified = 0;
    for (const results::Fields& fields : curve.fields)
      try {
        certify(method, curve, fields, *surface, *model);
        ++certified;
      } catch (const std::domain_error& error) { // no contact, for example
        as_submitted(method,
                     fmt::format("step {}: {}", fields.step, error.what()));
      }
    return certified;
  }

  void as_submitted(const results::MethodRecord& method,
                    const std::string& why) const {
    fmt::print("  {:<16} as submitted: {}\n", method.name, why);
  }

  std::optional<Model> model_of(const results::MethodRecord& record,
                                const SurfaceOfCase& surface) const {
    const auto known = [&] {
      return std::ranges::find(case_->methods, record.name,
                               &cases::MethodSpec::name);
    };
    if (!case_ || known() == case_->methods.end()) {
      fmt::print("  {:<16} against the half-space of E* in hard contact\n",
                 record.name);
      return Model{
          std::make_unique<contact::FourierOperator>(
              contact::halfspace_operator(
                  surface.record.grid,
                  {.contact_modulus = result_.contact_modulus,
                   .thickness = std::numeric_limits<double>::infinity()})),
          0.0};
    }
    const cases::MethodSpec& method = *known();
    const cases::ContactSettings* law = contact_of(method);
    if (law == nullptr) {
      as_submitted(record, "no bound exists for this method");
      return std::nullopt;
    }
    Cache none;
    const CaseKeys keys(*case_, program_identity(), {}); // nothing is cached
    SolverFactory factory(case_->material, none, keys);
    return Model{factory.operator_of(method, surface, 1),
                 law->law == cases::ContactLaw::penalty
                     ? 1.0 / law->penalty.in_si(surface.scales)
                     : 0.0};
  }

  void certify(const results::MethodRecord& method, const results::Curve& curve,
               const results::Fields& fields,
               const results::SurfaceRecord& surface,
               const Model& model) const {
    const auto row = std::ranges::find(curve.points, fields.step,
                                       &results::CurvePoint::step);
    const bool has_row = row != curve.points.end();
    const contact::SubmittedField submitted{
        surface.heights, model.local_compliance,
        has_row ? row->nominal_pressure : fields.nominal_pressure,
        fields.pressure,
        has_row ? row->mean_gap : std::numeric_limits<double>::quiet_NaN()};
    const contact::FieldCheck check =
        contact::check_field(*model.elasticity, submitted);
    const contact::SeparationBounds bounds =
        contact::bound_separation(*model.elasticity, submitted);
    const double height = surface.rms_height;
    const double load = submitted.nominal_pressure;
    fmt::print("  {:<16} {:>4} {:>11.4e} {:>+9.1e} {:>9.1e} {:>9.1e} {:>9.1e} "
               "{:>9.1e} {:>10.1e} {:>+10.6f} {:>9.1e}\n",
               method.name, fields.step, load / result_.contact_modulus,
               check.load_error, check.largest_tension / load,
               check.largest_penetration / height,
               check.complementarity / height,
               check.duality_gap / load / height, check.pressure_error,
               (has_row ? row->mean_gap : check.mean_gap) / height,
               bounds.error / height);
  }

  const Result& result_;
  std::optional<cases::Case> case_;
};

} // namespace

ExitCode certify_results(const std::vector<std::string>& paths) {
  std::vector<Result> results;
  results.reserve(paths.size());
  for (const std::string& path : paths)
    results.push_back(results::read_result(path));
  fmt::print("Lengths in h_rms. G/p_0, |p-p*|/|p| and |u-u*| are upper bounds; "
             "p* and u* are\nthe exact answer on this grid "
             "(docs/numerics/certificate.md).\n");
  fmt::print(
      "  {:<16} {:>4} {:>11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} "
      "{:>9}\n",
      "method", "step", "p_0/E*", "load err", "tension", "overlap", "<p,|g|>",
      "G/p_0", "|p-p*|/|p|", "u", "|u-u*|");
  int certified = 0;
  for (const Result& result : results)
    certified += Certifier(result).run();
  if (certified > 0)
    return exit_good;
  fmt::print(stderr, "no field could be certified\n");
  return exit_bad_input;
}

} // namespace asperity::app
