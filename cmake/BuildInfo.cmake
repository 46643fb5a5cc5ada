# cmake -DSOURCE=... -DHEADER=... [-DTOOLS=...] -P BuildInfo.cmake
# Writes the commit the program is built from into HEADER, only when it changes.
# "unknown" without git, and where SOURCE is not itself a checkout (an unpacked
# archive may lie inside somebody's repository). Dirty: a tracked file differs.
#
# And the stamp of what decides the numbers: every source of every module, at
# any depth, and TOOLS (compiler, flags, libraries). Excluded by name is what
# only reports, so that a file nobody thought of counts. A glob, because a list
# could omit one.
cmake_minimum_required(VERSION 3.25)
set(commit "unknown")
set(dirty "unknown")
find_program(GIT git)
if(GIT)
  set(ENV{GIT_OPTIONAL_LOCKS} 0) # a build beside a git command must not stop it
  file(REAL_PATH "${SOURCE}" source)
  # Another user's checkout is built and run anyway, so git may read it.
  set(GIT ${GIT} -c safe.directory=${source})
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
file(GLOB modules LIST_DIRECTORIES true RELATIVE ${SOURCE} ${SOURCE}/*)
list(FILTER modules EXCLUDE REGEX "^(\\..*|build.*|reports|tests|tools|out)$")
set(sources "")
foreach(module IN LISTS modules)
  file(GLOB_RECURSE found RELATIVE ${SOURCE} ${SOURCE}/${module}/*.cpp ${SOURCE}/${module}/*.hpp)
  list(APPEND sources ${found})
endforeach()
list(FILTER sources EXCLUDE REGEX "^(run/cli/|suite/exchange/board/|run/progress\\.|run/plan/plan_text\\.)")
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
