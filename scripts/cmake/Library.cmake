# A library is one folder of sources and one CMake target. It sees the headers of the folders that it
# depends on, directly or through others, and no others: each folder is reachable only through an
# include directory of its own, so that a forbidden include does not compile (tests/layers).

add_library(tp100_options INTERFACE)
target_compile_options(tp100_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2 -Werror
  # GCC says the first of paths that cannot happen, and the second of any type of a .cpp file that another one
  # includes, as unity builds do.
  $<$<CXX_COMPILER_ID:Clang>:-Wnull-dereference> $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
  # Bit-identical runs need the same rounding whatever the optimiser fuses, and on every processor: Eigen's packets sum
  # in an order of their own, and those of ARM fuse.
  -ffp-contract=off
  # Every checkout gives the same objects, which the compiler cache then has.
  -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
target_compile_definitions(tp100_options INTERFACE EIGEN_DONT_VECTORIZE)
if(TP100_SANITIZE)
  target_compile_options(tp100_options INTERFACE
    -fsanitize=${TP100_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # Sanitizers make GCC report paths that cannot happen.
    -Wno-null-dereference $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(tp100_options INTERFACE -fsanitize=${TP100_SANITIZE})
  if(TP100_SANITIZE MATCHES "address.*undefined")
    # The address sanitizer sees these too; they take a third of the compiler's time.
    target_compile_options(tp100_options INTERFACE -fno-sanitize=null,object-size)
  endif()
endif()

# tp100_library(FOLDER [DEPENDS folders...] [SOURCES generated files...] [EXCLUDE <regex>]
#               [LIBRARIES targets...] [PRIVATE_LIBRARIES targets...])
# Makes the target tp100_<FOLDER>, with / as _, of all .cpp files beside the CMakeLists.txt that calls it, but for
# main.cpp and those that match EXCLUDE. Headers are included as "<FOLDER>/<header>.h".
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
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${view})
    target_link_libraries(${name} INTERFACE ${LIB_DEPENDS} ${LIB_LIBRARIES})
  endif()
  set_property(GLOBAL APPEND PROPERTY TP100_LIBRARIES ${folder})
endfunction()

# tp100_test(NAME SOURCES ... DEPENDS folders... [LABELS ...] [LIBRARIES ...] [LONG <regex>]
#            [ALL <regex>] [NIGHTLY <regex>] [COMPUTE <regex>])
# Of the labels "realtime" says that a test waits more than it computes: many run at once, and nothing that computes beside
# them; "threads" that it starts threads, or programs of ours that do: under the thread sanitizer only those are built
# and run, the others have nothing that it could find. LONG, ALL and NIGHTLY match how names of tests (Suite.Name)
# begin: LONG ones are started first, ALL and NIGHTLY ones are left to scripts/test --all and --nightly. COMPUTE ones of a
# program with "threads" compute for long in threads that its other tests start too: under the thread sanitizer nightly.
function(tp100_test name)
  cmake_parse_arguments(TEST "" "LONG;ALL;NIGHTLY;COMPUTE" "SOURCES;DEPENDS;LABELS;LIBRARIES" ${ARGN})
  if(TP100_SANITIZE STREQUAL "thread" AND TEST_COMPUTE)
    list(APPEND TEST_NIGHTLY ${TEST_COMPUTE})
    list(JOIN TEST_NIGHTLY "|" TEST_NIGHTLY)
  endif()
  list(TRANSFORM TEST_DEPENDS REPLACE / _)
  list(TRANSFORM TEST_DEPENDS PREPEND tp100_)
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE tp100_options tp100_test_options tp100_test_time
    ${TEST_DEPENDS} ${TEST_LIBRARIES} GTest::gmock GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM tp100_test_headers)
  target_include_directories(${name} PRIVATE ${CMAKE_BINARY_DIR}/tests/paths)
  if(TP100_SANITIZE STREQUAL "thread" AND NOT "threads" IN_LIST TEST_LABELS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  # An emulator has no real time, and other tests start programs: tests/arm64 does that.
  if(CMAKE_CROSSCOMPILING AND (NOT "${TEST_LABELS}" MATCHES "^(unit|unit;physics|)$"))
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  # scripts/test runs these nightly only, and builds them then.
  if(TP100_SANITIZE MATCHES address AND "lockstep" IN_LIST TEST_LABELS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(lockstep_tests ${name})
  endif()
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
  endif()
  # A program takes longer to start under a sanitizer than most of its tests: one start for all of them. Tests in real
  # time may need a second try and so stay apart, as do programs with long tests or with such that are not always run.
  if(TP100_SANITIZE AND NOT "realtime" IN_LIST TEST_LABELS AND NOT TEST_LONG AND NOT TEST_ALL AND NOT TEST_NIGHTLY)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT 600
      ENVIRONMENT "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state")
    return()
  endif()
  # A parameter's value may print as bytes, which differ from build to build.
  gtest_discover_tests(${name} TEST_PREFIX "${name}." NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES
    TIMEOUT 300 ENVIRONMENT "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state")
  # Not among the properties above: discovery would keep the first of several labels only.
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
