# The three ways to add code to this project. Everything else is a plain list.
set(werror_by_default OFF)
if("$ENV{ASPERITY_WERROR}" STREQUAL "ON") # as .ci/run has it
  set(werror_by_default ON)
endif()
option(ASPERITY_WERROR "Treat warnings in our own code as errors" ${werror_by_default})
option(ASPERITY_UNITY "Compile several sources of a library as one" OFF)
option(ASPERITY_FUZZ "Build the fuzz targets for libFuzzer (preset sanitizers)" OFF)

# The default linker reads every library that deal.II's own libraries need, 20 s
# for each program; gold, of the same Debian package, takes 2 s.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold ASPERITY_HAS_GOLD)

add_library(asperity_flags INTERFACE)
target_link_options(asperity_flags INTERFACE
  $<$<BOOL:${ASPERITY_HAS_GOLD}>:-fuse-ld=gold>)
target_compile_features(asperity_flags INTERFACE cxx_std_20)
target_compile_options(asperity_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  $<$<BOOL:${ASPERITY_WERROR}>:-Werror>)
# GCC 12's optimiser raises these by mistake inside its own std::string.
target_compile_options(asperity_flags INTERFACE
  $<$<AND:$<BOOL:${ASPERITY_WERROR}>,$<CXX_COMPILER_ID:GNU>>:-Wno-error=restrict>)

# In a unity build GCC takes the unnamed namespaces of sources for a header's.
target_compile_options(asperity_flags INTERFACE
  $<$<AND:$<BOOL:${ASPERITY_UNITY}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)

# asperity_show(target PUBLIC module) adds an include folder that holds nothing but
# a link to this top-level folder. A target sees the modules that it depends on
# and no other: the source folder itself is on no include path.
function(asperity_show target scope folder)
  set(visible ${PROJECT_BINARY_DIR}/include/${folder})
  file(MAKE_DIRECTORY ${visible})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${visible}/${folder} SYMBOLIC)
  target_include_directories(${target} ${scope} ${visible})
endfunction()

# Headers that tests and benchmarks share, found as "tests/...".
add_library(asperity_test_sources INTERFACE)
asperity_show(asperity_test_sources INTERFACE tests)

# Headers, and what several sources instantiate, take most of the time of a small
# source, so a unity build is some times faster from nothing; batches keep two
# processors busy. Names of one library's sources are therefore unique, also in
# unnamed namespaces.
# No default is kept in a cache: a build folder of an older state has today's. The
# batch 0 is all sources of a library.
if(NOT DEFINED ASPERITY_UNITY_BATCH)
  set(ASPERITY_UNITY_BATCH 45)
endif()

# Tests, too; each has a namespace of its own, asperity::theory::persson_test.
if(NOT DEFINED ASPERITY_UNITY_TESTS)
  set(ASPERITY_UNITY_TESTS 20)
endif()

# What computes little is optimised little. At -O1, GCC 12 takes a function for one
# without effect whose loop has a store through a pointer that the choice of induction
# variables rewrote, and drops its calls: convolutions lost the mirror image of their
# spectrum in this way.
set(asperity_o1 $<$<CONFIG:Release>:-O1>
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fno-ivopts>)

# The sources of the program and of the module compute nothing.
function(asperity_compile_as_one target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ASPERITY_UNITY}
    UNITY_BUILD_BATCH_SIZE 0)
  target_compile_options(${target} PRIVATE ${asperity_o1})
endfunction()

# asperity_library(theory SOURCES hertz.cpp persson.cpp [DEPENDS asperity::base]
#                  [PRIVATE_DEPENDS PkgConfig::fftw3] [PRECOMPILE <header>] [SHARED]
#                  [LITTLE_OPTIMIZED])
# Sources are named inside the module's folder. DEPENDS is the whole permission
# to include: list direct dependencies only. Position-independent, because the
# deal.II module is loaded at run time; what must exist once in the process, in
# the program and in that module together, is SHARED. LITTLE_OPTIMIZED is for
# modules that compute little: it halves the time of their compilation.
function(asperity_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SHARED;LITTLE_OPTIMIZED" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS;PRECOMPILE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "asperity_library(${name}): unknown ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(kind STATIC)
  if(arg_SHARED)
    set(kind SHARED)
  endif()
  add_library(asperity_${name} ${kind} ${arg_SOURCES})
  add_library(asperity::${name} ALIAS asperity_${name})
  set_target_properties(asperity_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  set_target_properties(asperity_${name} PROPERTIES UNITY_BUILD ${ASPERITY_UNITY}
    UNITY_BUILD_BATCH_SIZE ${ASPERITY_UNITY_BATCH})
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE folder)
  string(REGEX REPLACE "/.*" "" folder ${folder})
  asperity_show(asperity_${name} PUBLIC ${folder})
  target_link_libraries(asperity_${name}
    PUBLIC ${arg_DEPENDS} PRIVATE asperity_flags ${arg_PRIVATE_DEPENDS})
  if(arg_LITTLE_OPTIMIZED)
    target_compile_options(asperity_${name} PRIVATE ${asperity_o1})
  endif()
  if(arg_PRECOMPILE)
    target_precompile_headers(asperity_${name} PRIVATE ${arg_PRECOMPILE})
  endif()
endfunction()

# What every test includes is compiled once, and tests are optimised less than
# the libraries they call: half of the compiler's time for a test.
set(test_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> ${asperity_o1}
  $<$<CONFIG:Debug>:-O0>)
if(BUILD_TESTING)
  find_package(GTest REQUIRED)
  file(WRITE ${CMAKE_BINARY_DIR}/test_headers.cpp "")
  add_library(asperity_test_headers OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(asperity_test_headers PRIVATE asperity_flags GTest::gtest)
  target_compile_options(asperity_test_headers PRIVATE ${test_options})
  target_precompile_headers(asperity_test_headers PRIVATE <gtest/gtest.h> <algorithm>
    <array> <cmath> <complex> <filesystem> <fstream> <functional> <map> <memory>
    <numeric> <optional> <random> <span> <sstream> <string> <vector>)
  add_library(asperity_test_main STATIC ${PROJECT_SOURCE_DIR}/tests/main.cpp)
  target_link_libraries(asperity_test_main PUBLIC asperity::base asperity_test_sources
    asperity_flags GTest::gtest)
endif()

# The unit tests that do not load deal.II: what tests/sanitizers/run builds.
add_custom_target(asperity_fast_tests)

set(ASPERITY_UNIT_SECONDS 60 CACHE STRING "CPU time that one unit test may take [s]")

# asperity_tests(theory DEPENDS asperity::theory UNIT persson hertz [ANALYTIC ...]
#                [CONVERGENCE ...] [AGREEMENT ...] [GOLDEN ...] [SOURCES file.cpp])
# links the tests of a module, tests/theory/persson_test.cpp and so on, into one
# program, test_theory. Each of these sources is a test of ctest, theory/persson,
# whose label is its tier; test_theory --source persson runs it by hand.
function(asperity_tests program)
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" ""
    "DEPENDS;SOURCES;UNIT;ANALYTIC;CONVERGENCE;AGREEMENT;GOLDEN")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "asperity_tests(${program}): unknown ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(is_fast OFF)
  if(module MATCHES "^(base|cases|contact|exchange|input|md|mechanics|meshes|ranks|results|surfaces|theory)$")
    set(is_fast ON)
  endif()
  set(tiers UNIT ANALYTIC CONVERGENCE AGREEMENT GOLDEN)
  if(ASPERITY_FUZZ AND is_fast)
    set(tiers UNIT) # the others take too long under sanitizers
  endif()
  add_executable(test_${program} ${arg_SOURCES})
  target_link_libraries(test_${program} PRIVATE ${arg_DEPENDS} asperity_flags asperity_test_main)
  target_compile_options(test_${program} PRIVATE ${test_options})
  target_precompile_headers(test_${program} REUSE_FROM asperity_test_headers)
  set_target_properties(test_${program} PROPERTIES UNITY_BUILD ${ASPERITY_UNITY}
    UNITY_BUILD_BATCH_SIZE ${ASPERITY_UNITY_TESTS})
  if(is_fast)
    add_dependencies(asperity_fast_tests test_${program})
  endif()
  foreach(tier IN LISTS tiers)
    string(TOLOWER ${tier} label)
    # A unit test that takes longer than its tier allows is killed. CPU time, which
    # a busy machine does not change; a sanitizer makes it some times longer.
    set(launch "")
    if(tier STREQUAL UNIT)
      set(launch sh -c "ulimit -S -t ${ASPERITY_UNIT_SECONDS} && exec \"$0\" \"$@\"")
      if(is_fast)
        list(APPEND label fast)
      endif()
    endif()
    foreach(name IN LISTS arg_${tier})
      target_sources(test_${program} PRIVATE ${name}_test.cpp)
      add_test(NAME ${module}/${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
        COMMAND ${launch} $<TARGET_FILE:test_${program}> --source ${name})
      set_tests_properties(${module}/${name} PROPERTIES LABELS "${label}" TIMEOUT 600)
      # OpenMPI keeps memory to the end of the process, so what loads it cannot
      # pass the leak checker of the preset sanitizers.
      if(module MATCHES "^(exchange|fem|methods|program|reports|results|robustness|run)$")
        set_tests_properties(${module}/${name} PROPERTIES ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
      endif()
    endforeach()
  endforeach()
endfunction()

# Programs that measure are built and run by hand, and by `ctest -C ci`, which runs
# some of each once, so that they keep working.
add_custom_target(asperity_benchmarks)

# asperity_benchmark(md/green DEPENDS asperity::md [SMOKE regex]) builds
# tests/md/green_bench.cpp with Google Benchmark; `ctest -C ci` runs those that match
# the regex.
function(asperity_benchmark path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SMOKE" "DEPENDS")
  string(MAKE_C_IDENTIFIER "bench_${path}" target)
  add_executable(${target} EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/${path}_bench.cpp)
  add_dependencies(asperity_benchmarks ${target})
  target_link_libraries(${target}
    PRIVATE ${arg_DEPENDS} asperity_test_sources asperity_flags benchmark::benchmark_main)
  if(arg_SMOKE)
    add_test(NAME bench/${path} CONFIGURATIONS ci
      COMMAND ${target} --benchmark_filter=${arg_SMOKE} --benchmark_min_time=0.001)
    set_tests_properties(bench/${path} PROPERTIES LABELS bench TIMEOUT 120)
  endif()
endfunction()
