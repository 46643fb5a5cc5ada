// The program asperity_mesh lets gmsh read or mesh a user's file in a process
// separate from the program that needs the mesh, so that the latter can limit
// its resources and what it may do.
//
//     asperity_mesh FILE UNIT confined|unconfined OUTPUT
//
// It writes the bytes of mesh_bytes.hpp to OUTPUT, or what is wrong to standard
// error. The exit codes are those of asperity.
#include "base/confined_process.hpp"
#include "meshes/gmsh_file.hpp"
#include "meshes/mesh_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <dlfcn.h>
#include <exception>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

/// The file and the line that gmsh is parsing; null if this version of gmsh
/// does not tell.
[[gnu::weak]] extern std::string gmsh_yyname;
[[gnu::weak]] extern int gmsh_yylineno;

/// Takes the place of stat() for gmsh, which looks so for an option file beside
/// each file that it opens (block.geo.opt) and executes it: there is none.
// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name)
extern "C" int stat(const char* path, struct stat* found) noexcept {
  if (std::string_view(path).ends_with(".opt")) {
    errno = ENOENT;
    return -1;
  }
  return fstatat(AT_FDCWD, path, found, 0);
}

namespace asperity::meshes {
namespace {

constexpr int exit_bad_input = 2;
constexpr int exit_system_error = 4;

bool is_confined = false;

/// Where messages go, whatever gmsh does to standard error.
int messages = STDERR_FILENO;

void say(std::string_view text) {
  static_cast<void>(!write(messages, text.data(), text.size()));
}

/// Says in which file and line gmsh is, if it is parsing one.
void say_place() {
  if (&gmsh_yyname == nullptr || &gmsh_yylineno == nullptr ||
      gmsh_yyname.empty())
    return;
  char line[32];
  // gmsh reads on to the end of the line before it executes a command.
  std::snprintf(line, sizeof line,
                "', line %d: ", std::max(1, gmsh_yylineno - 1));
  say("'");
  say(gmsh_yyname);
  say(line);
}

[[noreturn]] void refuse(const ForbiddenAct& act) {
  say_place();
  say(act.what);
  if (act.file != nullptr) {
    say(" (");
    say(act.file);
    say(")");
  }
  say(", which the file of a mesh may do only with allow_commands = true in "
      "[mesh]; set it if you trust the file");
  _exit(exit_bad_input);
}

/// What gmsh and the file print is not wanted.
void silence() {
  messages = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (messages < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0 ||
      dup2(nowhere, STDERR_FILENO) < 0)
    throw std::runtime_error("cannot open /dev/null");
}

/// A mesh file that begins as one contains no instructions, so that it is read
/// on any system.
void confine(bool is_script) {
  if (!confine_process(refuse) && is_script)
    throw std::domain_error(
        "this system does not let a program be confined (seccomp), so that a "
        ".geo file needs allow_commands = true in [mesh]; set it if you trust "
        "the file");
}

int mesh_as_asked(char** words) {
  std::FILE* const output = std::fopen(words[4], "wb");
  if (output == nullptr)
    throw std::runtime_error(std::string("cannot write ") + words[4]);
  silence();
  const std::string path = words[1];
  is_confined = std::string_view(words[3]) == "confined";
  const std::string bytes = bytes_of(gmsh_file(path, std::stod(words[2]), [&] {
    if (is_confined)
      confine(path.ends_with(".geo"));
  }));
  const bool is_written =
      std::fwrite(bytes.data(), 1, bytes.size(), output) == bytes.size();
  if (std::fclose(output) != 0 || !is_written)
    throw std::runtime_error(std::string("cannot write ") + words[4]);
  return 0;
}

} // namespace

/// Takes the place of system(), which would end the confined process without
/// words, because it blocks all signals.
int system_or_refusal(const char* command) {
  if (is_confined && command == nullptr)
    return 1; // asked whether there is a shell
  if (is_confined)
    refuse({"starts a program", command});
  using System = int (*)(const char*);
  return reinterpret_cast<System>(dlsym(RTLD_NEXT, "system"))(command);
}

} // namespace asperity::meshes

extern "C" int system(const char* command) {
  return asperity::meshes::system_or_refusal(command);
}

int main(int n_words, char** words) {
  using namespace asperity::meshes;
  if (n_words != 5) {
    say("usage: asperity_mesh FILE UNIT confined|unconfined OUTPUT\n");
    return exit_bad_input;
  }
  try {
    return mesh_as_asked(words);
  } catch (const std::domain_error& error) {
    say(error.what());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    say("out of memory");
  } catch (const std::exception& error) {
    say(error.what());
  }
  return exit_system_error;
}
