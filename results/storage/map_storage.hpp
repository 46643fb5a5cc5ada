#pragma once

// This internal header of results/ stores surfaces and maps as groups.

#include "results/storage/change.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::results {

/// Writes a surface into an empty group.
/// @param heights  empty: none; surface.heights is not read
void write_surface(Hdf5Group& group, const SurfaceRecord& surface,
                   const MapRows& heights);
/// @param path  of the file, which is opened again for maps that are left in it
/// @return  the rms height is NaN if it is missing
SurfaceRecord read_surface(const Hdf5Group& group,
                           const std::filesystem::path& path, MapsInFile left);

/// Writes the maps of a step into the group `fields` and replaces those of an
/// earlier attempt.
void write_fields(Hdf5Group& group, const FieldsChange& fields);
/// Reads the maps of all steps, sorted by step. The lengths of a grid are 0 if
/// the file does not contain them, and so are its numbers of points if the map
/// is not two-dimensional.
/// @throws input::InputError  pressure and gap differ in shape
std::vector<Fields> read_fields(const Hdf5Group& group,
                                const std::filesystem::path& path,
                                MapsInFile left);

/// Sets the attributes `name` and `name`_unit.
void set_with_unit(Hdf5Group& group, const std::string& name, double number,
                   const std::string& unit);

/// Returns the attribute, or `otherwise` if it is missing.
double number_or(const Hdf5Group& group, const std::string& name,
                 double otherwise);

/// Returns the realisation or step after which a group is named; nothing for
/// any other name.
std::optional<int> index_of(const std::string& name);

} // namespace asperity::results
