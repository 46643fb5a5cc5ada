// Tests of input/reader/collection.hpp: the order of the parts and their
// figures, and every mistake with its line.
#include "input/reader/collection.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace asperity::cases::collection_test {

class CollectionFile : public testing::Test {
protected:
  ~CollectionFile() override { std::filesystem::remove(file); }

  Collection read(const std::string& text) const {
    std::ofstream(file) << text;
    return read_collection(file, {"heavy", "light"});
  }

  std::string mistake(const std::string& text) const {
    return tests::message_of<input::InputError>([&] { read(text); });
  }

  std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      ("collection-" + std::to_string(::getpid()) + ".toml");
};

TEST_F(CollectionFile, KeepsTheOrderOfThePartsAndTheirFigures) {
  const Collection collection = read("parts = [\"light\", \"heavy\"]\n"
                                     "[figures]\nheavy = [\"b\", \"a\"]\n");

  EXPECT_EQ(collection.parts, (std::vector<std::string>{"light", "heavy"}));
  ASSERT_EQ(collection.figures.size(), 2U);
  EXPECT_EQ(collection.figures[0].name, "b");
  EXPECT_EQ(collection.figures[1].part, "heavy");
  EXPECT_NE(collection.figures[1].place.text.find(":3"), std::string::npos);
}

TEST_F(CollectionFile, NamesEveryMistakeWithItsLine) {
  const std::string message =
      mistake("parts = [\"ligth\", \"heavy\", 3]\nfigure = []\n"
              "[figures]\nheavi = []\nheavy = \"a\"\n");

  for (const char* part :
       {"toml:1: parts has \"ligth\"", "nearest: light",
        "toml:1: parts has the item 3", "toml:1: parts lacks \"light\"",
        "toml:2: figure is unknown", "toml:4: figures.heavi is not a part",
        "toml:5: figures.heavy = \"a\", but must be a list"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " in\n"
                                                     << message;
}

TEST_F(CollectionFile, RefusesTwoOfAPartAndNone) {
  EXPECT_NE(
      mistake("parts = [\"light\", \"light\", \"heavy\"]\n").find("twice"),
      std::string::npos);
  EXPECT_NE(mistake("").find("parts is missing"), std::string::npos);
  EXPECT_NE(mistake("parts = [\n").find("not TOML"), std::string::npos);
}

} // namespace asperity::cases::collection_test
