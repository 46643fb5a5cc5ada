#include "suite/exchange/checksums.hpp"

#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <fmt/format.h>

#include <sstream>

namespace asperity::exchange {

std::string checksum_text(const Hashes& hashes) {
  std::string text;
  for (const auto& [file, hash] : hashes)
    text += fmt::format("{}  {}\n", hash, file);
  return text;
}

std::vector<std::string> verified_files(const std::filesystem::path& folder) {
  const std::filesystem::path list = folder / checksum_file;
  std::vector<std::string> names;
  if (!std::filesystem::exists(std::filesystem::symlink_status(list)))
    return names;
  input::require_own_file(folder, list);
  std::istringstream lines(
      input::read_input_file(list, input::largest_text_file));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    constexpr std::size_t digits = 64;
    const std::string name =
        line.size() > digits + 2 ? line.substr(digits + 2) : "";
    const std::string stated = line.substr(0, digits);
    if (!is_good_name(name) || name.front() == '.' ||
        line.substr(0, digits + 2) != stated + "  ")
      throw input::InputError(fmt::format(
          "{}:{}: is \"{}\", but must be a SHA-256, two blanks and the name of "
          "a file",
          list.string(), number, printable(line)));
    const std::filesystem::path file = folder / name;
    input::require_own_file(folder, file);
    const std::string found =
        content_hash(input::read_input_file(file, input::largest_number_file));
    if (found != stated)
      throw input::InputError(fmt::format(
          "{}: its SHA-256 is {}, but {} states {}: the file is damaged or was "
          "changed",
          file.string(), found, checksum_file, printable(stated, digits)));
    names.push_back(name);
  }
  return names;
}

} // namespace asperity::exchange
