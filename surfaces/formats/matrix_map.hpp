#pragma once

// This internal header of surfaces/formats makes maps of matrices whose files
// have no sizes or units.

#include "surfaces/formats/scan.hpp"

#include <string>

namespace asperity::surfaces {

/// The map of a matrix, or that of a list x y z if the format is automatic and
/// its three columns are one.
/// @param numbers  rows of the file [1]; its grid has the points per side
/// @param name     for messages: the path, or the dataset in it
/// @param what     the file in words: "an .npy file"
/// @throws input::InputError  a key of the case is missing, or the columns may
///                            be those of a list
OpenMap map_of_matrix(OpenMap numbers, const std::string& name,
                      const std::string& what, mechanics::MapFormat format,
                      const MapScale& scale);

} // namespace asperity::surfaces
