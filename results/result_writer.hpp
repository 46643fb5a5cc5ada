#pragma once

// Writes DIR/result.h5 step by step, so that a kill at any moment loses at
// most the step in progress and leaves a file that opens.

#include "results/result.hpp"
#include "results/result_reader.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>

namespace asperity::results {

class Hdf5File;

/// What a result says of its case.
struct CaseInfo {
  std::string name;
  std::string title;
  std::string text; ///< byte for byte, without NUL
  std::string hash;
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  std::string reference = {};   ///< of reference.csv, as text; empty: none
};

/// The file's layout is docs/results.md. Each function below is one step: it
/// copies the last good file to ".result.h5.part" beside it, changes the copy,
/// and renames it over the old one. A step is there whole or not at all; a
/// left-over part of a killed run is overwritten. One writer a folder; its
/// functions may be called from any thread.
///
/// All throw Hdf5Error or std::filesystem::filesystem_error when the disk or
/// the library refuses: the file then holds all steps before. Bad arguments
/// are std::domain_error.
class ResultWriter {
public:
  enum class Mode {
    create, ///< a new file, over an old one
    resume  ///< goes on with an old one of the same case, else a new one
  };

  /// Makes the folder if need be. The file's status is "running" from here.
  /// @throws cases::CaseError  resume, and the file is of another case (by
  ///                           hash) or no result file; nothing is changed
  ResultWriter(const std::filesystem::path& folder, const CaseInfo& info,
               Mode mode = Mode::create);

  /// DIR/result.h5
  const std::filesystem::path& path() const { return path_; }

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
                               const Fields& fields);

  /// Maps of a step, before its row (else a kill between leaves a step that
  /// counts as done without its maps); replaces those of an earlier try.
  void append_fields(const std::string& method, int realization,
                     const Grid& grid, const Fields& fields);

  /// True if that row is in the file, from this run or an earlier one.
  bool has_step(const std::string& method, int realization, int step) const;

  /// A study's table; replaces one of the same name.
  /// @throws std::domain_error  a table or column without a name or with one
  ///         that has '/', two columns of one name, or of different lengths
  void record_table(const Table& table);

  /// True if that table is in the file, from this run or an earlier one.
  bool has_table(const std::string& name) const;

  /// CPU time of this writer's steps, the copies among it [s]; to be asked
  /// when no other thread writes.
  double cpu_time() const { return cpu_time_; }

  /// What was not computed; replaces the list that was there.
  void record_skipped(std::span<const Skipped> skipped);

  /// @param status  complete | interrupted
  void finish(const std::string& status);

private:
  using Change = std::function<void(Hdf5File&)>;
  void update(const Change& change); // all below: under hdf5_mutex()
  void create(const CaseInfo& info);
  void adopt(const CaseInfo& info);
  void require_begun(const std::string& method, int realization) const;
  void require_new(const std::string& method, int realization,
                   std::span<const CurvePoint> points) const;

  std::filesystem::path path_;
  std::filesystem::path part_;
  StepsDone steps_;
  std::set<std::string> methods_;
  std::set<std::string> tables_;
  double cpu_time_ = 0.0; ///< [s]
};

} // namespace asperity::results
