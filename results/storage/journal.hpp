#pragma once

// Inside results/ only: the changes of a result that are not in result.h5 yet,
// one after the other in a file beside it.

#include "base/file_descriptor.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace asperity::results {

/// The journal of a result file: "result.journal" of "result.h5".
std::filesystem::path journal_of(const std::filesystem::path& result_file);

/// What a reader does with a record. Numbers count from 1 through the life of
/// a result.
using TakeRecord =
    std::function<void(std::uint64_t number, std::string_view bytes)>;

/// Gives every whole record to `take`, in order, one in memory at a time. A
/// missing journal, and one with another identity, has none; from the first
/// damaged record on, which a killed writer leaves, nothing is read.
/// @param identity  what result.h5 says in its attribute "journal"
/// @return  length of what is whole [B]; 0: no journal of this result
std::uintmax_t read_journal(const std::filesystem::path& path,
                            const std::string& identity,
                            const TakeRecord& take);

/// Appends records. The file is
///
///     asperity-journal-1 <identity> newline,
///
/// and for each record its length and its number, 8 bytes each, the SHA-256 of
/// number and bytes, 64 hexadecimal digits, and its bytes; numbers in this
/// machine's byte order. Records reach the disk at most ten seconds after
/// append(), or with the next one after that.
///
/// All throw std::system_error naming the file; the records before stay whole.
class Journal {
public:
  /// Goes on behind what is whole in the file, or begins one.
  Journal(std::filesystem::path path, std::string identity);

  void append(std::uint64_t number, std::string_view bytes);

  /// [B]
  std::uintmax_t size() const { return size_; }

  /// Removes the file; the next append() makes it again.
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  void open();
  void write(std::string_view bytes);

  std::filesystem::path path_;
  std::string identity_;
  FileDescriptor file_;
  std::uintmax_t size_ = 0;
  Clock::time_point synced_ = Clock::now();
};

} // namespace asperity::results
