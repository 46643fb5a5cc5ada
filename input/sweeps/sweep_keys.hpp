#pragma once

// The keys and values of [sweep] as they are written, and their mistakes. This
// header is internal to the reader of sweeps.

#include "input/sweeps/sweep.hpp"
#include "input/text/node.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// A swept key as it is written, before its values are combined.
struct WrittenKey {
  std::string key;
  std::vector<Node> values;
  Place place;
};

/// Reads the swept keys of the table [sweep], which may also be written as
/// tables: surface.hurst = [...] or "surface.hurst" = [...]. Mistakes are added
/// to the list.
std::vector<WrittenKey> read_swept_keys(const Node& table, Mistakes& mistakes);

/// Returns the value of an override in TOML; "" removes the key.
std::string value_text(const Node& node);

/// Returns the number of points; more than most_sweep_points if there are too
/// many of them.
std::size_t n_points(const std::vector<WrittenKey>& keys, Combine combine);

/// Checks the keys against each other and against the overrides of --set.
void check_swept_keys(const Node& table, const std::vector<WrittenKey>& keys,
                      Combine combine,
                      const std::vector<std::string>& overrides,
                      Mistakes& mistakes);

} // namespace asperity::cases
