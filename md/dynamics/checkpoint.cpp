#include "md/dynamics/checkpoint.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

namespace asperity::md {
namespace {

constexpr std::size_t hash_digits = 64;

struct Header {
  std::array<char, 8> magic = {'A', 'S', 'P', 'M', 'O', 'T', '0', '2'};
  std::uint64_t known_word = 0x0102030405060708U;
  std::array<char, hash_digits> fingerprint{};
  std::int64_t step = 0;
  std::uint64_t n_unknowns = 0;
  std::uint64_t n_sums = 0;
};

void append(std::string& bytes, std::span<const double> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()),
               values.size_bytes());
}

std::vector<double> take(const char*& bytes, std::size_t n) {
  std::vector<double> values(n);
  std::memcpy(values.data(), bytes, n * sizeof(double));
  bytes += n * sizeof(double);
  return values;
}

Header header_of(const std::string& fingerprint, std::size_t n_unknowns,
                 std::size_t n_sums) {
  Header header;
  fingerprint.copy(header.fingerprint.data(), hash_digits);
  header.n_unknowns = n_unknowns;
  header.n_sums = n_sums;
  return header;
}

} // namespace

std::string
fingerprint(std::string_view text,
            std::initializer_list<std::span<const double>> numbers) {
  ContentHash hash;
  hash.add(text);
  for (const std::span<const double> part : numbers)
    hash.add({reinterpret_cast<const char*>(part.data()), part.size_bytes()});
  return hash.text();
}

void write_checkpoint(const std::filesystem::path& path,
                      const std::string& fingerprint,
                      const Checkpoint& checkpoint) {
  Header header = header_of(fingerprint, checkpoint.motion.state.size(),
                            checkpoint.sums.size());
  header.step = checkpoint.motion.step;
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  append(bytes, checkpoint.motion.state);
  append(bytes, checkpoint.motion.velocities);
  append(bytes, checkpoint.sums);
  write_file_atomically(path, bytes);
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path,
                                          const std::string& fingerprint,
                                          std::size_t n_unknowns,
                                          std::size_t n_sums) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::size_t n_numbers = 2 * n_unknowns + n_sums;
  if (bytes.size() != sizeof(Header) + n_numbers * sizeof(double))
    return std::nullopt;
  Header found;
  std::memcpy(&found, bytes.data(), sizeof found);
  Header expected = header_of(fingerprint, n_unknowns, n_sums);
  expected.step = found.step;
  if (std::memcmp(&found, &expected, sizeof found) != 0)
    return std::nullopt;

  Checkpoint checkpoint;
  const char* numbers = bytes.data() + sizeof found;
  checkpoint.motion.step = found.step;
  checkpoint.motion.state = take(numbers, n_unknowns);
  checkpoint.motion.velocities = take(numbers, n_unknowns);
  checkpoint.sums = take(numbers, n_sums);
  return checkpoint;
}

} // namespace asperity::md
