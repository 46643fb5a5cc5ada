// Tests of the list of formats: what a format is told once, the documents, the
// keys of a case and the tests with any bytes have. A format of this one file
// is read, listed and named like the others.
#include "base/read_file.hpp"
#include "input/reader/vocabulary.hpp"
#include "surfaces/formats/map_format.hpp"
#include "tests/surfaces/map_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace asperity::surfaces::map_formats_test {

using namespace tests_of_formats;

/// "TOY 3 2" and 6 digits, heights in um on pixels of 1 um.
Scan read_toy(const MapBytes& bytes, const ScanRequest& request) {
  const std::string_view text = bytes.all();
  refuse_scale(request.scale, bytes.name());
  require_sound_grid(bytes.name(), text[4] - '0', text[6] - '0', 1.0,
                     text.size() - 8);
  const Grid grid{text[4] - '0', text[6] - '0', 1e-6 * (text[4] - '0'),
                  1e-6 * (text[6] - '0')};
  std::vector<double> numbers;
  for (const char digit : text.substr(8, grid.size()))
    numbers.push_back(digit - '0');
  return scan_of_numbers(grid, numbers, "toy reader", {.unit = 1e-6});
}

const bool is_registered = add_map_format(
    {.name = "toy",
     .words = {"a toy", "`TOY`", "1 um", "none", "one"},
     .reads = [](std::string_view bytes) { return bytes.starts_with("TOY "); },
     .heights = read_toy,
     .scales = FileScales::all,
     .endings = {".toy"}});

TEST(MapFormats, TakeOneOfASingleFile) {
  ASSERT_TRUE(is_registered);
  const std::string path = written("a.toy", "TOY 3 2 123456");

  for (const char* const format : {"auto", "toy"}) {
    const Scan scan = read_scan(path, {format});
    EXPECT_EQ(scan.map.grid, (Grid{3, 2, 3e-6, 2e-6}));
    EXPECT_EQ(scan.map.heights[5], 6e-6);
    EXPECT_EQ(scan.reader, "toy reader");
  }
  EXPECT_EQ(list_channels(path).front().points_x, 3);
  EXPECT_EQ(refusal_of(path, {"auto", {}, {1.0, {}}}),
            "surface.length = 1 m, but must be left out: " + path +
                " itself gives its lengths and its unit of height");
  EXPECT_EQ(name_in_brackets("b.TOY"), " (a toy)");
  EXPECT_EQ(read_scan_bytes("123 4\n5 6\n", "map.txt", {"auto", {}, {1.0, 1.0}})
                .reader,
            "own reader of plain matrices"); // others are read as before
}

// [surface] format has the names in the order of the list.
TEST(MapFormats, AreTheWordsOfTheKeyOfACase) {
  const std::vector<const char*> names = map_format_names();
  EXPECT_EQ(names[0], std::string("auto"));
  EXPECT_EQ(names[1], std::string("toy"));
  EXPECT_EQ(names.back(), std::string("convert"));
  EXPECT_EQ(cases::find_key("surface", "format")->words,
            std::vector<std::string>(names.begin(), names.end()));
}

/// The row of a format in the page.
std::string row_of(const MapFormat& format) {
  const FormatWords& words = format.words;
  const std::string name =
      *format.name == '\0' ? "" : fmt::format("`{}`: ", format.name);
  return fmt::format("| {}{}{}{} | {} | {} | {} | {} |\n", name, words.title,
                     format.endings.empty() ? "" : " ",
                     fmt::join(format.endings, ", "), words.recognised_by,
                     words.scales, words.missing, words.channels);
}

TEST(MapFormats, AreTheTableOfThePage) {
  std::string table;
  for (const MapFormat& format : map_formats())
    if (format.heights != read_toy)
      table += row_of(format);
  EXPECT_NE(read_file("docs/reference/map-files.md", 1 << 20)
                .find("|---|---|---|---|---|\n" + table + "\n"),
            std::string::npos)
      << table;
}

// Each format that its bytes tell, and that is read from memory, has a file
// among those of the tests with any bytes.
TEST(MapFormats, AreAllTestedWithAnyBytes) {
  std::set<std::string> tested{"plain", "gwyddion", "xyz",
                               "hdf5",  "convert",  "toy"};
  for (const auto& entry :
       std::filesystem::directory_iterator("tests/fuzz/corpus/scan")) {
    const std::string bytes = read_file(entry.path(), 1 << 20);
    tested.insert(format_of_map({bytes, "map"}, "auto").name);
  }
  for (const MapFormat& format : map_formats())
    EXPECT_TRUE(tested.contains(format.name)) << format.name;
}

} // namespace asperity::surfaces::map_formats_test
