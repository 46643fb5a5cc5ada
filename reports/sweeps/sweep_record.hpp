#pragma once

// The plan of a sweep as sweep.json states it: the swept keys, their values and
// the points, each with the folder of its result.

#include "input/sweeps/sweep.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::reports {

struct PointRecord {
  std::vector<std::size_t> choice; ///< index of the value of each key
  std::string case_hash;           ///< of the case of the point
  std::string problem = {};        ///< why the point has no complete result
};

struct SweepRecord {
  std::string case_name;
  std::string title;
  cases::Combine combine = cases::Combine::product;
  std::vector<cases::SweptKey> keys;
  std::vector<PointRecord> points;

  /// Returns "surface.hurst = 0.7, surface.seed = 2".
  std::string label(std::size_t point) const;
};

/// Returns a value of a swept key for a reader, without quotes: "14 nm"; "none"
/// where the key is removed.
std::string value_label(const std::string& value);

/// Returns the folder of a point below that of the sweep: "points/007".
std::filesystem::path point_folder(std::size_t point);

inline constexpr const char* sweep_file = "sweep.json";

/// The case file of a sweep over several maps, in the folder of their results.
inline constexpr const char* maps_file = "maps.toml";
/// A line of it, by which a file is known to be one that we wrote.
inline constexpr const char* maps_mark =
    "# Each map is a point: docs/reference/sweeps.md.";

/// Returns the record as the first part of sweep.json; `points` has one object
/// per point, to which others may be added.
nlohmann::ordered_json record_json(const SweepRecord& record);

/// Reads the record from folder/sweep.json.
///
/// @throws input::InputError  there is no such file, or it is not what
///                            record_json() writes
SweepRecord read_sweep_record(const std::filesystem::path& folder);

} // namespace asperity::reports
