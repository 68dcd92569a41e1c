#pragma once
// The image that a programmer writes into the flash of an ATmega2560.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tp100::sim {

/// Contents of the flash and, from an ELF file, the addresses of its symbols.
struct AvrImage {
  static constexpr std::uint32_t kFlashSize = 256 * 1024;

  std::string path;
  std::uint32_t begin = 0;          ///< address of the first byte in the flash
  std::vector<std::uint8_t> flash;  ///< gaps are 0xFF
  /// Byte addresses; data starts at 0x800000. Empty for a HEX file.
  std::map<std::string, std::uint32_t> symbols;
};

/// Reads an ELF file or, if it ends in ".hex", an Intel HEX file. Throws UserError.
AvrImage read_avr_image(const std::string& path);

/// The firmware built with this program: <prefix>/share/tp100/tp100.hex of an installed program,
/// else the one of the build tree. Throws UserError with how to build it.
std::string built_firmware();

/// Arduino's bootloader for the Mega 2560 as Debian ships it. Throws UserError.
std::string stock_bootloader();

}  // namespace tp100::sim
