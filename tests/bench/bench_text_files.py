"""The paper's exchange: a script at the robot's port and an engine in another process, joined by two text files.

The script writes what the robot sent to Encoder.txt, the engine polls it and writes a pose to Orientation.txt, which
the script polls before it answers the robot. Usage: bench_text_files.py PORT POLL_S
"""
import os
import subprocess
import sys
import tempfile
import time
import tty


def wait_for_change(path, last, poll_s):
    """Waits until the file's first word differs from `last`; returns its words."""
    while True:
        try:
            with open(path) as file:
                text = file.read()
            # The file may be half written.
            if text.endswith("\n") and text.split()[0] != last:
                return text.split()
        except FileNotFoundError:
            pass
        if poll_s > 0.0:
            time.sleep(poll_s)


def write(path, *words):
    with open(path, "w") as file:
        file.write(" ".join(map(str, words)) + "\n")


def engine(folder, poll_s):
    last, x_m = "", 0.0
    while True:
        last, left, right = wait_for_change(os.path.join(folder, "Encoder.txt"), last, poll_s)
        x_m += (float(left) + float(right)) / 2.0 * 0.005
        write(os.path.join(folder, "Orientation.txt"), last, x_m, 0.0, 0.0)


def robot(folder, path, poll_s):
    port = os.open(path, os.O_RDWR | os.O_NOCTTY)
    tty.setraw(port)
    frame, number = b"", 0
    while True:
        frame += os.read(port, 4096)
        if not frame.endswith(b"\0"):
            continue
        number += 1
        write(os.path.join(folder, "Encoder.txt"), number, 0.1, 0.1)
        wait_for_change(os.path.join(folder, "Orientation.txt"), str(number - 1) if number > 1 else "", poll_s)
        os.write(port, frame)
        frame = b""


def main():
    if sys.argv[1] == "--engine":
        engine(sys.argv[2], float(sys.argv[3]))
    with tempfile.TemporaryDirectory(prefix="tp100-bench-") as folder:
        other = subprocess.Popen([sys.executable, __file__, "--engine", folder, sys.argv[2]])
        try:
            robot(folder, sys.argv[1], float(sys.argv[2]))
        finally:
            other.kill()
            other.wait()


if __name__ == "__main__":
    main()
