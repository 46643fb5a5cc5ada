#pragma once

// Inside results/ only: what one write adds to a result, as it goes into the
// journal and from there into result.h5 or a Result.

#include "results/types/result.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::results {

class Hdf5File;

/// Of one method; with a realisation, of that curve.
struct MethodChange {
  std::string name;
  int realization = -1; ///< -1: of none
  std::optional<std::string> kind = {};
  std::optional<std::string> description = {};
  std::optional<double> setup_cpu_time = {}; ///< [s]
  std::optional<SurfaceRecord> own_surface = {};
  std::vector<Fields> fields = {};     ///< each over those of its step
  std::vector<CurvePoint> points = {}; ///< of steps that are not there yet
};

/// Each part is added, or replaces what is there under its name.
struct Change {
  std::optional<std::string> status = {};
  Provenance provenance = {};
  std::vector<std::pair<int, SurfaceRecord>> surfaces = {};
  std::vector<MethodChange> methods = {};
  std::vector<Table> tables = {};
  std::optional<std::vector<Skipped>> skipped = {};
};

/// Every number comes back bit by bit; maps in single precision, as result.h5
/// has them.
std::string bytes_of(Change change);

/// @throws cases::CaseError  the bytes are not what bytes_of() writes
Change change_in(std::string_view bytes);

/// Puts a change into an open result file.
/// @throws Hdf5Error
void write_change(Hdf5File& file, const Change& change);

/// Puts a change into a result that was read; the rows of a curve come in the
/// order of their steps.
void merge_change(Result& result, Change change);

} // namespace asperity::results
