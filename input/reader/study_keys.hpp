#pragma once

// What the reader of a case is told of the studies that a case may ask for. It
// knows none of them: studies/list/list.cpp adds them when the program starts.

#include "input/reader/vocabulary.hpp"
#include "input/types/omissions.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asperity::cases {

class TableReader;

/// The part of a study that belongs to the case file.
struct StudyKeys {
  /// Its table, and those inside it ("magnification.leak"); none if it answers
  /// a table of another one.
  std::vector<Table> tables;
  /// Reads the table, if there is one and the case has it, and asks for the
  /// study: Case::studies. The surface, the methods and the loads of the case
  /// have been read.
  void (*read)(TableReader table, Case& read);
  bool (*is_asked)(const Case&);
  /// What it asks of each method.
  std::vector<AskedTraits> questions = {};
  /// What its answers for a step depend on, besides the maps of the step: a
  /// part of the key of a kept step. "" without such; null: none are kept.
  std::string (*step_key)(const Case&) = nullptr;
  /// Load steps whose maps it needs in the result; null: none.
  std::vector<std::size_t> (*saved_steps)(const Case&) = nullptr;
  /// Whether a full block answers on its own mesh what its contact conducts.
  bool conducts = false;

  /// "flow"; "" without a table.
  std::string name() const { return tables.empty() ? "" : tables.front().name; }
};

/// Adds studies, whose objects must live as long as the program.
void add_studies(std::span<const StudyKeys* const> studies);

/// The studies in the order in which they were added.
std::span<const StudyKeys* const> known_studies();

/// Whether the case asks for a study: "magnification".
bool is_asked(const Case& contact_case, const std::string& study);

} // namespace asperity::cases
