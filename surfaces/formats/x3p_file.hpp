#pragma once

// This internal header of surfaces/formats opens an X3P file and reads its
// members, whose checksums are found on the way.

#include "base/content_hash.hpp"
#include "surfaces/formats/x3p_document.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// Where main.xml names the members with the points.
inline const std::string x3p_link_path = "Record3/DataLink/";

/// An archive and what its main.xml says.
struct X3pFile {
  /// @param name  of the file, for messages
  /// @throws input::InputError  there is no main.xml, or it is malformed
  X3pFile(std::unique_ptr<ZipArchive> opened, std::string name);

  std::size_t count() const {
    return static_cast<std::size_t>(header.size_x * header.size_y);
  }

  /// Whether the points are in main.xml itself.
  bool are_points_listed() const;

  /// Compares main.xml with the file of its checksum, if there is one.
  /// @throws input::InputError  they differ
  void check_sum_of_document() const;

  std::string name;
  std::unique_ptr<ZipArchive> archive;
  std::string text; ///< of main.xml
  X3pDocument document;
  X3pHeader header;
};

/// A member that main.xml names, with its checksum.
class X3pMember {
public:
  /// @param file  outlives this object
  /// @param link  key of main.xml with the name of the member
  /// @param sum   key with its MD5 checksum, which may be empty
  /// @throws input::InputError  there is no such member
  X3pMember(const X3pFile& file, const char* link, const char* sum);

  const std::string& name() const { return name_; }

  /// Name of file and member, for messages.
  std::string full_name() const;

  /// Number of bytes that the archive states.
  std::uint64_t size() const { return member_.size(); }

  /// Reads bytes, fewer only at the end.
  /// @return  valid until the next call
  std::string_view read(std::size_t count);

  /// Reads to the end.
  void finish();

  /// @throws input::InputError  the bytes read have another checksum
  void compare_sum() const;

private:
  const X3pFile* file_;
  std::string name_;
  std::string stated_; ///< checksum; may be empty
  ZipMember member_;
  std::unique_ptr<ContentHash> sum_;
  std::string buffer_;
};

} // namespace asperity::surfaces
