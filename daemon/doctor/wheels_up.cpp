#include "doctor/wheels_up.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/clock.h"
#include "core/faults.h"
#include "doctor/probe_session.h"
#include "doctor/tracks.h"

namespace tp100::doctor {
namespace {

constexpr double kHelloLimitS = 8.0;
constexpr double kSettleS = 0.3;
constexpr double kDistanceS = 1.0;
constexpr double kStandstillS = 0.6;
constexpr double kAloneLimitS = 2.0;
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
  // A track that counts backwards must be driven to the end and judged, not stopped as a fault.
  out.max_track_mps = 1.0F;
  out.stall_duty = 0;
  out.flags = static_cast<std::uint8_t>(out.flags & ~wire::kUseGyro);
  return settings;
}

class WheelsUp {
 public:
  WheelsUp(const WheelsUpOptions& options, Operator& person, const std::atomic<bool>& stop)
      : options_(options),
        stop_(stop),
        person_(person),
        session_(link::open_port(options.port, options.serial), open_loop(options.session), stop) {
    session_.on_sample = [this](const Sample& sample) { add(sample); };
  }
  // The motors are switched off in any case.
  ~WheelsUp() {
    if (session_.disarm()) person_.motors_off(monotonic_now());
  }
  WheelsUp(const WheelsUp&) = delete;
  WheelsUp& operator=(const WheelsUp&) = delete;

  Findings run() {
    const auto ready = [this] { return session_.session().state() == SessionState::kReady; };
    if (!session_.run(kHelloLimitS, ready))
      return wheels_up_broken_off(options_.port + ": no session with the robot",
                                  "run tp100d doctor without --wheels-up first");
    person_.say("both tracks run in opposite directions, then reversed");
    const std::optional<TrackDrive> spin = drive({0.0, 2.0 * track_mps_});
    if (!spin) return stopped();
    const bool look = !doctor::on_floor(spin->turned_rad);
    const std::optional<TrackDrive> left = drive(Side::kLeft, look);
    const std::optional<TrackDrive> right = left ? drive(Side::kRight, look) : std::nullopt;
    if (!right) return stopped();
    Findings findings = doctor::track_findings(*left, *right, wiring());
    const bool well = count(findings, Severity::kError) == 0;
    const bool watched =
        left->seen != ObservedMotion::kUnknown && right->seen != ObservedMotion::kUnknown;
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
    if (refused_)
      return wheels_up_broken_off("the robot cannot be armed: " + session_.why(), session_.fix());
    if (session_.session().counters().reboots > 0)
      return wheels_up_broken_off("the board restarted while a track ran",
                                  "charge the battery and check the power wiring");
    if (const auto fault = first_fault(session_.newest().faults))
      return wheels_up_broken_off(
          "the robot stopped by itself: " + std::string(describe(*fault).cause),
          std::string(describe(*fault).fix));
    if (session_.gone())
      return wheels_up_broken_off(options_.port + ": port is gone",
                                  "check the plug and run it again");
    if (stop_) return wheels_up_broken_off("stopped before it was complete", "run it again");
    if (alone_)
      return wheels_up_broken_off("nobody watched while a track ran",
                                  "keep the page that started it in sight, and run it again");
    return wheels_up_broken_off(options_.port + ": the robot fell silent",
                                "check the cable and run it again");
  }

  void wait(double seconds) {
    session_.run(seconds, [] { return false; });
  }

  /// One motion, while somebody watches. False: nobody watches any more.
  bool move(const Motion& motion) {
    session_.command(motion.speed_mps, motion.yaw_rate_radps);
    const bool left_alone = session_.run(kDistanceS, [this] { return !person_.watches(); });
    session_.command(0.0, 0.0);
    return !left_alone;
  }

  /// One motion and the standstill after it.
  Sums travel(const Motion& motion) {
    Sums before = sums_;
    DeviceUs begun_us = last_.device_us;
    while (!move(motion)) {
      alone_ = !session_.run(kAloneLimitS, [this] { return person_.watches(); });
      if (!alone_) wait(kStandstillS);
      if (!still_there()) return {};
      before = sums_;
      begun_us = last_.device_us;
    }
    wait(kStandstillS);
    watched_s_ += static_cast<double>(last_.device_us - begun_us) * 1e-6;
    watched_rad_ += sums_.yaw_rad - before.yaw_rad;
    return {sums_.left_m - before.left_m, sums_.right_m - before.right_m,
            sums_.yaw_rad - before.yaw_rad};
  }

  /// Arms for one motion and its reverse. Nothing: it was not completed.
  std::optional<TrackDrive> drive(const Motion& motion) {
    wait(kSettleS);
    if (!session_.arm()) {
      refused_ = still_there();
      return std::nullopt;
    }
    const Sums forward = travel(motion);
    const Sums back = still_there() ? travel({-motion.speed_mps, -motion.yaw_rate_radps}) : Sums{};
    session_.disarm();
    if (!still_there() || session_.newest().faults != 0) return std::nullopt;
    return TrackDrive{0.5 * (forward.left_m - back.left_m), 0.5 * (forward.right_m - back.right_m),
                      0.5 * (forward.yaw_rad - back.yaw_rad), ObservedMotion::kUnknown};
  }

  std::optional<TrackDrive> drive(Side side, bool look) {
    const std::string name = side == Side::kLeft ? "left" : "right";
    person_.say("the " + name + " track runs forward, then back");
    const double turn_radps = side == Side::kLeft ? -track_mps_ : track_mps_;
    std::optional<TrackDrive> driven = drive({0.5 * track_mps_, turn_radps});
    if (driven && look) driven->seen = ask(name);
    return still_there() ? driven : std::nullopt;
  }

  bool still_there() const {
    const link::Session& session = session_.session();
    return !session_.gone() && !stop_ && !alone_ && session.counters().reboots == 0 &&
           session.state() == SessionState::kReady;
  }

  std::optional<std::string> answer(const Question& question) {
    person_.ask(question);
    std::optional<std::string> given;
    session_.run(kAnswerLimitS, [&] {
      given = person_.take_answer();
      return given.has_value() || person_.ended();
    });
    return given;
  }

  ObservedMotion ask(const std::string& track) {
    const Question question{"What ran?",
                            {{"", "the " + track + " track, forward first"},
                             {"b", "the " + track + " track, back first"},
                             {"o", "the other one"},
                             {"n", "none"}}};
    while (true) {
      const std::optional<std::string> reply = answer(question);
      if (!reply) return ObservedMotion::kUnknown;
      if (reply->empty()) return ObservedMotion::kAsAsked;
      if (*reply == "b") return ObservedMotion::kBackwards;
      if (*reply == "o") return ObservedMotion::kOtherTrack;
      if (*reply == "n") return ObservedMotion::kNothing;
    }
  }

  std::optional<double> hand_turn() {
    if (!answer({"Hold the robot level and still", {{"", "it is still"}}})) return std::nullopt;
    const double before_rad = sums_.yaw_rad;
    const DeviceUs begun_us = last_.device_us;
    if (!answer({"Turn it by a quarter to the left (counter-clockwise from above)",
                 {{"", "it is turned"}}}))
      return std::nullopt;
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
  Operator& person_;
  ProbeSession session_;
  const double track_mps_ = std::min(kTrackMps, options_.drive.max_track_mps);
  Sample last_{};
  Sums sums_{};
  double watched_s_ = 0.0;  // over all motions
  double watched_rad_ = 0.0;
  bool refused_ = false;
  bool alone_ = false;
};

}  // namespace

Findings wheels_up_broken_off(std::string seen, std::string fix) {
  return {error("wheels-up", std::move(seen), std::move(fix))};
}

Findings try_wheels_up(const WheelsUpOptions& options, Operator& person,
                       const std::atomic<bool>& stop) {
  return WheelsUp(options, person, stop).run();
}

}  // namespace tp100::doctor
