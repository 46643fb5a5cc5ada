// Compares the heights and fields of two results bit by bit, which
// `asperity diff` does not do. Arguments: two folders. Exit code 1 and a
// sentence if they differ.
#include "results/result_reader.hpp"

#include <cstdio>
#include <exception>
#include <string>

namespace asperity::results {
namespace {

/// Empty if all maps of two results are equal.
std::string difference(const Result& one, const Result& other) {
  if (one.surfaces.size() != other.surfaces.size() ||
      one.methods.size() != other.methods.size())
    return "numbers of surfaces or methods";
  for (std::size_t r = 0; r < one.surfaces.size(); ++r)
    if (one.surfaces[r].heights.empty() ||
        one.surfaces[r].heights != other.surfaces[r].heights)
      return "heights of realisation " + std::to_string(r);
  std::size_t maps = 0;
  for (std::size_t m = 0; m < one.methods.size(); ++m)
    for (std::size_t r = 0; r < one.methods[m].realizations.size(); ++r) {
      const auto& fields = one.methods[m].realizations[r].fields;
      const auto& others = other.methods[m].realizations.at(r).fields;
      if (fields.size() != others.size())
        return "number of fields of " + one.methods[m].name;
      for (std::size_t k = 0; k < fields.size(); ++k, ++maps)
        if (fields[k].step != others[k].step ||
            fields[k].nominal_pressure != others[k].nominal_pressure ||
            fields[k].pressure != others[k].pressure ||
            fields[k].gap != others[k].gap)
          return "fields of " + one.methods[m].name;
    }
  return maps == 0 ? "there are no fields" : "";
}

} // namespace
} // namespace asperity::results

int main(int argc, char** argv) {
  using namespace asperity::results;
  try {
    const std::string found =
        argc == 3 ? difference(read_result(argv[1]), read_result(argv[2]))
                  : "arguments: two folders";
    if (found.empty())
      return 0;
    std::fprintf(stderr, "different: %s\n", found.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
