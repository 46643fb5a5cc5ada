// Tests of surfaces/formats/gwyddion_file.hpp, with a reader of the format that
// is independent of the writer.
#include "surfaces/formats/gwyddion_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces::gwyddion_file_test {

template <class Number>
Number taken(std::string_view& bytes) {
  Number number{};
  if (bytes.size() < sizeof(Number))
    throw std::runtime_error("ends early");
  std::memcpy(&number, bytes.data(), sizeof(Number));
  bytes.remove_prefix(sizeof(Number));
  return number;
}

std::string text_from(std::string_view& bytes) {
  const std::size_t end = bytes.find('\0');
  if (end == std::string_view::npos)
    throw std::runtime_error("text without end");
  std::string text(bytes.substr(0, end));
  bytes.remove_prefix(end + 1);
  return text;
}

struct GwyFound {
  std::map<std::string, std::int32_t> integers;
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> arrays;
};

/// Reads an object and those in it; names are "parent/name".
void read_object(std::string_view& bytes, const std::string& path,
                 GwyFound& found) {
  found.texts[path + "type"] = text_from(bytes);
  const auto size = taken<std::uint32_t>(bytes);
  std::string_view inside = bytes.substr(0, size);
  if (inside.size() != size)
    throw std::runtime_error("object ends early");
  bytes.remove_prefix(size);
  while (!inside.empty()) {
    const std::string name = path + text_from(inside);
    const char type = taken<char>(inside);
    if (type == 'i')
      found.integers[name] = taken<std::int32_t>(inside);
    else if (type == 'd')
      found.numbers[name] = taken<double>(inside);
    else if (type == 's')
      found.texts[name] = text_from(inside);
    else if (type == 'o')
      read_object(inside, name + ":", found);
    else if (type == 'D') {
      const auto count = taken<std::uint32_t>(inside);
      for (std::uint32_t i = 0; i < count; ++i)
        found.arrays[name].push_back(taken<double>(inside));
    } else {
      throw std::runtime_error("unknown component type");
    }
  }
}

// A rectangular map is one channel with its sizes, units and rows.
TEST(GwyddionFile, HoldsTheMap) {
  const HeightMap map{{3, 2, 6e-6, 1e-6},
                      {1e-9, 2e-9, 3e-9, -4e-9, -5e-9, 0.5}};
  const std::string bytes = gwyddion_bytes(map, "a title");
  ASSERT_TRUE(bytes.starts_with("GWYP"));
  std::string_view rest = std::string_view(bytes).substr(4);
  GwyFound found;
  read_object(rest, "", found);
  EXPECT_TRUE(rest.empty());
  EXPECT_EQ(found.texts["type"], "GwyContainer");
  EXPECT_EQ(found.texts["/0/data/title"], "a title");
  EXPECT_EQ(found.texts["/0/data:type"], "GwyDataField");
  EXPECT_EQ(found.integers["/0/data:xres"], 3);
  EXPECT_EQ(found.integers["/0/data:yres"], 2);
  EXPECT_EQ(found.numbers["/0/data:xreal"], 6e-6);
  EXPECT_EQ(found.numbers["/0/data:yreal"], 1e-6);
  EXPECT_EQ(found.texts["/0/data:si_unit_xy:type"], "GwySIUnit");
  EXPECT_EQ(found.texts["/0/data:si_unit_xy:unitstr"], "m");
  EXPECT_EQ(found.texts["/0/data:si_unit_z:unitstr"], "m");
  EXPECT_EQ(found.arrays["/0/data:data"], map.heights);
}

} // namespace asperity::surfaces::gwyddion_file_test
