#include "wire/frame.h"

#include <gtest/gtest.h>

#include <cstring>

namespace tp100::wire {
namespace {

TEST(Crc16, HasTheCheckValueOfIbm3740) {
  const char* text = "123456789";
  EXPECT_EQ(crc16(reinterpret_cast<const uint8_t*>(text), 9), 0x29B1);
}

TEST(Frame, RoundTripsEverySizeWithAndWithoutZeros) {
  for (size_t size = 0; size <= kMaxPayload; ++size) {
    for (int pattern = 0; pattern < 3; ++pattern) {
      uint8_t payload[kMaxPayload];
      for (size_t i = 0; i < size; ++i) {
        payload[i] = static_cast<uint8_t>(pattern == 0 ? 0 : pattern == 1 ? i + 1 : i % 3);
      }
      uint8_t frame[kMaxFrame];
      const size_t length = encode_frame(0x42, payload, size, frame);
      ASSERT_LE(length, kMaxFrame);
      FrameDecoder decoder;
      for (size_t i = 0; i + 1 < length; ++i) {
        ASSERT_NE(frame[i], kDelimiter);
        ASSERT_EQ(decoder.push(frame[i]), DecodeResult::kNothing);
      }
      ASSERT_EQ(decoder.push(frame[length - 1]), DecodeResult::kFrame);
      ASSERT_EQ(decoder.type(), 0x42);
      ASSERT_EQ(decoder.size(), size);
      ASSERT_EQ(memcmp(decoder.payload(), payload, size), 0);
    }
  }
}

TEST(Frame, RefusesAPayloadThatNoBufferHolds) {
  uint8_t payload[kMaxPayload + 1] = {};
  uint8_t frame[kMaxFrame];
  EXPECT_EQ(encode_frame(1, payload, sizeof payload, frame), 0u);
}

}  // namespace
}  // namespace tp100::wire
