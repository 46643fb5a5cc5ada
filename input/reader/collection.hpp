#pragma once

// Reads collection.toml, which lists the parts of a collection of cases and the
// figures that its common report shows.

#include "input/input_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::cases {

/// One figure that a part shows, by its file name without ending.
struct ShownFigure {
  std::string part;
  std::string name;
  input::Place place; ///< where the file names it, for messages
};

struct Collection {
  std::vector<std::string> parts; ///< names of sub-folders, in their order
  std::vector<ShownFigure> figures;
};

/// Reads
///
///     parts = ["polymer", "adhesion"]
///
///     [figures]
///     polymer = ["pressure-gap", "area-pressure"]
///
/// @param file     collection.toml
/// @param folders  the sub-folders that hold a case
/// @throws input::InputError  an unknown key, a part that is no such
///                            sub-folder, a sub-folder that no part names, a
///                            part named twice, or figures of something that is
///                            not a part
Collection read_collection(const std::filesystem::path& file,
                           const std::vector<std::string>& folders);

} // namespace asperity::cases
