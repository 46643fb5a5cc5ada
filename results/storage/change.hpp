#pragma once

// The change that one write operation makes to a result: the one form in which
// finished load steps and tables are serialised. Its record is appended to the
// journal of a result, and is an entry of the cache.

#include "base/file_bytes.hpp"
#include "results/types/map_rows.hpp"
#include "results/types/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {

class Hdf5File;

/// A map of a change, which is passed on by rows.
struct ChangeMap {
  MapRows rows = {};     ///< empty: there is no map
  StoredMap stored = {}; ///< the same map, if it is in a record in a file
};

/// A surface whose heights are not in its record.
struct SurfaceChange {
  SurfaceRecord record; ///< without heights
  ChangeMap heights = {};
};

/// The maps of one load step.
struct FieldsChange {
  int step = 0;
  double nominal_pressure = 0.0; ///< [Pa]
  Grid grid = {};
  ChangeMap pressure = {};
  ChangeMap gap = {};
  bool has_double_maps = false; ///< else in single precision
  MapInCell map = {};           ///< the user's map in these
};

/// Changes of one method or, with a realisation, of one curve.
struct MethodChange {
  std::string name = {};
  int realization = -1; ///< -1: none
  std::optional<std::string> kind = {};
  std::optional<std::string> description = {};
  std::optional<std::string> contact = {};
  std::optional<double> setup_cpu_time = {}; ///< [s]
  std::optional<SurfaceChange> own_surface = {};
  std::vector<FieldsChange> fields = {}; ///< replace those of the same step
  std::vector<CurvePoint> points = {};   ///< new steps
};

/// Changes of a result. Each part is added, or replaces an existing one of the
/// same name.
struct Change {
  std::optional<std::string> status = {};
  Provenance provenance = {};
  std::vector<std::pair<int, SurfaceChange>> surfaces = {};
  std::vector<MethodChange> methods = {};
  std::vector<Table> tables = {};
  std::optional<std::vector<Skipped>> skipped = {};
};

/// A serialised change.
struct Record {
  std::uintmax_t size = 0; ///< [B]
  /// Asks for the maps of the change, which must exist until then.
  /// @throws std::domain_error  a map has not as many values as its grid
  BytePieces bytes;
};

/// Serialises a change. Every number is reproduced bit by bit, except for maps
/// of load steps, which are stored in single precision as in result.h5.
Record record_of(Change change);

/// Deserialises a change. Its maps remain in the file until they are read.
/// @throws input::InputError  the bytes do not have the layout of record_of()
Change change_in(const FileBytes& record);

/// Applies a change to an open result file.
/// @throws Hdf5Error
void write_change(Hdf5File& file, const Change& change);

/// Applies a change of a record to a result that was read. The rows of a curve
/// are sorted by step.
/// @param left  maps that are not read into memory
void merge_change(Result& result, Change change, MapsInFile left);

} // namespace asperity::results
