#pragma once

// What several works refuse, told at once.

#include "input/input_error.hpp"

#include <string>

namespace asperity::input {

/// Collects the refusals of several works, which are thrown at once. Identical
/// ones are stored once.
class Refusals {
public:
  void add(std::string refusal);

  /// Adds what the work refuses.
  template <class Work>
  void of(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      add(error.what());
    }
  }

  bool empty() const { return text_.empty(); }

  const std::string& text() const { return text_; } ///< without a last newline

  /// @throws InputError  there are refusals
  void throw_if_any() const;

private:
  std::string text_;
};

} // namespace asperity::input
