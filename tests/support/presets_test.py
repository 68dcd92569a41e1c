#!/usr/bin/env python3
"""scripts/test with CTest arguments, on a small project: which presets it builds, and how it ends."""
import os
import shutil
import subprocess
import tempfile

from verdict import ROOT, check

PRESETS = ("dev", "asan", "tsan", "fuzz")
PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(presets NONE)
enable_testing()
cmake_path(GET CMAKE_BINARY_DIR FILENAME preset)
add_custom_target(built ALL COMMAND ${CMAKE_COMMAND} -E touch built)
add_custom_target(fuzzers DEPENDS built)
add_custom_target(nightly_tests)
if(preset STREQUAL "dev")
  add_test(NAME arm64.make COMMAND true)
  set_tests_properties(arm64.make PROPERTIES LABELS "arm64;nightly")
endif()
if(NOT preset STREQUAL "tsan")
  add_test(NAME fuzz.wire COMMAND true)
endif()
if(preset STREQUAL "dev" OR preset STREQUAL "asan")
  # As gtest_discover_tests does.
  file(WRITE ${CMAKE_BINARY_DIR}/discovered.cmake "if(EXISTS ${CMAKE_BINARY_DIR}/built)
  add_test(Suite.Name true --gtest_filter=Suite.Name)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_BINARY_DIR}/discovered.cmake)
endif()
"""


def presets():
    """CMakePresets.json of the small project."""
    named = [f'"name": "{name}"' for name in PRESETS]
    configure = ", ".join(f'{{{name}, "generator": "Ninja", "binaryDir": "${{sourceDir}}/build/${{presetName}}"}}'
                          for name in named)
    use = ", ".join(f'{{{name}, "configurePreset": "{preset}"}}' for name, preset in zip(named, PRESETS))
    return f'{{"version": 6, "configurePresets": [{configure}], "buildPresets": [{use}], "testPresets": [{use}]}}'


def main():
    with tempfile.TemporaryDirectory(prefix="tp100-presets-") as tree:
        shutil.copytree(ROOT + "/scripts", tree + "/scripts")
        for path, text in ((tree + "/CMakeLists.txt", PROJECT), (tree + "/CMakePresets.json", presets()),
                           (tree + "/scripts/setup", "#!/bin/sh\n")):  # every package is there
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)

        def expect(status, built, *arguments):
            shutil.rmtree(tree + "/build", ignore_errors=True)
            ended = subprocess.run([tree + "/scripts/test", *arguments], text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, check=False)
            got = [preset for preset in PRESETS if os.path.exists(f"{tree}/build/{preset}/built")]
            check(ended.returncode == status and got == built,
                  f"scripts/test {' '.join(arguments)}: status {ended.returncode}, built {got}\n{ended.stdout}")
            check((status != 0) == ("test: no test of that name" in ended.stdout), ended.stdout)

        expect(0, ["dev"], "--nightly", "-L", "arm64")
        expect(0, ["dev", "asan", "fuzz"], "--nightly", "-R", "fuzz.wire")
        # The tests of a test program are known only after a build.
        expect(0, [*PRESETS], "--nightly", "-R", "Suite")
        expect(1, ["dev"], "--nightly", "-R", "no_such_test")


if __name__ == "__main__":
    main()
