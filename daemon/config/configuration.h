#pragma once
// The configuration file (config/tp100.toml) as data. One table of keys in the source file is used
// to read it and to write it with meaning, unit, default and range.

#include <array>
#include <string>
#include <vector>

#include "bridge/parameters.h"
#include "config/world_settings.h"
#include "core/enum_names.h"
#include "course/robot_file.h"
#include "text/key.h"

namespace tp100::config {

// Clients whose commands the server accepts; STOP is accepted from all.

enum class CommandsFrom { kLocal, kAll, kNone };
inline constexpr std::array<EnumName<CommandsFrom>, 3> kCommandsFromNames = {{
    {CommandsFrom::kLocal, "local"},
    {CommandsFrom::kAll, "all"},
    {CommandsFrom::kNone, "none"},
}};

/// Connection to the robot.
struct LinkSettings {
  std::string port = "auto";  ///< device path, or "auto": found by its USB ids, see
                              ///< link/port_discovery.h
  int baud = 500000;
  double timeout_ms = 500.0;               ///< no valid frame for this long: link lost
  double first_frame_timeout_ms = 5000.0;  ///< nothing received for this long: warn
  double clock_answer_ms = 200.0;          ///< later answers to clock requests are not used
  bool hang_up = false;  ///< HUPCL: closing drops DTR, the next open resets a Mega
};

/// What starts a step.
enum class Pacing {
  kHost,   ///< the host's clock
  kRobot,  ///< the robot's samples; the host's clock if there are none
};
inline constexpr std::array<EnumName<Pacing>, 2> kPacingNames = {{
    {Pacing::kHost, "host"},
    {Pacing::kRobot, "robot"},
}};

/// The real-time loop.
struct LoopConfiguration {
  double rate_hz = 200.0;
  Pacing pacing = Pacing::kHost;
  int spin_us = 60;   ///< the last part of the wait is spun
  int priority = 80;  ///< SCHED_FIFO; 0: ordinary scheduling
  int cpu = -1;       ///< -1: any
  bool lock_memory = true;
  bool hold_cpu_latency = true;  ///< /dev/cpu_dma_latency at 0
};

/// Where runs are recorded.
struct RecordSettings {
  std::string directory{};  ///< each run gets its own folder in it; empty: nothing is recorded
  int max_mb = 2000;
  int quota_mb = 0;                   ///< of all runs in `directory`; 0: none
  double black_box_s = 10.0;          ///< kept for a fault (live/live_recording.h); 0: none
  std::string black_box_directory{};  ///< empty: `directory`, or the user's state folder
};

/// Address of the overhead camera's samples and images. The camera's noise model is in the
/// parameters.
struct CameraSettings {
  std::string listen;         ///< "udp:[HOST:]PORT"; empty: no camera
  double max_age_ms = 400.0;  ///< older detections are ignored
  double image_hz = 10.0;     ///< most images that are shown and recorded; 0: none
};

/// The page and the viewers.
struct ServerConfiguration {
  std::string listen = "auto";  ///< HOST:PORT, "auto" or "off"
  CommandsFrom commands = CommandsFrom::kLocal;
  std::string origins;  ///< allowed besides the page's own, separated by spaces
  std::string hosts;    ///< names in Host besides addresses and localhost
  int max_clients = 64;
  bool stop_unwatched = false;
  std::string robots;  ///< pages of robots of other machines, separated by spaces
};

/// Publishing on ROS 2's topics.
struct Ros2Settings {
  bool enabled = false;
  int domain = -1;               ///< -1: ROS_DOMAIN_ID, or 0 without it
  std::string interface = "lo";  ///< empty: by CYCLONEDDS_URI, or Cyclone DDS's own choice
};

/// Everything that a file can set. Privileges refused by the system are reported, but not fatal.
struct Configuration {
  std::string robot = "end-loaded";  ///< bundled name or file
  std::string course;                ///< bundled name or file; empty: none, driving by hand only
  std::string library;  ///< folder with the user's own courses and robots; empty: the default
  LinkSettings link{};
  LoopConfiguration loop{};
  CameraSettings camera{};
  RecordSettings record{};
  WorldSettings world{};  ///< whether there is one is set in the parameters
  ServerConfiguration server{};
  Ros2Settings ros2{};
  bridge::Parameters parameters{};  ///< model and drive come from the robot: see bridge_parameters
};

/// Parses a configuration file. `file` is only used in messages. Throws UserError
/// (file:line:column). Pure: reads no file itself.
Configuration parse_configuration(const std::string& text, const std::string& file);

/// A commented file that parse_configuration reads back.
std::string write_configuration(const Configuration& configuration);

/// Every key with its value, in the order of the file.
std::vector<text::KeyText> configuration_keys(const Configuration& configuration);

/// Parameters of the step for this robot: the configuration's, with the robot's model and drive
/// values.
bridge::Parameters bridge_parameters(const Configuration& configuration,
                                     const course::Robot& robot);

}  // namespace tp100::config
