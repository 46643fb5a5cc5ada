#include "surfaces/formats/scan_formats.hpp"

#include "surfaces/formats/length_units.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

namespace asperity::surfaces {
namespace {

using namespace std::string_view_literals;
using mechanics::MapFormat;

/// Formats that Gwyddion reads, by the ending of the file name.
constexpr std::pair<std::string_view, std::string_view> foreign_formats[] = {
    {".al3d", "Alicona Imaging AL3D"},
    {".asc", "ASCII export of an instrument"},
    {".bcr", "Image Metrology BCR"},
    {".bcrf", "Image Metrology BCR"},
    {".dat", "Zygo MetroPro or another program"},
    {".datx", "Zygo Mx"},
    {".di", "Bruker/Digital Instruments Nanoscope"},
    {".frt", "FRT MicroProf"},
    {".hdf", "HDF"},
    {".hfm", "Nanonis or another program"},
    {".ibw", "Igor binary wave, Asylum Research"},
    {".jpk", "JPK Instruments"},
    {".lext", "Olympus LEXT"},
    {".mi", "Agilent/Molecular Imaging MI"},
    {".mnt", "MountainsMap"},
    {".mtx", "MTX"},
    {".nid", "Nanosurf"},
    {".nms", "Nanotech Dulcinea"},
    {".oir", "Olympus OIR"},
    {".opd", "Wyko OPD"},
    {".opdx", "Bruker/Wyko OPDx"},
    {".os3d", "Digital Surf OS3D"},
    {".plu", "Sensofar PLu"},
    {".plux", "Sensofar PLUx"},
    {".poir", "Olympus POIR"},
    {".spm", "Bruker Nanoscope"},
    {".stp", "WSxM"},
    {".sur", "Digital Surf"},
    {".pro", "Digital Surf profile"},
    {".sxm", "Nanonis"},
    {".tif", "TIFF, Park Systems"},
    {".tiff", "TIFF, Park Systems"},
    {".tmd", "TrueMap"},
    {".top", "WSxM"},
    {".vk3", "Keyence VK"},
    {".vk4", "Keyence VK"},
    {".vk6", "Keyence VK"},
    {".vk7", "Keyence VK"},
    {".wsxm", "WSxM"},
    {".xyz", "list of points"},
    {".zmg", "Zygo"},
    {".zon", "Keyence ZON"},
};

/// Whether the bytes may be a text of numbers: no zero byte, and no control
/// characters at the beginning.
bool looks_like_text(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 4096);
  return bytes.find('\0') == std::string_view::npos &&
         std::none_of(begin.begin(), begin.end(), [](char letter) {
           const auto code = static_cast<unsigned char>(letter);
           return code < 9 || (code > 13 && code < 32);
         });
}

} // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04"sv);
}

MapFormat recognised_format(std::string_view bytes) {
  static constexpr std::pair<std::string_view, MapFormat> beginnings[] = {
      {"GWYP", MapFormat::gwy},
      {"\x93NUMPY", MapFormat::npy},
      {"\x89HDF\r\n\x1A\n", MapFormat::hdf5},
      {"aISO-1.0", MapFormat::sdf},
      {"bISO-1.0", MapFormat::sdf},
      {"aBCR-1.0", MapFormat::sdf},
      {"bBCR-1.0", MapFormat::sdf},
      {"DIGITAL SURF", MapFormat::sur},
      {"DSCOMPRESSED", MapFormat::sur},
      {"WSxM file", MapFormat::wsxm},
      // Texts with headers of their own, which Gwyddion reads.
      {"Wyko ASCII Data File Format", MapFormat::convert},
      {"ISO/TC 201 SPM data transfer format", MapFormat::convert},
      {"Gwyddion XYZ Field 1.0", MapFormat::convert},
      {"//Exported ASCII-File", MapFormat::convert},
      {"# Daisy ", MapFormat::convert},
      {"# Sensolytics: ", MapFormat::convert},
      {"[Header Section]", MapFormat::convert},
      {"\tX,nm\t0\t", MapFormat::convert}};
  for (const auto& [beginning, format] : beginnings)
    if (bytes.starts_with(beginning))
      return format;
  if (is_zip(bytes))
    return bytes.find(x3p_member) != std::string_view::npos
               ? MapFormat::x3p
               : MapFormat::convert;
  return looks_like_text(bytes) ? MapFormat::automatic : MapFormat::convert;
}

namespace {

/// What Gwyddion does not read either, and how it can be made readable.
constexpr std::pair<std::string_view, std::string_view> containers[] = {
    {"\xFF\xFE"sv, "UTF-16 text: convert it by iconv -f UTF-16 -t UTF-8"},
    {"\xFE\xFF"sv, "UTF-16 text: convert it by iconv -f UTF-16 -t UTF-8"},
    {"\x1F\x8B"sv, "compressed by gzip: unpack it by gunzip"},
    {"BZh"sv, "compressed by bzip2: unpack it by bunzip2"},
    {"\xFD\x37zXZ"sv, "compressed by xz: unpack it by unxz"},
    {"\x28\xB5\x2F\xFD"sv, "compressed by zstd: unpack it by unzstd"},
};

} // namespace

std::string name_in_brackets(const std::string& path) {
  std::string begin(8, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  for (const auto& [magic, name] : containers)
    if (begin.starts_with(magic))
      return " (" + std::string(name) + ")";
  // UTF-16 without a mark: zero bytes beside ASCII digits and blanks.
  const auto has_zeros = [&](std::size_t first) {
    for (std::size_t i = 0; i < begin.size(); ++i)
      if ((begin[i] == '\0') != (i % 2 == first))
        return false;
    return true;
  };
  if (has_zeros(0) || has_zeros(1))
    return " (UTF-16 text: convert it by iconv -f UTF-16LE -t UTF-8)";
  const std::string ending =
      lower_case(std::filesystem::path(path).extension().string());
  for (const auto& [known, name] : foreign_formats)
    if (ending == known)
      return " (" + std::string(name) + ")";
  return "";
}

} // namespace asperity::surfaces
