#pragma once

// The mesh of the file that a case names. It is made once in a process, so that
// the mesh that is checked, the one whose bytes are in the keys of the cache
// and the one that is computed with are the same.

#include "base/grid.hpp"
#include "input/types/case.hpp"
#include "meshes/block_mesh.hpp"

#include <optional>
#include <string>

namespace asperity::methods {

/// Reads the file of [mesh] and returns the hash of the bytes of the mesh.
/// Later calls return the same, whatever has become of the file.
/// @param contact_case  with mesh.file
/// @throws input::InputError  read_mesh_file refuses it; the message begins
///                            with the line of mesh.file
std::string hash_of_mesh(const cases::Case& contact_case);

/// The mesh of the file for the block of a method; empty for another method or
/// mesh.
/// @param grid  of the surface that the method presses
/// @throws input::InputError  in addition: the mesh is not valid for the sides
///                            of the block, its contact surface is not the
///                            rectangle of the surface, or it does not suit
///                            the element, the far boundary or the counter-body
std::optional<meshes::BlockMesh> file_mesh(const cases::Case& contact_case,
                                           const cases::MethodSpec& method,
                                           const Grid& grid);

} // namespace asperity::methods
