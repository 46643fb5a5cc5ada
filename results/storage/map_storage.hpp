#pragma once

// Inside results/ only: surfaces and maps as the groups they are in a file.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::results {

/// Writes into an empty group.
void write_surface(Hdf5Group& group, const SurfaceRecord& surface);
SurfaceRecord read_surface(const Hdf5Group& group);

/// Puts the maps of a step into the group `fields`, over those of an earlier
/// try.
void write_fields(Hdf5Group& group, const Grid& grid, const Fields& fields);
/// Of every step, in their order; the sides of a grid are 0 where the file does
/// not say them, its points where the map is not two-dimensional.
/// @throws cases::CaseError  pressure and gap differ in shape
std::vector<Fields> read_fields(const Hdf5Group& group);

/// The attributes `name` and `name`_unit.
void set_with_unit(Hdf5Group& group, const std::string& name, double number,
                   const std::string& unit);

/// The attribute, or `otherwise` where it is missing.
double number_or(const Hdf5Group& group, const std::string& name,
                 double otherwise);

/// The realisation or step a group is named by; nothing for another name.
std::optional<int> index_of(const std::string& name);

} // namespace asperity::results
