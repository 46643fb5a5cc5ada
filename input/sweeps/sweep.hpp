#pragma once

// Reads [sweep]: one case file that describes many cases, its points. Each
// point is an ordinary case: the text of the file without [sweep], plus one
// override per swept key.

#include "input/types/case.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::cases {

struct StackedText;

/// Largest number of points of a sweep.
inline constexpr std::size_t most_sweep_points = 1000;

/// How the values of several keys form points.
enum class Combine {
  product, ///< every value of each key with every value of the others
  zip      ///< the first value of each key, then the second of each, ...
};

struct SweptKey {
  std::string key;                 ///< as for --set: "surface.hurst"
  std::vector<std::string> values; ///< in TOML, one line each; "" removes the
                                   ///< key
};

struct SweptPoint {
  std::vector<std::size_t> choice;    ///< index of the value of each key
  std::vector<std::string> overrides; ///< make the case of the point from the
                                      ///< file and the overrides of the sweep
  Case contact_case;
};

struct CaseSweep {
  std::string path;  ///< of the case file
  std::string name;  ///< as Case::name
  std::string title; ///< of the file; that of a point also names its values
  Combine combine = Combine::product;
  std::vector<SweptKey> keys;     ///< in the order of the file
  std::vector<SweptPoint> points; ///< the last key varies fastest
};

/// Returns "surface.hurst = 0.7, load.cycle = "load"": the values of a point.
std::string point_label(const std::vector<SweptKey>& keys,
                        const std::vector<std::size_t>& choice);

/// Returns what the text of a point says, without [sweep] and the form in which
/// it is written: two points with equal contents are the same case, also if
/// they belong to different sweeps.
///
/// @param text  Case::text
/// @throws input::InputError  the text is not TOML
std::string point_content(const std::string& text);

/// Returns true if the case file, after its overrides, has a [sweep].
///
/// @throws input::InputError  the file cannot be read, or is not TOML
bool is_sweep(const std::string& path,
              const std::vector<std::string>& overrides = {});

/// Reads a case file with a [sweep] and all cases that it describes.
///
/// @param overrides  "key.path=value" entries that are applied to the file
///                   first, also to the table itself:
///                   sweep."surface.hurst"=[0.5, 0.7]
/// @throws input::InputError  a mistake in [sweep]: an unknown key, a value
///                            that is not a list, an empty list, a value twice
///                            in a product, lists of different lengths in a
///                            zip, more than most_sweep_points points, a swept
///                            key that --set also gives; or a point that is not
///                            a valid case, whose values are named with its
///                            mistakes
CaseSweep read_sweep(const std::string& path,
                     const std::vector<std::string>& overrides = {});
CaseSweep read_sweep(StackedText file_text,
                     const std::vector<std::string>& overrides = {});

} // namespace asperity::cases
