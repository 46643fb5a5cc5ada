# cmake -DSOURCE=... -DHEADER=... [-DTOOLS=...] -P BuildInfo.cmake
# Writes the commit the program is built from into HEADER, only when it changes.
# "unknown" without git, and where SOURCE is not itself a checkout (an unpacked
# archive may lie inside somebody's repository). Dirty: a tracked file differs.
#
# And the stamp of what decides the numbers: every source of every room, and
# TOOLS (compiler, flags, libraries). Left out by name is what only speaks, so
# that a file nobody thought of counts. A glob, because a list could forget one.
cmake_minimum_required(VERSION 3.25)
set(commit "unknown")
set(dirty "unknown")
find_program(GIT git)
if(GIT)
  set(ENV{GIT_OPTIONAL_LOCKS} 0) # a build beside a git command must not stop it
  file(REAL_PATH "${SOURCE}" source)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND top STREQUAL source)
    set(commit "${head}")
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes STREQUAL "")
      set(dirty "no")
    else()
      set(dirty "yes")
    endif()
  endif()
endif()
set(told "${TOOLS}")
file(GLOB sources RELATIVE ${SOURCE} ${SOURCE}/*/*.cpp ${SOURCE}/*/*.hpp)
list(FILTER sources EXCLUDE REGEX
  "^(reports|tests|build)/|^app/(main|commands|progress|collection|plan_text)\\.")
list(SORT sources)
foreach(source IN LISTS sources)
  file(SHA256 ${SOURCE}/${source} hash)
  string(APPEND told "\n${source} ${hash}")
endforeach()
string(SHA256 numerics "${told}")

file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#pragma once

// Written by the build, see cmake/BuildInfo.cmake.

namespace asperity::results {

inline constexpr char build_commit[] = \"@commit@\";
inline constexpr char build_dirty[] = \"@dirty@\";
inline constexpr char build_numerics[] =
    \"@numerics@\";

} // namespace asperity::results
")
