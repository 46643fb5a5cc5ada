// Gives any bytes to the commands `surface`, `run --dry-run` and `report`: they
// may refuse them, but no signal may end them.
#include "base/atomic_file.hpp"
#include "base/child_process.hpp"
#include "base/temporary_folder.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace asperity::fuzz {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// What a command may end with: done, a failed check, a mistake of the input,
/// or no convergence.
constexpr int largest_exit_code = 4;

void require_no_signal(const fs::path& folder, const Words& words) {
  ChildCommand command;
  command.words = {ASPERITY_PROGRAM};
  command.words.insert(command.words.end(), words.begin(), words.end());
  command.folder = folder;
  command.output = folder / "log.txt";
  command.environment.push_back("ASPERITY_CACHE=" +
                                (folder / "cache").string());
  command.limits.cpu_time = 60.0;
  const ChildEnd end = ChildProcess(command).wait();
  if (end.exit_code > largest_exit_code || end.exit_code < 0)
    std::fprintf(stderr, "asperity %s: %s\n", words.front().c_str(),
                 end.failure.c_str());
  require(end.exit_code >= 0 && end.exit_code <= largest_exit_code,
          "the command ends by itself");
}

/// The file's ending decides which reader answers.
const char* ending_of(const std::string& bytes) {
  if (bytes.starts_with("\x89HDF"))
    return ".h5";
  if (bytes.starts_with("\x93NUMPY"))
    return ".npy";
  if (bytes.starts_with("PK"))
    return ".x3p";
  return bytes.find("[surface]") != std::string::npos ? ".toml" : ".txt";
}

void give(const std::string& bytes) {
  const TemporaryFolder temporary("asperity-fuzz");
  const std::string file = std::string("input") + ending_of(bytes);
  write_file_atomically(temporary.path() / file, bytes);
  const Words scale{"--length", "10 um", "--height-unit", "nm"};
  if (file.ends_with(".toml")) {
    require_no_signal(temporary.path(), {"run", file, "--dry-run"});
    return;
  }
  Words surface{"surface", file, "--no-report"};
  surface.insert(surface.end(), scale.begin(), scale.end());
  require_no_signal(temporary.path(), surface);
  Words run{"run", file, "--dry-run", "--contact-modulus", "1 GPa"};
  run.insert(run.end(), scale.begin(), scale.end());
  require_no_signal(temporary.path(), run);
  if (file.ends_with(".h5"))
    require_no_signal(temporary.path(), {"report", file});
}

} // namespace

/// The bytes themselves, and two versions with a small damage that follows from
/// them.
void read_input(const std::string& bytes) {
  give(bytes);
  if (bytes.size() < 8)
    return;
  std::uint32_t sum = 2166136261U;
  for (const char c : bytes)
    sum = (sum ^ static_cast<std::uint8_t>(c)) * 16777619U;
  give(bytes.substr(0, bytes.size() / 2 + sum % (bytes.size() / 2)));
  std::string changed = bytes;
  for (std::size_t k = 0; k < 4; ++k) {
    sum = sum * 1664525U + 1013904223U;
    changed[sum % changed.size()] = static_cast<char>('0' + (sum >> 24U) % 10U);
  }
  give(changed);
}

} // namespace asperity::fuzz
