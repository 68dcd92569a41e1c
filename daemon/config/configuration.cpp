#include "config/configuration.h"

#include <array>
#include <span>

#include "config/parameter_keys.h"
#include "config/world_settings.h"
#include "text/key.h"

namespace tp100::config {
namespace {

using text::Key;

std::span<const Key<Configuration>> run_keys() {
  using T = Configuration;
  static const std::array<Key<T>, 3> kKeys = {{
      {"robot", &T::robot, {}, "Robot: a name from config/robots or the path of a robot file"},
      {"course",
       &T::course,
       {},
       "Course: a name from config/courses or the path of a course file; empty: poses only, the "
       "robot stands still"},
      {"library",
       &T::library,
       {},
       "Folder of your own files, with subfolders courses and robots: their names are valid above, "
       "and the page saves there. Empty: $XDG_DATA_HOME/tp100 or ~/.local/share/tp100"},
  }};
  return kKeys;
}

std::span<const Key<LinkSettings>> link_keys() {
  using T = LinkSettings;
  static const std::array<Key<T>, 6> kKeys = {{
      {"port",
       &T::port,
       {},
       "Serial port: a device path, or auto: the only board that may be the robot by its USB ids, "
       "an Arduino Mega, or a bridge chip that is certainly not open in another program. With "
       "several candidates a path is needed"},
      {"baud", &T::baud, {9600, 2000000}, "Speed of the port; the firmware uses the default"},
      {"timeout_ms",
       &T::timeout_ms,
       {50, 10000},
       "The link counts as lost after this time without a valid frame"},
      {"first_frame_timeout_ms",
       &T::first_frame_timeout_ms,
       {500, 60000},
       "A warning is given after this time without any frame or without an answer to the first "
       "requests"},
      {"clock_answer_ms",
       &T::clock_answer_ms,
       {50, 2000},
       "The robot's answers to clock requests are not used if they come later than this; without "
       "any, no run begins"},
      {"hang_up",
       &T::hang_up,
       {},
       "Drop DTR when the port is closed, so that the next opening resets a Mega"},
  }};
  return kKeys;
}

std::span<const Key<LoopConfiguration>> loop_keys() {
  using T = LoopConfiguration;
  static const std::array<Key<T>, 7> kKeys = {{
      {"rate_hz", &T::rate_hz, {50, 1000}, "Steps per second"},
      {"pacing",
       text::enum_choice<T, &T::pacing, kPacingNames>(),
       {},
       "What starts a step: the host's clock, or the robot's samples with the clock as deadline"},
      {"spin_us",
       &T::spin_us,
       {0, 1000},
       "pacing host: for the last part of each wait, the loop polls the clock instead of sleeping; "
       "not used with a single processor"},
      {"priority",
       &T::priority,
       {0, 99},
       "SCHED_FIFO priority, if permitted; 0 for ordinary scheduling. If not 0, the thread that "
       "carries out STOP gets 1, and for root (CAP_SYS_NICE) so do the kernel's threads "
       "kworker/u*, which carry a port's bytes"},
      {"cpu",
       &T::cpu,
       {-1, 1023},
       "Processor on which the loop runs; -1: any. With pacing robot, choose the one that handles "
       "the port's interrupts (/proc/interrupts): waking another one takes longer than a cycle"},
      {"lock_memory", &T::lock_memory, {}, "Lock all memory, so that no step waits for a page"},
      {"hold_cpu_latency",
       &T::hold_cpu_latency,
       {},
       "Hold /dev/cpu_dma_latency at 0 while running: halves the wake-up time"},
  }};
  return kKeys;
}

std::span<const Key<RecordSettings>> record_keys() {
  using T = RecordSettings;
  static const std::array<Key<T>, 5> kKeys = {{
      {"directory",
       &T::directory,
       {},
       "Folder for recordings. Each run gets its own folder in it; with --stay, a recording lasts "
       "from the start of a run to one second after its end. Empty: nothing is recorded"},
      {"max_mb",
       &T::max_mb,
       {1, 1000000},
       "Size at which a recording is ended with a warning; the run continues"},
      {"quota_mb",
       &T::quota_mb,
       {0, 100000000},
       "Before a recording begins, the oldest runs in the folder are deleted until all together "
       "are at most this large; never one with a name, note or tags, and never one that is open. "
       "0: nothing is deleted but black boxes, beyond 500 MB of them"},
      {"black_box_s",
       &T::black_box_s,
       {0, 60},
       "Length of the recording that is written after a fault if no recording is running; it ends "
       "one second after the fault. 0: none is written"},
      {"black_box_directory",
       &T::black_box_directory,
       {},
       "Folder for these recordings. Empty: the directory above, or if that is empty, "
       "$XDG_STATE_HOME/tp100 or ~/.local/state/tp100"},
  }};
  return kKeys;
}

std::span<const Key<CameraSettings>> camera_stream_keys() {
  using T = CameraSettings;
  static const std::array<Key<T>, 3> kKeys = {{
      {"listen",
       &T::listen,
       {},
       "Overhead camera: address at which its detections and images arrive, udp:PORT for this "
       "machine only or udp:ADDRESS:PORT; empty: no camera"},
      {"max_age_ms", &T::max_age_ms, {20, 500}, "Detections older than this are not used"},
      {"image_hz",
       &T::image_hz,
       {0, 30},
       "Of the images that the camera sends, at most this many a second are shown on the page and "
       "recorded; 0: none. How many it sends, and how large: [image] in the file of its view"},
  }};
  return kKeys;
}

std::span<const Key<ServerConfiguration>> server_keys() {
  using T = ServerConfiguration;
  static const std::array<Key<T>, 7> kKeys = {{
      {"listen",
       &T::listen,
       {},
       "Address of the page and for viewers: ADDRESS:PORT, with port 0 for any free port; auto: "
       "127.0.0.1:8765, or any free port if that one is in use; off: no server"},
      {"commands",
       text::enum_choice<T, &T::commands, kCommandsFromNames>(),
       {},
       "Viewers, and nodes of ROS 2, whose commands are accepted: those on this machine (local; of "
       "nodes, only if ros2.interface is lo), all or none. STOP is accepted from everybody"},
      {"origins",
       &T::origins,
       {},
       "Other web pages that may connect, separated by spaces, for example "
       "https://app.foxglove.dev"},
      {"hosts",
       &T::hosts,
       {},
       "Names of this machine, in addition to its addresses and localhost, separated by spaces"},
      {"max_clients", &T::max_clients, {1, 256}, "Largest number of viewers at the same time"},
      {"stop_unwatched",
       &T::stop_unwatched,
       {},
       "Whether a run or a drive is stopped when no page has been in sight for 2 s"},
      {"robots",
       &T::robots,
       {},
       "Pages of robots on other machines, for the page of all robots, separated by spaces, for "
       "example http://10.0.0.7:8765; those on this machine are found. Each must have this page in "
       "its server.origins"},
  }};
  return kKeys;
}

std::span<const Key<Ros2Settings>> ros2_keys() {
  using T = Ros2Settings;
  static const std::array<Key<T>, 3> kKeys = {{
      {"enabled",
       &T::enabled,
       {},
       "Publish poses, IMU, joints, battery, path and state on ROS 2's topics, as node /tp100d, "
       "and take velocities, goals and names of courses as server.commands permits"},
      {"domain",
       &T::domain,
       {-1, 232},
       "Domain of ROS 2; -1: of the environment variable ROS_DOMAIN_ID, or 0 without it"},
      {"interface",
       &T::interface,
       {},
       "Network interface: lo for this machine only, or the name of another, for example eth0. "
       "Empty: as the environment variable CYCLONEDDS_URI says, or without it Cyclone DDS's "
       "choice"},
  }};
  return kKeys;
}

/// Calls visit(section, keys, values) for every section in the order of the file.
template <class Values, class Visit>
void for_each_section(Values& configuration, Visit visit) {
  auto& parameters = configuration.parameters;
  visit("", run_keys(), configuration);
  visit("", setup_keys(), parameters);
  visit("link", link_keys(), configuration.link);
  visit("loop", loop_keys(), configuration.loop);
  visit("model", model_keys(), parameters);
  visit("model", track_keys(), parameters.model);
  visit("estimation", steering_keys(), parameters);
  visit("estimation", estimation_keys(), parameters.estimation);
  visit("camera", camera_stream_keys(), configuration.camera);
  visit("camera", camera_keys(), parameters.estimation.camera);
  visit("control", control_keys(), parameters.control);
  visit("control", bridge_keys(), parameters);
  visit("world", world_keys(), parameters.world);
  visit("world", world_stream_keys(), configuration.world);
  visit("record", record_keys(), configuration.record);
  visit("server", server_keys(), configuration.server);
  visit("ros2", ros2_keys(), configuration.ros2);
}

}  // namespace

Configuration parse_configuration(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  Configuration configuration;
  std::string last;
  text::TomlTable table = root;
  for_each_section(configuration, [&](const std::string& section, auto keys, auto& values) {
    if (section != last) table = root.table(section);
    last = section;
    text::read_keys(table, keys, values);
  });
  root.finish();
  return configuration;
}

std::string write_configuration(const Configuration& configuration) {
  std::string text = text::toml_comment(
      "Configuration of tp100d and tp100-sim, with every key at its default. A file needs only the "
      "keys that differ. Angles are in degrees; the end of a key's name gives its unit. `tp100d "
      "check FILE` checks a file.");
  std::string last = "none";
  for_each_section(configuration, [&](const std::string& section, auto keys, const auto& values) {
    if (section != last) text += section.empty() ? "\n" : "\n[" + section + "]\n";
    last = section;
    text += text::write_keys(keys, values);
  });
  return text;
}

std::vector<text::KeyText> configuration_keys(const Configuration& configuration) {
  std::vector<text::KeyText> out;
  for_each_section(configuration, [&](const std::string& section, auto keys, const auto& values) {
    text::describe_keys(section.empty() ? "" : section + ".", keys, values, out);
  });
  return out;
}

bridge::Parameters bridge_parameters(const Configuration& configuration,
                                     const course::Robot& robot) {
  bridge::Parameters parameters = configuration.parameters;
  parameters.model = robot.model;
  parameters.model.turning_threshold_radps = configuration.parameters.model.turning_threshold_radps;
  parameters.model.slip_curve = configuration.parameters.model.slip_curve;
  parameters.shape = robot.shape;
  parameters.drive = robot.drive;
  return parameters;
}

}  // namespace tp100::config
