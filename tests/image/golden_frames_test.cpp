#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "sim/board/avr_board.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

std::vector<std::uint8_t> golden_bytes() {
  std::ifstream file(source_path("tests/wire/golden_frames.txt"));
  std::vector<std::uint8_t> bytes;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    for (std::size_t at = line.rfind(' ') + 1; at + 1 < line.size(); at += 2) {
      bytes.push_back(static_cast<std::uint8_t>(std::stoi(line.substr(at, 2), nullptr, 16)));
    }
  }
  return bytes;
}

TEST(GoldenFrames, AreDecodedAndCodedByteForByteOnTheMega) {
  const std::vector<std::uint8_t> golden = golden_bytes();
  ASSERT_GT(golden.size(), 300u);
  AvrBoard mega({.image = build_path("firmware/image/golden_mega.elf")}, nullptr);
  mega.reset(PowerUp::kPowerOn, 0);
  std::vector<std::uint8_t> sent;
  for (std::int64_t ms = 1; ms <= 200; ++ms) {
    mega.advance(ms * 1'000'000, {}, {});
    for (const TimedByte& byte : mega.take_sent()) sent.push_back(byte.value);
  }
  EXPECT_EQ(sent, golden);
}

}  // namespace
}  // namespace tp100::sim
