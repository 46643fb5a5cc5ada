#include "run/output.hpp"

#include "base/read_file.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace asperity::run {
namespace {

/// Standard output while it is redirected; -1: it is not.
int saved_output = -1;
bool is_json_wanted = false;
bool is_quiet_wanted = false;

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void require_output(bool is_good, const char* what) {
  if (!is_good)
    throw_errno(what);
}

} // namespace

OutputScope::OutputScope(const OutputOptions& options) {
  is_json_wanted = options.is_json;
  is_quiet_wanted = options.is_quiet && !options.is_json;
  if (!options.is_quiet && !options.is_json)
    return;
  std::fflush(stdout);
  const int target = options.is_quiet ? open("/dev/null", O_WRONLY | O_CLOEXEC)
                                      : dup(STDERR_FILENO);
  require_output(target >= 0, "cannot redirect standard output");
  saved_output = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  const bool is_redirected =
      saved_output >= 0 && dup2(target, STDOUT_FILENO) >= 0;
  close(target);
  require_output(is_redirected, "cannot redirect standard output");
}

OutputScope::~OutputScope() {
  is_json_wanted = false;
  is_quiet_wanted = false;
  if (saved_output < 0)
    return;
  std::fflush(stdout);
  dup2(saved_output, STDOUT_FILENO);
  close(saved_output);
  saved_output = -1;
}

bool wants_json() {
  return is_json_wanted;
}

bool wants_quiet() {
  return is_quiet_wanted;
}

void emit_answer(const std::string& text) {
  std::fflush(stdout);
  const int output = saved_output < 0 ? STDOUT_FILENO : saved_output;
  for (std::size_t begin = 0; begin < text.size();) {
    const ssize_t written =
        write(output, text.data() + begin, text.size() - begin);
    if (written < 0 && errno == EINTR)
      continue;
    require_output(written >= 0, "cannot write standard output");
    begin += static_cast<std::size_t>(written);
  }
}

std::string json_of_file(const std::filesystem::path& path) {
  constexpr std::uintmax_t largest = std::uintmax_t{1} << 30U;
  return std::filesystem::exists(path) ? read_file(path, largest) : "null\n";
}

} // namespace asperity::run
