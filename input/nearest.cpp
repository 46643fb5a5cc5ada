#include "input/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>

namespace asperity::input {
namespace {

std::string lower_case(std::string word) {
  for (char& letter : word)
    letter =
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

int half_letters_apart(const std::string& a, const std::string& b) {
  return edit_distance(a, b) + edit_distance(lower_case(a), lower_case(b));
}

} // namespace

int edit_distance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = std::exchange(row[0], static_cast<int>(i));
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substitution, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string nearest(const std::string& word,
                    const std::vector<std::string>& words) {
  const auto best = std::min_element(
      words.begin(), words.end(),
      [&](const std::string& a, const std::string& b) {
        return half_letters_apart(word, a) < half_letters_apart(word, b);
      });
  return best == words.end() ? "" : *best;
}

} // namespace asperity::input
