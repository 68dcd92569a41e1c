#!/usr/bin/env python3
"""image.py FLASH.bin OUT.uf2 MAX_BYTES: puts the CRC into the second boot stage, the first 256 bytes of the flash (RP2040
data sheet, 2.8.1.3.1), and writes the whole as UF2, which a Pico takes as a file on its drive. Fails above the budget."""
import struct
import sys

FLASH = 0x10000000
RP2040 = 0xE48BFF56


def crc32(data):
    """CRC-32 as the ROM computes it: polynomial 0x04c11db7, highest bit first, initial value all ones, not inverted."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def uf2(data):
    blocks = [data[at:at + 256].ljust(256, b"\0") for at in range(0, len(data), 256)]
    for number, block in enumerate(blocks):
        head = struct.pack("<8I", 0x0A324655, 0x9E5D5157, 0x2000, FLASH + 256 * number, 256, number, len(blocks), RP2040)
        yield head + block.ljust(476, b"\0") + struct.pack("<I", 0x0AB16F30)


def main(source, target, most):
    with open(source, "rb") as file:
        data = file.read()
    if len(data) > int(most):
        sys.exit(f"image.py: {source} has {len(data)} bytes, above its budget of {most}")
    with open(target, "wb") as file:
        file.write(b"".join(uf2(data[:252] + struct.pack("<I", crc32(data[:252])) + data[256:])))
    print(f"{target}: {len(data)} of {most} bytes of flash")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("image.py: give FLASH.bin OUT.uf2 MAX_BYTES")
    main(*sys.argv[1:])
