#include "doctor/wheels_up.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "core/faults.h"
#include "doctor/robot_talk.h"
#include "doctor/tracks.h"

namespace tp100::doctor {
namespace {

/// Lines typed on standard input, read without blocking.
class Answers {
 public:
  /// The next line, if there is one; reads all available input. Never waits.
  std::optional<std::string> take();
  /// Discards what was typed on a terminal before the question; a pipe keeps its lines.
  void drop_typed_ahead();
  /// End of input: there will be no more lines.
  bool ended() const { return ended_ && pending_.empty(); }

 private:
  std::string pending_;
  bool ended_ = false;
};

std::optional<std::string> Answers::take() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (!ended_ && ::poll(&input, 1, 0) > 0) {
    std::array<char, 256> buffer;
    const ssize_t n = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (n > 0) pending_.append(buffer.data(), static_cast<std::size_t>(n));
    if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN)) ended_ = true;
  }
  const std::size_t end = pending_.find('\n');
  if (end == std::string::npos) {
    if (ended_) pending_.clear();
    return std::nullopt;
  }
  std::string line = pending_.substr(0, end);
  pending_.erase(0, end + 1);
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

void Answers::drop_typed_ahead() {
  if (::isatty(STDIN_FILENO) == 0) return;
  ::tcflush(STDIN_FILENO, TCIFLUSH);
  pending_.clear();
}

constexpr double kHelloLimitS = 8.0;
constexpr double kSettleS = 0.3;
constexpr double kDistanceS = 1.0;
constexpr double kStandstillS = 0.6;
constexpr double kAnswerLimitS = 600.0;
constexpr double kTrackMps = 0.1;
// With this wheelbase, half of it as turning radius and no slip, the other track's speed is exactly
// 0.
constexpr float kUnitWheelbaseM = 1.0F;

/// Parameters that turn a command into a duty: neither counts nor gyro act on the motors.
link::SessionSettings open_loop(link::SessionSettings settings) {
  wire::Parameters& out = settings.parameters;
  out.wheelbase_m = out.wheelbase_tight_m = out.wheelbase_spin_m = kUnitWheelbaseM;
  out.slip_left = out.slip_right = 0.0F;
  out.speed_kp = out.speed_ki = out.yaw_kp = 0.0F;
  out.max_yaw_radps = 1.0F;
  // So that a track that counts backwards is driven to the end and judged, not stopped as a fault.
  out.max_track_mps = 1.0F;
  out.stall_duty = 0;
  out.flags = static_cast<std::uint8_t>(out.flags & ~wire::kUseGyro);
  return settings;
}

void say(const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

Findings broken_off(std::string seen, std::string fix) {
  return {{Severity::kError, "wheels-up", std::move(seen), std::move(fix)}};
}

Findings nobody() {
  return broken_off("nobody pressed Enter, nothing moved", "run it in a terminal");
}

/// Waits for a line, without a robot session.
bool entered(Answers& answers, const std::atomic<bool>& stop) {
  while (!stop && !answers.ended()) {
    if (answers.take()) return true;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    ::poll(&input, 1, 100);
  }
  return false;
}

class WheelsUp {
 public:
  WheelsUp(const WheelsUpOptions& options, const std::atomic<bool>& stop, Answers& answers)
      : options_(options),
        stop_(stop),
        answers_(answers),
        talk_(link::open_port(options.port, options.serial), open_loop(options.session), stop) {
    talk_.on_sample = [this](const Sample& sample, HostNs) { add(sample); };
  }
  // The motors are switched off in any case.
  ~WheelsUp() { talk_.disarm(); }
  WheelsUp(const WheelsUp&) = delete;
  WheelsUp& operator=(const WheelsUp&) = delete;

  Findings run() {
    const auto ready = [this] { return talk_.session().state() == SessionState::kReady; };
    if (!talk_.turn(kHelloLimitS, ready))
      return broken_off(options_.port + ": no session with the robot",
                        "run tp100d doctor without --wheels-up first");
    say("both tracks run against each other, then the other way round");
    const std::optional<TrackDrive> spin = drive({0.0, 2.0 * track_mps_});
    if (!spin) return stopped();
    const bool look = !doctor::on_floor(spin->turned_rad);
    const std::optional<TrackDrive> left = drive(Side::kLeft, look);
    const std::optional<TrackDrive> right = left ? drive(Side::kRight, look) : std::nullopt;
    if (!right) return stopped();
    Findings findings = doctor::track_findings(*left, *right, wiring());
    const bool well = count(findings, Severity::kError) == 0;
    const bool watched = left->seen != Seen::kUnknown && right->seen != Seen::kUnknown;
    const std::optional<double> hand_rad = watched ? hand_turn() : std::nullopt;
    if (!still_there()) return stopped();
    append(findings, doctor::gyro_findings(hand_rad, spin->turned_rad, well));
    return findings;
  }

 private:
  /// Accumulated encoder and gyro values.
  struct Sums {
    double left_m = 0.0, right_m = 0.0, yaw_rad = 0.0;
  };

  /// A command, valid with a wheelbase of 1 m.
  struct Motion {
    double speed_mps = 0.0;
    double yaw_rate_radps = 0.0;
  };

  void add(const Sample& sample) {
    if (last_.device_us != 0) {
      const double per_count = 1.0 / options_.drive.counts_per_metre;
      sums_.left_m += static_cast<double>(sample.left_counts - last_.left_counts) * per_count;
      sums_.right_m += static_cast<double>(sample.right_counts - last_.right_counts) * per_count;
      sums_.yaw_rad +=
          sample.gyro_radps[2] * static_cast<double>(sample.device_us - last_.device_us) * 1e-6;
    }
    last_ = sample;
  }

  Findings stopped() const {
    if (refused_) return broken_off("the robot cannot be armed: " + talk_.why(), talk_.fix());
    if (talk_.session().counters().reboots > 0)
      return broken_off("the board restarted as a track ran",
                        "charge the battery and check the power wiring");
    if (const auto fault = first_fault(talk_.newest().faults))
      return broken_off("the robot stopped by itself: " + std::string(describe(*fault).cause),
                        std::string(describe(*fault).fix));
    if (talk_.gone())
      return broken_off(options_.port + ": port is gone", "check the plug and run it again");
    if (stop_) return broken_off("stopped before its end", "run it again");
    return broken_off(options_.port + ": the robot fell silent",
                      "check the cable and run it again");
  }

  void wait(double seconds) {
    talk_.turn(seconds, [] { return false; });
  }

  /// One motion and the standstill after it.
  Sums way(const Motion& motion) {
    const Sums before = sums_;
    const DeviceUs begun_us = last_.device_us;
    talk_.command(motion.speed_mps, motion.yaw_rate_radps);
    wait(kDistanceS);
    talk_.command(0.0, 0.0);
    wait(kStandstillS);
    watched_s_ += static_cast<double>(last_.device_us - begun_us) * 1e-6;
    watched_rad_ += sums_.yaw_rad - before.yaw_rad;
    return {sums_.left_m - before.left_m, sums_.right_m - before.right_m,
            sums_.yaw_rad - before.yaw_rad};
  }

  /// Arms for one motion and its reverse. Nothing: it was not completed.
  std::optional<TrackDrive> drive(const Motion& motion) {
    wait(kSettleS);
    if (!talk_.arm()) {
      refused_ = still_there();
      return std::nullopt;
    }
    const Sums forward = way(motion);
    const Sums back = way({-motion.speed_mps, -motion.yaw_rate_radps});
    talk_.disarm();
    if (!still_there() || talk_.newest().faults != 0) return std::nullopt;
    return TrackDrive{0.5 * (forward.left_m - back.left_m), 0.5 * (forward.right_m - back.right_m),
                      0.5 * (forward.yaw_rad - back.yaw_rad), Seen::kUnknown};
  }

  std::optional<TrackDrive> drive(Side side, bool look) {
    const std::string name = side == Side::kLeft ? "left" : "right";
    say("the " + name + " track runs forward, then back");
    const double turn_radps = side == Side::kLeft ? -track_mps_ : track_mps_;
    std::optional<TrackDrive> driven = drive({0.5 * track_mps_, turn_radps});
    if (driven && look) driven->seen = ask(name);
    return still_there() ? driven : std::nullopt;
  }

  bool still_there() const {
    const link::Session& session = talk_.session();
    return !talk_.gone() && !stop_ && session.counters().reboots == 0 &&
           session.state() == SessionState::kReady;
  }

  std::optional<std::string> answer() {
    answers_.drop_typed_ahead();
    std::optional<std::string> line;
    talk_.turn(kAnswerLimitS, [&] {
      line = answers_.take();
      return line.has_value() || answers_.ended();
    });
    return line;
  }

  Seen ask(const std::string& track) {
    while (true) {
      say("What ran? Enter: the " + track + " track, forward first; b: the " + track +
          " track, back first; o: the other one; n: none");
      const std::optional<std::string> reply = answer();
      if (!reply) return Seen::kUnknown;
      if (reply->empty()) return Seen::kAsAsked;
      if (*reply == "b") return Seen::kBackwards;
      if (*reply == "o") return Seen::kOtherTrack;
      if (*reply == "n") return Seen::kNothing;
    }
  }

  std::optional<double> hand_turn() {
    say("Hold the robot level and still, press Enter, turn it by a quarter to the left (counter-"
        "clockwise from above) and press Enter again");
    if (!answer()) return std::nullopt;
    const double before_rad = sums_.yaw_rad;
    const DeviceUs begun_us = last_.device_us;
    if (!answer()) return std::nullopt;
    // On the stand nothing turned: all that the gyro measured there was its bias.
    const double bias_radps = watched_s_ > 0.0 ? watched_rad_ / watched_s_ : 0.0;
    const double took_s = static_cast<double>(last_.device_us - begun_us) * 1e-6;
    return sums_.yaw_rad - before_rad - bias_radps * took_s;
  }

  doctor::Wiring wiring() const {
    const course::DriveValues& drive = options_.drive;
    return {drive.invert_left_motor, drive.invert_right_motor, drive.invert_left_encoder,
            drive.invert_right_encoder, drive.swap_tracks};
  }

  const WheelsUpOptions& options_;
  const std::atomic<bool>& stop_;
  Answers& answers_;
  RobotTalk talk_;
  const double track_mps_ = std::min(kTrackMps, options_.drive.max_track_mps);
  Sample last_{};
  Sums sums_{};
  double watched_s_ = 0.0;  // over all motions
  double watched_rad_ = 0.0;
  bool refused_ = false;
};

}  // namespace

Findings try_wheels_up(const WheelsUpOptions& options, const std::atomic<bool>& stop) {
  say("Put the robot on a stand, its tracks free. Each track runs forward and back for a second. "
      "Enter starts, Ctrl-C ends it.");
  Answers answers;
  answers.drop_typed_ahead();
  if (!entered(answers, stop)) return nobody();
  return WheelsUp(options, stop, answers).run();
}

}  // namespace tp100::doctor
