# Claim: cmake/BuildInfo.cmake tells a clean checkout, a dirty one and none
# apart, and does not touch its header when nothing changed. Run as
# cmake -DSCRIPT=... -DWORK=... -P, in a repository made for it.
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
