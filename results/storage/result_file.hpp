#pragma once

// This internal header of results/ manages result.h5 and its journal. The order
// of writes ensures that a valid result is on disk at every moment.

#include "results/storage/change.hpp"
#include "results/storage/journal.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace asperity::results {

class Hdf5File;
class Hdf5Group;

/// The information about the journal that is stored in result.h5.
struct JournalState {
  std::string identity;     ///< empty: no journal
  std::uint64_t folded = 0; ///< number of the last change that is in the file
};

JournalState journal_state(const Hdf5Group& file);

/// Appends each change to the journal, which costs only the size of the change.
/// Whenever the journal exceeds result.h5, and at the end, all changes are
/// written to a copy of result.h5, which is synchronised to disk and replaces
/// result.h5 by a rename. Every byte is thus copied only a few times in total,
/// however many changes there are.
///
/// Functions throw std::system_error or Hdf5Error if the file system or the
/// library reports an error; everything written before is then preserved.
class ResultFile {
public:
  using Edit = std::function<void(Hdf5File&)>;

  /// Creates a new file, which replaces an existing one; `begin` writes its
  /// initial contents.
  static ResultFile created(const std::filesystem::path& path,
                            const Edit& begin);

  /// Opens a file and moves the changes of its journal into it.
  /// @param edit  called on the file afterwards
  static ResultFile opened(const std::filesystem::path& path,
                           const Edit& edit = {});

  const std::filesystem::path& path() const { return path_; }

  void append(Change change);

  /// Moves all changes into result.h5 and then calls `last` on it.
  void fold(const Edit& last = {});

private:
  ResultFile(const std::filesystem::path& path, std::string identity);
  void write_journal_into(Hdf5File& file) const;
  void replace(const std::function<void()>& make_part);

  std::filesystem::path path_;
  std::filesystem::path part_; ///< the copy, ".result.h5.part" in the same
                               ///< folder
  std::string identity_;
  std::uint64_t folded_ = 0;
  std::uint64_t changes_ = 0; ///< number of the last change
  Journal journal_;
};

} // namespace asperity::results
