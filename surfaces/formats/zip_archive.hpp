#pragma once

// Reads the members of a zip archive, with limits on their size, and writes
// archives. It is the only user of libzip.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// A member of an archive that is unpacked from its beginning to its end. The
/// archive must outlive it.
class ZipMember {
public:
  /// Unpacked size [bytes], as the archive says.
  std::uint64_t size() const { return size_; }

  /// Fills the bytes, fewer only at the end of the member.
  /// @return  number of bytes
  /// @throws input::InputError  the member is damaged or has another size
  std::size_t read(std::span<char> bytes);

private:
  friend class ZipArchive;

  struct Close {
    void operator()(void* member) const;
  };

  ZipMember(void* file, std::uint64_t size, std::string name)
      : file_(file), size_(size), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& what) const;

  std::unique_ptr<void, Close> file_; ///< zip_file_t
  std::uint64_t size_ = 0;
  std::uint64_t taken_ = 0; ///< bytes so far
  std::string name_;        ///< of file and member, for messages
};

class ZipArchive {
public:
  /// An archive in memory.
  /// @param bytes  must outlive this object
  /// @param name   of the file, for messages
  /// @throws input::InputError  the bytes are no archive
  ZipArchive(std::string_view bytes, std::string name);

  /// An archive in a file, which is not read as a whole.
  /// @throws input::InputError  the file is no archive
  explicit ZipArchive(const std::string& path);
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

  /// Begins to unpack a member.
  /// @throws input::InputError  there is no such member, it is encrypted or
  ///                            larger than input::largest_number_file
  ZipMember open(const std::string& member) const;

private:
  /// @param source  zip_source_t, null if it could not be made
  /// @param error   zip_error_t, which is finished
  void open_source(void* source, void* error);
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
