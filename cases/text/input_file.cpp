#include "cases/text/input_file.hpp"

#include "base/read_file.hpp"
#include "cases/text/case_error.hpp"

namespace asperity::cases {

std::string read_input_file(const std::filesystem::path& path,
                            std::uintmax_t largest) {
  try {
    return read_file(path, largest);
  } catch (const FileError& error) {
    throw CaseError(error.what());
  }
}

} // namespace asperity::cases
