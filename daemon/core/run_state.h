#pragma once
// States of a run, as printed in `state: A -> B` and in snapshots, and the reasons that refuse a
// start.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/enum_names.h"

namespace tp100 {

enum class RunState : std::uint8_t {
  kIdle,      ///< no run; commands request a standstill
  kArming,    ///< operator started; robot not armed yet
  kRunning,   ///< following the course
  kFinished,  ///< path completed, robot disarmed
  kAborted,   ///< a fault ended the run, robot disarmed; its cause is latched
  kDriving,   ///< driven by hand, on no course
};

/// Names as printed in `state: A -> B`.
inline constexpr std::array<EnumName<RunState>, 6> kRunStateNames = {{
    {RunState::kIdle, "idle"},
    {RunState::kArming, "arming"},
    {RunState::kRunning, "running"},
    {RunState::kFinished, "finished"},
    {RunState::kAborted, "aborted"},
    {RunState::kDriving, "driving"},
}};
constexpr std::string_view to_string(RunState state) { return name_in(kRunStateNames, state); }

/// The robot is armed: it follows the course or is driven by hand.
constexpr bool armed(RunState state) {
  return state == RunState::kRunning || state == RunState::kDriving;
}

/// Armed or about to be: nothing else can begin.
constexpr bool under_way(RunState state) { return state == RunState::kArming || armed(state); }

/// The first reason that refuses a start of the course, or driving by hand.
enum class StartRefusal : std::uint8_t {
  kNone,
  kNoCourse,
  kUnderWay,       ///< a run is arming or running
  kNoSession,      ///< no robot, or the handshake is not over
  kNoSample,       ///< no fresh sample
  kMotorsOn,       ///< the robot is armed or has a duty without a request
  kUnknownFault,   ///< the robot reports a fault that this version does not know
  kTilted,         ///< by more than control.max_tilt_deg
  kNoImu,          ///< the yaw needs the gyro, and the IMU delivers no values
  kNotStill,       ///< the gyro's bias is not known: it has not been at rest yet
  kNoWorld,        ///< the external world has not answered in time
  kDriven,         ///< the robot is driven by hand
  kWhere,          ///< it may be elsewhere than at the start, and the start does not say where
  kSeenElsewhere,  ///< a camera sees it elsewhere than at the start
  kOffPath,        ///< from where it is, there is no path to continue on
};

/// The reason and what to do, in one line; empty for kNone.
constexpr std::string_view to_string(StartRefusal refusal) {
  switch (refusal) {
    case StartRefusal::kNone:
      return "";
    case StartRefusal::kNoCourse:
      return "no course; start the daemon with --course";
    case StartRefusal::kUnderWay:
      return "a run is under way";
    case StartRefusal::kNoSession:
      return "no robot yet";
    case StartRefusal::kNoSample:
      return "no fresh sample from the robot; check the cable";
    case StartRefusal::kMotorsOn:
      return "the robot's motors are on without a request; press STOP";
    case StartRefusal::kUnknownFault:
      return "the robot reports an unknown fault; update the daemon";
    case StartRefusal::kTilted:
      return "the robot is tilted by more than control.max_tilt_deg; set it upright";
    case StartRefusal::kNoImu:
      return "the MPU6050 delivers no values; check its wiring, or use set-up stand";
    case StartRefusal::kNotStill:
      return "the gyro is not still; leave the robot at rest for a second";
    case StartRefusal::kNoWorld:
      return "the external world does not answer; start its program";
    case StartRefusal::kDriven:
      return "the robot is driven by hand; release it first";
    case StartRefusal::kWhere:
      return "the robot may be elsewhere than at the course's start; say where it stands: "
             "\"start\" "
             "once it is put back there, or \"here\" to continue from the pose that is shown";
    case StartRefusal::kSeenElsewhere:
      return "the overhead camera sees the robot elsewhere than at the course's start; put it "
             "there, or say \"here\" to continue from where it is";
    case StartRefusal::kOffPath:
      return "the robot is beside the path or at its end, so the course cannot continue from here; "
             "put it back at the start, or drive it by hand onto the path";
  }
  return "unknown";
}

/// Why a start is refused for where the robot stands, by what the start says of that.
struct alignas(4) StartPlaces {
  StartRefusal unsaid = StartRefusal::kNone;  ///< nothing: then a run begins at the start
  StartRefusal placed = StartRefusal::kNone;  ///< "it stands at the course's start"
  StartRefusal here = StartRefusal::kNone;    ///< "where it is estimated to be"

  /// Somebody has to say where the robot stands.
  constexpr bool asks() const { return unsaid != StartRefusal::kNone; }
};

}  // namespace tp100
