#pragma once

// Inside results/ only: a table of a study as the group it is in a file.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <string>

namespace asperity::results {

/// @throws std::domain_error  the table or a column has no name or one with
///         '/', two columns share one, or their lengths differ
void require_table(const Table& table);

/// Fills the empty group `group`.
/// @param table  as require_table() wants it
void write_table(Hdf5Group& group, const Table& table);

/// Columns by their `order`, those without one in the order of the file.
/// @throws cases::CaseError  the columns differ in length
Table read_table(const Hdf5Group& group, const std::string& name);

} // namespace asperity::results
