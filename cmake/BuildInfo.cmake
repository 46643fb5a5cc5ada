# cmake -DSOURCE=... -DHEADER=... -P BuildInfo.cmake
# Writes the commit the program is built from into HEADER, only when it changes.
# "unknown" without git, and where SOURCE is not itself a checkout (an unpacked
# archive may lie inside somebody's repository). Dirty: a tracked file differs.
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
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#pragma once

// Written by the build, see cmake/BuildInfo.cmake.

namespace asperity::results {

inline constexpr char build_commit[] = \"@commit@\";
inline constexpr char build_dirty[] = \"@dirty@\";

} // namespace asperity::results
")
