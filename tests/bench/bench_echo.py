"""Answers each frame received on a port with the same frame, in Python. Usage: bench_echo.py PORT"""
import os
import sys
import tty

port = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
tty.setraw(port)
frame = b""
while True:
    frame += os.read(port, 4096)
    if frame.endswith(b"\0"):
        os.write(port, frame)
        frame = b""
