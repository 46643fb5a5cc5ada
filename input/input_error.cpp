#include "input/input_error.hpp"

#include <algorithm>
#include <cstdlib>

namespace asperity::input {

void Mistakes::add(const Place& place, const std::string& what) {
  const std::string text = place.text + ": " + what;
  const bool is_known =
      std::any_of(entries_.begin(), entries_.end(),
                  [&](const Entry& entry) { return entry.text == text; });
  if (!is_known)
    entries_.push_back({place.line, text});
}

void Mistakes::throw_if_any(const std::string& where) const {
  if (entries_.empty())
    return;
  std::vector<Entry> sorted = entries_;
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const Entry& a, const Entry& b) { return a.line < b.line; });
  std::string message =
      std::to_string(sorted.size()) + " mistake(s) in " + where + "\n";
  for (const Entry& entry : sorted)
    message += "  " + entry.text + "\n";
  throw InputError(message);
}

void throw_mistake(const Place& place, const std::string& what,
                   const std::string& where) {
  Mistakes mistakes;
  mistakes.add(place, what);
  mistakes.throw_if_any(where);
  std::abort(); // not reached, because there is one mistake
}

} // namespace asperity::input
