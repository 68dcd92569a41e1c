#include "sim/faults/fault_kind.h"

#include <algorithm>
#include <array>

namespace tp100::sim {
namespace {

using enum FaultKind;
using enum FaultWord;

constexpr std::array kTexts = std::to_array<FaultText>({
    {kFlip, "flip", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "one bit of a byte is turned over"},
    {kDrop, "drop", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte is missing"},
    {kDuplicate, "duplicate", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte comes twice"},
    {kInsert, "insert", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte that nobody sent comes between two"},
    {kNoise, "noise", "bytes", "bytes", 64, 1, 100000, kDirection, true,
     "a burst of random bytes; to the robot at the cable's speed, to the host all at once"},
    {kDelimiter, "delimiter", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte becomes a frame's end"},
    {kTruncate, "truncate", "bytes", "share of the frames", 0.05, 0, 1, kDirection, false,
     "a frame loses what follows its eighth byte"},
    {kFuse, "fuse", "bytes", "share of the frames", 0.05, 0, 1, kDirection, false,
     "the end between two frames is missing"},
    {kChatter, "chatter", "bytes", "period, ms", 333, 1, 60000, kDirection, false,
     "a modem manager's AT commands, or a boot banner, between the frames"},
    {kDelay, "delay", "time", "ms", 20, 0, 10000, kDirection, false, "every byte comes later"},
    {kJitter, "jitter", "time", "most, ms", 5, 0, 1000, kDirection, false,
     "every frame comes later by a time of its own; none overtakes"},
    {kBatch, "batch", "time", "ms", 16, 1, 1000, kDirection, false,
     "bytes come in heaps, as from a USB bridge with a latency timer"},
    {kStall, "stall", "time", "ms", 100, 1, 60000, kDirection, true,
     "nothing comes for a while, then all of it at once"},
    {kDrift, "drift", "time", "ppm", 100, -5000, 5000, kNone, false,
     "the board's clock runs fast (from power-on, whatever the time says)"},
    {kWrap, "wrap", "time", "", 0, 0, 0, kNone, true,
     "the board's 32-bit clock begins again from 0 (its 71.6 minutes are over)"},
    {kClockStep, "clock-step", "time", "ms", 500, -60000, 60000, kNone, false,
     "times in the robot's messages jump"},
    {kSyncLate, "sync-late", "time", "ms", 30, 1, 1000, kNone, false,
     "answers to clock requests wait on their way"},
    {kSyncTwice, "sync-twice", "time", "", 0, 0, 0, kNone, false,
     "answers to clock requests come twice"},
    {kCut, "cut", "link", "", 0, 0, 0, kDirection, false,
     "bytes are lost while the port stays open (half-open with one direction)"},
    {kUnplug, "unplug", "link", "s", 1, 0.01, 3600, kNone, true,
     "the port goes away and comes back, under another number where it has one; the board "
     "restarts"},
    {kReboot, "reboot", "link", "", 0, 0, 0, kNone, true, "the board restarts"},
    {kRebootLoop, "reboot-loop", "link", "period, s", 0.5, 0.05, 3600, kNone, false,
     "the board restarts again and again"},
    {kHang, "hang", "link", "", 0, 0, 0, kNone, true,
     "the firmware's main loop turns in one place until the watchdog bites (board avr)"},
    {kVersion, "version", "protocol", "version", 2, 0, 65535, kNone, false,
     "hello names another protocol"},
    {kSchema, "schema", "protocol", "", 0, 0, 0, kNone, false,
     "hello names other messages of the same protocol"},
    {kBoard, "board", "protocol", "number", 77, 0, 255, kNone, false, "hello names another board"},
    {kUnknownMessage, "unknown-message", "protocol", "type", 0x3F, 0, 255, kDirection, false,
     "after each frame a good one of a type that nobody knows"},
    {kReplay, "replay", "protocol", "frames back", 20, 1, 200, kDirection, false,
     "after each frame an old one again"},
    {kSequence, "sequence", "protocol", "", 0, 0, 0, kNone, false,
     "samples count from 0 again while the board runs on"},
    {kEncoderStuck, "encoder-stuck", "sensor", "", 0, 0, 0, kSide, false,
     "no more edges, whatever the belt does"},
    {kEncoderSilent, "encoder-silent", "sensor", "", 0, 0, 0, kSide, false,
     "phase B is dead: the count goes one up and one down"},
    {kEncoderLose, "encoder-lose", "sensor", "share of the edges", 0.5, 0, 1, kSide, false,
     "edges are lost, as of a disk that slips on its axle: less is counted than the track moves"},
    {kEncoderFlip, "encoder-flip", "sensor", "", 0, 0, 0, kSide, false,
     "phases A and B are swapped: it counts the other way"},
    {kEncoderJump, "encoder-jump", "sensor", "counts", 500, -30000, 30000, kSide, true,
     "counts that no belt made"},
    {kImuMissing, "imu-missing", "sensor", "", 0, 0, 0, kNone, false,
     "the MPU6050 does not answer"},
    {kImuFrozen, "imu-frozen", "sensor", "", 0, 0, 0, kNone, false,
     "the MPU6050 answers with the same values for ever"},
    {kImuSaturated, "imu-saturated", "sensor", "", 0, 0, 0, kNone, false,
     "gyro and accelerometer at full scale"},
    {kBattery, "battery", "sensor", "V, both cells", 5.5, 0, 20, kNone, false,
     "the battery divider shows another voltage"},
    {kHostStall, "host-stall", "host", "ms", 300, 1, 60000, kNone, true,
     "the daemon's loop stands still (tp100-sim course; stop the daemon for it elsewhere)"},
});

}  // namespace

std::span<const FaultText> fault_texts() { return kTexts; }

const FaultText& text_of(FaultKind kind) {
  return *std::find_if(kTexts.begin(), kTexts.end(),
                       [&](const FaultText& text) { return text.kind == kind; });
}

}  // namespace tp100::sim
