#pragma once

// A run in time, put aside and taken up again bit for bit. Owns the file's
// layout and the check that it belongs to the run.

#include "md/dynamics/dynamics.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::md {

/// SHA-1 over everything that defines a run, in the order it is added.
class Fingerprint {
public:
  Fingerprint();
  ~Fingerprint();
  Fingerprint& add(std::span<const double> values);
  Fingerprint& add(double value);
  Fingerprint& add(std::string_view text);

  /// 40 hexadecimal digits of what was added so far.
  std::string text() const;

private:
  struct Hash;
  std::unique_ptr<Hash> hash_;
};

struct Checkpoint {
  Motion motion;
  std::vector<double> sums; ///< whatever the run has added up so far
};

/// Writes by base/atomic_file.hpp, so that a reader finds the old file or the
/// new one. Binary, in this machine's byte order: 8 bytes "ASPMOT01", a known
/// word, the fingerprint, step, the two sizes, then the numbers.
/// @throws std::system_error  naming the path
void write_checkpoint(const std::filesystem::path& path,
                      const std::string& fingerprint,
                      const Checkpoint& checkpoint);

/// @return  nothing if there is no such file, or it is another run's, of
///          another size, layout or byte order
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path,
                                          const std::string& fingerprint,
                                          std::size_t n_unknowns,
                                          std::size_t n_sums);

} // namespace asperity::md
