// Frames, and properties of FrameDecoder for random hostile streams.
#include "wire/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace tp100::wire {
namespace {

TEST(Crc16, HasTheCheckValueOfIbm3740) {
  const char* text = "123456789";
  EXPECT_EQ(crc16(reinterpret_cast<const uint8_t*>(text), 9), 0x29B1);
}

TEST(Frame, RefusesAPayloadThatNoBufferHolds) {
  uint8_t payload[kMaxPayload + 1] = {};
  uint8_t frame[kMaxFrame];
  EXPECT_EQ(encode_frame(1, payload, sizeof payload, frame), 0u);
}

using Bytes = std::vector<std::uint8_t>;

struct Frame {
  std::uint8_t type;
  Bytes payload;
  bool operator==(const Frame&) const = default;
};

struct Outcome {
  std::vector<Frame> frames;
  std::map<DecodeResult, int> losses;
  int lost() const {
    int sum = 0;
    for (const auto& [cause, count] : losses) sum += count;
    return sum;
  }
};

// Decodes between two guards, which would show an overflow of the decoder's buffer.
Outcome decode(const Bytes& stream, std::size_t forgotten = 0) {
  constexpr std::uint64_t kGuard = 0xA5A5A5A5A5A5A5A5U;
  struct {
    std::uint64_t before = kGuard;
    FrameDecoder decoder;
    std::uint64_t after = kGuard;
  } guarded;
  FrameDecoder& decoder = guarded.decoder;
  Outcome outcome;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    if (i == forgotten) decoder.reset();
    const DecodeResult received = decoder.push(stream[i]);
    EXPECT_LE(decoder.size(), kMaxPayload);
    if (received == DecodeResult::kFrame) {
      outcome.frames.push_back(
          {decoder.type(), Bytes(decoder.payload(), decoder.payload() + decoder.size())});
    } else if (received != DecodeResult::kNothing) {
      ++outcome.losses[received];
    }
  }
  EXPECT_TRUE(guarded.before == kGuard && guarded.after == kGuard);
  return outcome;
}

Bytes coded(const Frame& frame) {
  Bytes out(kMaxFrame);
  out.resize(encode_frame(frame.type, frame.payload.data(), frame.payload.size(), out.data()));
  return out;
}

// Payloads with many zeros, as in real frames. The first two bytes hold the frame's number, so that
// no two frames are equal.
std::vector<Frame> random_frames(std::mt19937& random, std::size_t count) {
  std::vector<Frame> frames;
  for (std::size_t n = 0; n < count; ++n) {
    Frame frame{static_cast<std::uint8_t>(random() % 256), Bytes(2 + random() % (kMaxPayload - 1))};
    for (std::uint8_t& byte : frame.payload) {
      byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    }
    frame.payload[0] = static_cast<std::uint8_t>(n);
    frame.payload[1] = static_cast<std::uint8_t>(n >> 8);
    frames.push_back(frame);
  }
  return frames;
}

Bytes join(const std::vector<Frame>& frames) {
  Bytes stream;
  for (const Frame& frame : frames) {
    const Bytes bytes = coded(frame);
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  }
  return stream;
}

// Number of frames in `sent` that are missing in `received`; -1 if a received frame was never sent.
int missing(const std::vector<Frame>& sent, const std::vector<Frame>& received) {
  std::size_t at = 0;
  for (const Frame& frame : received) {
    while (at < sent.size() && !(sent[at] == frame)) ++at;
    if (at == sent.size()) return -1;
    ++at;
  }
  return static_cast<int>(sent.size() - received.size());
}

class DecoderProperty : public testing::TestWithParam<unsigned> {
 protected:
  std::mt19937 random_{GetParam()};
};

// Any bytes, few delimiters, and small codes, of which many decode.
TEST_P(DecoderProperty, RandomBytesNeverOverflow) {
  Bytes stream(200000);
  for (std::uint8_t& byte : stream) {
    byte = static_cast<std::uint8_t>(random_() % (GetParam() % 3 == 0 ? 24 : 256));
    if (GetParam() % 3 == 1 && byte == 0 && random_() % 8 != 0) byte = 1;
  }
  EXPECT_GT(decode(stream).lost(), 50);
}

TEST_P(DecoderProperty, AStreamMayBeJoinedAnywhere) {
  const std::vector<Frame> frames = random_frames(random_, 20);
  const Bytes stream = join(frames);
  for (std::size_t from = 0; from < stream.size(); ++from) {
    const Outcome outcome = decode(Bytes(stream.begin() + static_cast<long>(from), stream.end()));
    ASSERT_GE(missing(frames, outcome.frames), 0) << from;
    ASSERT_LE(outcome.lost(), 1) << from;
    // All frames after the first delimiter in the stream must be decoded.
    const auto delimiters = std::count(stream.begin() + static_cast<long>(from), stream.end(), 0);
    ASSERT_GE(static_cast<long>(outcome.frames.size()), delimiters - 1) << from;
  }
}

TEST_P(DecoderProperty, OneFlippedBitCostsItsFrameAndAtMostOneMore) {
  const std::vector<Frame> frames = random_frames(random_, 12);
  const Bytes stream = join(frames);
  for (std::size_t bit = 0; bit < stream.size() * 8; ++bit) {
    Bytes corrupted = stream;
    corrupted[bit / 8] = static_cast<std::uint8_t>(corrupted[bit / 8] ^ (1U << (bit % 8)));
    // If the last delimiter is corrupted, the delimiter of the next frame replaces it.
    corrupted.push_back(kDelimiter);
    const Outcome outcome = decode(corrupted);
    const int gone = missing(frames, outcome.frames);
    ASSERT_GE(gone, 1) << "bit " << bit;
    const bool delimiter = stream[bit / 8] == kDelimiter;
    ASSERT_LE(gone, delimiter ? 2 : 1) << "bit " << bit;
    ASSERT_GE(outcome.lost(), 1) << "bit " << bit;
    ASSERT_LE(outcome.lost(), 2) << "bit " << bit;
  }
}

TEST_P(DecoderProperty, ATruncatedFrameCostsItselfAndAtMostTheNext) {
  const std::vector<Frame> frames = random_frames(random_, 3);
  const Bytes first = coded(frames[0]), second = coded(frames[1]), third = coded(frames[2]);
  for (std::size_t keep = 0; keep < second.size(); ++keep) {
    Bytes stream = first;
    stream.insert(stream.end(), second.begin(), second.begin() + static_cast<long>(keep));
    const std::size_t cut = stream.size();
    stream.insert(stream.end(), third.begin(), third.end());
    stream.insert(stream.end(), third.begin(), third.end());
    const Outcome outcome = decode(stream);
    ASSERT_GE(outcome.frames.size(), 2u) << keep;
    ASSERT_EQ(outcome.frames.front(), frames[0]) << keep;
    ASSERT_EQ(outcome.frames.back(), frames[2]) << keep;
    ASSERT_EQ(outcome.lost(), keep == 0 ? 0 : 1) << keep;
    // On a new connection the half frame is forgotten.
    EXPECT_EQ(decode(stream, cut).frames, (std::vector{frames[0], frames[2], frames[2]})) << keep;
  }
}

TEST_P(DecoderProperty, OversizeIsCountedOnceAndSkippedToTheNextDelimiter) {
  const std::vector<Frame> frames = random_frames(random_, 2);
  for (const std::size_t length : {kMaxFrame, kMaxFrame + 1, std::size_t{5000}}) {
    Bytes stream = coded(frames[0]);
    for (std::size_t i = 0; i < length; ++i)
      stream.push_back(static_cast<std::uint8_t>(1 + random_() % 255));
    const std::size_t cut = stream.size();
    stream.push_back(kDelimiter);
    const Bytes second = coded(frames[1]);
    stream.insert(stream.end(), second.begin(), second.end());
    const Outcome outcome = decode(stream);
    EXPECT_EQ(outcome.frames, frames);
    EXPECT_EQ(outcome.losses, (std::map<DecodeResult, int>{{DecodeResult::kOversize, 1}}));
    stream.erase(stream.begin() + static_cast<long>(cut));
    EXPECT_EQ(decode(stream, cut).frames, frames) << "a new connection begins with a frame";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DecoderProperty, testing::Range(1U, 9U),
                         testing::PrintToStringParamName());

TEST(Decoder, NamesTheCauseOfEveryLoss) {
  const std::vector<std::pair<Bytes, DecodeResult>> bad = {
      {{0x05, 0x01, 0x00}, DecodeResult::kCobs},
      {{0xFF, 0x01, 0x00}, DecodeResult::kCobs},
      {{0x03, 0x01, 0x02, 0x00}, DecodeResult::kShort},
      {{0x01, 0x00}, DecodeResult::kShort},
      {{0x04, 0x01, 0x02, 0x03, 0x00}, DecodeResult::kCrc}};
  for (const auto& [frame, cause] : bad)
    EXPECT_EQ(decode(frame).losses, (std::map<DecodeResult, int>{{cause, 1}}));
  EXPECT_EQ(decode({0x00, 0x00, 0x00}).lost(), 0) << "spare delimiters are no loss";
}

// A code that points beyond the end of its frame must be refused: the byte there belongs to another
// frame.
TEST(Decoder, ACodeMayPointToTheEndOfItsFrameAndNoFurther) {
  for (std::size_t coded = 1; coded < kMaxFrame; ++coded) {
    for (std::size_t code = 1; code <= 0xFF; ++code) {
      Bytes stream{static_cast<std::uint8_t>(code)};
      // The stream holds the block that the code begins, followed by empty blocks.
      while (stream.size() < coded) stream.push_back(stream.size() < code ? 0x11 : 0x01);
      stream.push_back(kDelimiter);
      const std::map<DecodeResult, int> losses = decode(stream).losses;
      ASSERT_EQ(losses.size(), 1U) << coded << " " << code;
      EXPECT_EQ(losses.begin()->first == DecodeResult::kCobs, code > coded) << coded << " " << code;
    }
  }
}

}  // namespace
}  // namespace tp100::wire
