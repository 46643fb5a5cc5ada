#include "surfaces/formats/x3p_file.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

namespace asperity::surfaces {
namespace {

/// @param member  in words
void refuse_other_sum(const std::string& name, const std::string& member,
                      std::string stated, const std::string& found) {
  for (char& digit : stated)
    digit = static_cast<char>(std::tolower(static_cast<unsigned char>(digit)));
  if (stated != found)
    throw input::InputError(fmt::format(
        "{}: {} has the MD5 checksum {}, but the file states {}; it is "
        "damaged or was changed",
        name, printable(member), found, printable(stated)));
}

/// Some programs pack the folder of the file instead of its content.
std::unique_ptr<ZipArchive> entered(std::unique_ptr<ZipArchive> archive) {
  archive->enter_folder_of("main.xml");
  return archive;
}

} // namespace

X3pFile::X3pFile(std::unique_ptr<ZipArchive> opened, std::string file_name)
    : name(std::move(file_name)),
      archive(entered(std::move(opened))),
      text(archive->member("main.xml")),
      document(text, name),
      header(document.header()) {}

bool X3pFile::are_points_listed() const {
  return document.text_at(x3p_link_path + "PointDataLink").empty();
}

void X3pFile::check_sum_of_document() const {
  const std::string member = document.text_at("Record4/ChecksumFile");
  if (member.empty() || !archive->has(member))
    return;
  const std::string line = archive->member(member);
  refuse_other_sum(name, "main.xml",
                   line.substr(0, line.find_first_of(" \t\r\n*")),
                   md5_hash(text));
}

X3pMember::X3pMember(const X3pFile& file, const char* link, const char* sum)
    : file_(&file),
      name_(file.document.text_at(x3p_link_path + link)),
      stated_(file.document.text_at(x3p_link_path + sum)),
      member_(file.archive->open(name_)),
      sum_(std::make_unique<ContentHash>(HashMethod::md5)) {}

std::string X3pMember::full_name() const {
  return file_->name + ": " + printable(name_);
}

std::string_view X3pMember::read(std::size_t count) {
  buffer_.resize(count);
  const std::size_t n = member_.read(buffer_);
  const std::string_view bytes = std::string_view(buffer_).substr(0, n);
  if (!stated_.empty())
    sum_->add(bytes);
  return bytes;
}

void X3pMember::finish() {
  while (!read(std::size_t{1} << 16).empty()) {
  }
}

void X3pMember::compare_sum() const {
  if (!stated_.empty())
    refuse_other_sum(file_->name, name_, stated_, sum_->text());
}

} // namespace asperity::surfaces
