#pragma once
// The faults that the emulated robot can have, as `tp100-sim faults` lists them.

#include <cstdint>
#include <span>
#include <string_view>

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

/// What a fault's word says.
enum class FaultWord : std::uint8_t {
  kNone,
  kDirection,  ///< to-host, to-robot; without: both
  kSide,       ///< left, right; without: both
};

/// One row of the list.
struct FaultText {
  FaultKind kind;
  std::string_view name;
  std::string_view group;
  std::string_view number;  ///< name and unit of its number; empty: it has none
  double standard, least, most;
  FaultWord word;
  bool at_once;  ///< happens once, at its beginning; else it lasts
  std::string_view what;
};

/// All of them, group by group.
std::span<const FaultText> fault_texts();
const FaultText& text_of(FaultKind kind);

}  // namespace tp100::sim
