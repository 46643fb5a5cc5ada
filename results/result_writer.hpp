#pragma once

// Writes DIR/result.h5 step by step, so that a kill at any moment loses at
// most the step in progress and leaves a file that opens.

#include "results/result_reader.hpp"
#include "results/storage/result_file.hpp"
#include "results/types/result.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>

namespace asperity::results {

/// SHA-256 of each input file by the key of the case that names it, and
/// "program": the stamp of the build.
using Inputs = std::map<std::string, std::string>;

/// Of a result that was read: its facts "input <key>".
Inputs inputs_of(const Result& result);

/// What a result says of its case.
struct CaseInfo {
  std::string name;
  std::string title;
  std::string text; ///< byte for byte, without NUL
  std::string hash;
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  std::string reference = {};   ///< of reference.csv, as text; empty: none
  Inputs inputs = {};           ///< what decides the numbers beside the text
};

/// The file's layout is docs/results.md. Each function below is one change: it
/// goes whole to the journal beside the file (result_file.hpp), and from there
/// into the file, at the latest in finish(). Readers see both as one. After a
/// kill at any moment every change is there whole or not at all. One writer per
/// folder; its functions may be called from any thread.
///
/// All throw Hdf5Error or std::system_error when the disk or the library
/// refuses: all changes before are then still there. Bad arguments are
/// std::domain_error.
class ResultWriter {
public:
  enum class Mode {
    create, ///< a new file, over an old one
    resume  ///< goes on with an old one of the same case, else a new one
  };

  /// Makes the folder if need be. The file's status is "running" from here.
  /// @throws cases::CaseError  resume, and the file is no result file, or of
  ///                           another case, other input files or another
  ///                           program; says which, and nothing is changed
  ResultWriter(const std::filesystem::path& folder, const CaseInfo& info,
               Mode mode = Mode::create);

  /// DIR/result.h5
  const std::filesystem::path& path() const { return file_.path(); }

  /// Adds facts or replaces those of the same name.
  void record_provenance(const Provenance& facts);

  /// Replaces what was there of that realisation. Empty heights or spectrum
  /// are left out.
  /// @param realization  0..
  void record_surface(int realization, const SurfaceRecord& surface);

  /// Once before the steps of a method; again (after a resume) it replaces
  /// kind and description.
  /// @param name  not empty, no '/'
  void begin_method(const std::string& name, const std::string& kind,
                    const std::string& description);

  /// [s], of one method on one realisation.
  void record_setup_time(const std::string& method, int realization,
                         double cpu_time);

  /// The surface of a method that did not run on the case's; replaces what was
  /// there. Empty heights or spectrum are left out.
  /// @throws std::domain_error  the method was not begun
  void record_own_surface(const std::string& method, int realization,
                          const SurfaceRecord& surface);

  /// Adds a row to a curve. A contact_stiffness of NaN is taken from the curve
  /// by differences when the run is complete.
  /// @throws std::domain_error  the method was not begun, or this step is there
  void append_step(const std::string& method, int realization,
                   const CurvePoint& point);

  /// The same for many rows at once, which costs no more than one.
  void append_steps(const std::string& method, int realization,
                    std::span<const CurvePoint> points);

  /// A row with its maps, both or neither.
  /// @param grid  of the maps, the method's own; fields.grid is not read
  void append_step_with_fields(const std::string& method, int realization,
                               const CurvePoint& point, const Grid& grid,
                               Fields fields);

  /// Maps of a step, before its row (else a kill between leaves a step that
  /// counts as done without its maps); replaces those of an earlier try.
  void append_fields(const std::string& method, int realization,
                     const Grid& grid, Fields fields);

  /// True if that row is in the file, from this run or an earlier one.
  bool has_step(const std::string& method, int realization, int step) const;

  /// A study's table; replaces one of the same name.
  /// @throws std::domain_error  a table or column without a name or with one
  ///         that has '/', two columns of one name, or of different lengths
  void record_table(const Table& table);

  /// True if that table is in the file, from this run or an earlier one.
  bool has_table(const std::string& name) const;

  /// CPU time of this writer's changes [s]; to be asked when no other thread
  /// writes.
  double cpu_time() const { return cpu_time_; }

  /// What was not computed; replaces the list that was there.
  void record_skipped(std::span<const Skipped> skipped);

  /// @param status  complete | interrupted
  void finish(const std::string& status);

private:
  void record(Change change); // as all below: under mutex_
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

/// Puts the changes that a killed run left in its journal into result.h5, so
/// that the file can be moved. Does nothing where there is no result.
/// @throws as ResultWriter
void settle_result(const std::filesystem::path& folder);

} // namespace asperity::results
