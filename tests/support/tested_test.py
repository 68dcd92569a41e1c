#!/usr/bin/env python3
"""tests/tested.py on ctest runs of a small project: skips and second tries."""
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
add_test(NAME Gtest.Case COMMAND printf "[ RUN      ] A.B\\n/a.cpp:33: Skipped\\nno\\nkernel\\n\\n[  SKIPPED ] A.B (0 ms)\\n")
set_tests_properties(program script silent PROPERTIES SKIP_RETURN_CODE 77)
set_tests_properties(Gtest.Case PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
foreach(i RANGE 1 4)
  add_test(NAME flaky${i} COMMAND sh -c "if [ -e f${i} ]; then rm f${i}; else touch f${i}; exit 1; fi")
endforeach()
"""
SKIPPED = """skipped, 4 of 5 tests:
  program: no qemu
  script: needs root
  silent: it does not say why
  Gtest.Case: no kernel
"""
UNKNOWN = " (error: tests/SKIPS does not list this reason)"
STRICT = "".join(line + (UNKNOWN if line.startswith("  ") else "") + "\n" for line in SKIPPED.splitlines())


def retried(count):
    return f"second tries: {count} of {count} tests\n" + "".join(f"  flaky{i + 1}\n" for i in range(count))


def main():
    with tempfile.TemporaryDirectory(prefix="tp100-tested-") as folder:
        with open(folder + "/CMakeLists.txt", "w", encoding="utf-8") as file:
            file.write(PROJECT)
        build = folder + "/build"
        subprocess.run(["cmake", "-S", folder, "-B", build], stdout=subprocess.DEVNULL, check=True)

        def expect(wanted, status, tests, *options):
            run = f"{folder}/run"
            subprocess.run(["ctest", "--test-dir", build, "--output-junit", run + ".xml", "--output-log", run + ".log",
                            "--parallel", "2", "-R", tests, "--repeat", "until-pass:2"],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            # The log of the next run must be a new one.
            subprocess.run(["ctest", "--test-dir", build, "-N"], stdout=subprocess.DEVNULL, check=True)
            got = subprocess.run([sys.executable, "-B", ROOT + "/tests/tested.py", *options, run], text=True,
                                 stdout=subprocess.PIPE, check=False)
            if (got.stdout, got.returncode) != (wanted, status):
                sys.exit(f"failed: {tests} {options}: expected {status}\n{wanted}got {got.returncode}\n{got.stdout}")

        skips = "program|script|silent|passed|Gtest"
        expect(SKIPPED, 0, skips)
        expect(STRICT, 1, skips, "--no-skips")
        expect("", 0, "passed", "--no-skips")
        expect(retried(3), 0, "flaky[123]")
        expect(retried(4) + "error: more than 3 tests needed a second try\n", 1, "flaky")


if __name__ == "__main__":
    main()
