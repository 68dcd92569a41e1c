#pragma once
// The configuration file (config/tp100.toml) as data. One table of keys in the source file both
// reads it and writes it with meaning, unit, default and range.

#include <string>
#include <vector>

#include "bridge/parameters.h"
#include "config/commands_from.h"
#include "config/world_settings.h"
#include "course/robot.h"
#include "text/key.h"

namespace tp100::config {

/// How the robot is reached.
struct LinkSettings {
  std::string port = "auto";  ///< device path, or "auto": found by its USB ids, see ports.h
  int baud = 500000;
  double timeout_ms = 500.0;               ///< no good frame for this long: link lost
  double first_frame_timeout_ms = 5000.0;  ///< nothing heard for this long: warn
  bool hang_up = false;  ///< HUPCL: closing drops DTR, the next open resets a Mega
};

/// What starts a step.
enum class Pacing {
  kHost,   ///< the host's clock
  kRobot,  ///< the robot's samples, the host's clock if they do not come
};

/// What becomes of turns that are due while one takes too long: loop::OverrunPolicy.
enum class Overrun {
  kSkip,
  kShift,
};

/// The real-time loop.
struct LoopSettings {
  double rate_hz = 200.0;
  Pacing pacing = Pacing::kHost;
  Overrun overrun = Overrun::kSkip;
  int spin_us = 60;   ///< the last part of the wait is spun
  int priority = 80;  ///< SCHED_FIFO; 0: ordinary scheduling
  int cpu = -1;       ///< -1: any
  bool lock_memory = true;
  bool hold_cpu_latency = true;  ///< /dev/cpu_dma_latency at 0
};

/// Where runs are recorded.
struct RecordSettings {
  std::string directory{};  ///< each run gets a folder of its own in it; empty: nothing is recorded
  int max_mb = 2000;
  double black_box_s = 10.0;          ///< kept for a fault (live/black_box.h); 0: nothing
  std::string black_box_directory{};  ///< empty: `directory`, or the user's folder for such things
};

/// Where the overhead camera is heard. What is believed of it is in the parameters.
struct CameraSettings {
  std::string listen;         ///< "udp:[HOST:]PORT"; empty: no camera
  double max_age_ms = 400.0;  ///< older detections are of no use any more
};

/// The page and the viewers.
struct ServerSettings {
  std::string listen = "auto";  ///< HOST:PORT, "auto" or "off"
  CommandsFrom commands = CommandsFrom::kLocal;
  std::string origins;  ///< permitted besides the page's own, separated by spaces
  std::string hosts;    ///< names in Host besides addresses and localhost
  int max_clients = 64;
};

/// Everything that a file can set. Privileges that the system refuses are reported, not fatal.
struct Configuration {
  std::string robot = "end-loaded";  ///< bundled name or file
  std::string course;                ///< bundled name or file; empty: none, the robot stands still
  LinkSettings link{};
  LoopSettings loop{};
  CameraSettings camera{};
  RecordSettings record{};
  WorldSettings world{};  ///< whether there is one is in the parameters
  ServerSettings server{};
  bridge::Parameters parameters{};  ///< model and drive are the robot's: see bridge_parameters
};

/// Parses a configuration file. `file` is only used in messages. Throws SetupError
/// (file:line:column). Pure: reads no file itself.
Configuration parse_configuration(const std::string& text, const std::string& file);

/// A commented file that parse_configuration reads back.
std::string write_configuration(const Configuration& configuration);

/// Every key with its value, in the order of the file.
std::vector<text::KeyText> configuration_keys(const Configuration& configuration);

/// Settings of the step for this robot: the configuration's, with the robot's model and drive
/// values.
bridge::Parameters bridge_parameters(const Configuration& configuration,
                                     const course::Robot& robot);

}  // namespace tp100::config
