#pragma once

// The readers of the tables of a case, internal to the case reader except for
// entry_of() and check_counter_body(). Each adds mistakes to the given list and
// returns its best result.

#include "base/grid.hpp"
#include "input/reader/table_reader.hpp"
#include "input/text/node.hpp"
#include "input/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// Requirements of the methods on the rest of the case.
struct Demands {
  bool is_surface_built = true; ///< whether a method needs a realisation
  bool is_poisson_needed = false;
};

/// @param file  reader of the whole case
std::vector<MethodSpec> read_methods(TableReader& file,
                                     mechanics::SurfaceKind kind,
                                     Mistakes& mistakes);
Demands demands_of(const std::vector<MethodSpec>& methods);
void check_md(TableReader& table, const mechanics::MdSettings& md);

mechanics::SurfaceSpec read_surface(TableReader table, bool is_surface_built);
/// Checks the keys of a measured map, which have been read.
void check_map(TableReader& table, const mechanics::SurfaceSpec& spec);
mechanics::MaterialSpec read_material(TableReader material,
                                      bool is_poisson_needed);
/// @param read  the case with its surface and material already read
mechanics::MeshSpec read_mesh(TableReader table, const Case& read);
/// Reads nominal pressures, which are > 0 unless the path may be tensile.
void read_gaps(TableReader& load, const Key& key,
               mechanics::LoadingPath& program);
void read_pressures(TableReader& load, const Key& key,
                    mechanics::LoadingPath& program);
mechanics::LoadingPath read_load(TableReader load,
                                 const std::vector<MethodSpec>& methods);
/// Reads report.fields: a number, "none" or "all".
void read_fields(TableReader& report, const Key& key, ReportSpec& spec);
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
