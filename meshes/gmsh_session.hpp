#pragma once

// Access to gmsh, which has a single state for the complete process.

#include <functional>

namespace asperity::meshes {

/// Runs `work` between the initialisation and the finalisation of gmsh, one
/// caller at a time. gmsh runs without configuration files, signal handlers and
/// output, with one thread and with the same random numbers each time.
///
/// @param work  may call gmsh's interface; must not call in_gmsh
/// @throws std::domain_error  gmsh fails; the message is its own. Exceptions of
///                            `work` itself are passed on
void in_gmsh(const std::function<void()>& work);

} // namespace asperity::meshes
