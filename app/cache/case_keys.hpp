#pragma once

// Under which key the cache keeps what a case computes. Owns the list of what
// decides a number.

#include "cases/text/node.hpp"
#include "cases/types/case.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace asperity::app {

/// Keys, by content_hash(), of the parts of one case. They are made of the
/// case's tables as they are written, defaults left out, in any order of keys:
/// whatever key is added to the vocabulary is in them. Title, [report],
/// [expect], comments, and other methods' tables are not.
class CaseKeys {
public:
  /// @param program  what decides the numbers besides the case:
  ///                 program_identity()
  CaseKeys(const cases::Case& rough_case, std::string program);

  /// One a step of the load program: surface, realisation, material, method,
  /// and every load up to that step.
  std::vector<std::string> steps(const cases::MethodSpec& method,
                                 int realization) const;

  /// Of a study's table.
  std::string table(const cases::MethodSpec& theory,
                    const std::string& name) const;

  /// Of an operator of the block's face.
  /// @param face  in words, all that the block and its grid are
  std::string face(const std::string& face) const;

private:
  std::string method_text(const cases::MethodSpec& method) const;

  const cases::Case& case_;
  std::string program_;
  cases::Node file_;
  std::map<std::string, std::string> inputs_; ///< input_hashes()
  std::string scene_;                         ///< surface and material
};

/// SHA-256 of what is in each file that the case names, by the key that names
/// it: "surface.file". A base case is part of the case's text.
/// @throws cases::CaseError  a file cannot be read
std::map<std::string, std::string> input_hashes(const cases::Case& rough_case);

/// Build and processor: equal ones compute the same bits.
std::string program_identity();

} // namespace asperity::app
