#pragma once

// The keys under which the cache stores the results of a case. This class
// defines the list of inputs that determine a result.

#include "base/grid.hpp"
#include "input/text/node.hpp"
#include "input/types/case.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::methods {

/// The cache keys, by content_hash(), of the parts of one case. They are
/// computed from the tables of the case as they are written, without default
/// values and independently of the order of keys, so a key that is added to the
/// vocabulary is included automatically. The title, [report], [expect],
/// comments and the tables of other methods are excluded.
class CaseKeys {
public:
  /// @param contact_case  the case; it must outlive this object
  /// @param program     everything besides the case that determines the
  ///                    results: program_identity()
  CaseKeys(const cases::Case& contact_case, std::string program);

  /// @param inputs  input_hashes() of the case; without them, for a case whose
  ///                files are not there, only operator_text() is complete
  CaseKeys(const cases::Case& contact_case, std::string program,
           std::map<std::string, std::string> inputs);

  /// Returns one key per step of the loading path. It covers the surface, the
  /// realisation, the material, the method and all loads up to that step.
  std::vector<std::string> steps(const cases::MethodSpec& method,
                                 int realization) const;

  /// Returns the key of the table of a study.
  std::string table(const cases::MethodSpec& theory,
                    const std::string& name) const;

  /// Describes the operator on the contact surface of a method's block: grid,
  /// material and all keys of the method but those of the contact law and the
  /// magnification, which act on the pressure and the heights only. Methods of
  /// the case with equal descriptions may share the operator.
  std::string operator_text(const cases::MethodSpec& method,
                            const Grid& grid) const;

  /// Returns the key of an operator in the cache.
  ///
  /// @param text  operator_text()
  std::string of_operator(const std::string& text) const;

private:
  cases::Node table_of(const cases::MethodSpec& method) const;
  std::string method_text(const cases::MethodSpec& method) const;

  const cases::Case& case_;
  std::string program_;
  std::map<std::string, std::string> inputs_; ///< input_hashes()
  std::string problem_text_;                  ///< text of surface and material
};

/// Returns the SHA-256 hash of each file that the case names, by the key that
/// names it: "surface.file", "material.variation.file" or "mesh.file", which is
/// that of the mesh that gmsh makes of the file (file_mesh.hpp). A base case is
/// part of the text of the case.
///
/// @throws input::InputError  a file cannot be read, or gives no mesh
std::map<std::string, std::string>
input_hashes(const cases::Case& contact_case);

/// Identifies build and processor: equal identities compute identical bits.
std::string program_identity();

} // namespace asperity::methods
