"""Table of a part whose rows a program prints as JSON objects, one a line, on standard input.

Usage: bench_rows.py PART
"""
import json
import sys

from bench_table import Table

PARTS = {
    "decode": ("receiving frames of the wire, median round", [
        ("what", "what", "<40s"), ("frame_bytes", "bytes", "5d"), ("ns_per_frame", "ns/frame", "8.1f"),
        ("slowest_round_ns", "slowest", "8.1f"), ("mb_per_s", "MB/s", "7.1f"),
        ("frames_per_s", "frames/s", "10.3g")]),
}


def main():
    part = sys.argv[1]
    title, columns = PARTS[part]
    table = Table(part, title, columns)
    for line in sys.stdin:
        table.row(**json.loads(line))
    table.save()


if __name__ == "__main__":
    main()
