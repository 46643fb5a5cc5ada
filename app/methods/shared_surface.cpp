#include "app/methods/shared_surface.hpp"

#include "app/methods/shared_load_steps.hpp"
#include "contact/operators/workers.hpp"
#include "fem/plugin.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace asperity::app {
namespace {

using nlohmann::json;

constexpr const char* surface_key = "shared surface";

json or_null(const std::optional<double>& number) {
  return number ? json(*number) : json();
}

std::optional<double> number_in(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// The members that a random surface uses.
SurfaceSource source_in(const json& text) {
  SurfaceSource source;
  mechanics::SurfaceSpec& surface = source.surface;
  source.realization = text.at("realization");
  source.highest_wavevector = number_in(text.at("highest"));
  surface.kind =
      static_cast<mechanics::SurfaceKind>(text.at("kind").get<int>());
  surface.length = text.at("length").get<double>();
  surface.points = text.at("points").get<int>();
  surface.seed = text.at("seed");
  surface.amplitudes =
      static_cast<mechanics::Amplitudes>(text.at("amplitudes").get<int>());
  surface.rescale = text.at("rescale");
  surface.rms_height = number_in(text.at("rms_height"));
  surface.rms_slope = number_in(text.at("rms_slope"));
  surface.hurst = text.at("hurst");
  surface.wavevector_low = text.at("low");
  surface.wavevector_roll_off = text.at("roll_off");
  surface.wavevector_high = text.at("high");
  surface.file = text.at("file").get<std::string>();
  surface.form_radius = number_in(text.at("form_radius"));
  return source;
}

SharedRows rows_in(const json& text) {
  const SurfaceSource source = source_in(text);
  const int points = *source.surface.points;
  const double length = *source.surface.length;
  const Grid grid{points, points, length, length};
  RankGroup& ranks = fem::load_fem_module().rank_group();
  return {grid, ranks, contact::row_bounds(grid, ranks.size())};
}

/// What this rank has generated last.
struct KeptHeights {
  std::string source;
  std::vector<double> heights;
};

KeptHeights& kept_heights() {
  static KeptHeights kept;
  return kept;
}

const std::vector<double>& own_heights(const json& text, const SharedRows& rows,
                                       int threads) {
  KeptHeights& kept = kept_heights();
  const std::string key = text.dump();
  if (kept.source != key || kept.heights.size() != rows.size()) {
    kept = {};
    const SurfaceSource source = source_in(text);
    kept.heights =
        surfaces::build_rows(source.surface, source.realization, rows,
                             source.highest_wavevector, threads);
    kept.source = key;
  }
  return kept.heights;
}

/// What all ranks do for surface_by_rows().
std::pair<surfaces::Statistics, std::vector<surfaces::Shell>>
describe_part(const json& command) {
  const json& source = command.at("source");
  const int threads = command.at("threads");
  const SharedRows rows = rows_in(source);
  const std::vector<double>& heights = own_heights(source, rows, threads);
  return {surfaces::statistics(rows, heights, threads),
          surfaces::spectral_shells(rows, heights, threads)};
}

/// What all ranks do for heights_by_rows(); only rank 0 takes values.
void send_heights(const json& command, const results::TakeValues& take) {
  const json& source = command.at("source");
  const SharedRows rows = rows_in(source);
  rows.pass_to_rank_0(own_heights(source, rows, command.at("threads")), take);
}

json command_of(const char* what, const SurfaceSource& source, int threads) {
  return {
      {surface_key, what}, {"source", json_of(source)}, {"threads", threads}};
}

} // namespace

bool has_surfaces_by_rows(const cases::Case& contact_case,
                          const std::vector<cases::MethodSpec>& methods,
                          int n_ranks) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (!surfaces::is_random(surface.kind) || !surface.points || !surface.length)
    return false;
  const Grid grid{*surface.points, *surface.points, *surface.length,
                  *surface.length};
  const auto is_shared = [&](const cases::MethodSpec& method) {
    return method.has_fields() && is_shared_by_ranks(method, grid, n_ranks);
  };
  return std::ranges::any_of(methods, is_shared) &&
         std::ranges::all_of(methods, [&](const cases::MethodSpec& method) {
           return !method.has_fields() || is_shared(method);
         });
}

SurfaceOfCase surface_by_rows(const SurfaceSource& source,
                              double contact_modulus, int threads) {
  surfaces::require_rows(source.surface, source.highest_wavevector);
  const json command = command_of("describe", source, threads);
  SurfaceOfCase surface;
  fem::load_fem_module().on_all_ranks(command.dump(), [&](const std::string&,
                                                          int) {
    auto [numbers, shells] = describe_part(command);
    const Grid grid = rows_in(command.at("source")).grid();
    surface =
        described_surface(grid, numbers, std::move(shells), contact_modulus);
  });
  surface.source = source;
  return surface;
}

results::MapRows heights_by_rows(const SurfaceSource& source, int threads) {
  return [command = command_of("send", source, threads)](
             const results::TakeValues& take) {
    fem::load_fem_module().on_all_ranks(
        command.dump(),
        [&](const std::string&, int) { send_heights(command, take); });
  };
}

bool is_for_shared_surface(const std::string& text) {
  return json::parse(text).contains(surface_key);
}

void follow_shared_surface(const std::string& text) {
  const json command = json::parse(text);
  if (command.at(surface_key) == "describe")
    static_cast<void>(describe_part(command));
  else
    send_heights(command, {});
}

json json_of(const SurfaceSource& source) {
  const mechanics::SurfaceSpec& surface = source.surface;
  return {{"realization", source.realization},
          {"highest", or_null(source.highest_wavevector)},
          {"kind", static_cast<int>(surface.kind)},
          {"length", *surface.length},
          {"points", *surface.points},
          {"seed", surface.seed},
          {"amplitudes", static_cast<int>(surface.amplitudes)},
          {"rescale", surface.rescale},
          {"rms_height", or_null(surface.rms_height)},
          {"rms_slope", or_null(surface.rms_slope)},
          {"hurst", surface.hurst},
          {"low", surface.wavevector_low},
          {"roll_off", surface.wavevector_roll_off},
          {"high", surface.wavevector_high},
          {"file", surface.file},
          {"form_radius", or_null(surface.form_radius)}};
}

std::vector<double> take_heights(const json& source, const SharedRows& rows,
                                 int threads) {
  static_cast<void>(own_heights(source, rows, threads));
  return std::exchange(kept_heights(), {}).heights;
}

} // namespace asperity::app
