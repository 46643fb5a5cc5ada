#include "surfaces/formats/scan_formats.hpp"

#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
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

bool begins_with(std::string_view bytes,
                 std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(
      beginnings, [&](std::string_view one) { return bytes.starts_with(one); });
}

bool is_x3p(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04"sv) &&
         bytes.find("main.xml") != std::string_view::npos;
}

/// Texts with headers of their own, which Gwyddion reads.
bool is_foreign_text(std::string_view bytes) {
  return begins_with(bytes, {"Wyko ASCII Data File Format",
                             "ISO/TC 201 SPM data transfer format",
                             "Gwyddion XYZ Field 1.0", "//Exported ASCII-File",
                             "# Daisy ", "# Sensolytics: ", "[Header Section]",
                             "\tX,nm\t0\t"});
}

bool is_never(std::string_view) {
  return false;
}

/// All formats. The first one that recognises the bytes reads them.
constexpr MapReader map_readers[] = {
    {MapFormat::gwy,
     [](std::string_view bytes) { return bytes.starts_with("GWYP"); }, open_gwy,
     gwy_channels},
    {MapFormat::npy,
     [](std::string_view bytes) { return bytes.starts_with("\x93NUMPY"); },
     open_npy, npy_channels},
    {MapFormat::hdf5,
     [](std::string_view bytes) {
       return bytes.starts_with("\x89HDF\r\n\x1A\n");
     },
     open_hdf5, hdf5_channels},
    {MapFormat::sdf,
     [](std::string_view bytes) {
       return begins_with(bytes,
                          {"aISO-1.0", "bISO-1.0", "aBCR-1.0", "bBCR-1.0"});
     },
     open_sdf},
    {MapFormat::sur,
     [](std::string_view bytes) {
       return begins_with(bytes, {"DIGITAL SURF", "DSCOMPRESSED"});
     },
     open_sur},
    {MapFormat::wsxm,
     [](std::string_view bytes) { return bytes.starts_with("WSxM file"); },
     open_wsxm},
    {MapFormat::x3p, is_x3p, open_x3p},
    {MapFormat::automatic,
     [](std::string_view bytes) {
       return looks_like_text(bytes) && !is_foreign_text(bytes);
     },
     open_text, text_channels},
    {MapFormat::plain, is_never, open_text},
    {MapFormat::gwyddion, is_never, open_text},
    {MapFormat::xyz, is_never, open_text},
    {MapFormat::convert, [](std::string_view) { return true; }, open_converted,
     converted_channels}};

const MapReader& recognised_reader(std::string_view bytes) {
  return *std::ranges::find_if(map_readers, [&](const MapReader& reader) {
    return reader.recognises(bytes);
  });
}

} // namespace

MapFormat recognised_format(std::string_view bytes) {
  return recognised_reader(bytes).format;
}

const MapReader& reader_of_map(const MapBytes& bytes, MapFormat format) {
  if (format != MapFormat::automatic)
    return *std::ranges::find(map_readers, format, &MapReader::format);
  const MapReader& found = recognised_reader(bytes.beginning());
  // Texts and archives are known by all of their bytes.
  const bool is_certain = found.format != MapFormat::automatic &&
                          found.format != MapFormat::convert;
  return is_certain ? found : recognised_reader(bytes.all());
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
