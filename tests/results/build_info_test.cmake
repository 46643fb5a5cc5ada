# Verifies that cmake/BuildInfo.cmake distinguishes a clean checkout, a modified
# one and none, and does not write its header when nothing changed; its stamp
# changes with every source that can change a number, at any depth. Run as
# cmake -DSCRIPT=... -DWORK=... -P, in a repository made for it.
cmake_minimum_required(VERSION 3.25)
find_program(GIT git REQUIRED)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/checkout/archive)

function(git)
  execute_process(COMMAND ${GIT} -C ${WORK}/checkout -c user.name=n -c user.email=e ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

function(expect source pattern)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE=${source}
    -DHEADER=${WORK}/build_info.hpp -P ${SCRIPT} COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${WORK}/build_info.hpp header)
  if(NOT header MATCHES "${pattern}")
    message(FATAL_ERROR "${source}: no match of ${pattern} in:\n${header}")
  endif()
endfunction()

# The stamp of the build of ${WORK}/sources.
function(stamp result)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE=${WORK}/sources
    -DHEADER=${WORK}/stamp.hpp -P ${SCRIPT} COMMAND_ERROR_IS_FATAL ANY)
  file(STRINGS ${WORK}/stamp.hpp found REGEX "^ +.[0-9a-f]+")
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

set(numerical base/grid.hpp fem/block.cpp fem/block/assembly.cpp contact/a/b/kernel.hpp
  methods/step.cpp input/types/units.cpp module-of-tomorrow/new.cpp)
set(other reports/page.cpp reports/figures/page.cpp tests/fem/block_test.cpp
  build/release/generated/info.hpp build-old/generated/info.hpp .git/stored.cpp run/cli/main.cpp)
foreach(file IN LISTS numerical other)
  file(WRITE ${WORK}/sources/${file} "one\n")
endforeach()
foreach(file IN LISTS numerical other)
  stamp(before)
  file(APPEND ${WORK}/sources/${file} "two\n")
  stamp(after)
  if(file IN_LIST numerical AND before STREQUAL after)
    message(FATAL_ERROR "${file} was touched, and the stamp is still ${after}")
  elseif(file IN_LIST other AND NOT before STREQUAL after)
    message(FATAL_ERROR "${file} changed the stamp from ${before} to ${after}")
  endif()
endforeach()

set(unknown "commit.. = \"unknown\".*dirty.. = \"unknown\"")
git(init)
expect(${WORK}/checkout "${unknown}") # no commit yet
file(WRITE ${WORK}/checkout/source.cpp "one")
git(add source.cpp)
git(commit -m first)
expect(${WORK}/checkout "commit.. = \"[0-9a-f]+\".*dirty.. = \"no\"")
file(TIMESTAMP ${WORK}/build_info.hpp before "%s.%f" UTC)
expect(${WORK}/checkout "dirty.. = \"no\"")
file(TIMESTAMP ${WORK}/build_info.hpp after "%s.%f" UTC)
if(NOT before STREQUAL after)
  message(FATAL_ERROR "the header was written again without a change")
endif()
file(WRITE ${WORK}/checkout/source.cpp "two")
expect(${WORK}/checkout "dirty.. = \"yes\"")
expect(${WORK}/checkout/archive "${unknown}") # inside somebody's repository
file(REMOVE_RECURSE ${WORK})
