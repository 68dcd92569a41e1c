#pragma once
// The faults that the emulated robot can have, as `tp100-sim faults` lists them, and one as given
// on the command line.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/time.h"

namespace tp100::sim {

/// Meaning of a fault's word.
enum class FaultWord : std::uint8_t {
  kNone,
  kDirection,  ///< to-host, to-robot; without: both
  kSide,       ///< left, right; without: both
};

/// A kind of fault that the emulator can inject.
struct InjectableFault {
  std::string_view name;
  std::string_view group;
  std::string_view number;  ///< name and unit of its number; empty: no number
  double standard, least, most;
  FaultWord word;
  bool at_once;  ///< true: occurs once, at its beginning; false: lasts
  std::string_view what;
};

/// All faults, group by group.
inline constexpr auto kInjectableFaults = std::to_array<InjectableFault>({
    {"flip", "bytes", "share of the bytes", 0.001, 0, 1, FaultWord::kDirection, false,
     "one bit of a byte is inverted"},
    {"drop", "bytes", "share of the bytes", 0.001, 0, 1, FaultWord::kDirection, false,
     "a byte is missing"},
    {"duplicate", "bytes", "share of the bytes", 0.001, 0, 1, FaultWord::kDirection, false,
     "a byte arrives twice"},
    {"insert", "bytes", "share of the bytes", 0.001, 0, 1, FaultWord::kDirection, false,
     "a spurious byte is inserted between two"},
    {"noise", "bytes", "bytes", 64, 1, 100000, FaultWord::kDirection, true,
     "a burst of random bytes; to the robot at the cable's speed, to the host all at once"},
    {"delimiter", "bytes", "share of the bytes", 0.001, 0, 1, FaultWord::kDirection, false,
     "a byte becomes a frame delimiter"},
    {"truncate", "bytes", "share of the frames", 0.05, 0, 1, FaultWord::kDirection, false,
     "a frame loses what follows its eighth byte"},
    {"fuse", "bytes", "share of the frames", 0.05, 0, 1, FaultWord::kDirection, false,
     "the delimiter between two frames is missing"},
    {"chatter", "bytes", "period, ms", 333, 1, 60000, FaultWord::kDirection, false,
     "a modem manager's AT commands, or a boot banner, between the frames"},
    {"delay", "time", "ms", 20, 0, 10000, FaultWord::kDirection, false, "every byte is delayed"},
    {"jitter", "time", "most, ms", 5, 0, 1000, FaultWord::kDirection, false,
     "every frame is delayed by a random time; the order is kept"},
    {"batch", "time", "ms", 16, 1, 1000, FaultWord::kDirection, false,
     "bytes arrive in bursts, as from a USB bridge with a latency timer"},
    {"stall", "time", "ms", 100, 1, 60000, FaultWord::kDirection, true,
     "nothing arrives for a while, then all of it at once"},
    {"drift", "time", "ppm", 100, -5000, 5000, FaultWord::kNone, false,
     "the board's clock runs fast (from power-on, whatever time is given)"},
    {"wrap", "time", "", 0, 0, 0, FaultWord::kNone, true,
     "the board's 32-bit clock wraps to 0 (as after 71.6 minutes)"},
    {"clock-step", "time", "ms", 500, -60000, 60000, FaultWord::kNone, false,
     "times in the robot's messages jump"},
    {"sync-late", "time", "ms", 30, 1, 1000, FaultWord::kNone, false,
     "answers to clock requests are delayed"},
    {"sync-twice", "time", "", 0, 0, 0, FaultWord::kNone, false,
     "answers to clock requests arrive twice"},
    {"cut", "link", "", 0, 0, 0, FaultWord::kDirection, false,
     "bytes are lost while the port stays open (half-open with one direction)"},
    {"unplug", "link", "s", 1, 0.01, 3600, FaultWord::kNone, true,
     "the port disappears and returns, under another number if it has one; the board "
     "restarts"},
    {"reboot", "link", "", 0, 0, 0, FaultWord::kNone, true, "the board restarts"},
    {"reboot-loop", "link", "period, s", 0.5, 0.05, 3600, FaultWord::kNone, false,
     "the board restarts again and again"},
    {"hang", "link", "", 0, 0, 0, FaultWord::kNone, true,
     "the firmware's main loop hangs until the watchdog resets the board (board avr)"},
    {"version", "protocol", "version", 2, 0, 65535, FaultWord::kNone, false,
     "hello names another protocol"},
    {"schema", "protocol", "", 0, 0, 0, FaultWord::kNone, false,
     "hello names other messages of the same protocol"},
    {"board", "protocol", "number", 77, 0, 255, FaultWord::kNone, false,
     "hello names another board"},
    {"unknown-message", "protocol", "type", 0x3F, 0, 255, FaultWord::kDirection, false,
     "a valid frame of an unknown type follows each frame"},
    {"replay", "protocol", "frames back", 20, 1, 200, FaultWord::kDirection, false,
     "an old frame follows each frame"},
    {"sequence", "protocol", "", 0, 0, 0, FaultWord::kNone, false,
     "sample numbers restart at 0 while the board runs on"},
    {"encoder-stuck", "sensor", "", 0, 0, 0, FaultWord::kSide, false,
     "the encoder gives no edges, whatever the track does"},
    {"encoder-silent", "sensor", "", 0, 0, 0, FaultWord::kSide, false,
     "phase B is dead: the count alternates between two values"},
    {"encoder-lose", "sensor", "share of the edges", 0.5, 0, 1, FaultWord::kSide, false,
     "edges are lost, as if the disk slipped on its axle"},
    {"encoder-flip", "sensor", "", 0, 0, 0, FaultWord::kSide, false,
     "phases A and B are swapped: the encoder counts backwards"},
    {"encoder-jump", "sensor", "counts", 500, -30000, 30000, FaultWord::kSide, true,
     "the count jumps without any motion"},
    {"imu-missing", "sensor", "", 0, 0, 0, FaultWord::kNone, false, "the MPU6050 does not answer"},
    {"imu-frozen", "sensor", "", 0, 0, 0, FaultWord::kNone, false,
     "the MPU6050 always answers with the same values"},
    {"imu-saturated", "sensor", "", 0, 0, 0, FaultWord::kNone, false,
     "gyro and accelerometer read full scale"},
    {"battery", "sensor", "V", 5.5, 0, 20, FaultWord::kNone, false,
     "the battery divider reads another voltage"},
    {"host-stall", "host", "ms", 300, 1, 60000, FaultWord::kNone, true,
     "the daemon's loop stops for this time (tp100-sim course only; elsewhere stop the daemon)"},
});

/// The place of a fault in this list.
using FaultKind = std::size_t;

/// The fault of that name, which must be in the list.
consteval FaultKind fault_kind(std::string_view name) {
  FaultKind at = 0;
  while (kInjectableFaults[at].name != name) ++at;
  return at;
}

/// One fault as given on the command line.
struct PlannedFault {
  FaultKind kind{};
  double number = 0.0;  ///< in the unit of the list
  bool to_host = true, to_robot = true;
  bool left = true, right = true;
  HostNs begin_ns = 0;  ///< since the port was opened
  HostNs end_ns = std::numeric_limits<std::int64_t>::max();

  bool active(HostNs at_ns) const { return at_ns >= begin_ns && at_ns < end_ns; }
};

/// Parses NAME[:NUMBER][:WORD][@T[+D]]: from T s after the port was opened (default 0), for D s
/// (default: for ever). Throws UserError.
PlannedFault parse_fault(std::string_view text);
std::vector<PlannedFault> parse_faults(const std::vector<std::string>& texts);

}  // namespace tp100::sim
