#pragma once

// Reads a case's README.md for the report: as plain paragraphs. It is internal
// to the report on a collection.

#include <string>
#include <vector>

namespace asperity::reports {

/// Returns the paragraphs without heading marks, one line each, with "**" and
/// "`" removed.
std::vector<std::string> plain_paragraphs(const std::string& readme);

/// Returns the paragraph that begins with "**Word.**", without that beginning,
/// as plain text; empty if there is none.
std::string paragraph_on(const std::string& readme, const std::string& word);

} // namespace asperity::reports
