// The bytes of a port: each that comes is in a frame or counted, and frames leave as they were
// queued.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>
#include <vector>

#include "link/frame_reader.h"
#include "link/output_queue.h"
#include "support/sequence.h"
#include "support/wire_host.h"

namespace tp100::link {
namespace {

using test::frame_of;
using Bytes = std::vector<std::uint8_t>;

/// A frame as a bad line may pass it on. `damage` 0: whole; 1: one bit flipped; 2: cut short; 3:
/// far too long; 4: only its delimiter.
Bytes damaged(Bytes frame, int damage, test::Sequence& random) {
  const int size = static_cast<int>(frame.size());
  if (damage == 1) {
    std::uint8_t& byte = frame.at(static_cast<std::size_t>(random.below(size - 1)));
    const int bit = 1 << random.below(8);
    // A byte that became a delimiter would make two frames of one.
    byte ^= static_cast<std::uint8_t>(byte != bit ? bit : bit == 1 ? 2 : 1);
  }
  if (damage == 2) {
    frame.resize(static_cast<std::size_t>(1 + random.below(size - 2)));
    frame.push_back(wire::kDelimiter);
  }
  if (damage == 3) frame.insert(frame.begin(), wire::kMaxFrame + 10, 0x01);
  if (damage == 4) frame = {wire::kDelimiter};
  return frame;
}

TEST(FrameReader, EachFrameIsReadOrCountedOnceAndWhatComesBeforeTheFirstIsForeign) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    test::Sequence random(seed);
    LinkCounters counters{};
    FrameReader reader(counters);
    std::uint64_t good = 0, corrupted = 0, foreign = 0;
    bool begun = false;
    const auto count_bad = [&](std::size_t bytes) {
      (begun ? corrupted : foreign) += begun ? 1 : bytes;
    };
    for (std::uint16_t id = 0; id < 300; ++id) {
      const wire::SyncReply sent{id, 0x01000200U, 9, 0, 1};
      const int damage = random.below(8);
      const Bytes bytes = damaged(frame_of(sent), damage, random);
      bool read = false;
      for (const std::uint8_t byte : bytes) read = reader.push(byte);
      ASSERT_EQ(read, damage == 0 || damage > 4);
      if (read) {
        wire::SyncReply got{};
        ASSERT_TRUE(wire::read_payload(reader.payload(), reader.size(), got));
        EXPECT_EQ(reader.type(), static_cast<std::uint8_t>(wire::Type::kSyncReply));
        EXPECT_EQ(got.id, id);
        EXPECT_EQ(reader.frame_bytes(), bytes.size());
        ++good;
        begun = true;
      } else if (damage != 4 || !begun) {
        count_bad(bytes.size());
      }
      if (random.chance(0.1)) {
        // The port goes in the middle of a frame, or of one that never ends.
        const Bytes cut(random.chance(0.5) ? 5 : 300, 0x55);
        for (const std::uint8_t byte : cut) reader.push(byte);
        reader.reset();
        count_bad(cut.size());
        begun = false;
      }
      ASSERT_EQ(counters.frames_in, good);
      ASSERT_EQ(counters.corrupted(), corrupted);
      ASSERT_EQ(counters.foreign_bytes, foreign);
    }
  }
}

TEST(FrameReader, ABadFrameIsCountedByItsCause) {
  Bytes oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(wire::kDelimiter);
  struct Case {
    std::uint64_t LinkCounters::*cause;
    Bytes bytes;
  };
  const Case cases[] = {{&LinkCounters::oversize, oversize},
                        {&LinkCounters::cobs_errors, {0x09, 'x', 'y', 0x00}},
                        {&LinkCounters::undersize, {0x02, 'x', 0x00}},
                        {&LinkCounters::crc_errors, {0x05, 'x', 'y', 'z', 'u', 0x00}}};
  LinkCounters counters{};
  FrameReader reader(counters);
  for (const std::uint8_t byte : frame_of(wire::Disarm{7})) reader.push(byte);
  for (const Case& each : cases) {
    for (const std::uint8_t byte : each.bytes) reader.push(byte);
    EXPECT_EQ(counters.*each.cause, 1U);
  }
  EXPECT_EQ(counters.corrupted(), 4U);
}

TEST(OutputQueueTest, FramesLeaveWholeAndInOrderOrAreCountedHoweverThePortTakesThem) {
  constexpr std::size_t kRoom = 160;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    test::Sequence random(seed);
    LinkCounters counters{}, robots{};
    OutputQueue<kRoom> queue(counters);
    FrameReader robot(robots);
    std::deque<std::uint16_t> waiting;  // numbers of the frames whose ends have not left
    // Frames that were dropped; the delimiter of the next one may still end one that was cut.
    std::set<std::uint16_t> dropped;
    std::uint64_t unwritten = 0, bytes_out = 0, late = 0;
    const auto forget = [&] {
      dropped.insert(waiting.begin(), waiting.end());
      waiting.clear();
    };
    // What the robot got before may be half a frame, so that the next one begins with a delimiter.
    bool between_frames = false, begins_anew = true;
    for (std::uint16_t id = 0; id < 600; ++id) {
      const std::size_t size = queue.bytes().size();
      const auto below = [&](std::size_t limit) {
        return static_cast<std::size_t>(random.below(static_cast<int>(limit)));
      };
      const std::size_t what = below(24);
      if (what < 10) {
        const std::size_t frame = frame_of(wire::SyncRequest{id}).size();
        const bool fits = size + frame + 1 <= kRoom;
        ASSERT_EQ(queue.push(wire::SyncRequest{id}), fits ? frame : 0);
        ASSERT_EQ(queue.bytes().size(), size + (fits ? frame + (begins_anew ? 1 : 0) : 0));
        if (fits) waiting.push_back(id);
        unwritten += fits ? 0 : 1;
        begins_anew = begins_anew && !fits;
      } else if (what < 13 && !begins_anew) {
        const std::size_t spare = below(90);
        ASSERT_EQ(queue.pad(spare), std::min(spare, kRoom - size));
      } else if (what < 22) {
        const std::size_t n = what == 21 ? size : below(size + 1);
        for (const std::uint8_t byte : queue.bytes().first(n)) {
          between_frames = byte == wire::kDelimiter;
          ++bytes_out;
          if (!robot.push(byte)) continue;
          wire::SyncRequest got{};
          ASSERT_TRUE(wire::read_payload(robot.payload(), robot.size(), got));
          late += dropped.count(got.id);
          if (dropped.contains(got.id)) continue;
          ASSERT_EQ(got.id, waiting.at(0));
          waiting.pop_front();
        }
        queue.written(what == 21 ? kRoom : n);
      } else if (what == 22) {
        unwritten += waiting.size();
        forget();
        queue.drop();
        begins_anew = !between_frames;
      } else if (what == 23 && random.chance(0.3)) {
        forget();
        queue.reset();
        between_frames = false;
        begins_anew = true;
      }
      ASSERT_EQ(counters.frames_out, robots.frames_in - late);
      ASSERT_EQ(counters.bytes_out, bytes_out);
      ASSERT_EQ(counters.unwritten, unwritten);
    }
    EXPECT_GT(counters.frames_out, 50U);
    EXPECT_GT(counters.unwritten, 10U);
  }
}

}  // namespace
}  // namespace tp100::link
