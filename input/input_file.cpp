#include "input/input_file.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"

namespace asperity::input {

std::string read_input_file(const std::filesystem::path& path,
                            std::uintmax_t largest) {
  try {
    return read_file(path, largest);
  } catch (const FileError& error) {
    throw InputError(error.what());
  }
}

void require_own_file(const std::filesystem::path& folder,
                      const std::filesystem::path& file) {
  std::filesystem::path at = folder;
  for (const std::filesystem::path& name : file.lexically_relative(folder)) {
    if (name == "..")
      throw InputError(file.string() + ": must be in the folder " +
                       folder.string());
    at /= name;
    if (std::filesystem::is_symlink(at))
      throw InputError(at.string() +
                       ": is a symbolic link, by which a file from elsewhere "
                       "would be read and published; a copy is allowed");
  }
}

} // namespace asperity::input
