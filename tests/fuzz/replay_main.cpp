// Passes every file of some folders, the corpora, to a fuzz target: bytes that
// once made a reader fail must not do so again. Needs no fuzzer.
#include "base/read_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <cstdio>
#include <filesystem>

int main(int count, char** arguments) {
  int files = 0;
  for (int folder = 1; folder < count; ++folder)
    for (const auto& entry :
         std::filesystem::directory_iterator(arguments[folder])) {
      std::printf("%s\n", entry.path().filename().c_str());
      std::fflush(stdout); // names the file that ends the program
      asperity::fuzz::read_input(
          asperity::read_file(entry.path(), 16 * 1024 * 1024));
      ++files;
    }
  std::printf("%d files\n", files);
  return files > 0 ? 0 : 1;
}
