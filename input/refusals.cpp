#include "input/refusals.hpp"

namespace asperity::input {

void Refusals::add(std::string refusal) {
  while (refusal.ends_with('\n'))
    refusal.pop_back();
  if (("\n" + text_ + "\n").find("\n" + refusal + "\n") == text_.npos)
    text_ += (text_.empty() ? "" : "\n") + refusal;
}

void Refusals::throw_if_any() const {
  if (!empty())
    throw InputError(text_);
}

} // namespace asperity::input
