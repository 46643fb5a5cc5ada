#pragma once

// Writes DIR/result.h5 step by step. If the run is interrupted at any moment,
// at most the current step is lost and the file remains readable.

#include "results/result_reader.hpp"
#include "results/storage/change.hpp"
#include "results/storage/result_file.hpp"
#include "results/types/map_rows.hpp"
#include "results/types/result.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>

namespace asperity::results {

/// SHA-256 of each input file by the key of the case that names it, and the
/// stamp of the build under the key "program".
using Inputs = std::map<std::string, std::string>;

/// Returns the inputs of a result that was read, i.e. its facts "input <key>".
Inputs inputs_of(const Result& result);

/// Information about the case that is stored in a result.
struct CaseInfo {
  std::string name;
  std::string title;
  std::string text; ///< verbatim, without NUL
  std::string hash;
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  std::string reference = {};   ///< text of reference.csv; empty: none
  Inputs inputs = {};           ///< what else determines the numbers
};

/// The layout of the file is described in docs/reference/results.md. Each
/// member function that writes makes one atomic change, which is appended to
/// the journal beside the file (result_file.hpp) and moved into the file later,
/// at the latest in finish(). Readers combine both. After an interruption at
/// any moment, each change is present either completely or not at all. There
/// must be one writer per folder; its member functions may be called from any
/// thread.
///
/// All functions throw Hdf5Error or std::system_error if the file system or the
/// library reports an error; all earlier changes are then preserved. Invalid
/// arguments cause std::domain_error.
class ResultWriter {
public:
  enum class Mode {
    create, ///< creates a new file and replaces an existing one
    resume  ///< continues an existing file of the same case, or creates one
  };

  /// Creates the folder if necessary and sets the status to "running".
  /// @throws input::InputError  in mode `resume`, the file is not a result
  ///                            file, or it belongs to another case, other
  ///                            input files or another program. The message
  ///                            names the difference, and nothing is changed.
  ResultWriter(const std::filesystem::path& folder, const CaseInfo& info,
               Mode mode = Mode::create);

  /// Returns DIR/result.h5.
  const std::filesystem::path& path() const { return file_.path(); }

  /// Adds facts or replaces those of the same name.
  void record_provenance(const Provenance& facts);

  /// Replaces the surface of a realisation; writes no empty map or spectrum.
  /// @param realization  >= 0
  void record_surface(int realization, const SurfaceRecord& surface);

  /// Adds a method. It is called once before the steps of the method; when
  /// called again after a resume, it replaces kind, description and contact.
  /// @param contact  as in MethodRecord
  /// @param name  not empty, without '/'
  void begin_method(const std::string& name, const std::string& kind,
                    const std::string& description,
                    const std::string& contact = "pressure");

  /// Records the setup time of a method for one realisation [s].
  void record_setup_time(const std::string& method, int realization,
                         double cpu_time);

  /// As record_surface(), for a method with a surface other than the case's.
  /// @throws std::domain_error  begin_method() was not called for this method
  void record_own_surface(const std::string& method, int realization,
                          const SurfaceRecord& surface);

  /// Adds finished steps: their rows, maps and tables in one change. Maps pass
  /// by rows and are never held in memory.
  /// @throws std::domain_error  as the following functions, or a map has not as
  ///                            many values as its grid
  void append(const Change& change);

  /// Adds a row to a curve. A contact_stiffness of NaN is computed from the
  /// curve by finite differences when the run is complete.
  /// @throws std::domain_error  no begin_method() before, or the step exists
  void append_step(const std::string& method, int realization,
                   const CurvePoint& point);

  /// Adds many rows at once, at the cost of a single change.
  void append_steps(const std::string& method, int realization,
                    std::span<const CurvePoint> points);

  /// Adds a row together with its maps in one change.
  /// @param grid  grid of the maps, that of the method; fields.grid is not read
  void append_step_with_fields(const std::string& method, int realization,
                               const CurvePoint& point, const Grid& grid,
                               const Fields& fields);

  /// Adds the maps of a step and replaces those of an earlier attempt. It must
  /// be called before the row is added, because otherwise an interruption in
  /// between would leave a step that counts as finished but has no maps.
  void append_fields(const std::string& method, int realization,
                     const Grid& grid, const Fields& fields);

  /// Returns whether that row exists, from this run or an earlier one.
  bool has_step(const std::string& method, int realization, int step) const;

  /// Records the table of a study and replaces one of the same name.
  /// @throws std::domain_error  a name is empty or contains '/', two columns
  ///                            have the same name, or they differ in length
  void record_table(const Table& table);

  /// Returns whether that table exists, from this run or an earlier one.
  bool has_table(const std::string& name) const;

  /// Returns the CPU time of the changes of this writer [s]. It must not be
  /// called while another thread writes.
  double cpu_time() const { return cpu_time_; }

  /// Records what was not computed and replaces an earlier list.
  void record_skipped(std::span<const Skipped> skipped);

  /// Moves all changes into the file and sets its status.
  /// @param status  complete | interrupted
  void finish(const std::string& status);

private:
  void record(Change change); // requires mutex_, as do the following
  void require_begun(const std::string& method, int realization) const;
  void require_new(const std::string& method, int realization,
                   std::span<const CurvePoint> points) const;

  ResultFile file_;
  mutable std::mutex mutex_;
  StepsDone steps_;
  std::set<std::string> methods_;
  std::set<std::string> tables_;
  double cpu_time_ = 0.0; ///< [s]
};

/// Moves the changes that an interrupted run left in its journal into
/// result.h5, so that the file can be moved, if there is a result.
/// @throws as ResultWriter
void settle_result(const std::filesystem::path& folder);

} // namespace asperity::results
