#pragma once

// This internal header of results/ defines the change that one write operation
// makes to a result, as it is stored in the journal and later applied to
// result.h5 or to a Result.

#include "results/types/result.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::results {

class Hdf5File;

/// Changes of one method or, with a realisation, of one curve.
struct MethodChange {
  std::string name;
  int realization = -1; ///< -1: none
  std::optional<std::string> kind = {};
  std::optional<std::string> description = {};
  std::optional<double> setup_cpu_time = {}; ///< [s]
  std::optional<SurfaceRecord> own_surface = {};
  std::vector<Fields> fields = {};     ///< replace those of the same step
  std::vector<CurvePoint> points = {}; ///< new steps
};

/// Changes of a result. Each part is added, or replaces an existing one of the
/// same name.
struct Change {
  std::optional<std::string> status = {};
  Provenance provenance = {};
  std::vector<std::pair<int, SurfaceRecord>> surfaces = {};
  std::vector<MethodChange> methods = {};
  std::vector<Table> tables = {};
  std::optional<std::vector<Skipped>> skipped = {};
};

/// Serialises a change. Every number is reproduced bit by bit, except for maps,
/// which are stored in single precision as in result.h5.
std::string bytes_of(Change change);

/// Deserialises a change.
/// @throws input::InputError  the bytes do not have the layout of bytes_of()
Change change_in(std::string_view bytes);

/// Applies a change to an open result file.
/// @throws Hdf5Error
void write_change(Hdf5File& file, const Change& change);

/// Applies a change to a result that was read. The rows of a curve are sorted
/// by step.
void merge_change(Result& result, Change change);

} // namespace asperity::results
