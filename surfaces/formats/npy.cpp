#include "surfaces/formats/npy.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace asperity::surfaces {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view npy_magic = "\x93NUMPY"sv;

[[noreturn]] void refuse_npy(const std::string& name, const std::string& what) {
  throw input::InputError(fmt::format("{}: {}", name, what));
}

/// The header and the place of the numbers behind it.
struct NpyParts {
  std::string_view header;
  std::size_t begin = 0;
};

NpyParts npy_parts(std::string_view bytes, const std::string& name) {
  constexpr std::size_t before_length = 8; // magic, two bytes of version
  if (!bytes.starts_with(npy_magic) || bytes.size() < before_length + 4)
    refuse_npy(name, "is no .npy file: it does not begin with \\x93NUMPY");
  const int version = static_cast<unsigned char>(bytes[6]);
  const std::size_t bytes_of_length = version == 1 ? 2 : 4;
  if (version < 1 || version > 3)
    refuse_npy(name, fmt::format("has version {} of the .npy format; allowed "
                                 "are 1, 2 and 3",
                                 version));
  std::size_t length = 0; // little-endian
  for (std::size_t i = bytes_of_length; i-- > 0;)
    length =
        256 * length + static_cast<unsigned char>(bytes[before_length + i]);
  const std::size_t begin = before_length + bytes_of_length;
  if (length > bytes.size() - begin)
    refuse_npy(name, "ends within its header");
  return {bytes.substr(begin, length), begin + length};
}

/// Returns the text after "'key':" up to the comma or brace that ends the
/// value; commas within brackets belong to it.
std::string_view npy_value(std::string_view header, std::string_view key,
                           const std::string& name) {
  const std::string quoted = fmt::format("'{}':", key);
  const std::size_t found = header.find(quoted);
  if (found == std::string_view::npos)
    refuse_npy(name, fmt::format("has a header without {}", key));
  std::string_view rest = header.substr(found + quoted.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const bool is_tuple = rest.starts_with('(');
  const std::size_t end = rest.find_first_of(is_tuple ? ")"sv : ",}"sv);
  return rest.substr(is_tuple ? 1 : 0,
                     std::min(end, rest.size()) - (is_tuple ? 1 : 0));
}

/// Returns the numbers of "256, 256" or "7,".
std::vector<std::size_t> npy_shape(std::string_view text,
                                   const std::string& name) {
  std::vector<std::size_t> shape;
  for (const char* at = text.data(); at < text.data() + text.size();) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    std::size_t extent = 0;
    const auto [next, error] =
        std::from_chars(at, text.data() + text.size(), extent);
    if (error != std::errc())
      refuse_npy(name, fmt::format("has the shape ({}), which is no list of "
                                   "sizes",
                                   text));
    shape.push_back(extent);
    at = next;
  }
  return shape;
}

template <class Number, class Bits>
double number_of(const char* bytes, bool is_swapped) {
  std::array<char, sizeof(Bits)> kept{};
  std::copy_n(bytes, kept.size(), kept.begin());
  if (is_swapped)
    std::ranges::reverse(kept);
  return static_cast<double>(std::bit_cast<Number>(kept));
}

} // namespace

Matrix read_npy_text(std::string_view bytes, const std::string& name) {
  const NpyParts parts = npy_parts(bytes, name);
  const std::string_view type = npy_value(parts.header, "descr", name);
  const bool is_double = type.ends_with("f8'");
  if (type.size() != 5 || (!is_double && !type.ends_with("f4'")))
    refuse_npy(name, fmt::format("has numbers of type {}; allowed are '<f8', "
                                 "'<f4', '>f8' and '>f4': write "
                                 "array.astype(float)",
                                 type));
  const std::string_view shape_text = npy_value(parts.header, "shape", name);
  const std::vector<std::size_t> shape = npy_shape(shape_text, name);
  const std::size_t width = is_double ? 8 : 4;
  const std::uintmax_t data_bytes = bytes.size() - parts.begin;
  const std::uintmax_t count = data_bytes / width;
  if (shape.size() != 2)
    refuse_npy(name, fmt::format("has {} dimensions, shape ({}), but must have "
                                 "2: rows and columns",
                                 shape.size(), shape_text));
  if (shape[0] == 0 || shape[1] == 0 || count % shape[0] != 0 ||
      shape[1] != count / shape[0] || count * width != data_bytes)
    refuse_npy(name, fmt::format("has the shape ({}) and {} bytes of numbers, "
                                 "which is not {} bytes for each",
                                 shape_text, data_bytes, width));
  const bool is_swapped =
      (type[1] == '>') == (std::endian::native == std::endian::little);
  const bool is_by_column =
      npy_value(parts.header, "fortran_order", name) == "True";
  Matrix matrix{shape[0], shape[1], std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + parts.begin + i * width;
    const std::size_t place =
        is_by_column ? i % matrix.rows * matrix.columns + i / matrix.rows : i;
    matrix.numbers[place] =
        is_double ? number_of<double, std::uint64_t>(at, is_swapped)
                  : number_of<float, std::uint32_t>(at, is_swapped);
  }
  return matrix;
}

Matrix read_npy(const std::filesystem::path& path) {
  return read_npy_text(input::read_input_file(path, input::largest_number_file),
                       path.string());
}

std::string npy_bytes(std::span<const double> numbers, std::size_t rows,
                      std::size_t columns) {
  static_assert(std::endian::native == std::endian::little);
  if (numbers.size() != rows * columns)
    throw std::domain_error("a matrix must have rows * columns numbers");
  std::string header = fmt::format(
      "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows,
      columns);
  // Magic, version, length and header fill a multiple of 64 bytes.
  constexpr std::size_t before = 10;
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes(npy_magic);
  bytes += {'\1', '\0', static_cast<char>(header.size() % 256),
            static_cast<char>(header.size() / 256)};
  bytes += header;
  const std::size_t begin = bytes.size();
  bytes.resize(begin + numbers.size_bytes());
  std::memcpy(bytes.data() + begin, numbers.data(), numbers.size_bytes());
  return bytes;
}

} // namespace asperity::surfaces
