#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {

// Each format is a function of the file that reads it.
MapFormat plain_format(), gwyddion_format(), xyz_format(), sdf_format(),
    x3p_format(), npy_format(), hdf5_format(), gwy_format(), sur_format(),
    wsxm_format(), other_text_format(), converted_format();

namespace {

using namespace std::string_view_literals;

std::vector<MapFormat>& all_formats() {
  static std::vector<MapFormat> formats{
      plain_format(), gwyddion_format(),   xyz_format(),
      sdf_format(),   x3p_format(),        npy_format(),
      hdf5_format(),  gwy_format(),        sur_format(),
      wsxm_format(),  other_text_format(), converted_format()};
  return formats;
}

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
    {".pro", "Digital Surf profile"},
    {".sxm", "Nanonis"},
    {".tif", "TIFF, Park Systems"},
    {".tiff", "TIFF, Park Systems"},
    {".tmd", "TrueMap"},
    {".vk3", "Keyence VK"},
    {".vk4", "Keyence VK"},
    {".vk6", "Keyence VK"},
    {".vk7", "Keyence VK"},
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

/// Texts with headers of their own, which Gwyddion reads.
bool is_foreign_text(std::string_view bytes) {
  static constexpr std::string_view beginnings[] = {
      "Wyko ASCII Data File Format",
      "ISO/TC 201 SPM data transfer format",
      "Gwyddion XYZ Field 1.0",
      "//Exported ASCII-File",
      "# Daisy ",
      "# Sensolytics: ",
      "[Header Section]",
      "\tX,nm\t0\t"};
  return std::ranges::any_of(
      beginnings, [&](std::string_view one) { return bytes.starts_with(one); });
}

const MapFormat& recognised_format(std::string_view bytes) {
  return *std::ranges::find_if(all_formats(), [&](const MapFormat& format) {
    return format.reads(bytes);
  });
}

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

const std::vector<MapFormat>& map_formats() {
  return all_formats();
}

bool add_map_format(MapFormat format) {
  all_formats().insert(all_formats().begin(), std::move(format));
  return true;
}

std::vector<const char*> map_format_names() {
  std::vector<const char*> names{"auto"};
  for (const MapFormat& format : map_formats())
    if (*format.name != '\0')
      names.push_back(format.name);
  return names;
}

const MapFormat& map_format_called(std::string_view name) {
  const auto found = std::ranges::find(map_formats(), name, &MapFormat::name);
  if (name.empty() || found == map_formats().end())
    throw std::domain_error("format = " + std::string(name) +
                            ", but must be the name of a format of maps");
  return *found;
}

const MapFormat& format_of_map(const MapBytes& bytes, std::string_view name) {
  if (name != "auto")
    return map_format_called(name);
  const MapFormat& found = recognised_format(bytes.beginning());
  // Texts and archives are known by all of their bytes.
  const bool is_certain = &found < &*std::prev(map_formats().end(), 2);
  return is_certain ? found : recognised_format(bytes.all());
}

bool is_text_map(std::string_view bytes) {
  return looks_like_text(bytes) && !is_foreign_text(bytes);
}

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
  for (const MapFormat& format : map_formats())
    if (std::ranges::find(format.endings, ending) != format.endings.end())
      return " (" + format.words.title + ")";
  for (const auto& [known, name] : foreign_formats)
    if (ending == known)
      return " (" + std::string(name) + ")";
  return "";
}

} // namespace asperity::surfaces
