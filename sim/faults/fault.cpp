#include "sim/faults/fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/time.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::sim {
namespace {

using enum FaultKind;
using enum FaultWord;

constexpr std::array kInjectableFaults = std::to_array<InjectableFault>({
    {kFlip, "flip", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "one bit of a byte is inverted"},
    {kDrop, "drop", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte is missing"},
    {kDuplicate, "duplicate", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte arrives twice"},
    {kInsert, "insert", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a spurious byte is inserted between two"},
    {kNoise, "noise", "bytes", "bytes", 64, 1, 100000, kDirection, true,
     "a burst of random bytes; to the robot at the cable's speed, to the host all at once"},
    {kDelimiter, "delimiter", "bytes", "share of the bytes", 0.001, 0, 1, kDirection, false,
     "a byte becomes a frame delimiter"},
    {kTruncate, "truncate", "bytes", "share of the frames", 0.05, 0, 1, kDirection, false,
     "a frame loses what follows its eighth byte"},
    {kFuse, "fuse", "bytes", "share of the frames", 0.05, 0, 1, kDirection, false,
     "the delimiter between two frames is missing"},
    {kChatter, "chatter", "bytes", "period, ms", 333, 1, 60000, kDirection, false,
     "a modem manager's AT commands, or a boot banner, between the frames"},
    {kDelay, "delay", "time", "ms", 20, 0, 10000, kDirection, false, "every byte is delayed"},
    {kJitter, "jitter", "time", "most, ms", 5, 0, 1000, kDirection, false,
     "every frame is delayed by a random time; the order is kept"},
    {kBatch, "batch", "time", "ms", 16, 1, 1000, kDirection, false,
     "bytes arrive in bursts, as from a USB bridge with a latency timer"},
    {kStall, "stall", "time", "ms", 100, 1, 60000, kDirection, true,
     "nothing arrives for a while, then all of it at once"},
    {kDrift, "drift", "time", "ppm", 100, -5000, 5000, kNone, false,
     "the board's clock runs fast (from power-on, whatever time is given)"},
    {kWrap, "wrap", "time", "", 0, 0, 0, kNone, true,
     "the board's 32-bit clock wraps to 0 (as after 71.6 minutes)"},
    {kClockStep, "clock-step", "time", "ms", 500, -60000, 60000, kNone, false,
     "times in the robot's messages jump"},
    {kSyncLate, "sync-late", "time", "ms", 30, 1, 1000, kNone, false,
     "answers to clock requests are delayed"},
    {kSyncTwice, "sync-twice", "time", "", 0, 0, 0, kNone, false,
     "answers to clock requests arrive twice"},
    {kCut, "cut", "link", "", 0, 0, 0, kDirection, false,
     "bytes are lost while the port stays open (half-open with one direction)"},
    {kUnplug, "unplug", "link", "s", 1, 0.01, 3600, kNone, true,
     "the port disappears and returns, under another number if it has one; the board "
     "restarts"},
    {kReboot, "reboot", "link", "", 0, 0, 0, kNone, true, "the board restarts"},
    {kRebootLoop, "reboot-loop", "link", "period, s", 0.5, 0.05, 3600, kNone, false,
     "the board restarts again and again"},
    {kHang, "hang", "link", "", 0, 0, 0, kNone, true,
     "the firmware's main loop hangs until the watchdog resets the board (board avr)"},
    {kVersion, "version", "protocol", "version", 2, 0, 65535, kNone, false,
     "hello names another protocol"},
    {kSchema, "schema", "protocol", "", 0, 0, 0, kNone, false,
     "hello names other messages of the same protocol"},
    {kBoard, "board", "protocol", "number", 77, 0, 255, kNone, false, "hello names another board"},
    {kUnknownMessage, "unknown-message", "protocol", "type", 0x3F, 0, 255, kDirection, false,
     "a valid frame of an unknown type follows each frame"},
    {kReplay, "replay", "protocol", "frames back", 20, 1, 200, kDirection, false,
     "an old frame follows each frame"},
    {kSequence, "sequence", "protocol", "", 0, 0, 0, kNone, false,
     "sample numbers restart at 0 while the board runs on"},
    {kEncoderStuck, "encoder-stuck", "sensor", "", 0, 0, 0, kSide, false,
     "the encoder gives no edges, whatever the track does"},
    {kEncoderSilent, "encoder-silent", "sensor", "", 0, 0, 0, kSide, false,
     "phase B is dead: the count alternates between two values"},
    {kEncoderLose, "encoder-lose", "sensor", "share of the edges", 0.5, 0, 1, kSide, false,
     "edges are lost, as if the disk slipped on its axle"},
    {kEncoderFlip, "encoder-flip", "sensor", "", 0, 0, 0, kSide, false,
     "phases A and B are swapped: the encoder counts backwards"},
    {kEncoderJump, "encoder-jump", "sensor", "counts", 500, -30000, 30000, kSide, true,
     "the count jumps without any motion"},
    {kImuMissing, "imu-missing", "sensor", "", 0, 0, 0, kNone, false,
     "the MPU6050 does not answer"},
    {kImuFrozen, "imu-frozen", "sensor", "", 0, 0, 0, kNone, false,
     "the MPU6050 always answers with the same values"},
    {kImuSaturated, "imu-saturated", "sensor", "", 0, 0, 0, kNone, false,
     "gyro and accelerometer read full scale"},
    {kBattery, "battery", "sensor", "V", 5.5, 0, 20, kNone, false,
     "the battery divider reads another voltage"},
    {kHostStall, "host-stall", "host", "ms", 300, 1, 60000, kNone, true,
     "the daemon's loop stops for this time (tp100-sim course only; elsewhere stop the daemon)"},
});

constexpr double kMaxS = 1e6;

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw SetupError("--fault " + text::one_line(std::string(text)) + ": " + why +
                   "; see tp100-sim faults");
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Removes and returns the part before `mark`; also removes `mark`.
std::string_view cut(std::string_view& rest, char mark) {
  const std::size_t at = rest.find(mark);
  const std::string_view head = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return head;
}

const InjectableFault& kind_named(std::string_view name, std::string_view whole) {
  std::vector<std::string_view> names;
  for (const InjectableFault& row : injectable_faults()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  refuse(whole, "no such fault" + text::suggestion(name, names));
}

bool take_word(std::string_view word, FaultWord kind, PlannedFault& fault) {
  if (kind == FaultWord::kDirection && (word == "to-host" || word == "to-robot")) {
    fault.to_host = word == "to-host";
    fault.to_robot = !fault.to_host;
    return true;
  }
  if (kind == FaultWord::kSide && (word == "left" || word == "right")) {
    fault.left = word == "left";
    fault.right = !fault.left;
    return true;
  }
  return false;
}

void take_number(std::string_view word, const InjectableFault& row, std::string_view whole,
                 PlannedFault& fault) {
  const std::optional<double> number = row.number.empty() ? std::nullopt : number_of(word);
  if (!number)
    refuse(whole, "'" + text::one_line(std::string(word)) + "' says nothing about " +
                      std::string(row.name));
  if (*number < row.least || *number > row.most)
    refuse(whole, std::string(row.number) + " is out of range");
  fault.number = *number;
}

HostNs time_of(std::string_view text, std::string_view whole) {
  const std::optional<double> seconds = number_of(text);
  if (!seconds || *seconds < 0.0 || *seconds > kMaxS)
    refuse(whole, "'" + text::one_line(std::string(text)) + "' is no time in seconds");
  return from_s(*seconds);
}

}  // namespace

std::span<const InjectableFault> injectable_faults() { return kInjectableFaults; }

const InjectableFault& injectable_fault(FaultKind kind) {
  return *std::find_if(kInjectableFaults.begin(), kInjectableFaults.end(),
                       [&](const InjectableFault& row) { return row.kind == kind; });
}

PlannedFault parse_fault(std::string_view whole) {
  std::string_view when = whole;
  std::string_view what = cut(when, '@');
  const bool timed = what.size() < whole.size();
  const InjectableFault& row = kind_named(cut(what, ':'), whole);
  PlannedFault fault{.kind = row.kind, .number = row.standard};
  while (!what.empty()) {
    const std::string_view word = cut(what, ':');
    if (!take_word(word, row.word, fault)) take_number(word, row, whole, fault);
  }
  if (!timed) return fault;
  const bool ends = when.find('+') != std::string_view::npos;
  fault.begin_ns = time_of(cut(when, '+'), whole);
  if (ends && row.at_once) refuse(whole, "happens once and does not last");
  if (ends) fault.end_ns = fault.begin_ns + time_of(when, whole);
  return fault;
}

std::vector<PlannedFault> parse_faults(const std::vector<std::string>& texts) {
  std::vector<PlannedFault> faults;
  faults.reserve(texts.size());
  for (const std::string& text : texts) faults.push_back(parse_fault(text));
  return faults;
}

}  // namespace tp100::sim
