#pragma once

// Reads the commands of a script that hold for the plots after them: axes,
// bars, shaded ranges. It is internal to this folder.

#include "reports/explore/chart.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// What is set at one place of the script.
struct ScriptState {
  ChartAxis x, y, second;
  std::vector<ChartMark> marks;
};

/// Reads the words of a command that begins with "set" or "unset". Those that
/// only concern the appearance on paper change nothing.
/// @throws NotUnderstood  the command matters, but is not understood
void read_setting(const std::vector<std::string>& words, ScriptState& state);

} // namespace asperity::reports
