#pragma once

// A case's README.md as the report shows it: plain paragraphs. Internal to the
// report on a collection.

#include <string>
#include <vector>

namespace asperity::reports {

/// The paragraphs without heading marks, a line each, "**" and "`" taken out.
std::vector<std::string> plain_paragraphs(const std::string& readme);

/// The paragraph that begins with "**Word.**", without that beginning, plain;
/// empty if there is none.
std::string paragraph_on(const std::string& readme, const std::string& word);

} // namespace asperity::reports
