#pragma once

// The rows of combinations_test.cpp.

#include "input/types/omissions.hpp"
#include "mechanics/contact_law.hpp"
#include "mechanics/surface_spec.hpp"

#include <string>
#include <vector>

namespace asperity::run::combinations_test {

enum class Kind {
  refused, ///< by the reader or the plan
  omitted, ///< the method says that it leaves this out
  tested,  ///< allowed, with a test of a property
};

/// Pairs of which the program does the same.
struct Row {
  std::string first;  ///< values, "a|b"; "*": all
  std::string second; ///< likewise
  Kind kind = Kind::tested;
  std::string text; ///< part of the refusal or of the reason, or a test
};

/// The name that the rows have for a value of an enumeration.
const char* name_in_rows(mechanics::ContactLaw law);
const char* name_in_rows(mechanics::Edges edges);

std::vector<Row> law_study_rows();
std::vector<Row> edges_study_rows();
std::vector<Row> method_study_rows();
std::vector<Row> law_method_rows();
std::vector<Row> method_edges_rows();
std::vector<Row> method_path_rows();
std::vector<Row> edges_path_rows();
std::vector<Row> study_path_rows();
std::vector<Row> law_path_rows();
std::vector<Row> law_edges_rows();
std::vector<Row> ranks_rows();

} // namespace asperity::run::combinations_test
