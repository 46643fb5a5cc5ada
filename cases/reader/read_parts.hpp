#pragma once

// The tables of a case, one reader each. Private to the case reader; each
// complains into the list it is given and returns the best it could make.

#include "cases/reader/table_reader.hpp"
#include "cases/text/node.hpp"
#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// What the methods ask of the rest of the case.
struct Demands {
  bool is_surface_built = true;   ///< some method needs a realisation
  bool is_poisson_needed = false; ///< [fem], [md], or a slab of finite
                                  ///< thickness
};

std::vector<MethodSpec> read_methods(const Node& file, SurfaceKind kind,
                                     Mistakes& mistakes);
/// @param has_mesh  the case has a [mesh]
void read_whole_block(TableReader& table, bool has_mesh, FemSettings& fem);
MdSettings read_md(TableReader& table);
Demands demands_of(const std::vector<MethodSpec>& methods);

SurfaceSpec read_surface(const Node& node, const std::string& folder,
                         bool is_surface_built, Mistakes& mistakes);
/// @param folder  where the paths of its files start
MaterialSpec read_material(const Node& table, const std::string& folder,
                           bool is_poisson_needed, Mistakes& mistakes);
/// Layers, inclusion and variation.
void read_block(TableReader& material, const std::string& folder,
                MaterialSpec& spec, Mistakes& mistakes);
/// @param read  with its material
MeshSpec read_mesh(const Node& node, const std::string& folder,
                   const Case& read, Mistakes& mistakes);
LoadProgram read_load(const Node& table, Mistakes& mistakes);
/// @param read  with its surface and methods
MagnificationStudy read_magnification_study(const Node& table, const Case& read,
                                            Mistakes& mistakes);
AdhesionStudy read_adhesion_study(const Node& table, const Case& read,
                                  Mistakes& mistakes);
ReportSpec read_report(const Node& table, Mistakes& mistakes);
/// @param read  with its methods and studies
std::vector<Expectation> read_expectations(const Node& table, SurfaceKind kind,
                                           const Case& read,
                                           Mistakes& mistakes);

/// What only the whole case can tell: a lattice without the material's nu, a
/// magnification below the longest wave.
void check_together(const Node& file, const Case& read, Mistakes& mistakes);
/// Of these, what concerns a block that is no homogeneous box.
void check_block(const Node& file, const Case& read, Mistakes& mistakes);

/// The entry of a method's key, its base's if it is a variant without one, or
/// the method's table.
const Node& entry_of(const Node& file, const std::string& method,
                     const std::string& key);

} // namespace asperity::cases
