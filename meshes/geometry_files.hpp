#pragma once

// Finds the files that a geometry of gmsh reads, so that a change of any of
// them changes the hash of the input.

#include <filesystem>
#include <vector>

namespace asperity::meshes {

/// Returns the mesh file and, for a .geo file, every regular file that it or
/// one of those names as a string literal (Include, Merge, ...), each once, in
/// the order of the text. Relative names refer to the folder of the file that
/// names them. Names that gmsh composes at run time are not found.
///
/// @throws input::InputError  a file cannot be read or exceeds the limit of
///                            files of numbers (input/input_file.hpp)
std::vector<std::filesystem::path>
geometry_files(const std::filesystem::path& mesh_file);

} // namespace asperity::meshes
