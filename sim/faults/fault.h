#pragma once
// The faults that the emulated robot can have, as `tp100-sim faults` lists them, and one as given
// on the command line.

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/time.h"

namespace tp100::sim {

enum class FaultKind : std::uint8_t {
  // bytes of the cable
  kFlip,
  kDrop,
  kDuplicate,
  kInsert,
  kNoise,
  kDelimiter,
  kTruncate,
  kFuse,
  kChatter,
  // time
  kDelay,
  kJitter,
  kBatch,
  kStall,
  kDrift,
  kWrap,
  kClockStep,
  kSyncLate,
  kSyncTwice,
  // link
  kCut,
  kUnplug,
  kReboot,
  kRebootLoop,
  kHang,
  // protocol
  kVersion,
  kSchema,
  kBoard,
  kUnknownMessage,
  kReplay,
  kSequence,
  // sensors
  kEncoderStuck,
  kEncoderSilent,
  kEncoderLose,
  kEncoderFlip,
  kEncoderJump,
  kImuMissing,
  kImuFrozen,
  kImuSaturated,
  kBattery,
  // host
  kHostStall,
};

/// Meaning of a fault's word.
enum class FaultWord : std::uint8_t {
  kNone,
  kDirection,  ///< to-host, to-robot; without: both
  kSide,       ///< left, right; without: both
};

/// A kind of fault that the emulator can inject.
struct InjectableFault {
  FaultKind kind;
  std::string_view name;
  std::string_view group;
  std::string_view number;  ///< name and unit of its number; empty: no number
  double standard, least, most;
  FaultWord word;
  bool at_once;  ///< true: occurs once, at its beginning; false: lasts
  std::string_view what;
};

/// All faults, group by group.
std::span<const InjectableFault> injectable_faults();
const InjectableFault& injectable_fault(FaultKind kind);

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
/// (default: for ever). Throws SetupError.
PlannedFault parse_fault(std::string_view text);
std::vector<PlannedFault> parse_faults(const std::vector<std::string>& texts);

}  // namespace tp100::sim
