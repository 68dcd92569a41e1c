#include <sched.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "bridge/terrain_contacts.h"
#include "core/arithmetic.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/time.h"
#include "link/camera_message.h"
#include "link/udp.h"
#include "loop/pacing.h"
#include "loop/real_time.h"
#include "ros2/participant.h"
#include "ros2/topics.h"
#include "sim/robot/commands.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/pty.h"
#include "sim/sensors/overhead_camera.h"
#include "text/format.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

/// The emulated overhead camera on the network: sends the datagrams that tp100-camera would send.
class CameraStream {
 public:
  /// Throws UserError.
  CameraStream(const OverheadCamera& camera, const link::UdpAddress& to, std::uint64_t seed);

  /// Call once per physics step with the body's exact pose. `virtual_ns` is the camera's time,
  /// which began at `begin_ns` of the monotonic clock. Never waits.
  void look(const Pose& truth, HostNs virtual_ns, HostNs begin_ns, HostNs monotonic_ns);

 private:
  OverheadCamera camera_;
  link::UdpSender sender_;
  link::CameraMessage message_{};
};

CameraStream::CameraStream(const OverheadCamera& camera, const link::UdpAddress& to,
                           std::uint64_t seed)
    : camera_(camera), sender_(to) {
  // Two robots with the same seed must be two streams.
  message_.stream =
      static_cast<std::uint32_t>(seed * 0x9E3779B1U) ^ static_cast<std::uint32_t>(::getpid());
  message_.clock = link::monotonic_clock_name();
}

void CameraStream::look(const Pose& truth, HostNs virtual_ns, HostNs begin_ns,
                        HostNs monotonic_ns) {
  camera_.look(truth, virtual_ns);
  while (const auto seen = camera_.take(virtual_ns)) {
    const HostNs stamp_ns = begin_ns + seen->measured_ns;
    message_.sequence = seen->sequence;
    message_.stamp_us = stamp_ns / kNsPerUs;
    message_.age_us = std::max<std::int64_t>(0, (monotonic_ns - stamp_ns) / kNsPerUs);
    message_.x_m = seen->x_m;
    message_.y_m = seen->y_m;
    message_.yaw_rad = seen->yaw_rad;
    sender_.send(link::encode(message_));
  }
}

// If it is behind real time by more than this (a suspended machine), it does not catch up.
constexpr HostNs kGiveUpNs = 500 * kNsPerMs;

volatile std::sig_atomic_t g_stop = 0;

void on_signal(int) { g_stop = 1; }

void sleep_until(HostNs at_ns) {
  const timespec at{at_ns / kNsPerS, at_ns % kNsPerS};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR && g_stop == 0) {
  }
}

// Lower than the priority of a daemon's loop on the same machine.
constexpr int kFifoPriority = 10;

void go_beside_others() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_OTHER, &none);
  ::setpriority(PRIO_PROCESS, 0, -15);
}

/// Real-time priority and locked memory: a real robot does not wait for the programs of its host.
/// Without them, a machine that is busy for a fifth of a second makes the firmware stop for lack of
/// commands. Niceness alone does not help: the kernel weighs whole sessions against each other.
void go_before_others() {
  const std::vector<loop::Privilege> privileges =
      loop::apply_to_this_thread({.priority = kFifoPriority});
  if (!std::ranges::all_of(privileges, &loop::Privilege::granted)) go_beside_others();
}

/// True if this thread has computed nearly all the time since the last call, or since it began.
class Overloaded {
 public:
  bool operator()(HostNs now_ns) {
    const HostNs used_ns = thread_cpu_ns();
    const bool all_the_time = used_ns - used_ns_ > (now_ns - asked_ns_) * 4 / 5;
    used_ns_ = used_ns;
    asked_ns_ = now_ns;
    return all_the_time;
  }

 private:
  HostNs asked_ns_ = monotonic_now();
  HostNs used_ns_ = thread_cpu_ns();
};

/// Prints the firmware's log messages and when its motors begin to run, and counts its samples.
class FirmwareLog {
 public:
  /// Number of samples since the last restart().
  std::uint64_t samples() const { return samples_; }
  void restart() { samples_ = 0; }
  void push(std::uint8_t byte) {
    if (decoder_.push(byte) != wire::DecodeResult::kFrame) return;
    if (decoder_.type() == static_cast<std::uint8_t>(wire::Type::kSample)) read_sample();
    if (decoder_.type() == static_cast<std::uint8_t>(wire::Type::kLog)) print_log();
  }

 private:
  void read_sample() {
    ++samples_;
    wire::Sample sample{};
    if (!wire::read_payload(decoder_.payload(), decoder_.size(), sample)) return;
    const bool on = sample.state == static_cast<std::uint8_t>(wire::State::kRunning);
    // The firmware itself reports only when they go off.
    if (on && !on_) print(sample.device_us, "motors on");
    on_ = on;
  }
  void print_log() {
    wire::Log log{};
    if (!wire::read_payload(decoder_.payload(), decoder_.size(), log)) return;
    std::array<char, wire::Log::kTextSize + 1> text{};
    for (std::size_t i = 0; i < wire::Log::kTextSize; ++i) text[i] = static_cast<char>(log.text[i]);
    print(log.device_us, text.data());
  }
  static void print(std::uint32_t device_us, const char* text) {
    std::printf("robot: %.6f s: %s\n", static_cast<double>(device_us) * 1e-6, text);
    std::fflush(stdout);
  }

  wire::FrameDecoder decoder_;
  std::uint64_t samples_ = 0;
  bool on_ = false;  // the motors, as of the newest sample
};

/// The robot's end of the cable in real time.
class Cable {
 public:
  Cable(EmulatedRobot& robot, const std::string& link) : robot_(robot), link_(link), pty_(link) {}

  const std::string& device() const { return pty_->device(); }
  /// Number of samples that the robot sent since the port was opened.
  std::uint64_t samples() const { return log_.samples(); }

  /// Removes and restores the port as the robot's faults require.
  void plug() {
    if (const std::optional<double> away_s = robot_.take_fault(fault_kind("unplug"))) {
      std::printf("robot: %.6f s: unplugged for %g s\n", to_s(robot_.now_ns() - reset_ns_),
                  *away_s);
      std::fflush(stdout);
      pty_.reset();
      open_ = false;
      waiting_.clear();
      plug_ns_ = robot_.now_ns() + from_s(*away_s);
    }
    if (pty_ || robot_.now_ns() < plug_ns_) return;
    pty_.emplace(link_);
    std::printf("robot: %.6f s: plugged in again, on %s\n", to_s(robot_.now_ns() - reset_ns_),
                device().c_str());
    std::fflush(stdout);
  }

  /// Opening the port resets the board, as DTR does on a Mega.
  void watch() {
    if (!pty_) return;
    const bool open = pty_->open();
    if (open == open_) return;
    open_ = open;
    // On the board's clock, like the firmware's own lines.
    std::printf("robot: %.6f s: port %s\n", to_s(robot_.now_ns() - reset_ns_),
                open ? "opened, board resets" : "closed");
    std::fflush(stdout);
    if (open) {
      robot_.reset(PowerUp::kExternal);
      reset_ns_ = robot_.now_ns();
      robot_.opened();
      log_.restart();
    }
    waiting_.clear();
  }
  void from_host() {
    if (!pty_) return;
    std::array<std::uint8_t, 4096> buffer;
    const std::size_t n = pty_->read(buffer);
    robot_.receive(std::span(buffer.data(), n), robot_.now_ns() + kPhysicsStepNs);
  }
  void to_host(const std::vector<TimedByte>& sent) {
    for (const TimedByte& byte : sent) {
      log_.push(byte.value);
      if (open_) waiting_.push_back(byte.value);
    }
    if (waiting_.empty()) return;
    const std::size_t n = pty_->write(waiting_);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(n));
    // A client that does not read loses bytes, as it would on a real port.
    if (waiting_.size() > kMaxWaiting) waiting_.clear();
  }

 private:
  static constexpr std::size_t kMaxWaiting = 8192;
  EmulatedRobot& robot_;
  std::string link_;
  std::optional<Pty> pty_;
  HostNs plug_ns_ = 0;
  FirmwareLog log_;
  bool open_ = false;
  HostNs reset_ns_ = 0;
  std::vector<std::uint8_t> waiting_;
};

/// The requested camera, above the middle of the course's fence.
std::optional<CameraStream> camera_stream(const RobotCommand& command, const Loaded& loaded,
                                          const course::Fence& fence) {
  if (command.camera.empty() && command.camera_to.empty()) return std::nullopt;
  if (loaded.setup == bridge::Setup::kStand)
    throw UserError("--camera: on a stand it would see a robot that stands still; leave it out");
  const link::UdpAddress to = command.camera_to.empty()
                                  ? link::UdpAddress{.port = link::kCameraPort}
                                  : link::parse_udp(command.camera_to, "--camera-to");
  const course::EmulatedCamera values =
      load_camera(command.camera.empty() ? "overhead" : command.camera);
  const OverheadCamera camera(values, (fence.min_x_m + fence.max_x_m) / 2.0,
                              (fence.min_y_m + fence.max_y_m) / 2.0, command.options.seed);
  return std::optional<CameraStream>(std::in_place, camera, to, command.options.seed);
}

/// Publishes the true pose on its ROS 2 topic at the rate of samples.
class TruthTopic {
 public:
  explicit TruthTopic(const std::string& interface)
      : participant_({.enabled = true, .interface = interface}, "tp100_sim",
                     std::array{ros2::Topic::kGroundTruth}) {}
  /// Call once per physics step, with the body's pose at its end and the host time of that.
  void look(HostNs at, const Pose& truth) {
    if (at < due_ns_) return;
    due_ns_ = at + kPeriodNs;
    participant_.write(ros2::Topic::kGroundTruth, ros2::ground_truth(clock_.unix_ns(at), truth));
  }

 private:
  static constexpr HostNs kPeriodNs = 5 * kNsPerMs;
  const messages::PublishClock clock_{.start_ns = monotonic_now(), .start_unix_ns = unix_now_ns()};
  ros2::Participant participant_;
  HostNs due_ns_ = 0;
};

void print_place(const Pose& truth) {
  std::printf("robot: stands at x %.4f m, y %.4f m, yaw %.2f deg\n", truth.x_m, truth.y_m,
              truth.yaw_rad * kDegPerRad);
  std::fflush(stdout);
}

}  // namespace

int run_robot(const RobotCommand& command) {
  const Loaded loaded = load(command.options);
  if (command.blank && loaded.board != BoardKind::kAvr) {
    throw UserError("--blank: only an emulated chip can be blank; add --board avr");
  }
  const std::vector<PlannedFault> faults = parse_faults(command.faults);
  for (const PlannedFault& fault : faults)
    if (fault.kind == fault_kind("host-stall"))
      throw UserError("--fault host-stall: only for tp100-sim course; here stop the daemon itself");
  course::Course course;
  if (!command.course.empty()) course = load_course(command.course);
  EmulatedRobot robot({.values = loaded.robot.emulated,
                       .start = course.start,
                       .on_stand = loaded.setup == bridge::Setup::kStand,
                       .terrain = bridge::floor_of(course.terrain, loaded.setup),
                       .seed = command.options.seed,
                       .board = loaded.board,
                       .bootloader = true,
                       .blank = command.blank,
                       .faults = faults});
  std::optional<CameraStream> camera = camera_stream(command, loaded, course.fence);
  std::optional<TruthTopic> truth_topic;
  if (!command.ros2.empty()) truth_topic.emplace(command.ros2);
  Cable cable(robot, command.link);
  DisturbanceInjector disturbance_injector(course.disturbances);
  const loop::RealTimeProcess process({});
  go_before_others();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // Keep SIGHUP ignored under nohup.
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  // The robot keeps running when its log is no longer read.
  std::signal(SIGPIPE, SIG_IGN);
  std::printf("robot: %s, seed %llu, on %s%s%s\n", loaded.robot.name.c_str(),
              static_cast<unsigned long long>(command.options.seed), cable.device().c_str(),
              command.link.empty() ? "" : ", linked from ", command.link.c_str());
  std::fflush(stdout);

  robot.reset(PowerUp::kPowerOn);
  HostNs begin_ns = monotonic_now();
  Overloaded overloaded;
  while (g_stop == 0) {
    // A quantum is computed when it is over: nothing reaches the host too early, and what the host
    // wrote meanwhile arrives in the next one.
    const HostNs due_ns = begin_ns + robot.now_ns() + kPhysicsStepNs;
    const HostNs now_ns = monotonic_now();
    if (now_ns - due_ns > kGiveUpNs) {
      begin_ns += now_ns - due_ns;
      // A robot that cannot keep pace must not occupy a processor at real-time priority. After a
      // mere pause of the machine it keeps its priority, or it would fall behind again and again.
      if (overloaded(now_ns)) go_beside_others();
    }
    if (now_ns < due_ns) sleep_until(due_ns);
    cable.plug();
    cable.watch();
    cable.from_host();
    cable.to_host(robot.advance());
    if (camera) camera->look(robot.truth().pose, robot.now_ns(), begin_ns, monotonic_now());
    if (truth_topic) truth_topic->look(begin_ns + robot.now_ns(), robot.truth().pose);
    if (disturbance_injector.update(robot) != nullptr) {
      std::printf("robot: a disturbance pushes the robot\n");
      std::fflush(stdout);
    }
  }
  std::printf("robot: sent %s since its port was opened\n",
              text::counted(cable.samples(), "sample").c_str());
  print_place(robot.truth().pose);
  return 0;
}

}  // namespace tp100::sim
