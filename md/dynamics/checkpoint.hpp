#pragma once

// Checkpoints, from which a dynamics run can be resumed with bitwise identical
// results. It defines the file layout and verifies that a checkpoint belongs to
// the run.

#include "md/dynamics/dynamics.hpp"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::md {

/// SHA-256 hash, as 64 hexadecimal digits, of everything that defines a run:
/// a text, and the bits of numbers.
std::string fingerprint(std::string_view text,
                        std::initializer_list<std::span<const double>> numbers);

struct Checkpoint {
  Motion motion;
  std::vector<double> sums; ///< accumulated sums of the run
};

/// Writes a checkpoint through base/atomic_file.hpp, so that a reader finds
/// either the old or the new file. The file is binary, in the byte order of the
/// machine: the 8 bytes "ASPMOT02", a constant that identifies the byte order,
/// the fingerprint, the step, the two sizes, and the numbers.
/// @throws std::system_error  naming the path
void write_checkpoint(const std::filesystem::path& path,
                      const std::string& fingerprint,
                      const Checkpoint& checkpoint);

/// Reads a checkpoint.
/// @return  nothing if there is no such file, or if it belongs to another run
///          or has another size, layout or byte order
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path,
                                          const std::string& fingerprint,
                                          std::size_t n_unknowns,
                                          std::size_t n_sums);

} // namespace asperity::md
