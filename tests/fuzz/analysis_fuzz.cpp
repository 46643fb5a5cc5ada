// Analyses maps of any heights and spacings as `asperity surface` does: the
// numbers are finite where they must be, or the map is refused with a reason.
#include "input/input_error.hpp"
#include "reports/surface/surface_page.hpp"
#include "reports/surface/surface_report.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace asperity::fuzz {
namespace {

constexpr std::size_t head_bytes = 4;

std::uint8_t byte_at(const std::string& bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

/// 2 to 40 points per side, spacings 1:1 to 1:1000 in either order. The heights
/// are the bytes, again and again.
surfaces::HeightMap map_of(const std::string& bytes) {
  const auto points = [&](std::size_t at) {
    return 2 + byte_at(bytes, at) % 39;
  };
  const double ratio = std::pow(10.0, (byte_at(bytes, 2) - 128) / 127.0 * 3.0);
  surfaces::HeightMap map;
  map.grid = {points(0), points(1), 1e-6 * points(0), 1e-6 * points(1) * ratio};
  const std::size_t count = bytes.size() - head_bytes;
  for (std::size_t i = 0; i < map.grid.size(); ++i)
    map.heights.push_back(
        1e-9 * static_cast<std::int8_t>(bytes[head_bytes + i % count]));
  return map;
}

void require_order(const surfaces::FittedParameter& fitted) {
  require(!(fitted.value < fitted.low) && !(fitted.value > fitted.high),
          "the value of a fit is within its interval");
  require(std::isfinite(fitted.value) || !fitted.reason.empty(),
          "a number that is not determined has a reason");
}

void require_sound(const surfaces::MapAnalysis& map) {
  for (const double number :
       {map.heights.sa, map.heights.sq, map.heights.sz, map.heights.sdq,
        map.heights.sdr, map.neighbours.rms_curvature(), map.nayak,
        map.spectrum.rms_height})
    require(std::isfinite(number), "the parameters are finite");
  require(map.range.low <= map.range.high, "the reliable range is ascending");
  if (map.fit)
    for (const surfaces::FittedParameter& fitted :
         {map.fit->hurst, map.fit->roll_off, map.fit->cutoff, map.fit->blur,
          map.fit->rms_height})
      require_order(fitted);
}

} // namespace

void read_input(const std::string& bytes) {
  if (bytes.size() <= head_bytes)
    return;
  const bool is_periodic = byte_at(bytes, 3) % 2 == 1;
  const bool has_tip = byte_at(bytes, 3) / 2 % 2 == 1;
  reports::SurfaceReport report;
  try {
    report.maps.push_back(
        surfaces::analyse_map(map_of(bytes), is_periodic,
                              has_tip ? std::optional(1e-7) : std::nullopt));
  } catch (const std::domain_error&) { // flat, or too few points
    return;
  }
  report.maps.front().name = report.title = "map.txt";
  require_sound(report.maps.front());
  try {
    require_reliable(report);
    add_contact(report, 1e9, 0.5);
    require(!surface_text(report).empty(), "there is a table");
    require(!surface_json(report).empty(), "there is an answer");
  } catch (const input::InputError& error) {
    require(std::string(error.what()).starts_with("map.txt: "),
            "a refusal names the file");
  }
}

} // namespace asperity::fuzz
