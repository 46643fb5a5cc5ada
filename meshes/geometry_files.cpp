#include "meshes/geometry_files.hpp"

#include "input/input_file.hpp"

#include <algorithm>
#include <string>

namespace asperity::meshes {
namespace {

namespace fs = std::filesystem;

/// The contents of the string literals of one line at a time: an apostrophe or
/// quote in a comment ends with its line.
std::vector<std::string> literals(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find('"'); at != std::string::npos;
       at = text.find('"', at)) {
    const std::size_t end = text.find_first_of("\"\n", at + 1);
    if (end == std::string::npos)
      break;
    if (text[end] == '"')
      found.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return found;
}

} // namespace

std::vector<fs::path> geometry_files(const fs::path& mesh_file) {
  std::vector<fs::path> files{mesh_file};
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].extension() != ".geo")
      continue;
    const fs::path folder = files[i].parent_path();
    const std::string text =
        input::read_input_file(files[i], input::largest_number_file);
    for (const std::string& name : literals(text)) {
      const fs::path path = (folder / name).lexically_normal();
      std::error_code none;
      if (!name.empty() && fs::is_regular_file(path, none) &&
          std::ranges::find(files, path) == files.end())
        files.push_back(path);
    }
  }
  return files;
}

} // namespace asperity::meshes
