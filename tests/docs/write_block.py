#!/usr/bin/env python3
"""write_block.py PAGE NAME FOLDER: writes the block of a page that shows the file NAME to FOLDER/NAME."""
import os
import sys

from run_page import blocks


def main():
    page, name, folder = sys.argv[1:]
    shown = [body for _, word, body in blocks(page) if word == name]
    if len(shown) != 1:
        sys.exit(f"{page}: {len(shown)} blocks show {name}, there must be one")
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(shown[0])


if __name__ == "__main__":
    main()
