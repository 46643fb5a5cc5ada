#pragma once

// gmsh has one state for the whole process. Here it is entered and left.

#include <functional>

namespace asperity::meshes {

/// Runs `work` between gmsh's initialisation and its end, one caller at a time:
/// no configuration files, no signal handlers, nothing printed, one thread, the
/// same random numbers each time.
///
/// @param work  may call gmsh's interface; must not call in_gmsh
/// @throws std::domain_error  in gmsh's own words, where gmsh gives up; what
///                            `work` itself throws passes through
void in_gmsh(const std::function<void()>& work);

} // namespace asperity::meshes
