# cmake -DSOURCE=... -DHEADER=... -P BuildInfo.cmake
# Writes the commit the program is built from into HEADER, only when it changes.
set(commit "unknown")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit "${head}")
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT changes STREQUAL "")
      string(APPEND commit " dirty")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#pragma once

// Written by the build, see cmake/BuildInfo.cmake.

namespace asperity::results {

inline constexpr char build_commit[] = \"@commit@\";

} // namespace asperity::results
")
