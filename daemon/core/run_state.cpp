#include "core/run_state.h"

namespace tp100 {

std::string_view to_string(RunState state) {
  switch (state) {
    case RunState::kIdle:
      return "idle";
    case RunState::kArming:
      return "arming";
    case RunState::kRunning:
      return "running";
    case RunState::kFinished:
      return "finished";
    case RunState::kAborted:
      return "aborted";
    case RunState::kDriving:
      return "driving";
  }
  return "unknown";
}

std::string_view to_string(StartRefusal refusal) {
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
      return "the robot's motors are on without being asked; press STOP";
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
  }
  return "unknown";
}

}  // namespace tp100
