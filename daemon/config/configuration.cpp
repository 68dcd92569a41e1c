#include "config/configuration.h"

#include <array>
#include <span>

#include "config/world_keys.h"
#include "core/angle.h"
#include "text/key.h"

namespace tp100::config {
namespace {

using text::Choice;
using text::Key;

constexpr double kDeg = kRadPerDeg;
constexpr double kMs = 1e-3;

// Keys of these tables live in bridge::Parameters; the file shows them in the sections where a user
// looks.
std::span<const Key<Configuration>> run_keys() {
  using T = Configuration;
  static const std::array<Key<T>, 3> kKeys = {{
      {"robot", &T::robot, {}, "Robot: a name from config/robots or the path of a robot file"},
      {"course",
       &T::course,
       {},
       "Course: a name from config/courses or the path of a course file; empty: poses only, the "
       "robot stands still"},
      {"setup",
       Choice<T>{{"bench", "flat", "terrain"},
                 [](const T& c) { return static_cast<std::size_t>(c.parameters.setup); },
                 [](T& c, std::size_t i) { c.parameters.setup = static_cast<bridge::Setup>(i); }},
       {},
       "Where the robot stands. bench: tracks spin free, the gyro does not steer; flat: flat "
       "floor, obstacles only in the virtual world; terrain: the real floor has the obstacles too"},
  }};
  return kKeys;
}

std::span<const Key<LinkSettings>> link_keys() {
  using T = LinkSettings;
  static const std::array<Key<T>, 5> kKeys = {{
      {"port",
       &T::port,
       {},
       "Serial port: a device path, or auto: an Arduino Mega by its USB ids, or a bridge chip that "
       "is the only candidate and that surely nobody has open. A service with several candidates "
       "needs a path"},
      {"baud", &T::baud, {9600, 2000000}, "Speed of the port; the firmware speaks the default"},
      {"timeout_ms",
       &T::timeout_ms,
       {50, 10000},
       "Without a good frame for this long the link is lost"},
      {"first_frame_timeout_ms",
       &T::first_frame_timeout_ms,
       {500, 60000},
       "Nothing heard, or no answer to what is asked at the beginning, for this long: warn"},
      {"hang_up",
       &T::hang_up,
       {},
       "Drop DTR when the port is closed, so that the next opening resets a Mega"},
  }};
  return kKeys;
}

std::span<const Key<LoopSettings>> loop_keys() {
  using T = LoopSettings;
  static const std::array<Key<T>, 8> kKeys = {{
      {"rate_hz", &T::rate_hz, {50, 1000}, "Steps per second"},
      {"pacing",
       Choice<T>{{"host", "robot"},
                 [](const T& l) { return static_cast<std::size_t>(l.pacing); },
                 [](T& l, std::size_t i) { l.pacing = static_cast<Pacing>(i); }},
       {},
       "What starts a step: the host's clock, or the robot's samples with the clock as deadline"},
      {"overrun",
       Choice<T>{{"skip", "shift"},
                 [](const T& l) { return static_cast<std::size_t>(l.overrun); },
                 [](T& l, std::size_t i) { l.overrun = static_cast<Overrun>(i); }},
       {},
       "pacing host: where steps are due while one takes too long, skip leaves them out and keeps "
       "the beat, shift begins a new one"},
      {"spin_us",
       &T::spin_us,
       {0, 1000},
       "pacing host: the last part of each wait is spun instead of slept; not where there is one "
       "processor"},
      {"priority", &T::priority, {0, 99}, "SCHED_FIFO priority; 0 for ordinary scheduling"},
      {"cpu",
       &T::cpu,
       {-1, 1023},
       "Processor that the loop is tied to; -1 for any. Paced by the robot best the one that has "
       "the port's interrupts (/proc/interrupts): to wake another one takes longer than a turn"},
      {"lock_memory", &T::lock_memory, {}, "Lock all memory, so that no step waits for a page"},
      {"hold_cpu_latency",
       &T::hold_cpu_latency,
       {},
       "Hold /dev/cpu_dma_latency at 0 while running: halves the wake-up time"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> model_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 2> kKeys = {{
      {"mode",
       Choice<T>{{"extended", "paper"},
                 [](const T& p) { return static_cast<std::size_t>(p.paper_model); },
                 [](T& p, std::size_t i) { p.paper_model = i == 1; }},
       {},
       "paper: eqs 1-5 with the paper's constants whatever the robot file says; extended: the "
       "robot's values, turning centre and slope"},
      {"slip_curve",
       Choice<T>{{"table", "fit", "table-downhill", "fit-downhill"},
                 [](const T& p) { return static_cast<std::size_t>(p.slip_curve); },
                 [](T& p, std::size_t i) { p.slip_curve = static_cast<model::SlipCurve>(i); }},
       {},
       "How slip follows the slope: the paper's table or the straight line through it, held at its "
       "level value downhill (where the paper has no rows), or continued downhill, which is ours"},
  }};
  return kKeys;
}

std::span<const Key<course::ModelValues>> turning_keys() {
  using T = course::ModelValues;
  static const std::array<Key<T>, 1> kKeys = {{
      {"turning_threshold_radps",
       &T::turning_threshold_radps,
       {0, 10},
       "Above this yaw rate the slip angle of turning applies"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> steering_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 1> kKeys = {{
      {"steering",
       Choice<T>{{"model", "odometry", "fused"},
                 [](const T& p) { return static_cast<std::size_t>(p.steering); },
                 [](T& p, std::size_t i) { p.steering = static_cast<bridge::Steering>(i); }},
       {},
       "Pose that steers. model: encoders alone; odometry: encoders and gyro; fused: these and the "
       "overhead camera"},
  }};
  return kKeys;
}

std::span<const Key<estimation::Parameters>> estimation_keys() {
  using T = estimation::Parameters;
  static const std::array<Key<T>, 3> kKeys = {{
      {"still_s",
       &T::still_s,
       {0.1, 10},
       "Both belts rest for this long before the gyro bias is taken"},
      {"still_gyro_sd_radps",
       &T::still_gyro_sd_radps,
       {0.0005, 0.2},
       "Standard deviation of the gyro above which the robot is not at rest"},
      {"bias_time_s", &T::bias_time_s, {0.05, 60}, "Time constant of the gyro bias while at rest"},
  }};
  return kKeys;
}

std::span<const Key<RecordSettings>> record_keys() {
  using T = RecordSettings;
  static const std::array<Key<T>, 4> kKeys = {{
      {"directory",
       &T::directory,
       {},
       "Folder for recordings; each run gets a folder of its own in it, with --stay from its start "
       "to a second after its end. Empty: nothing is recorded"},
      {"max_mb",
       &T::max_mb,
       {1, 1000000},
       "A recording that has grown to this size is ended, with a warning; the run goes on"},
      {"black_box_s",
       &T::black_box_s,
       {0, 60},
       "So much, up to a second after a fault, is written as a recording when nothing is recorded "
       "anyway; 0: nothing is kept"},
      {"black_box_directory",
       &T::black_box_directory,
       {},
       "Folder for these. Empty: directory above, else $XDG_STATE_HOME/tp100 or "
       "~/.local/state/tp100"},
  }};
  return kKeys;
}

std::span<const Key<CameraSettings>> camera_stream_keys() {
  using T = CameraSettings;
  static const std::array<Key<T>, 2> kKeys = {{
      {"listen",
       &T::listen,
       {},
       "Overhead camera: where its detections come in, udp:PORT for this machine alone or "
       "udp:ADDRESS:PORT; empty: no camera"},
      {"max_age_ms", &T::max_age_ms, {20, 500}, "Detections older than this are not used"},
  }};
  return kKeys;
}

std::span<const Key<estimation::CameraParameters>> camera_keys() {
  using T = estimation::CameraParameters;
  static const std::array<Key<T>, 8> kKeys = {{
      {"position_sd_m",
       &T::position_sd_m,
       {1e-4, 0.1},
       "Standard deviation of the marker's place from picture to picture"},
      {"yaw_sd_deg", &T::yaw_sd_rad, {0.01, 20}, "Same of its direction", kDeg},
      {"time_sd_ms", &T::time_sd_s, {0, 100}, "Same of its time stamps", kMs},
      {"constant_sd_m",
       &T::constant_sd_m,
       {0, 0.1},
       "Error of the place that all pictures share: added to what is published as uncertain"},
      {"height_m", &T::height_m, {0.5, 20}, "Lens above the floor; it looks straight down"},
      {"offset_x_m",
       &T::offset_x_m,
       {-10, 10},
       "Lens from the middle of the course's fence, along the world's x"},
      {"offset_y_m", &T::offset_y_m, {-10, 10}, "Same along the world's y"},
      {"marker_height_m",
       &T::marker_height_m,
       {0, 0.4},
       "Marker above the reference point; the height of the plane that the camera measures in"},
  }};
  return kKeys;
}

std::span<const Key<ServerSettings>> server_keys() {
  using T = ServerSettings;
  static const std::array<Key<T>, 5> kKeys = {{
      {"listen",
       &T::listen,
       {},
       "Page and viewers: ADDRESS:PORT, port 0 for any free one; auto: 127.0.0.1:8765, or any free "
       "port if another program has that one; off: no server"},
      {"commands",
       Choice<T>{{"local", "all", "none"},
                 [](const T& s) { return static_cast<std::size_t>(s.commands); },
                 [](T& s, std::size_t i) { s.commands = static_cast<CommandsFrom>(i); }},
       {},
       "Whose commands are taken: those of this machine, of everybody, of nobody. STOP is taken "
       "from every viewer"},
      {"origins",
       &T::origins,
       {},
       "Web pages besides the own one that may connect, separated by spaces, for example "
       "https://app.foxglove.dev"},
      {"hosts",
       &T::hosts,
       {},
       "Names by which this machine is called, besides addresses and localhost, separated by "
       "spaces"},
      {"max_clients", &T::max_clients, {1, 256}, "Viewers at once"},
  }};
  return kKeys;
}

std::span<const Key<control::Parameters>> control_keys() {
  using T = control::Parameters;
  static const std::array<Key<T>, 31> kKeys = {{
      {"law",
       Choice<T>{{"stanley", "pure-pursuit", "lqr"},
                 [](const T& c) { return static_cast<std::size_t>(c.law); },
                 [](T& c, std::size_t i) { c.law = static_cast<control::LawName>(i); }},
       {},
       "How lines and arcs are steered. stanley: desired yaw from cross-track and heading error; "
       "pure-pursuit: the circle to a point ahead; lqr: gains of a quadratic regulator for each "
       "speed"},
      {"preview_s",
       &T::preview_s,
       {0, 1},
       "Lag of loop and motors: the path is read this far ahead"},
      {"cross_track_gain_1ps",
       &T::cross_track_gain_1ps,
       {0, 50},
       "Stanley: the approach angle is the arc tangent of this times the cross-track error over "
       "the speed"},
      {"soft_speed_mps",
       &T::soft_speed_mps,
       {0.001, 1},
       "Stanley: is added to the speed there, or the approach would jump about near a stop"},
      {"max_approach_deg", &T::max_approach_rad, {1, 80}, "Steepest approach to the path", kDeg},
      {"pursuit_s",
       &T::pursuit_s,
       {0.1, 10},
       "Pure pursuit: the point ahead lies the way of this time ahead"},
      {"pursuit_min_m", &T::pursuit_min_m, {0.01, 2}, "Pure pursuit: but not nearer than this"},
      {"pursuit_max_m", &T::pursuit_max_m, {0.01, 2}, "Pure pursuit: and not further than this"},
      {"lqr_cross_track_m",
       &T::lqr_cross_track_m,
       {0.001, 1},
       "LQR: cross-track error that weighs as much as the heading error and turn rate below"},
      {"lqr_heading_deg", &T::lqr_heading_rad, {0.1, 180}, "LQR: that heading error", kDeg},
      {"lqr_turn_radps", &T::lqr_turn_radps, {0.01, 10}, "LQR: that turn rate"},
      {"acceleration_mps2", &T::acceleration_mps2, {0.01, 5}, "Acceleration along the path"},
      {"full_speed_radius_m",
       &T::full_speed_radius_m,
       {0, 10},
       "In curves narrower than this the speed falls with the radius"},
      {"min_speed_mps", &T::min_speed_mps, {0.001, 0.3}, "Creep speed towards a stop"},
      {"pivot_rate_radps", &T::pivot_rate_radps, {0.05, 5}, "Turn rate on the spot"},
      {"pivot_acceleration_radps2",
       &T::pivot_acceleration_radps2,
       {0.05, 50},
       "Change of the turn rate on the spot"},
      {"pivot_tolerance_deg",
       &T::pivot_tolerance_rad,
       {0.05, 20},
       "A turn on the spot ends within this",
       kDeg},
      {"stop_tolerance_m",
       &T::stop_tolerance_m,
       {0.0005, 0.1},
       "A straight piece or arc ends within this"},
      {"settle_s", &T::settle_s, {0, 5}, "At rest within the tolerances for this long: piece done"},
      {"max_cross_track_m",
       &T::max_cross_track_m,
       {0.01, 10},
       "Abort beyond this distance from the path"},
      {"max_heading_error_deg",
       &T::max_heading_error_rad,
       {5, 180},
       "Abort beyond this heading error",
       kDeg},
      {"max_tilt_deg", &T::max_tilt_rad, {5, 90}, "Abort beyond this roll or pitch", kDeg},
      {"time_limit_factor",
       &T::time_limit_factor,
       {1, 100},
       "Abort after this many times the nominal duration of the course"},
      {"min_battery_v", &T::min_battery_v, {0, 20}, "Abort below this voltage of both cells"},
      {"stall_s",
       &T::stall_s,
       {0.1, 30},
       "Abort after a belt stood still against its command for this long"},
      {"disagreement_radps",
       &T::disagreement_radps,
       {0.05, 10},
       "Largest difference between the yaw rates of gyro and encoders"},
      {"disagreement_s", &T::disagreement_s, {0.1, 30}, "Abort after it was larger for this long"},
      {"turn_slip_share",
       &T::turn_slip_share,
       {0, 1},
       "Abort when gyro and encoders disagree in sum by more than this part of the turn and 6 deg; "
       "more for a robot that is not identified"},
      {"push_radps",
       &T::push_radps,
       {0.05, 10},
       "Difference between the yaw rates of gyro and encoders that is a push: the robot recovers"},
      {"recovery_speed_share",
       &T::recovery_speed_share,
       {0.1, 1},
       "After a push, part of the course's speed until the robot looks to where it should go"},
      {"recovery_window_m",
       &T::recovery_window_m,
       {0, 1},
       "After a push the path is searched this far before and behind the last place"},
  }};
  return kKeys;
}

std::span<const Key<bridge::Parameters>> bridge_keys() {
  using T = bridge::Parameters;
  static const std::array<Key<T>, 2> kKeys = {{
      {"command_life_ms",
       &T::command_life_s,
       {20, 190},
       "The robot stops when it has had no newer command than this; it refuses 200 and more",
       kMs},
      {"max_sample_age_ms",
       &T::max_sample_age_s,
       {10, 200},
       "No command is sent on a sample older than this",
       kMs},
  }};
  return kKeys;
}

/// Calls visit(section, keys, values) for every section in the order of the file.
template <class Values, class Visit>
void for_each_section(Values& configuration, Visit visit) {
  auto& parameters = configuration.parameters;
  visit("", run_keys(), configuration);
  visit("link", link_keys(), configuration.link);
  visit("loop", loop_keys(), configuration.loop);
  visit("model", model_keys(), parameters);
  visit("model", turning_keys(), parameters.model);
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
      "keys that differ. Angles are in degrees; a key's end names its unit. `tp100d check FILE` "
      "says whether a file is right.");
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
  parameters.shape = robot.shape;
  parameters.drive = robot.drive;
  return parameters;
}

}  // namespace tp100::config
