#pragma once

// The stress inside a block under pressure maps, found by all ranks of mpirun,
// so that no rank holds a whole map.

#include "app/methods/stress_section.hpp"

#include <string>

namespace asperity::app {

/// As StressUnderMaps, with the bits of one process. To be used on rank 0,
/// which reads the maps by pieces and sends their rows; one call at a time may
/// be active. What all ranks refuse, or a map that rank 0 cannot read, is an
/// exception on rank 0, after which the ranks take further commands; a failure
/// of some ranks alone, as of memory, ends all of them.
class SharedStress final : public StressUnderMaps {
public:
  /// @param threads  of each rank
  using StressUnderMaps::StressUnderMaps;

  StressPoint strongest(const results::Fields& map) const override;
  std::vector<std::vector<double>>
  von_mises_rows(const results::Fields& map, std::span<const double> depths,
                 int row) const override;
};

/// Returns whether a text that rank 0 has sent to all ranks is a command of
/// this class.
bool is_for_shared_stress(const std::string& text);

/// Executes such a command on a rank other than 0.
void follow_shared_stress(const std::string& text);

} // namespace asperity::app
