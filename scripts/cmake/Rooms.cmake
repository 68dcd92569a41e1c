# A room is one folder of sources and one CMake target. A room sees the headers of the rooms it
# names in DEPENDS and no others: each room's folder is reachable only through a directory of its
# own, so an include that the plan forbids does not compile.

add_library(tp100_options INTERFACE)
target_compile_options(tp100_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion -Wformat=2 -Werror
  # Bit-identical runs need the same rounding whatever the optimiser fuses.
  -ffp-contract=off)
if(TP100_SANITIZE)
  target_compile_options(tp100_options INTERFACE
    -fsanitize=${TP100_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # Sanitizers make GCC report paths that cannot happen with these two.
    -Wno-null-dereference $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(tp100_options INTERFACE -fsanitize=${TP100_SANITIZE})
  if(TP100_SANITIZE MATCHES "address.*undefined")
    # The address sanitizer sees these too; they take a third of the compiler's time.
    target_compile_options(tp100_options INTERFACE -fno-sanitize=null,object-size)
  endif()
endif()

# tp100_room(NAME PREFIX <include prefix> [SOURCES ...] [DEPENDS rooms...] [LIBRARIES targets...]
#            [PRIVATE_LIBRARIES targets...])
# Headers of the room are included as "<PREFIX>/<header>.h".
function(tp100_room name)
  cmake_parse_arguments(ROOM "" "PREFIX" "SOURCES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(view ${CMAKE_BINARY_DIR}/rooms/${name})
  cmake_path(GET ROOM_PREFIX PARENT_PATH parent)
  file(MAKE_DIRECTORY ${view}/${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/${ROOM_PREFIX} SYMBOLIC)

  list(TRANSFORM ROOM_DEPENDS PREPEND "tp100_")
  if(ROOM_SOURCES)
    add_library(tp100_${name} STATIC ${ROOM_SOURCES})
    target_include_directories(tp100_${name} PUBLIC ${view})
    target_link_libraries(tp100_${name}
      PUBLIC ${ROOM_DEPENDS} ${ROOM_LIBRARIES}
      PRIVATE tp100_options ${ROOM_PRIVATE_LIBRARIES})
  else()
    add_library(tp100_${name} INTERFACE)
    target_include_directories(tp100_${name} INTERFACE ${view})
    target_link_libraries(tp100_${name} INTERFACE ${ROOM_DEPENDS} ${ROOM_LIBRARIES})
  endif()
endfunction()

# tp100_test(NAME SOURCES ... DEPENDS rooms... [LABELS ...] [LIBRARIES ...] [LONG <regex>]
#            [ALL <regex>] [NIGHTLY <regex>])
# Of the labels "realtime" says that a test waits more than it computes: many run at once, and nothing that computes beside
# them; "threads" that it starts threads, or programs of ours that do: under the thread sanitizer only those are built
# and run, the others have nothing that it could find. LONG, ALL and NIGHTLY match how names of tests (Suite.Name)
# begin: LONG ones are started first, ALL and NIGHTLY ones are left to scripts/test --all and --nightly.
function(tp100_test name)
  cmake_parse_arguments(TEST "" "LONG;ALL;NIGHTLY" "SOURCES;DEPENDS;LABELS;LIBRARIES" ${ARGN})
  list(TRANSFORM TEST_DEPENDS PREPEND "tp100_")
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE tp100_options tp100_test_options tp100_test_time
    ${TEST_DEPENDS} ${TEST_LIBRARIES} GTest::gmock GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM tp100_test_headers)
  target_include_directories(${name} PRIVATE ${CMAKE_BINARY_DIR}/tests/paths)
  if(TP100_SANITIZE STREQUAL "thread" AND NOT "threads" IN_LIST TEST_LABELS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
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
  file(WRITE ${properties} "${text}endforeach()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${properties})
endfunction()
