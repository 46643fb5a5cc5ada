// Tests of a case with a base (input/reader/base_case.hpp): its keys override
// those of the base, its text is complete, and a message names the right file.
#include "base/temporary_folder.hpp"
#include "input/reader/base_case.hpp"
#include "input/reader/case_text.hpp"
#include "input/reader/read_case.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "case_samples.hpp"

namespace asperity::cases::base_case_test {

namespace fs = std::filesystem;

class BaseCase : public ::testing::Test {
private:
  TemporaryFolder temporary_{"base"};

protected:
  const fs::path folder = temporary_.path();

  BaseCase() {
    fs::create_directories(folder / "deep/er");
    write("block.toml", contact_case);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }

  Case read(const std::string& name,
            const std::vector<std::string>& overrides = {}) const {
    return read_case((folder / name).string(), overrides);
  }

  std::string mistakes_of(const std::string& name) const {
    try {
      (void)read(name);
    } catch (const input::InputError& error) {
      std::string message = error.what();
      for (std::size_t at = message.find(folder.string());
           at != std::string::npos; at = message.find(folder.string()))
        message.erase(at, folder.string().size() + 1);
      return message.substr(message.find('\n') + 1);
    }
    return "";
  }
};

const std::string on_block = "base = \"../../block.toml\"\n";

TEST_F(BaseCase, IsTheBaseButForItsOwnKeys) {
  write("deep/er/case.toml", on_block +
                                 "title = \"Mine, a \\\"test\\\"\"\n"
                                 "halfspace = \"\"\n"
                                 "[surface]\npoints = 64\n"
                                 "[fem.hard]\ncontact = \"hard\"\n"
                                 "[load]\nnominal_pressure = [\"2 MPa\", "
                                 "1e-3]\n");

  const Case mine = read("deep/er/case.toml");

  EXPECT_EQ(mine.name, "er");
  EXPECT_EQ(mine.title, "Mine, a \"test\"");
  EXPECT_EQ(mine.surface.points, 64);
  EXPECT_EQ(mine.surface.realizations, 3);
  ASSERT_EQ(mine.methods.size(), 3U);
  EXPECT_EQ(mine.methods[2].name, "fem.hard");
  ASSERT_EQ(mine.load.targets.size(), 2U);
  EXPECT_EQ(mine.load.targets[0].value, 2e6);
  EXPECT_EQ(mine.load.targets[1].value, 1e-3);
}

// The text of the case is complete: read again without the original folder, it
// gives the same text and the same numbers.
TEST_F(BaseCase, HasACompleteText) {
  write("deep/er/case.toml",
        on_block + "[expect]\n\"area_fraction@p=0.01 E*\" = { value = 0.1, "
                   "within = \"5 %\" }\n[load]\nnominal_pressure = { from = "
                   "\"2e-3 E*\", to = \"0.1 E*\", steps = 3, spacing = \"log\" "
                   "}\n");
  const Case mine = read("deep/er/case.toml", {"surface.points=128"});

  const Case again = read_case_text(mine.text, "no/such/folder/case.toml");

  EXPECT_EQ(mine.text.find("base ="), std::string::npos);
  EXPECT_EQ(mine.text.rfind(contact_case, 0), 0U) << "the base byte for byte";
  EXPECT_EQ(again.text, mine.text);
  EXPECT_EQ(again.surface.points, 128);
  ASSERT_EQ(again.load.targets.size(), 3U);
  EXPECT_EQ(again.load.targets[0].value, 2e-3);
  ASSERT_EQ(again.expectations.size(), 2U);
  EXPECT_EQ(again.expectations[1].quantity, "area_fraction@p=0.01 E*");
}

TEST_F(BaseCase, KeepsPathsInsideTheBasesSubTablesToo) {
  write("factors.txt", "1 1 1 2\n");
  write("block.toml", contact_case + "[fem.whole]\nsolver = \"full\"\n"
                                     "[material.variation]\nkind = \"table\"\n"
                                     "file = \"factors.txt\"\n");
  write("deep/top.toml", "base = \"../block.toml\"\nfem.solver = \"full\"\n");

  const Case mine = read("deep/top.toml");

  ASSERT_TRUE(mine.material.variation);
  EXPECT_TRUE(
      fs::equivalent(mine.material.variation->file, folder / "factors.txt"));
}

TEST_F(BaseCase, KeepsTheBasesPathsWithTheBase) {
  write("map.txt", "1 2 1 2\n2 1 2 1\n1 2 1 2\n2 1 2 1\n");
  write("measured.toml",
        shape_case("kind = \"measured\"\nfile = \"map.txt\"\nformat = "
                   "\"plain\"\nlength = 1e-6\nheight_unit = 1e-9\nlevel = "
                   "\"plane\"\nedges = \"periodic\"\n"));
  write("deep/middle.toml", "base = \"../measured.toml\"\n");
  write("deep/er/top.toml", "base = \"../middle.toml\"\n");

  for (const char* name : {"deep/middle.toml", "deep/er/top.toml"})
    EXPECT_TRUE(fs::equivalent(read(name).surface.file, folder / "map.txt"))
        << name;
}

// Each mistake is reported for the file that contains it.
TEST_F(BaseCase, NamesTheFileAMistakeIsIn) {
  std::string changed = contact_case;
  changed.replace(changed.find("hurst = 0.95"), 12, "hurst = 1.95");
  write("block.toml", changed);
  write("deep/er/case.toml", on_block + "[surface]\npoints = 513\n");

  EXPECT_EQ(mistakes_of("deep/er/case.toml"),
            "  deep/er/case.toml:3: surface.points = 513, but must be even\n"
            "  block.toml:10: surface.hurst = 1.95, but must be > 0 and <= 1 "
            "[1]\n");
}

// A long chain is no cycle; one that is too long is called that.
TEST_F(BaseCase, MayHaveManyBases) {
  std::string below = "block.toml";
  for (int i = 0; i < 60; ++i) {
    const std::string name = "chain" + std::to_string(i) + ".toml";
    write(name, "base = \"" + below + "\"\ntitle = \"Case " +
                    std::to_string(i) + "\"\n");
    below = name;
  }

  EXPECT_EQ(read("chain9.toml").title, "Case 9");
  EXPECT_EQ(read("chain48.toml").title, "Case 48");
  EXPECT_EQ(mistakes_of("chain49.toml"),
            "  chain0.toml:1: base: the chain of bases has more than 50 "
            "files\n");
}

TEST_F(BaseCase, StatesWhatABaseMustBe) {
  write("lost.toml", "base = \"nowhere.toml\"\n");
  write("second.toml", "title = \"A\"\nbase = \"block.toml\"\n");
  write("number.toml", "base = 3\n");
  write("circle.toml", "base = \"circle.toml\"\n");

  EXPECT_EQ(mistakes_of("lost.toml"),
            "  lost.toml:1: base: nowhere.toml: there is no such file\n");
  write("device.toml", "base = \"/dev/zero\"\n");
  EXPECT_EQ(mistakes_of("device.toml"),
            "  device.toml:1: base: /dev/zero: is a device, but must be a "
            "regular file\n");
  EXPECT_EQ(mistakes_of("second.toml"),
            "  second.toml:2: base must be the file's first key\n");
  EXPECT_EQ(mistakes_of("number.toml"),
            "  number.toml:1: base = 3, but must be the path of a file\n");
  EXPECT_EQ(mistakes_of("circle.toml"),
            "  circle.toml:1: base refers back to itself in a cycle\n");
  write("one.toml", "base = \"other.toml\"\n");
  write("other.toml", "base = \"deep/../one.toml\"\n");
  EXPECT_EQ(mistakes_of("one.toml"),
            "  other.toml:1: base refers back to itself in a cycle\n");
  EXPECT_NE(
      asperity::cases::mistakes_of("base = \"block.toml\"\n" + contact_case)
          .find("only a case file can have a base case"),
      std::string::npos);
}

// Overrides at the end are comments, of which the tree does not depend, so that
// a text is parsed once for all of them; inside a text of several lines they
// are none.
TEST(ParsedFile, IsThatOfTheTextThatIsGiven) {
  const std::string text = "[surface]\npoints = 8\n";
  EXPECT_EQ(without_overrides(text + "#--set a=1\n#--set b=2\n"), text);
  EXPECT_EQ(without_overrides(text), text);
  EXPECT_EQ(without_overrides("#--set a=1"), "");
  EXPECT_EQ(without_overrides("\n"), "\n");
  for (const std::string more : {"", "#--set surface.points=16\n"}) {
    const Node file = parsed_file(text + more, "one.toml");
    EXPECT_EQ(file.find("surface")->find("points")->integer, 8);
    EXPECT_EQ(file.find("surface")->find("points")->place.text, "one.toml:2");
  }
  const Node moved = parsed_file(text, "two.toml");
  EXPECT_EQ(moved.find("surface")->find("points")->place.text, "two.toml:2");
  const Node changed = parsed_file("[surface]\npoints = 9\n", "two.toml");
  EXPECT_EQ(changed.find("surface")->find("points")->integer, 9);
  for (const std::string word : {"first", "second"}) {
    const Node file = parsed_file(
        "title = \"\"\"\n#--set " + word + "=1\"\"\"\n", "long.toml");
    EXPECT_EQ(file.find("title")->text, "#--set " + word + "=1");
  }
}

} // namespace asperity::cases::base_case_test
