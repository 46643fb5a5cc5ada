#include "app/methods/shared_surface.hpp"

#include "app/methods/shared_load_steps.hpp"
#include "fem/plugin.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

#include "ranks/workers.hpp"

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

/// The members that are read from a case, in the order of SurfaceSpec.
json json_of(const mechanics::SurfaceSpec& surface) {
  json text = {{"kind", static_cast<int>(surface.kind)},
               {"length", or_null(surface.length)},
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
               {"format", static_cast<int>(surface.format)},
               {"level", static_cast<int>(surface.level)},
               {"edges", static_cast<int>(surface.edges)},
               {"height_unit", or_null(surface.height_unit)},
               {"length_y", or_null(surface.length_y)},
               {"length_unit", or_null(surface.length_unit)},
               {"missing_value", or_null(surface.missing_value)},
               {"align_lines", static_cast<int>(surface.align_lines)},
               {"spikes", or_null(surface.spikes)},
               {"fill", static_cast<int>(surface.fill)},
               {"max_missing", surface.max_missing},
               {"form_radius", or_null(surface.form_radius)},
               {"radius", surface.radius},
               {"recess", surface.recess},
               {"tilt", surface.tilt},
               {"amplitude", surface.amplitude},
               {"wavelength", surface.wavelength}};
  if (surface.points)
    text["points"] = *surface.points;
  if (surface.channel)
    text["channel"] = *surface.channel;
  if (const auto& crop = surface.crop)
    text["crop"] = {crop->x, crop->y, crop->length_x, crop->length_y};
  return text;
}

template <class Value>
Value enumerator_in(const json& text) {
  return static_cast<Value>(text.get<int>());
}

mechanics::SurfaceSpec surface_in(const json& text) {
  mechanics::SurfaceSpec surface;
  surface.kind = enumerator_in<mechanics::SurfaceKind>(text.at("kind"));
  surface.length = number_in(text.at("length"));
  surface.seed = text.at("seed");
  surface.amplitudes =
      enumerator_in<mechanics::Amplitudes>(text.at("amplitudes"));
  surface.rescale = text.at("rescale");
  surface.rms_height = number_in(text.at("rms_height"));
  surface.rms_slope = number_in(text.at("rms_slope"));
  surface.hurst = text.at("hurst");
  surface.wavevector_low = text.at("low");
  surface.wavevector_roll_off = text.at("roll_off");
  surface.wavevector_high = text.at("high");
  surface.file = text.at("file").get<std::string>();
  surface.format = enumerator_in<mechanics::MapFormat>(text.at("format"));
  surface.level = enumerator_in<mechanics::Levelling>(text.at("level"));
  surface.edges = enumerator_in<mechanics::Edges>(text.at("edges"));
  surface.height_unit = number_in(text.at("height_unit"));
  surface.length_y = number_in(text.at("length_y"));
  surface.length_unit = number_in(text.at("length_unit"));
  surface.missing_value = number_in(text.at("missing_value"));
  surface.align_lines =
      enumerator_in<mechanics::LineAlignment>(text.at("align_lines"));
  surface.spikes = number_in(text.at("spikes"));
  surface.fill = enumerator_in<mechanics::Filling>(text.at("fill"));
  surface.max_missing = text.at("max_missing");
  surface.form_radius = number_in(text.at("form_radius"));
  surface.radius = text.at("radius");
  surface.recess = text.at("recess");
  surface.tilt = text.at("tilt");
  surface.amplitude = text.at("amplitude");
  surface.wavelength = text.at("wavelength");
  if (text.contains("points"))
    surface.points = text.at("points").get<int>();
  if (text.contains("channel"))
    surface.channel = text.at("channel").get<std::string>();
  if (text.contains("crop")) {
    const json& crop = text.at("crop");
    surface.crop = {crop.at(0), crop.at(1), crop.at(2), crop.at(3)};
  }
  return surface;
}

SharedRows rows_in(const json& text) {
  const json& points = text.at("grid");
  const Grid grid{points.at(0), points.at(1), points.at(2), points.at(3)};
  RankGroup& ranks = fem::load_fem_module().rank_group();
  return {grid, ranks, row_bounds(grid, ranks.size())};
}

/// What this rank has built last.
struct KeptHeights {
  std::string source;
  std::vector<double> heights;
  surfaces::MapFacts facts; ///< if each rank has built its own rows
};

KeptHeights& kept_heights() {
  static KeptHeights kept;
  return kept;
}

/// The whole surface on rank 0 from before a command until its rows are sent.
std::vector<double>& whole_surface() {
  static std::vector<double> whole;
  return whole;
}

std::vector<double> built_whole(const SurfaceSource& source) {
  return source.highest_wavevector
             ? surfaces::build_surface_on(source.surface, source.realization,
                                          source.grid,
                                          source.highest_wavevector)
                   .heights
             : surfaces::build_surface(source.surface, source.realization)
                   .heights;
}

/// Builds the rows of this rank, or receives them from rank 0.
KeptHeights build_heights(const json& text, const SharedRows& rows,
                          int threads) {
  const SurfaceSource source{surface_in(text.at("surface")),
                             text.at("realization"),
                             number_in(text.at("highest"))};
  KeptHeights built{text.dump(), {}, {}};
  built.heights = text.at("is_whole")
                      ? rows.scattered(std::exchange(whole_surface(), {}))
                      : surfaces::build_rows(source.surface, source.realization,
                                             rows, source.highest_wavevector,
                                             threads, &built.facts);
  return built;
}

const KeptHeights& kept_heights(const json& text, const SharedRows& rows,
                                int threads) {
  KeptHeights& kept = kept_heights();
  if (kept.source != text.dump() || kept.heights.size() != rows.size()) {
    kept = {};
    kept = build_heights(text, rows, threads);
  }
  return kept;
}

/// What all ranks find for surface_by_rows().
struct Description {
  surfaces::Statistics numbers;
  std::vector<surfaces::Shell> shells;
  surfaces::MapFacts facts;
};

/// What all ranks do for surface_by_rows().
Description describe_part(const json& command) {
  const json& source = command.at("source");
  const int threads = command.at("threads");
  const SharedRows rows = rows_in(source);
  const KeptHeights& kept = kept_heights(source, rows, threads);
  return {surfaces::statistics(rows, kept.heights, threads),
          surfaces::spectral_shells(rows, kept.heights, threads), kept.facts};
}

/// What all ranks do for heights_by_rows(); only rank 0 takes values.
void send_heights(const json& command, const results::TakeValues& take) {
  const json& source = command.at("source");
  const SharedRows rows = rows_in(source);
  rows.pass_to_rank_0(kept_heights(source, rows, command.at("threads")).heights,
                      take);
}

json command_of(const char* what, const SurfaceSource& source, int threads) {
  return {
      {surface_key, what}, {"source", json_of(source)}, {"threads", threads}};
}

} // namespace

bool has_surfaces_by_rows(const cases::Case& contact_case,
                          const std::vector<cases::MethodSpec>& methods,
                          int n_ranks) {
  const auto has_fields = [](const cases::MethodSpec& method) {
    return method.has_fields();
  };
  if (n_ranks == 1 || std::ranges::none_of(methods, has_fields))
    return false;
  const Grid grid = surfaces::surface_grid(contact_case.surface);
  return std::ranges::all_of(methods, [&](const cases::MethodSpec& method) {
    return !method.has_fields() ||
           (n_ranks <= most_ranks(grid) &&
            is_shared_by_ranks(method, pressed_grid(contact_case, method, grid),
                               n_ranks));
  });
}

std::string rows_sentence(const SurfaceSource& source, int n_ranks) {
  if (!source.whole_because.empty())
    return fmt::format("rank 0 builds the whole surface, because {}, and sends "
                       "its rows to {} ranks",
                       source.whole_because, n_ranks);
  return fmt::format("{} ranks {} the rows of the surface", n_ranks,
                     source.surface.kind == mechanics::SurfaceKind::measured
                         ? "read"
                         : "generate");
}

void prepare_heights(const SurfaceSource& source) {
  if (!source.whole_because.empty() &&
      kept_heights().source != json_of(source).dump())
    whole_surface() = built_whole(source);
}

SurfaceOfCase surface_by_rows(const SurfaceSource& asked,
                              double contact_modulus, int threads) {
  SurfaceSource source = asked;
  source.grid = surfaces::surface_grid(source.surface);
  source.whole_because =
      surfaces::reason_for_whole(source.surface, source.highest_wavevector);
  prepare_heights(source);
  const json command = command_of("describe", source, threads);
  SurfaceOfCase surface;
  fem::load_fem_module().on_all_ranks(
      command.dump(), [&](const std::string&, int) {
        Description found = describe_part(command);
        surface = described_surface(source.grid, found.numbers,
                                    std::move(found.shells), contact_modulus);
        if (source.whole_because.empty() &&
            source.surface.kind == mechanics::SurfaceKind::measured)
          surface.map_facts = found.facts;
      });
  surface.source = source;
  return surface;
}

results::MapRows heights_by_rows(const SurfaceSource& source, int threads) {
  return [source, threads](const results::TakeValues& take) {
    prepare_heights(source);
    const json command = command_of("send", source, threads);
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
  const Grid& grid = source.grid;
  return {
      {"surface", json_of(source.surface)},
      {"realization", source.realization},
      {"highest", or_null(source.highest_wavevector)},
      {"grid", {grid.points_x, grid.points_y, grid.length_x, grid.length_y}},
      {"is_whole", !source.whole_because.empty()}};
}

std::vector<double> take_heights(const json& source, const SharedRows& rows,
                                 int threads) {
  static_cast<void>(kept_heights(source, rows, threads));
  return std::exchange(kept_heights(), {}).heights;
}

} // namespace asperity::app
