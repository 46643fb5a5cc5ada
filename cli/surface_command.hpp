#pragma once

// `asperity surface`: parameters, spectrum and predicted contact of measured
// maps and lines, or of the surface of a case.

#include "cli/command_parts.hpp"
#include "cli/report_forms.hpp"
#include "run/exit_code.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cli {

/// Options of `asperity surface`.
struct SurfaceCommand {
  std::vector<std::string> inputs; ///< map files, line scans or cases
  std::vector<std::string> overrides;
  std::string level = "plane"; ///< [surface] level of a file
  bool is_periodic = false;    ///< --edges periodic
  std::string length;          ///< "20 um"; empty: the file states it
  std::string height_unit;     ///< "nm"; empty: the file states it
  std::string missing_value;   ///< "-9999"; empty: no number marks a point
  std::string length_unit;     ///< "um", of positions; empty: stated or none
  std::string channel;         ///< title or number; empty: the one with heights
  std::string tip_radius;      ///< "10 nm"; empty: not known
  std::string contact_modulus; ///< "2 GPa"; empty: no theory
  double gamma = 0.4;          ///< of the theory, as `run MAP` sets it
  std::string out;             ///< empty: out/<name>
  std::string write;           ///< file to convert the map to
  std::string field;           ///< of a result: pressure, gap or heights
  bool is_whole_cell = false;  ///< the map with its mirror images
  std::string method;          ///< whose field; empty: the first with fields
  int step = -1;               ///< of the field; negative: the last saved one
  bool lists_channels = false; ///< print the channels of files, no more
  bool has_no_report = false;
  ReportForms forms; ///< of the report
};

/// Analyses the inputs, prints the results and writes the report.
/// @throws input::InputError  an input cannot be read, or an option is invalid
run::ExitCode inspect_surface(const SurfaceCommand& command);

/// @param surface, output, action  must outlive the parsing of the command line
void add_surface_command(CLI::App& program, SurfaceCommand& surface,
                         run::OutputOptions& output, Action& action);

} // namespace asperity::cli
