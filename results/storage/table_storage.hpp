#pragma once

// This internal header of results/ stores the table of a study as a group.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <string>

namespace asperity::results {

/// Checks the names and lengths of a table.
/// @throws std::domain_error  the name of the table or of a column is empty or
///                            contains '/', two columns have the same name, or
///                            the columns differ in length
void require_table(const Table& table);

/// Writes into the empty group `group`.
/// @param table  must satisfy require_table()
void write_table(Hdf5Group& group, const Table& table);

/// Reads a table. Columns are sorted by their attribute `order`; those without
/// it keep the order of the file.
/// @throws input::InputError  the columns differ in length
Table read_table(const Hdf5Group& group, const std::string& name);

} // namespace asperity::results
