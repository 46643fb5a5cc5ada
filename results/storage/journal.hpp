#pragma once

// This internal header of results/ declares the journal, a file beside
// result.h5 that contains the changes of a result that are not in result.h5
// yet.

#include "base/file_bytes.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace asperity::results {

/// Returns the path of the journal of a result file: "result.journal" for
/// "result.h5".
std::filesystem::path journal_of(const std::filesystem::path& result_file);

/// Callback for a record. Records are numbered from 1 throughout the life of a
/// result.
using TakeRecord =
    std::function<void(std::uint64_t number, const FileBytes& record)>;

/// Passes all intact records to `take` in order. They remain readable after the
/// journal has been removed. A journal that is missing or has another identity
/// yields no records. Reading ends at the first damaged record, which an
/// interrupted writer may leave behind.
/// @param identity  the attribute "journal" of result.h5
/// @return  length of the intact part [B]; 0 if this is not the journal of the
///          result
std::uintmax_t read_journal(const std::filesystem::path& path,
                            const std::string& identity,
                            const TakeRecord& take);

/// Appends records to a journal. The file starts with
///
///     asperity-journal-1 <identity> newline,
///
/// followed for each record by its length and its number, 8 bytes each, a
/// SHA-256 hash of 64 hexadecimal digits, which covers the number and the
/// bytes, and its bytes. Numbers are in the byte order of the machine. The
/// bytes are written first, so that an interrupted record is a damaged one.
/// append() synchronises the file to disk if ten seconds have passed since the
/// last synchronisation.
///
/// All functions throw std::system_error naming the file, and append() what the
/// pieces throw; earlier records remain intact.
class Journal {
public:
  /// Continues after the intact part of an existing file, or starts a new one.
  Journal(std::filesystem::path path, std::string identity);

  /// Appends a record, of which one piece is in memory at a time.
  void append(std::uint64_t number, const BytePieces& bytes);

  /// Returns the size of the journal [B].
  std::uintmax_t size() const { return size_; }

  /// Removes the file; the next append() creates it again.
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  void open();
  void write(std::uintmax_t place, std::string_view bytes);

  std::filesystem::path path_;
  std::string identity_;
  FileDescriptor file_;
  std::uintmax_t size_ = 0;
  Clock::time_point synced_ = Clock::now();
};

} // namespace asperity::results
