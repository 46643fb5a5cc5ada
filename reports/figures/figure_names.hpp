#pragma once

// The names of all figures that reports can hold, so that a file can ask for
// one by its name and a misspelt name is found.

#include <string>
#include <vector>

namespace asperity::reports {

/// The names; one that ends with "-" is followed by the name of a method or by
/// the number of a load.
const std::vector<std::string>& figure_names();

/// Whether a figure can have this name: "pressure-gap", "maps-fem".
bool is_figure_name(const std::string& name);

} // namespace asperity::reports
