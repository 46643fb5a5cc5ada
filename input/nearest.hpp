#pragma once

// Finds the nearest valid word for error messages ("did you mean"), using the
// edit distance.

#include <string>
#include <vector>

namespace asperity::input {

/// Returns the Levenshtein distance: the number of letters to insert, delete or
/// replace to change `a` into `b`.
int edit_distance(const std::string& a, const std::string& b);

/// Returns the word of `words` with the smallest edit distance, the first one
/// in case of ties, or "" if there are none. Letters that differ only in case
/// count as half a letter: "Gpa" is nearer to "GPa" than to "Pa".
std::string nearest(const std::string& word,
                    const std::vector<std::string>& words);

} // namespace asperity::input
