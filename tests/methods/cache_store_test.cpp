// Tests of the store: entries are read back, damaged entries are not, and the
// size limit holds.
#include "base/content_hash.hpp"
#include "input/input_error.hpp"
#include "run/methods/cache/cache.hpp"
#include "tests/folder.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace asperity::methods::cache_store_test {

namespace fs = std::filesystem;

class Store : public tests::FolderTest {
protected:
  /// A key that is the hash of a number.
  static std::string key(int number) {
    return content_hash(std::to_string(number));
  }

  fs::path file(int number) const { return folder / (key(number) + ".step"); }

  /// Sets the time of the last use this far into the past.
  void age(int number, int hours) const {
    fs::last_write_time(file(number), fs::file_time_type::clock::now() -
                                          std::chrono::hours(hours));
  }
};

TEST_F(Store, ReadsBackWhatItWasGiven) {
  Cache cache(folder, 1000);
  const std::string bytes("\0\xff two \n", 8);

  cache.write(key(1), entry_kind::step, bytes);

  EXPECT_EQ(cache.read(key(1), entry_kind::step), bytes);
  EXPECT_FALSE(cache.read(key(2), entry_kind::step));
  EXPECT_FALSE(cache.read(key(1), entry_kind::state));
}

std::string file_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The file has the same bytes whatever the pieces, and is read by pieces.
TEST_F(Store, WritesAndReadsPieces) {
  Cache cache(folder, 1000);
  cache.write(key(1), entry_kind::step, "one entry");
  const std::string whole = file_text(file(1));
  cache.remove(key(1), entry_kind::step);

  cache.write(key(1), entry_kind::step, 9, [](const TakeBytes& take) {
    take("one ");
    take("");
    take("entry");
  });

  EXPECT_EQ(file_text(file(1)), whole);
  const std::optional<FileBytes> entry = cache.open(key(1), entry_kind::step);
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->size(), 9U);
  cache.remove(key(1), entry_kind::step); // it remains readable
  std::string part(3, ' ');
  entry->read(0, part);
  EXPECT_EQ(part, "one");
  part.resize(5);
  entry->read(4, part);
  EXPECT_EQ(part, "entry");
  EXPECT_THROW(entry->read(5, part), std::runtime_error);
}

// Without room for an entry its pieces are not asked for; a failure leaves no
// file.
TEST_F(Store, AsksForNoPiecesInVain) {
  Cache cache(folder, 1000);
  bool was_asked = false;
  cache.write(key(1), entry_kind::step, 1000,
              [&](const TakeBytes&) { was_asked = true; });
  EXPECT_FALSE(was_asked);

  EXPECT_THROW(cache.write(key(1), entry_kind::step, 9,
                           [](const TakeBytes& take) {
                             take("one ");
                             throw std::runtime_error("no more");
                           }),
               std::runtime_error);
  EXPECT_TRUE(fs::is_empty(folder));
}

// If any byte differs, the entry is removed.
TEST_F(Store, TreatsADamagedEntryAsMissingAndRemovesIt) {
  Cache cache(folder, 1000);
  const std::string bytes = "a step";
  cache.write(key(1), entry_kind::step, bytes);
  const auto size = static_cast<std::streamoff>(fs::file_size(file(1)));
  for (std::streamoff place = 0; place < size; ++place) {
    cache.write(key(1), entry_kind::step, bytes);
    std::fstream stream(file(1),
                        std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(place).put('~');
    stream.close();

    EXPECT_FALSE(cache.read(key(1), entry_kind::step)) << place;
    EXPECT_FALSE(fs::exists(file(1)));
  }
  const std::vector<std::string> problems = cache.problems();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find(std::to_string(size) + " damaged entries"),
            std::string::npos)
      << problems[0];
}

TEST_F(Store, TreatsATruncatedEntryAsMissing) {
  Cache cache(folder, 1000);
  for (const std::uintmax_t length : {0u, 10u, 152u, 155u}) {
    cache.write(key(1), entry_kind::step, "a step");
    fs::resize_file(file(1), length);

    EXPECT_FALSE(cache.read(key(1), entry_kind::step)) << length;
  }
}

// An entry under another name is rejected: neither that of another key nor that
// of another kind is returned.
TEST_F(Store, TreatsARenamedEntryAsMissing) {
  Cache cache(folder, 1000);
  cache.write(key(1), entry_kind::step, "one");
  cache.write(key(2), entry_kind::step, "two");
  fs::rename(file(1), folder / "kept");
  fs::rename(file(2), file(1));
  fs::rename(folder / "kept", file(2));

  EXPECT_FALSE(cache.read(key(1), entry_kind::step));
  EXPECT_FALSE(cache.read(key(2), entry_kind::step));

  cache.write(key(3), entry_kind::step, "three");
  fs::rename(file(3), folder / (key(3) + ".state"));
  EXPECT_FALSE(cache.read(key(3), entry_kind::state));
}

// Nine entries of 252 bytes are 2268; the tenth exceeds 2400, and 0.9 of the
// limit is left. The first, read again, outlives the second.
TEST_F(Store, RemovesTheLeastRecentlyUsedFirst) {
  Cache cache(folder, 2400);
  for (int i = 0; i < 9; ++i) {
    cache.write(key(i), entry_kind::step, std::string(100, 'x'));
    age(i, 20 - i);
  }
  ASSERT_TRUE(cache.read(key(0), entry_kind::step));

  cache.write(key(9), entry_kind::step, std::string(100, 'x'));

  EXPECT_LE(cache.contents().bytes, 2400u);
  EXPECT_TRUE(cache.read(key(0), entry_kind::step));
  EXPECT_FALSE(cache.read(key(1), entry_kind::step));
  EXPECT_TRUE(cache.read(key(9), entry_kind::step));
}

TEST_F(Store, KeepsNothingLargerThanItself) {
  Cache cache(folder, 100);

  cache.write(key(1), entry_kind::step, std::string(100, 'x'));

  EXPECT_EQ(cache.contents().entries, 0u);
}

TEST_F(Store, WithoutAFolderOrSizeIsOff) {
  Cache none;
  Cache homeless("", 1000);
  Cache empty(folder, 0);
  for (Cache* cache : {&none, &homeless, &empty}) {
    cache->write(key(1), entry_kind::step, "a step");

    EXPECT_FALSE(cache->is_on());
    EXPECT_FALSE(cache->read(key(1), entry_kind::step));
  }
}

// A folder that cannot be made is ignored.
TEST_F(Store, IgnoresAFolderThatCannotBeWritten) {
  std::ofstream(folder / "file") << "no folder";
  Cache cache(folder / "file" / "cache", 1000);

  cache.write(key(1), entry_kind::step, "a step");

  EXPECT_FALSE(cache.read(key(1), entry_kind::step));
  EXPECT_EQ(cache.contents().entries, 0u);
  ASSERT_EQ(cache.problems().size(), 1U);
  EXPECT_NE(cache.problems()[0].find("1 entries could not be written"),
            std::string::npos);
}

// Also where the user is root, who may remove everything but a folder with
// files.
TEST_F(Store, SaysThatAnEntryIsLeft) {
  Cache cache(folder, 1000);
  cache.write(key(1), entry_kind::step, "a step");
  fs::create_directories(folder / (key(2) + ".step") / "more");

  EXPECT_NE(tests::message_of<std::runtime_error>([&] { cache.clear(); })
                .find("1 of 2 entries could not be removed (Directory not "
                      "empty)"),
            std::string::npos);
  EXPECT_EQ(cache.contents().entries, 0u);
}

TEST_F(Store, ClearsItsOwnFilesAlone) {
  Cache cache(folder, 1000);
  cache.write(key(1), entry_kind::step, "a step");
  std::ofstream(folder / "letter.txt") << "not ours";

  cache.clear();

  EXPECT_EQ(cache.contents().entries, 0u);
  EXPECT_TRUE(fs::exists(folder / "letter.txt"));
}

// Four processes write and read the same keys at once under a limit that makes
// them remove each other's entries: every entry that is read is complete.
TEST_F(Store, ServesSeveralProcessesAtOnce) {
  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child) {
    const pid_t process = fork();
    if (process == 0) {
      Cache cache(folder, 20000);
      for (int i = 0; i < 300; ++i) {
        const int number = (7 * i + child) % 40;
        const std::string bytes(1000, static_cast<char>('0' + number));
        if (const auto found = cache.read(key(number), entry_kind::step);
            found && *found != bytes)
          _exit(1);
        cache.write(key(number), entry_kind::step, bytes);
      }
      _exit(0);
    }
    children.push_back(process);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  // One more process examines all entries, and the limit holds.
  Cache cache(folder, 20000);
  cache.write(key(100), entry_kind::step, "last");
  EXPECT_LE(cache.contents().bytes, 20000u);
}

TEST(CacheSize, IsReadWithItsUnit) {
  const auto size_of = [](const char* text) {
    setenv("ASPERITY_CACHE_SIZE", text, 1);
    const std::uintmax_t size = cache_size();
    unsetenv("ASPERITY_CACHE_SIZE");
    return size;
  };
  EXPECT_EQ(size_of("500 MB"), 500'000'000u);
  EXPECT_EQ(size_of("1.5GB"), 1'500'000'000u);
  EXPECT_EQ(size_of("4096"), 4096u);
  EXPECT_EQ(size_of("0"), 0u);
  EXPECT_EQ(cache_size(), 2'000'000'000u);
  EXPECT_THROW(size_of("much"), input::InputError);
  EXPECT_THROW(size_of("2 GiB"), input::InputError);
  EXPECT_THROW(size_of("-1"), input::InputError);
}

} // namespace asperity::methods::cache_store_test
