#pragma once

// Inside results/ only: result.h5 and its journal on the disk. Owns the order
// of writes that leaves a good result at every moment.

#include "results/storage/change.hpp"
#include "results/storage/journal.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace asperity::results {

class Hdf5File;
class Hdf5Group;

/// What result.h5 says of its journal.
struct JournalState {
  std::string identity;     ///< empty: it has none
  std::uint64_t folded = 0; ///< number of the last change that is in the file
};

JournalState journal_state(const Hdf5Group& file);

/// A change is appended to the journal, which costs its own size alone. When
/// the journal has outgrown result.h5, and at the end, all changes are put into
/// a copy of result.h5, which is synced to disk and renamed over it: every byte
/// is then copied a few times in all, however many changes there are.
///
/// Functions throw std::system_error or Hdf5Error when the disk or the library
/// refuses; what was written before is then still there.
class ResultFile {
public:
  using Edit = std::function<void(Hdf5File&)>;

  /// Makes a new file, over an old one; `begin` writes what is in it at once.
  static ResultFile created(const std::filesystem::path& path,
                            const Edit& begin);

  /// Goes on with a file: what its journal still has is put into it first.
  /// @param edit  then called on it
  static ResultFile opened(const std::filesystem::path& path,
                           const Edit& edit = {});

  const std::filesystem::path& path() const { return path_; }

  void append(Change change);

  /// Puts all changes into result.h5, then calls `last` on it.
  void fold(const Edit& last = {});

private:
  ResultFile(const std::filesystem::path& path, std::string identity);
  void write_journal_into(Hdf5File& file) const;
  void replace(const std::function<void()>& make_part);

  std::filesystem::path path_;
  std::filesystem::path part_; ///< the copy, ".result.h5.part" beside it
  std::string identity_;
  std::uint64_t folded_ = 0;
  std::uint64_t changes_ = 0; ///< number of the last one
  Journal journal_;
};

} // namespace asperity::results
