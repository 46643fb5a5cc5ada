#pragma once

// Reads the members of a zip archive, with limits on their size, and writes
// archives. It is the only user of libzip.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace asperity::surfaces {

class ZipArchive {
public:
  /// @param bytes  must outlive this object
  /// @param name   of the file, for messages
  /// @throws input::InputError  the bytes are no archive
  ZipArchive(std::string_view bytes, std::string name);

  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// Looks for members in the folder of the archive that has this one, if it is
  /// not at the top. Backslashes in names of the archive are slashes.
  /// @throws input::InputError  several folders have it
  void enter_folder_of(const std::string& member);

  bool has(const std::string& member) const;

  /// Returns the uncompressed bytes of a member.
  /// @throws input::InputError  there is no such member, it is damaged,
  ///                            encrypted or larger than
  ///                            input::largest_number_file
  std::string member(const std::string& member) const;

private:
  /// Index of a member in the folder that was entered; negative: none.
  std::int64_t index_of(const std::string& member) const;
  [[noreturn]] void refuse_member(const std::string& member,
                                  const std::string& what) const;

  void* archive_ = nullptr; ///< zip_t
  std::string name_;
  std::string folder_; ///< with a slash at its end; empty: the top
};

/// Returns an archive with these members, compressed, with a fixed date.
/// @throws std::runtime_error  libzip cannot write it
std::string zip_bytes(const std::map<std::string, std::string>& members);

} // namespace asperity::surfaces
