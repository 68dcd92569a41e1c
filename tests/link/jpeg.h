#pragma once
// Data with the JPEG headers that the daemon checks; the rest is not an image.

#include <string>

namespace tp100::test {

inline std::string word(unsigned value) {
  return {static_cast<char>(value >> 8U), static_cast<char>(value & 0xffU)};
}

/// The header of a baseline frame of one component, with its marker.
inline std::string frame_header(unsigned width_px, unsigned height_px) {
  return "\xff\xc0" + word(11) + "\x08" + word(height_px) + word(width_px) + "\x01" +
         std::string("\x01\x11\x00", 3);
}

inline std::string jpeg(unsigned width_px, unsigned height_px) {
  const std::string application =
      "\xff\xe0" + word(16) + std::string("JFIF\0\1\1\0\0\1\0\1\0\0", 14);
  const std::string scan = "\xff\xda" + word(8) + std::string("\1\1\0\0\x3f\0", 6);
  return "\xff\xd8" + application + frame_header(width_px, height_px) + scan + "content\xff\xd9";
}

}  // namespace tp100::test
