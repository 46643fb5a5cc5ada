#include "surfaces/formats/zip_archive.hpp"

#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <zip.h>

namespace asperity::surfaces {
namespace {

zip_t* as_zip(void* archive) {
  return static_cast<zip_t*>(archive);
}

[[noreturn]] void refuse_writing(const char* what) {
  throw std::runtime_error(fmt::format("libzip cannot {}", what));
}

} // namespace

ZipArchive::ZipArchive(std::string_view bytes, std::string name)
    : name_(std::move(name)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source =
      zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source != nullptr)
    archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
  const std::string reason =
      archive_ == nullptr ? zip_error_strerror(&error) : "";
  zip_error_fini(&error);
  if (archive_ != nullptr)
    return;
  zip_source_free(source);
  throw input::InputError(
      fmt::format("{}: is a damaged zip archive ({})", name_, reason));
}

ZipArchive::~ZipArchive() {
  zip_discard(as_zip(archive_));
}

namespace {

/// Calls take(index, name with slashes) for each member until it returns false.
template <class Take>
void each_name(zip_t* archive, const Take& take) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t index = 0; index < count; ++index) {
    const char* const name =
        zip_get_name(archive, static_cast<zip_uint64_t>(index), 0);
    std::string text = name == nullptr ? "" : name;
    std::ranges::replace(text, '\\', '/');
    if (!take(index, text))
      return;
  }
}

} // namespace

void ZipArchive::enter_folder_of(const std::string& member) {
  if (has(member))
    return;
  std::string found;
  each_name(as_zip(archive_), [&](zip_int64_t, const std::string& name) {
    if (!name.ends_with("/" + member))
      return true;
    if (!found.empty())
      throw input::InputError(
          fmt::format("{}: has several files {}, in {} and {}; unpack the "
                      "archive, and pack one of these folders",
                      name_, member, printable(found), printable(name)));
    found = name;
    return true;
  });
  folder_ =
      found.substr(0, found.size() - std::min(found.size(), member.size()));
}

std::int64_t ZipArchive::index_of(const std::string& member) const {
  const std::string full = folder_ + member;
  zip_int64_t found = zip_name_locate(as_zip(archive_), full.c_str(), 0);
  if (found < 0)
    each_name(as_zip(archive_),
              [&](zip_int64_t index, const std::string& name) {
                if (name == full)
                  found = index;
                return found < 0;
              });
  return found;
}

bool ZipArchive::has(const std::string& member) const {
  return index_of(member) >= 0;
}

void ZipArchive::refuse_member(const std::string& member,
                               const std::string& what) const {
  throw input::InputError(
      fmt::format("{}: {}: {}", name_, printable(member), what));
}

std::string ZipArchive::member(const std::string& member) const {
  zip_stat_t facts;
  zip_stat_init(&facts);
  const std::int64_t index = index_of(member);
  if (index < 0 ||
      zip_stat_index(as_zip(archive_), static_cast<zip_uint64_t>(index), 0,
                     &facts) != 0 ||
      (facts.valid & ZIP_STAT_SIZE) == 0)
    refuse_member(member, "the archive has no such file");
  if (facts.size > input::largest_number_file)
    refuse_member(member,
                  fmt::format("has {}, but must have at most {}",
                              bytes_text(static_cast<double>(facts.size)),
                              bytes_text(input::largest_number_file)));
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(as_zip(archive_), static_cast<zip_uint64_t>(index), 0),
      zip_fclose);
  if (file == nullptr)
    refuse_member(member, "cannot be unpacked");
  // The size is a claim of the archive: memory follows the bytes that come.
  std::string bytes;
  std::string piece(std::size_t{1} << 20, '\0');
  zip_int64_t count = 0;
  while ((count = zip_fread(file.get(), piece.data(), piece.size())) > 0) {
    bytes.append(piece, 0, static_cast<std::size_t>(count));
    if (bytes.size() > facts.size)
      refuse_member(member, "is longer than the archive says");
  }
  if (count < 0)
    refuse_member(member, "is damaged");
  if (bytes.size() != facts.size)
    refuse_member(member, "is shorter than the archive says");
  return bytes;
}

std::string zip_bytes(const std::map<std::string, std::string>& members) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (target == nullptr)
    refuse_writing("create an archive");
  zip_source_keep(target);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  zip_error_fini(&error);
  if (archive == nullptr)
    refuse_writing("open an archive");
  for (const auto& [name, content] : members) {
    zip_source_t* const source =
        zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t index =
        zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    constexpr zip_uint16_t first_day = 0x0021; // 1980-01-01
    if (index < 0 ||
        zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0,
                             first_day, 0) != 0)
      refuse_writing("add a file to an archive");
  }
  if (zip_close(archive) != 0)
    refuse_writing("write an archive");
  zip_stat_t facts;
  zip_source_stat(target, &facts);
  std::string bytes(facts.size, '\0');
  zip_source_open(target);
  const zip_int64_t count = zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  if (count != static_cast<zip_int64_t>(bytes.size()))
    refuse_writing("read its archive");
  return bytes;
}

} // namespace asperity::surfaces
