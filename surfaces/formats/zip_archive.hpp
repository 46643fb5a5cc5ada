#pragma once

// This file reads the members of a zip archive in memory, with limits on their
// size, and writes archives. It is the only user of libzip.

#include <map>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// An archive whose bytes outlive this object.
class ZipArchive {
public:
  /// @param name  of the file, for messages
  /// @throws input::InputError  the bytes are no archive
  ZipArchive(std::string_view bytes, std::string name);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  bool has(const std::string& member) const;

  /// Returns the uncompressed bytes of a member.
  /// @throws input::InputError  there is no such member, it is damaged,
  ///                            encrypted or larger than
  ///                            input::largest_number_file
  std::string member(const std::string& member) const;

private:
  [[noreturn]] void refuse_member(const std::string& member,
                                  const std::string& what) const;

  void* archive_ = nullptr; ///< zip_t
  std::string name_;
};

/// Returns an archive with these members, compressed, with a fixed date.
/// @throws std::runtime_error  libzip cannot write it
std::string zip_bytes(const std::map<std::string, std::string>& members);

} // namespace asperity::surfaces
