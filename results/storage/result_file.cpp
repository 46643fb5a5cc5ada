#include "results/storage/result_file.hpp"

#include "results/storage/hdf5_file.hpp"
#include "results/storage/map_storage.hpp"
#include "results/storage/result_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <random>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity::results {
namespace {

namespace fs = std::filesystem;

/// Minimum size of the journal before changes are moved, so that a small result
/// is copied only at the end.
constexpr std::uintmax_t least_to_fold = 4'000'000; // bytes

/// Returns a random identity that distinguishes this journal from that of
/// another run.
std::string new_identity() {
  std::random_device random;
  std::string identity;
  for (int word = 0; word < 4; ++word)
    identity += fmt::format("{:08x}", random());
  return identity;
}

/// Renames a file over another after its contents have been synchronised to
/// disk. After a power failure either the old or the new file is present.
void rename_to_disk(const fs::path& from, const fs::path& path) {
  const FileDescriptor file(::open(from.c_str(), O_RDWR | O_CLOEXEC));
  if (file.get() < 0 || ::fsync(file.get()) != 0)
    throw std::system_error(errno, std::generic_category(),
                            "cannot write " + from.string());
  fs::rename(from, path);
  // If the new name does not reach the disk, the old file is still present.
  const FileDescriptor names(::open((path.parent_path() / ".").c_str(),
                                    O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  ::fsync(names.get());
}

JournalState state_of_file(const fs::path& path) {
  const std::lock_guard lock(hdf5_mutex());
  return journal_state(Hdf5File(path, Hdf5File::Mode::read));
}

} // namespace

JournalState journal_state(const Hdf5Group& file) {
  JournalState state;
  if (file.has_attribute(layout::journal))
    state.identity = file.text_attribute(layout::journal);
  const double folded = number_or(file, layout::journal_folded, 0.0);
  constexpr double largest_exact = 9e15;
  if (folded > 0.0 && folded < largest_exact)
    state.folded = static_cast<std::uint64_t>(folded);
  return state;
}

ResultFile::ResultFile(const fs::path& path, std::string identity)
    : path_(path),
      part_(path.parent_path() /
            fmt::format(".{}.part", path.filename().string())),
      identity_(identity.empty() ? new_identity() : std::move(identity)),
      journal_(journal_of(path), identity_) {}

ResultFile ResultFile::created(const fs::path& path, const Edit& begin) {
  ResultFile result(path, "");
  const std::lock_guard lock(hdf5_mutex());
  result.replace([&] {
    Hdf5File file(result.part_, Hdf5File::Mode::create);
    begin(file);
    file.set_attribute(layout::journal, result.identity_);
    file.close();
  });
  return result;
}

ResultFile ResultFile::opened(const fs::path& path, const Edit& edit) {
  const JournalState state = state_of_file(path);
  ResultFile result(path, state.identity);
  result.folded_ = result.changes_ = state.folded;
  read_journal(journal_of(path), result.identity_,
               [&result](std::uint64_t number, const FileBytes&) {
                 result.changes_ = std::max(result.changes_, number);
               });
  result.fold(edit);
  return result;
}

void ResultFile::append(Change change) {
  journal_.append(changes_ + 1, record_of(std::move(change)).bytes);
  ++changes_;
  if (journal_.size() > std::max(least_to_fold, fs::file_size(path_)))
    fold();
}

void ResultFile::fold(const Edit& last) {
  const std::lock_guard lock(hdf5_mutex());
  replace([&] {
    fs::copy_file(path_, part_, fs::copy_options::overwrite_existing);
    Hdf5File file(part_, Hdf5File::Mode::read_write);
    write_journal_into(file);
    file.set_attribute(layout::journal, identity_);
    file.set_attribute(layout::journal_folded, static_cast<double>(changes_));
    if (last)
      last(file);
    file.close();
  });
}

void ResultFile::write_journal_into(Hdf5File& file) const {
  std::uint64_t read = folded_;
  read_journal(journal_of(path_), identity_,
               [&](std::uint64_t number, const FileBytes& record) {
                 if (number <= folded_)
                   return; // already in the file: the run was interrupted
                           // before it removed the journal
                 write_change(file, change_in(record));
                 read = number;
               });
  if (read != changes_)
    throw Hdf5Error(
        fmt::format("{}: change {} of {} cannot be read; nothing was changed",
                    journal_of(path_).string(), read + 1, changes_));
}

/// Replaces the file by the one that `make_part` creates.
void ResultFile::replace(const std::function<void()>& make_part) {
  try {
    fs::remove(part_); // left by a process that was killed
    make_part();
    rename_to_disk(part_, path_);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part_, ignored);
    throw;
  }
  folded_ = changes_;
  journal_.clear();
}

} // namespace asperity::results
