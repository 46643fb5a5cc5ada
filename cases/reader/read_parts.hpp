#pragma once

// The readers of the tables of a case, internal to the case reader except for
// entry_of() and check_counter_body(). Each adds mistakes to the given list and
// returns its best result.

#include "base/grid.hpp"
#include "cases/reader/table_reader.hpp"
#include "cases/text/node.hpp"
#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// Requirements of the methods on the rest of the case.
struct Demands {
  bool is_surface_built = true; ///< whether a method needs a realisation
  bool is_poisson_needed = false;
};

std::vector<MethodSpec>
read_methods(const Node& file, mechanics::SurfaceKind kind, Mistakes& mistakes);
/// @param has_mesh  whether the case has a [mesh]
void read_full_block(TableReader& table, bool has_mesh,
                     mechanics::FemSettings& fem);
mechanics::MdSettings read_md(TableReader& table);
Demands demands_of(const std::vector<MethodSpec>& methods);

mechanics::SurfaceSpec read_surface(const Node& node, const std::string& folder,
                                    bool is_surface_built, Mistakes& mistakes);
/// Reads the keys of a measured map; length has been read before.
void read_map(TableReader& table, mechanics::SurfaceSpec& spec);
/// @param folder  folder to which file paths are relative
mechanics::MaterialSpec read_material(const Node& table,
                                      const std::string& folder,
                                      bool is_poisson_needed,
                                      Mistakes& mistakes);
/// Reads layers, inclusion and variation of [material].
void read_block(TableReader& material, const std::string& folder,
                mechanics::MaterialSpec& spec, Mistakes& mistakes);
/// @param read  the case with its material already read
mechanics::MeshSpec read_mesh(const Node& node, const std::string& folder,
                              const Case& read, Mistakes& mistakes);
/// Reads a quantity, a list of quantities, or a sweep of them.
std::vector<mechanics::Quantity>
read_targets(TableReader& table, const std::string& name, Mistakes& mistakes);
mechanics::LoadingPath read_load(const Node& table, Mistakes& mistakes);
/// @param read  the case with its surface and methods already read
MagnificationStudy read_magnification_study(const Node& node, const Case& read,
                                            Mistakes& mistakes);
AdhesionStudy read_adhesion_study(const Node& node, const Case& read,
                                  Mistakes& mistakes);
ReportSpec read_report(const Node& table, Mistakes& mistakes);
/// @param read  the case with its methods and studies already read
std::vector<Expectation> read_expectations(const Node& table,
                                           mechanics::SurfaceKind kind,
                                           const Case& read,
                                           Mistakes& mistakes);

/// Checks conditions on several tables of the case: a lattice that does not
/// match the material's Poisson's ratio, and a magnification below that of the
/// longest wave.
void check_together(const Node& file, const Case& read, Mistakes& mistakes);
/// Checks those of these conditions that concern heterogeneous blocks.
void check_block(const Node& file, const Case& read, Mistakes& mistakes);

/// Checks the sizes and the place of a counter-body of its own mesh, below the
/// block of a method with two bodies. It does nothing after other mistakes.
/// @param grid  of the surface; that of a measured map follows from its file
void check_counter_body(const Node& file, const Case& read,
                        const mechanics::FemSettings& fem, const Grid& grid,
                        Mistakes& mistakes);

/// Returns the entry of a key of the method `name`, the inherited entry if a
/// variant does not have the key, or otherwise the table of the method.
const Node& entry_of(const Node& file, const std::string& name,
                     const std::string& key);

} // namespace asperity::cases
