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

} // namespace asperity::input
