// `asperity certify`: bounds on the errors of the pressure fields of a result,
// whichever program computed them.
#include "base/json.hpp"
#include "base/special_numbers.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/operators/halfspace.hpp"
#include "reports/analysis/summary.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"
#include "run/cli/command_line.hpp"
#include "run/methods/chosen.hpp"
#include "run/output.hpp"
#include "suite/exchange/answers/certified_field.hpp"
#include "suite/exchange/answers/imported_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

namespace asperity::cli {
namespace {

using results::Result;

/// Options of `asperity certify`.
struct CertifyCommand {
  std::vector<std::string> results; ///< files or folders
};

/// Error of a mean gap that every result must not exceed [h_rms].
constexpr double claimed_error = 1e-3;

/// What a field is certified against.
struct Model {
  std::unique_ptr<contact::SurfaceOperator> elasticity;
  double local_compliance = 0.0; ///< [m/Pa]
  double hardness = infinity;    ///< [Pa]
};

/// Where a field is in a result.
struct Place {
  std::string method;
  int realization = 0;
  double rms_height = 0.0; ///< of its surface [m]
  /// Whether mean gap and energy of the curve are those of the model. Those of
  /// an import follow from the continuum.
  bool has_numbers = true;
};

/// Certifies the fields of one result.
class Certifier {
public:
  explicit Certifier(const Result& result) : result_(result) {
    if (!result.case_text.empty())
      case_ = reports::case_of(result);
  }

  void run() {
    for (const results::MethodRecord& method : result_.methods)
      for (std::size_t r = 0; r < method.realizations.size(); ++r)
        certify(method, r);
  }

  const std::vector<exchange::CertifiedField>& fields() const {
    return fields_;
  }

  /// What is not certified or was assumed, one line each.
  const std::vector<std::string>& notes() const { return notes_; }

private:
  void certify(const results::MethodRecord& method, std::size_t realization) {
    const results::Curve& curve = method.realizations[realization];
    if (curve.fields.empty()) {
      if (realization == 0)
        as_submitted(method, "no pressure field is saved");
      return;
    }
    const results::SurfaceRecord* surface =
        reports::surface_of(result_, method, realization);
    if (surface == nullptr || !surface->has_heights() ||
        !(curve.fields.front().grid == surface->grid)) {
      as_submitted(method, "no heights are saved on the grid of its fields");
      return;
    }
    const methods::SurfaceOfCase on{
        *surface,
        {result_.contact_modulus, surface->grid.length_x,
         surface->grid.spacing_x(), surface->rms_height}};
    const std::optional<Model> model = model_of(method, on);
    if (!model)
      return;
    const cases::MethodSpec* const known = method_of(method);
    const bool is_on_elements =
        method.kind == "submission" && known != nullptr &&
        std::holds_alternative<mechanics::FemSettings>(known->settings);
    if (is_on_elements && realization == 0)
      notes_.push_back(fmt::format("{:<16} against the elements of {}",
                                   method.name, known->name));
    const Place place{method.name, static_cast<int>(realization),
                      surface->rms_height, !is_on_elements};
    const std::vector<double> heights = surface->height_map().whole();
    for (const results::Fields& fields : curve.fields)
      try {
        certify(place, curve, fields, heights, *model);
      } catch (const std::domain_error& error) { // no contact, for example
        as_submitted(method,
                     fmt::format("step {}: {}", fields.step, error.what()));
      }
  }

  void as_submitted(const results::MethodRecord& method,
                    const std::string& why) {
    notes_.push_back(fmt::format("{:<16} as submitted: {}", method.name, why));
  }

  /// The method of the case that a record belongs to; for an imported
  /// submission, the one whose block its problem has. Null if there is none.
  const cases::MethodSpec*
  method_of(const results::MethodRecord& record) const {
    if (!case_)
      return nullptr;
    const auto found = std::ranges::find_if(
        case_->methods, [&](const cases::MethodSpec& method) {
          return record.kind == "submission"
                     ? methods::convex_contact(method) != nullptr
                     : method.name == record.name;
        });
    return found == case_->methods.end() ? nullptr : &*found;
  }

  std::optional<Model> model_of(const results::MethodRecord& record,
                                const methods::SurfaceOfCase& surface) {
    const cases::MethodSpec* const known = method_of(record);
    for (const auto& [name, body] : result_.provenance)
      if (name == exchange::imported_body &&
          (known == nullptr || body == exchange::attracting_faces)) {
        as_submitted(record,
                     body == exchange::attracting_faces
                         ? "no bound exists for faces that attract each other"
                         : fmt::format("its body has {}, of which the file has "
                                       "no case; import certifies it",
                                       body));
        return std::nullopt;
      }
    if (known == nullptr) {
      notes_.push_back(fmt::format(
          "{:<16} against the half-space of E* in hard contact", record.name));
      return Model{contact::halfspace_operator(
                       surface.record.grid,
                       mechanics::halfspace(result_.contact_modulus))
                       .clone(),
                   0.0};
    }
    const cases::MethodSpec& method = *known;
    const mechanics::ContactSettings* law = methods::convex_contact(method);
    if (law == nullptr) {
      as_submitted(record, "no bound exists for this method");
      return std::nullopt;
    }
    const mechanics::ContactInterface contact = law->in_si(surface.scales);
    return Model{exchange::operator_of(*case_, method, surface),
                 contact.local_compliance(), contact.hardness};
  }

  /// Reads the pressure of one step and certifies it.
  void certify(const Place& place, const results::Curve& curve,
               const results::Fields& fields, std::span<const double> heights,
               const Model& model) {
    const auto row = std::ranges::find(curve.points, fields.step,
                                       &results::CurvePoint::step);
    const bool has_row = row != curve.points.end();
    if (std::isfinite(model.hardness) && has_row && row->is_unloading)
      throw std::domain_error(
          "the imprint on which the surface is unloaded is not saved");
    const std::vector<double> pressure = fields.pressure_map().whole();
    exchange::CertifiedField field = exchange::certified(
        *model.elasticity,
        {heights, model.local_compliance,
         has_row ? row->nominal_pressure : fields.nominal_pressure, pressure,
         has_row && place.has_numbers ? row->mean_gap : not_a_number,
         model.hardness},
        place.rms_height, claimed_error);
    field.method = place.method;
    field.realization = place.realization;
    field.step = fields.step;
    field.contact_modulus = result_.contact_modulus;
    exchange::add_load_claim(field);
    if (has_row)
      exchange::add_claims(
          row->area_fraction,
          place.has_numbers ? row->elastic_energy : not_a_number, field);
    fields_.push_back(std::move(field));
  }

  const Result& result_;
  std::optional<cases::Case> case_;
  std::vector<exchange::CertifiedField> fields_;
  std::vector<std::string> notes_;
};

/// Prints one line per saved pressure field: what it violates, and how far its
/// pressure and its mean gap can be from the exact answer of the discrete
/// problem. A method for which no bound exists is labelled "as submitted".
///
/// @return  exit_bad_input if no field could be certified,
///          exit_expectation_failed if a mean gap cannot be shown to be within
///          1e-3 h_rms of the exact one
run::ExitCode certify_results(const CertifyCommand& command) {
  std::vector<Result> results;
  results.reserve(command.results.size());
  for (const std::string& path : command.results) {
    results::require_readable(path);
    results.push_back(results::read_result(path, results::MapsInFile::large));
  }
  std::size_t name_width = 16;
  for (const Result& result : results)
    for (const results::MethodRecord& method : result.methods)
      name_width = std::max(name_width, method.name.size());
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  bool is_certified = false;
  bool is_sound = true;
  if (!run::wants_json())
    fmt::print("{}", exchange::certificate_head(name_width));
  for (const Result& result : results) {
    Certifier certifier(result);
    certifier.run();
    if (!run::wants_json()) {
      fmt::print("{}: {}\n", result.path, result.case_name);
      for (const std::string& note : certifier.notes())
        fmt::print("  {}\n", note);
    }
    for (const exchange::CertifiedField& field : certifier.fields()) {
      is_certified = true;
      is_sound = is_sound && exchange::all_hold(field);
      list.push_back(exchange::certificate_json(field));
      list.back()["result"] = result.path;
      if (!run::wants_json())
        fmt::print("{}{}", exchange::certificate_line(field, name_width),
                   exchange::broken_claims(field));
    }
  }
  if (run::wants_json())
    run::emit_answer(text_of_json(list, 2) + "\n");
  if (!is_certified) {
    fmt::print(stderr, "no field could be certified\n");
    return run::exit_bad_input;
  }
  return is_sound ? run::exit_good : run::exit_expectation_failed;
}

} // namespace

void add_certify(CommandLine& line) {
  auto [command, certify] =
      line.add<CertifyCommand>("certify",
                               "Bound the errors of the pressure fields of\n"
                               "results, of any program; exit 1 if a mean gap\n"
                               "may be wrong by more than 1e-3 h_rms.",
                               certify_results);
  command->add_option("result", certify.results, "results (files or folders)")
      ->required();
  add_quiet(command, line.output);
  add_json(command, line.output, "all numbers");
  add_example(command, "certify out/polymer");
}

} // namespace asperity::cli
