#pragma once

// "Did you mean": the word of a list that is fewest letters away. Owns the
// edit distance.

#include <string>
#include <vector>

namespace asperity::cases {

/// Letters to insert, delete or replace to get from `a` to `b` (Levenshtein).
int edit_distance(const std::string& a, const std::string& b);

/// The word of `words` with the smallest edit distance, the first of equals;
/// "" if there are none. Upper and lower case differ, but by half a letter:
/// "Gpa" is nearer to "GPa" than to "Pa".
std::string nearest(const std::string& word,
                    const std::vector<std::string>& words);

} // namespace asperity::cases
