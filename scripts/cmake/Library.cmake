# A library is one folder of sources and one CMake target. It sees the headers of the folders that it
# depends on, directly or through others, and no others: each folder is reachable only through an
# include directory of its own, so that a forbidden include does not compile (tests/layers).

add_library(tp100_options INTERFACE)
target_compile_options(tp100_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2 -Werror
  # Not of GCC, which warns of impossible paths.
  $<$<CXX_COMPILER_ID:Clang>:-Wnull-dereference>
  # GCC warns of any type of a .cpp file that another one includes, as unity builds do.
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  # Bit-identical runs need the same rounding at every optimisation level and on every processor: no fused multiply-add,
  # and no vectorised Eigen, which sums in another order and fuses on ARM.
  -ffp-contract=off
  # ccache needs the first with precompiled headers; the second makes GCC collect garbage less often (6 to 8 % of time).
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>
  # Every checkout gives the same objects, so that the compiler cache works across checkouts.
  -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
target_compile_definitions(tp100_options INTERFACE EIGEN_DONT_VECTORIZE)
if(TP100_SANITIZE)
  target_compile_options(tp100_options INTERFACE
    -fsanitize=${TP100_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # With sanitizers, GCC warns of impossible paths, and its thread sanitizer of fences, which Asio uses.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-tsan>)
  target_link_options(tp100_options INTERFACE -fsanitize=${TP100_SANITIZE})
  if(TP100_SANITIZE MATCHES "address.*undefined")
    # The address sanitizer detects these too, and they take a third of the compile time.
    target_compile_options(tp100_options INTERFACE -fno-sanitize=null,object-size)
  endif()
endif()

# Without unity builds each file is compiled by itself, with nothing but what it includes. clang's precompiled headers
# depend on the path of the checkout, so that the compiler cache would serve only one.
if(NOT CMAKE_UNITY_BUILD OR CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
# The headers of libraries that most sources include are read once for all of them.
file(WRITE ${CMAKE_BINARY_DIR}/headers.cpp "")
add_library(tp100_headers OBJECT ${CMAKE_BINARY_DIR}/headers.cpp)
target_link_libraries(tp100_headers PRIVATE tp100_options Eigen3::Eigen nlohmann_json::nlohmann_json)
target_precompile_headers(tp100_headers PRIVATE <algorithm> <array> <chrono> <cmath> <filesystem> <fstream> <functional>
  <map> <memory> <optional> <span> <string> <vector> <Eigen/LU> <nlohmann/json.hpp>)

# tp100_library(FOLDER [DEPENDS folders...] [SOURCES generated files...] [EXCLUDE <regex>]
#               [LIBRARIES targets...] [PRIVATE_LIBRARIES targets...])
# Makes the target tp100_<FOLDER> (/ becomes _) from all .cpp files beside the calling CMakeLists.txt except main.cpp
# and those that match EXCLUDE. Headers are included as "<FOLDER>/<header>.h".
function(tp100_library folder)
  cmake_parse_arguments(LIB "" "EXCLUDE" "DEPENDS;SOURCES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  string(REPLACE / _ name tp100_${folder})
  set(view ${CMAKE_BINARY_DIR}/include/${name})
  cmake_path(GET folder PARENT_PATH parent)
  file(MAKE_DIRECTORY ${view}/${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/${folder} SYMBOLIC)

  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(LIB_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "${LIB_EXCLUDE}")
  endif()
  list(APPEND sources ${LIB_SOURCES})
  list(TRANSFORM LIB_DEPENDS REPLACE / _)
  list(TRANSFORM LIB_DEPENDS PREPEND tp100_)
  if(sources)
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC ${view})
    target_link_libraries(${name} PUBLIC ${LIB_DEPENDS} ${LIB_LIBRARIES} PRIVATE tp100_options ${LIB_PRIVATE_LIBRARIES})
    target_precompile_headers(${name} REUSE_FROM tp100_headers)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${view})
    target_link_libraries(${name} INTERFACE ${LIB_DEPENDS} ${LIB_LIBRARIES})
  endif()
  set_property(GLOBAL APPEND PROPERTY TP100_LIBRARIES ${folder})
endfunction()

# tp100_test(NAME SOURCES ... DEPENDS folders... [LABELS ...] [LIBRARIES ...] [LONG <regex>]
#            [ALL <regex>] [NIGHTLY <regex>] [COMPUTE <regex>])
# Label "realtime": the test waits more than it computes, so that many such tests run at once. Label "threads": it starts
# threads, or programs of the project that do. LONG, ALL, NIGHTLY and COMPUTE match the beginnings of test names
# (Suite.Name): LONG tests are started first, ALL and NIGHTLY ones are run only by scripts/test --all and --nightly.
# COMPUTE ones compute for long in code and threads that other tests run too; the sanitizers run them nightly.
# Below --nightly each sanitizer has only the tests that it is for: the address sanitizer those of TP100_READERS, the
# thread sanitizer those with threads. The target nightly_tests builds the others.
function(tp100_test name)
  cmake_parse_arguments(TEST "" "LONG;ALL;NIGHTLY;COMPUTE" "SOURCES;DEPENDS;LABELS;LIBRARIES" ${ARGN})
  if(TP100_SANITIZE AND TEST_COMPUTE)
    list(APPEND TEST_NIGHTLY ${TEST_COMPUTE})
    list(JOIN TEST_NIGHTLY "|" TEST_NIGHTLY)
  endif()
  list(TRANSFORM TEST_DEPENDS REPLACE / _)
  list(TRANSFORM TEST_DEPENDS PREPEND tp100_)
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE tp100_options tp100_test_options tp100_test_paths
    ${TEST_DEPENDS} ${TEST_LIBRARIES} GTest::gmock GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM tp100_test_headers)
  # Under an emulator there is no real time, and tests that start programs are run by tests/arm64.
  if(CMAKE_CROSSCOMPILING AND (NOT "${TEST_LABELS}" MATCHES "^(unit|unit;physics|)$"))
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
  endif()
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
  if((TP100_SANITIZE MATCHES address AND NOT folder IN_LIST TP100_READERS) OR
      (TP100_SANITIZE STREQUAL "thread" AND NOT "threads" IN_LIST TEST_LABELS))
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(nightly_tests ${name})
    list(APPEND TEST_LABELS nightly)
  endif()
  # Under a sanitizer a program takes longer to start than most of its tests: start it once for all of them. Separate
  # starts remain for realtime tests, which may need a second try, and for long tests or tests that are not always run.
  if(TP100_SANITIZE AND NOT "realtime" IN_LIST TEST_LABELS AND NOT TEST_LONG AND NOT TEST_ALL AND NOT TEST_NIGHTLY)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT 600
      ENVIRONMENT "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state")
    return()
  endif()
  # Without values: a parameter's value may be printed as bytes, which differ from build to build.
  gtest_discover_tests(${name} TEST_PREFIX "${name}." NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES
    TIMEOUT 300 ENVIRONMENT "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state")
  # Not among the properties above, because discovery would keep only the first of several labels.
  set(properties ${CMAKE_CURRENT_BINARY_DIR}/${name}_properties.cmake)
  set(text "foreach(test IN LISTS ${name}_TESTS)\n  set(labels \"${TEST_LABELS}\")\n")
  foreach(level ALL NIGHTLY)
    if(TEST_${level})
      string(TOLOWER ${level} label)
      string(APPEND text "  if(test MATCHES [[^[^.]+\\.(${TEST_${level}})]])\n    list(APPEND labels ${label})\n  endif()\n")
    endif()
  endforeach()
  string(APPEND text "  set_tests_properties(\"\${test}\" PROPERTIES LABELS \"\${labels}\")\n")
  if(TEST_LONG)
    string(APPEND text "  if(test MATCHES [[^[^.]+\\.(${TEST_LONG})]])\n"
      "    set_tests_properties(\"\${test}\" PROPERTIES COST 100)\n  endif()\n")
  endif()
  string(APPEND text "endforeach()\nif(NOT ${name}_TESTS)\n"
    "  set_tests_properties(${name}_NOT_BUILT PROPERTIES LABELS \"${TEST_LABELS}\")\nendif()\n")
  file(WRITE ${properties} "${text}")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${properties})
endfunction()
