#include "md/lammps/lammps_answer.hpp"

#include "md/lammps/lammps_input.hpp"
#include "md/lammps/lammps_units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace asperity::md {
namespace {

/// Reads consecutive numbers from a text.
class NumberReader {
public:
  NumberReader(std::string_view text, std::string name)
      : text_(text), name_(std::move(name)) {}

  double next() {
    const std::size_t begin = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(begin == std::string_view::npos ? text_.size() : begin);
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc{})
      throw std::runtime_error(
          name_ + " ends early or has no number where one is expected");
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

private:
  std::string_view text_;
  std::string name_;
};

/// Reads the table of a dump with `columns` values after the atom number, which
/// must count from 1. Each value is multiplied by its unit.
std::vector<double> read_dump(const std::filesystem::path& path,
                              std::size_t atoms,
                              const std::vector<double>& units) {
  const std::string text = file_text(path);
  const std::string_view heading = "ITEM: ATOMS";
  const std::size_t found = text.find(heading);
  const std::size_t begin = text.find('\n', found);
  if (found == std::string::npos || begin == std::string::npos)
    throw std::runtime_error(path.string() +
                             " is missing or contains no atoms");
  NumberReader reader(std::string_view(text).substr(begin), path.string());
  std::vector<double> table;
  table.reserve(atoms * units.size());
  for (std::size_t atom = 0; atom < atoms; ++atom) {
    const double number = reader.next();
    if (number != static_cast<double>(atom + 1))
      throw std::runtime_error(
          fmt::format("{} has atom {} where atom {} is expected", path.string(),
                      number, atom + 1));
    for (const double unit : units)
      table.push_back(reader.next() * unit);
  }
  return table;
}

/// Extracts three adjacent columns of a table.
BlockVectors columns(const std::vector<double>& table, std::size_t width,
                     std::size_t first) {
  BlockVectors vectors;
  vectors.reserve(table.size() / width);
  for (std::size_t row = 0; row < table.size(); row += width)
    vectors.push_back(
        {table[row + first], table[row + first + 1], table[row + first + 2]});
  return vectors;
}

/// Returns the numbers of a line; empty if it contains anything else.
std::vector<double> numbers_of(const std::string& line) {
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
      return {};
    numbers.push_back(value);
  }
  return numbers;
}

} // namespace

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

LammpsAnswer read_answer(const LammpsBlock& block,
                         const std::filesystem::path& folder) {
  using metal::force;
  using metal::length;
  LammpsAnswer answer;
  const std::vector<double> all =
      read_dump(folder / lammps_file::answer, block.atoms(),
                {length, length, length, force, force, force});
  answer.positions = columns(all, 6, 0);
  answer.forces = columns(all, 6, 3);
  answer.contact = columns(read_dump(folder / lammps_file::contact,
                                     block.layer.size(), {force, force, force}),
                           3, 0);
  const std::filesystem::path path = folder / lammps_file::energies;
  const std::string energies = file_text(path);
  NumberReader reader(energies, path.string());
  answer.bond_energy = reader.next() * metal::energy;
  answer.pair_energy = reader.next() * metal::energy;
  return answer;
}

std::optional<LammpsProgress> progress_in(const std::string& log) {
  // The last line may be incomplete and end within a number.
  std::istringstream lines(log.substr(0, log.rfind('\n') + 1));
  std::optional<LammpsProgress> progress;
  for (std::string line; std::getline(lines, line);) {
    const std::vector<double> numbers = numbers_of(line);
    if (numbers.size() == 6)
      progress = LammpsProgress{
          static_cast<int>(numbers[0]), numbers[1] * metal::energy,
          numbers[4] * metal::force, numbers[5] * metal::force};
  }
  return progress;
}

int evaluations_in(const std::string& log) {
  std::istringstream lines(log);
  int sum = 0;
  const std::string heading = "Iterations, force evaluations =";
  for (std::string line; std::getline(lines, line);) {
    const std::size_t found = line.find(heading);
    if (found == std::string::npos)
      continue;
    const std::vector<double> numbers =
        numbers_of(line.substr(found + heading.size()));
    if (numbers.size() == 2)
      sum += static_cast<int>(numbers[1]);
  }
  return sum;
}

std::string error_in(const std::string& log) {
  const std::size_t begin = log.find("ERROR");
  if (begin == std::string::npos)
    return {};
  return log.substr(begin, log.find('\n', begin) - begin);
}

} // namespace asperity::md
