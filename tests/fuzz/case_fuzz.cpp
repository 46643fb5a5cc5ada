// Reads any bytes as a case file: the result is a case that can be read back,
// or an InputError.
#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_limits.hpp"
#include "input/text/toml_text.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <string>

namespace asperity::fuzz {
namespace {

int depth_of(const cases::Node& node) {
  int depth = 0;
  for (const cases::Node& element : node.list)
    depth = std::max(depth, 1 + depth_of(element));
  for (const cases::NodeEntry& entry : node.entries)
    depth = std::max(depth, 1 + depth_of(entry.node));
  return depth;
}

} // namespace

void read_input(const std::string& bytes) {
  try {
    const int depth = depth_of(cases::parse_toml(bytes, "case.toml"));
    require(depth <= 2 * (cases::deepest_nesting + cases::longest_key),
            "the limits of the text bound the depth of what is parsed");
    const cases::Case read = cases::read_case_text(bytes, "case.toml");
    const cases::Case again = cases::read_case_text(read.text, read.path);
    require(cases::case_hash(read) == cases::case_hash(again),
            "a case reads itself back");
  } catch (const input::InputError&) {
  }
}

} // namespace asperity::fuzz
