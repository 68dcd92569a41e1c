#!/usr/bin/env python3
"""What scripts/skipped.py makes of a ctest run of a small project: each skipped test with its reason, no other."""
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROJECT = r"""
cmake_minimum_required(VERSION 3.25)
project(skipping NONE)
enable_testing()
add_test(NAME program COMMAND sh -c "echo 'skipped: no qemu'; exit 77")
add_test(NAME script COMMAND sh -c "echo 'engines: skipped: needs root' >&2; exit 77")
add_test(NAME silent COMMAND sh -c "exit 77")
add_test(NAME passed COMMAND sh -c "echo 'skipped: a word in passing'")
add_test(NAME failed COMMAND sh -c "echo 'skipped: not this one'; exit 1")
add_test(NAME Gtest.Case COMMAND printf "[ RUN      ] A.B\\n/a.cpp:33: Skipped\\nno\\nkernel\\n\\n[  SKIPPED ] A.B (0 ms)\\n")
set_tests_properties(program script silent PROPERTIES SKIP_RETURN_CODE 77)
set_tests_properties(Gtest.Case PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
"""
ALL = """skipped, 4 of 6 tests:
  program: no qemu
  script: needs root
  silent: it does not say why
  Gtest.Case: no kernel
"""


def said(folder, *tests):
    subprocess.run(["ctest", "--test-dir", folder, *tests], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   check=False)
    return subprocess.run([sys.executable, ROOT + "/scripts/skipped.py", folder], text=True, stdout=subprocess.PIPE,
                          check=True).stdout


def main():
    with tempfile.TemporaryDirectory(prefix="tp100-skipped-") as folder:
        with open(folder + "/CMakeLists.txt", "w", encoding="utf-8") as file:
            file.write(PROJECT)
        subprocess.run(["cmake", "-S", folder, "-B", folder + "/build"], stdout=subprocess.DEVNULL, check=True)
        for tests, wanted in ((("--parallel", "2"), ALL), (("-R", "passed"), "")):
            if (got := said(folder + "/build", *tests)) != wanted:
                sys.exit(f"failed: ctest {' '.join(tests)}: expected\n{wanted}got\n{got}")


if __name__ == "__main__":
    main()
