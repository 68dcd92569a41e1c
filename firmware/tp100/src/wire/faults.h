// The only list of faults. A robot detects those of bits 0 to 15, latches them and sends them in
// every sample. The daemon detects the others and some of the robot's, and latches the faults that
// end a run, its own or the robot's. A latched fault keeps the motors off until the next start. The
// robot clears its own when it accepts an arm message; it refuses one only for faults that it
// detects at standstill: no session, no fresh command, IMU missing or stale, battery low. A track
// that stalls or turns in the wrong direction is detected again when it is driven.
#ifndef TP100_WIRE_FAULTS_H
#define TP100_WIRE_FAULTS_H

#include <stdint.h>

// X(bit, name, cause, fix)
#define TP100_ROBOT_FAULTS(X)                                                                      \
  X(0, command_timeout, "no fresh valid command for 200 ms",                                       \
    "check the cable and that the daemon runs; start again")                                       \
  X(1, stop_requested, "STOP was pressed", "make sure that the robot is free; start again")        \
  X(2, watchdog_reset, "the main loop hung and the watchdog restarted the board",                  \
    "update the firmware (scripts/flash, installed: tp100-flash); report it if it happens again")  \
  X(3, brown_out, "the supply voltage of the board dropped and the board restarted",               \
    "charge the battery, check the power wiring")                                                  \
  X(4, loop_hung, "the main loop did not run for 100 ms; motors were switched off by the timer",   \
    "check the I2C wiring of the MPU6050")                                                         \
  X(5, imu_missing, "the MPU6050 does not answer at I2C address 0x68",                             \
    "check SDA (20), SCL (21), its supply and AD0 to ground, or use set-up stand")                 \
  X(6, imu_stale, "the MPU6050 stopped delivering new values",                                     \
    "check the I2C wiring; the firmware re-initialises the sensor by itself")                      \
  X(7, battery_low, "the battery is below the cut-off voltage", "charge the battery")              \
  X(8, stalled_left,                                                                               \
    "the left track is driven but does not move, or its encoder counts less than the track moves", \
    "free the track; check the plugs of motor and encoder")                                        \
  X(9, stalled_right,                                                                              \
    "the right track is driven but does not move, or its encoder counts less than the track "      \
    "moves",                                                                                       \
    "free the track; check the plugs of motor and encoder")                                        \
  X(10, reversed_left, "the left track moves against its duty",                                    \
    "swap the motor leads or set drive.invert_left_motor / drive.invert_left_encoder")             \
  X(11, reversed_right, "the right track moves against its duty",                                  \
    "swap the motor leads or set drive.invert_right_motor / drive.invert_right_encoder")           \
  X(12, parameters_missing, "the board has no parameters yet", "wait for the handshake to finish")

#define TP100_DAEMON_FAULTS(X)                                                                    \
  X(16, link_lost, "the link broke, or no sample arrived for 200 ms",                             \
    "check the cable; the daemon reconnects by itself, then start again")                         \
  X(17, robot_rebooted, "the board restarted during the run", "check its supply; start again")    \
  X(18, cross_track, "the robot left the path by more than control.max_cross_track_m",            \
    "put it back to the start; identify the robot if it happens again")                           \
  X(19, heading,                                                                                  \
    "the heading error stayed above control.max_heading_error_deg, or the robot turned "          \
    "against the command",                                                                        \
    "check gyro sign and tracks; identify the robot")                                             \
  X(20, tilt, "roll or pitch exceeds control.max_tilt_deg", "set the robot upright")              \
  X(21, fence, "the reference point left the fence of the course",                                \
    "put the robot back to the start")                                                            \
  X(22, time_limit, "the run took longer than control.time_limit_factor allows",                  \
    "check for a slipping track and a low battery")                                               \
  X(23, stalled_track, "a track stands still although it is commanded to move", "free the track") \
  X(24, battery_below_minimum, "the battery voltage is below control.min_battery_v",              \
    "charge the battery")                                                                         \
  X(25, encoders_against_duty,                                                                    \
    "a track turns against its duty, or much less than its duty requires",                        \
    "check motor and encoder wiring, then drive.dead_band and drive.feed_forward")                \
  X(26, gyro_against_encoders,                                                                    \
    "gyro and encoders disagree about the turn (lost counts, or a mis-wired yaw loop)",           \
    "check both encoders, which track is left, and the gyro; identify the robot")                 \
  X(27, not_acknowledged,                                                                         \
    "the robot refused arm or disarm, did not confirm it in time, or disarmed by itself",         \
    "remove the cause of a refusal, which the log names; otherwise check the cable")              \
  X(28, samples_stale, "samples arrive too late to control the robot",                            \
    "check USB hub and host load")                                                                \
  X(29, immobilised,                                                                              \
    "the tracks run but the robot does not move, or does not get over the obstacle",              \
    "free the robot; clean tracks and floor; if it does move, check the set-up (terrain: "        \
    "the floor has the map's ramps and blocks) and the camera's image")                           \
  X(30, world_lost, "the external world is silent, too slow or was restarted",                    \
    "check the world's program; start again once the log reports the world as connected")         \
  X(31, moves_unasked, "the robot is armed or drives its motors without a request",               \
    "switch the motors' supply off; flash the board (scripts/flash, installed: tp100-flash)")     \
  X(32, camera_against_odometry,                                                                  \
    "camera contradicts odometry: the image stands still, is mirrored, turned or scaled, "        \
    "or shows another marker; or the robot was moved",                                            \
    "check the camera's image, its view file and the markers; place the robot or put it to the "  \
    "start")                                                                                      \
  X(33, world_against_odometry,                                                                   \
    "world contradicts odometry: the external world's robot does not move as the real one",       \
    "check the world's units, frame and robot; put the robot back to the start")

namespace tp100 {
namespace wire {

/// Fault bits; values are positions in a FaultMask.
enum class Fault : uint8_t {
#define TP100_FAULT(bit, name, cause, fix) name = (bit),
  TP100_ROBOT_FAULTS(TP100_FAULT) TP100_DAEMON_FAULTS(TP100_FAULT)
#undef TP100_FAULT
};

/// One bit per fault: bits 0 to 15 are the robot's and those that the wire carries; the daemon's
/// are bits 16 to 63.
typedef uint64_t FaultMask;

/// Mask of one fault.
constexpr FaultMask fault_bit(Fault fault) {
  return static_cast<FaultMask>(1) << static_cast<uint8_t>(fault);
}

}  // namespace wire
}  // namespace tp100

#endif
